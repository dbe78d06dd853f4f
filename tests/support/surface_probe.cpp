// SPDX-License-Identifier: MIT
#include "surface_probe.hpp"

#include <cstring>

#include "gpu/buffer.hpp"
#include "gpu/commands.hpp"
#include "raytorus_test_shaders.hpp"

namespace raytorus::test {

SurfaceProbe::SurfaceProbe(gpu::Context& deviceContext)
    : SurfaceProbe(deviceContext, trace::ShaderSource(test_shaders::find)) {}

SurfaceProbe::SurfaceProbe(gpu::Context& deviceContext, const trace::ShaderSource& shaders)
    : context(&deviceContext) {
    gpu::PipelineLayoutInfo info;
    info.bindings = {{0, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER}, {1, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER}};
    info.pushConstantBytes = sizeof(std::uint32_t);
    const gpu::ShaderModule shader(deviceContext, shaders.load("probe.comp"), "probe.comp");
    pipeline = gpu::makeComputePipeline(deviceContext, shader, info);
}

std::vector<SurfaceAnswer> SurfaceProbe::ask(const std::vector<SurfacePoint>& points) {
    const gpu::Buffer input =
        gpu::makeBuffer(*context, std::span<const SurfacePoint>(points), gpu::BufferUse::Storage);
    const gpu::Buffer output(*context, points.size() * sizeof(SurfaceAnswer), gpu::BufferUse::ReadBack);
    pipeline.bind(0, input);
    pipeline.bind(1, output);
    const auto count = static_cast<std::uint32_t>(points.size());
    context->submit([&](VkCommandBuffer commands) {
        pipeline.use(commands, std::as_bytes(std::span(&count, 1)));
        vkCmdDispatch(commands, (count + 63) / 64, 1, 1);
        gpu::bufferBarrier(commands, output, gpu::shaderWrite, gpu::hostRead);
    });
    std::vector<SurfaceAnswer> answers(points.size());
    std::memcpy(answers.data(), output.data(), answers.size() * sizeof(SurfaceAnswer));
    return answers;
}

}  // namespace raytorus::test
