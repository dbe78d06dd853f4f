// SPDX-License-Identifier: MIT
#include "bench/stream.hpp"

#include <algorithm>
#include <cstring>

#include "gpu/commands.hpp"
#include "trace_io.h"

namespace raytorus::bench {
namespace {

struct PushConstants {
    float majorRadius;
    float minorRadius;
    std::uint32_t count;
};

}  // namespace

Stream::Stream(gpu::Context& deviceContext, const reference::Torus& streamedTorus,
               std::span<const trace::TraceRay> rays, std::size_t copies)
    : context(&deviceContext),
      torus(streamedTorus),
      countOfOne(rays.size()),
      count(rays.size() * copies),
      stopwatch(deviceContext),
      rayBuffer(deviceContext, count * sizeof(trace::TraceRay), gpu::BufferUse::Storage),
      hitBuffer(deviceContext, count * TRACE_ALL_FLOATS * sizeof(float), gpu::BufferUse::ReadBack) {
    for (std::size_t copy = 0; copy < copies; ++copy) {
        std::memcpy(rayBuffer.data() + copy * rays.size_bytes(), rays.data(), rays.size_bytes());
    }
}

Shot Stream::time(const TimedMethod& method, trace::Query query) {
    const std::pair key{method.name, queryConstant(query)};
    if (!pipelines.contains(key)) {
        gpu::PipelineLayoutInfo info;
        info.bindings = {{TRACE_BINDING_RAYS, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER},
                         {TRACE_BINDING_HITS, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER}};
        info.pushConstantBytes = sizeof(PushConstants);
        info.specialization = {queryConstant(query)};
        const gpu::ShaderModule shader(*context, method.shaders.load("trace.comp"),
                                       "trace.comp of " + method.name);
        gpu::Pipeline made = gpu::makeComputePipeline(*context, shader, info);
        made.bind(TRACE_BINDING_RAYS, rayBuffer);
        made.bind(TRACE_BINDING_HITS, hitBuffer);
        pipelines.emplace(key, std::move(made));
    }
    const gpu::Pipeline& chosen = pipelines.at(key);
    const std::span<float> words = hitBuffer.as<float>().first(count * trace::hitFloats(query));
    // What an earlier run has left must not pass for this one's.
    std::ranges::fill(words, 0.0F);
    const PushConstants constants{torus.majorRadius, torus.minorRadius, static_cast<std::uint32_t>(count)};
    Shot shot;
    shot.rays = static_cast<double>(count);
    shot.seconds = stopwatch.submit([&](VkCommandBuffer commands) {
        chosen.use(commands, std::as_bytes(std::span(&constants, 1)));
        vkCmdDispatch(commands, (constants.count + TRACE_GROUP_SIZE - 1) / TRACE_GROUP_SIZE, 1, 1);
        gpu::bufferBarrier(commands, hitBuffer, gpu::shaderWrite, gpu::hostRead);
    });
    const std::size_t floatsOfOne = countOfOne * trace::hitFloats(query);
    const std::span<const float> first = words.first(floatsOfOne);
    shot.checksum = checksumOf(first);
    for (std::size_t at = floatsOfOne; at < words.size(); at += floatsOfOne) {
        const bool same = std::memcmp(first.data(), &words[at], first.size_bytes()) == 0;
        shot.layersAgree = shot.layersAgree && same;
    }
    return shot;
}

std::vector<float> Stream::answers(trace::Query query) const {
    const std::size_t stored = trace::hitFloats(query);
    const std::size_t wanted = answerFloats(query);
    const std::span<const float> words = hitBuffer.as<const float>();
    std::vector<float> result;
    result.reserve(countOfOne * wanted);
    for (std::size_t i = 0; i < countOfOne; ++i) {
        const std::span<const float> answer = words.subspan(i * stored, wanted);
        result.insert(result.end(), answer.begin(), answer.end());
    }
    return result;
}

}  // namespace raytorus::bench
