// SPDX-License-Identifier: MIT
#include "trace/self_check.hpp"

#include <cstdint>
#include <cstring>
#include <span>

#include "gpu/buffer.hpp"
#include "gpu/commands.hpp"
#include "gpu/pipeline.hpp"
#include "raytorus_shaders.hpp"

namespace raytorus::trace {

namespace {

// torus.glsl's TORUS_CHECK_SUMS, _PRODUCTS and _HIGHP; _FUSED_FMA; _DENORMALS.
constexpr int exactTier = 1 + 2 + 4;
constexpr int fusedFma = 8;
constexpr int denormals = 16;

}  // namespace

SelfCheck selfCheck(gpu::Context& context) {
    const float one = 1.0F;
    const gpu::Buffer output(context, sizeof(std::int32_t), gpu::BufferUse::ReadBack);
    gpu::PipelineLayoutInfo info;
    info.bindings = {{0, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER}};
    info.pushConstantBytes = sizeof one;
    const gpu::ShaderModule shader(context, shaders::find("self_check.comp"), "self_check.comp");
    gpu::Pipeline pipeline = gpu::makeComputePipeline(context, shader, info);
    pipeline.bind(0, output);
    context.submit([&](VkCommandBuffer commands) {
        pipeline.use(commands, std::as_bytes(std::span(&one, 1)));
        vkCmdDispatch(commands, 1, 1, 1);
        gpu::bufferBarrier(commands, output, gpu::shaderWrite, gpu::hostRead);
    });
    std::int32_t found = 0;
    std::memcpy(&found, output.data(), sizeof found);
    return {(found & exactTier) == exactTier, (found & fusedFma) != 0, (found & denormals) != 0};
}

}  // namespace raytorus::trace
