// SPDX-License-Identifier: MIT
#include "trace/fused_fma.hpp"

#include <cstring>
#include <span>

#include "gpu/buffer.hpp"
#include "gpu/commands.hpp"
#include "gpu/pipeline.hpp"
#include "raytorus_shaders.hpp"

namespace raytorus::trace {

bool fusesFma(gpu::Context& context) {
    const float factor = 1.0F + 0x1p-12F;
    const gpu::Buffer output(context, sizeof(float), gpu::BufferUse::ReadBack);
    gpu::PipelineLayoutInfo info;
    info.bindings = {{0, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER}};
    info.pushConstantBytes = sizeof factor;
    const gpu::ShaderModule shader(context, shaders::find("fused_fma.comp"), "fused_fma.comp");
    gpu::Pipeline pipeline = gpu::makeComputePipeline(context, shader, info);
    pipeline.bind(0, output);
    context.submit([&](VkCommandBuffer commands) {
        pipeline.use(commands, std::as_bytes(std::span(&factor, 1)));
        vkCmdDispatch(commands, 1, 1, 1);
        gpu::bufferBarrier(commands, output, gpu::shaderWrite, gpu::hostRead);
    });
    float error = 0.0F;
    std::memcpy(&error, output.data(), sizeof error);
    return error == 0x1p-24F;
}

}  // namespace raytorus::trace
