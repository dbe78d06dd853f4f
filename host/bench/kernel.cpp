// SPDX-License-Identifier: MIT
#include "bench/kernel.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <numeric>

#include "bench/bench_io.h"
#include "gpu/commands.hpp"
#include "trace_io.h"

namespace raytorus::bench {
namespace {

static_assert(sizeof(RayView) == 76, "the push constants of bench_rays.glsl");

}  // namespace

std::uint32_t checksumOf(std::span<const float> answers) {
    std::uint32_t sum = 0;
    for (const float number : answers) {
        sum += std::bit_cast<std::uint32_t>(number);
    }
    return sum;
}

std::uint32_t queryConstant(trace::Query query) {
    switch (query) {
        case trace::Query::All:
            return TRACE_QUERY_ALL;
        case trace::Query::Any:
            return TRACE_QUERY_ANY;
        case trace::Query::Nearest:
            break;
    }
    return TRACE_QUERY_NEAREST;
}

std::size_t answerFloats(trace::Query query) {
    return query == trace::Query::Nearest ? BENCH_NEAREST_FLOATS : trace::hitFloats(query);
}

Kernel::Kernel(gpu::Context& deviceContext, std::uint32_t pictureSide)
    : context(&deviceContext), side(pictureSide), stopwatch(deviceContext) {}

std::uint32_t Kernel::pixels() const {
    return side * BENCH_BLOCK_SIDE;
}

std::size_t Kernel::rayCount() const {
    return std::size_t{side} * side * BENCH_GROUP_RAYS;
}

gpu::Pipeline& Kernel::pipeline(const TimedMethod& method, trace::Query query, Pattern pattern,
                                std::uint32_t task) {
    const Key key{method.name, queryConstant(query), pattern, task};
    const auto found = pipelines.find(key);
    if (found != pipelines.end()) {
        return found->second;
    }
    gpu::PipelineLayoutInfo info;
    info.bindings = {{BENCH_BINDING_WORDS, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER}};
    info.pushConstantBytes = sizeof(RayView);
    info.specialization = {queryConstant(query), pattern == Pattern::Scattered ? 1U : 0U, task};
    const gpu::ShaderModule shader(*context, method.shaders.load("bench.comp"),
                                   "bench.comp of " + method.name);
    return pipelines.emplace(key, gpu::makeComputePipeline(*context, shader, info)).first->second;
}

void Kernel::reserve(std::size_t words) {
    const std::size_t bytes = words * sizeof(std::uint32_t);
    if (output.size() < bytes) {
        output = gpu::Buffer(*context, bytes, gpu::BufferUse::ReadBack);
    }
}

double Kernel::run(gpu::Pipeline& chosen, const RayView& view, std::uint32_t layers) {
    chosen.bind(BENCH_BINDING_WORDS, output);
    return stopwatch.submit([&](VkCommandBuffer commands) {
        chosen.use(commands, std::as_bytes(std::span(&view, 1)));
        vkCmdDispatch(commands, side, side, layers);
        gpu::bufferBarrier(commands, output, gpu::shaderWrite, gpu::hostRead);
    });
}

std::vector<trace::TraceRay> Kernel::rays(Pattern pattern, const RayView& view) {
    const std::size_t words = rayCount() * TRACE_RAY_FLOATS;
    reserve(words);
    run(pipeline(timedMethods().front(), trace::Query::Any, pattern, BENCH_TASK_RAYS), view, 1);
    std::vector<trace::TraceRay> made(rayCount());
    std::memcpy(made.data(), output.data(), words * sizeof(float));
    return made;
}

std::vector<float> Kernel::answers(const TimedMethod& method, trace::Query query, Pattern pattern,
                                   const RayView& view) {
    const std::size_t words = rayCount() * answerFloats(query);
    reserve(words);
    run(pipeline(method, query, pattern, BENCH_TASK_ANSWERS), view, 1);
    const std::span<const float> written = output.as<const float>().first(words);
    return {written.begin(), written.end()};
}

Shot Kernel::time(const TimedMethod& method, trace::Query query, Pattern pattern, const RayView& view,
                  std::uint32_t layers) {
    const std::size_t invocations = rayCount() / BENCH_RAYS_EACH;
    gpu::Pipeline& chosen = pipeline(method, query, pattern, BENCH_TASK_TIME);
    reserve(invocations * layers);
    const std::span<std::uint32_t> words = output.as<std::uint32_t>().first(invocations * layers);
    // What an earlier run has left must not pass for this one's.
    std::ranges::fill(words, 0U);
    Shot shot;
    shot.seconds = run(chosen, view, layers);
    shot.rays = static_cast<double>(rayCount()) * layers;
    const std::span<const std::uint32_t> first = words.first(invocations);
    shot.checksum = std::accumulate(first.begin(), first.end(), std::uint32_t{0});
    for (std::size_t layer = 1; layer < layers; ++layer) {
        shot.layersAgree =
            shot.layersAgree && std::ranges::equal(first, words.subspan(layer * invocations, invocations));
    }
    return shot;
}

}  // namespace raytorus::bench
