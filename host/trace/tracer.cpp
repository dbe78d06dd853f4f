// SPDX-License-Identifier: MIT
#include "trace/tracer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "core/error.hpp"
#include "gpu/commands.hpp"
#include "trace_io.h"

namespace raytorus::trace {
namespace {

static_assert(sizeof(TraceRay) == TRACE_RAY_FLOATS * sizeof(float));
static_assert(sizeof(NearestHit) == TRACE_NEAREST_FLOATS * sizeof(float));
static_assert(sizeof(AllHits) == TRACE_ALL_FLOATS * sizeof(float));

struct PushConstants {
    float majorRadius;
    float minorRadius;
    std::uint32_t count;
};

std::uint32_t queryConstant(Query query) {
    switch (query) {
        case Query::All:
            return TRACE_QUERY_ALL;
        case Query::Any:
            return TRACE_QUERY_ANY;
        case Query::Nearest:
            break;
    }
    return TRACE_QUERY_NEAREST;
}

}  // namespace

std::size_t Tracer::maxCapacity(const gpu::Context& context, Query query) {
    const VkPhysicalDeviceLimits& limits = context.info().limits;
    const std::size_t rayBytes = std::max(std::size_t{TRACE_RAY_FLOATS}, hitFloats(query)) * sizeof(float);
    return std::min<std::size_t>(limits.maxStorageBufferRange / rayBytes,
                                 std::size_t{limits.maxComputeWorkGroupCount[0]} * TRACE_GROUP_SIZE);
}

Tracer::Batch::Batch(gpu::Context& context, std::size_t capacity, std::size_t hitFloats)
    : rays(context, capacity * sizeof(TraceRay), gpu::BufferUse::Storage),
      hits(context, capacity * hitFloats * sizeof(float), gpu::BufferUse::ReadBack),
      submission(context) {}

Tracer::Tracer(gpu::Context& context, Query wanted, std::size_t rayCapacity, const ShaderSource& shaders,
               std::size_t batchCount)
    : query(wanted), capacity(rayCapacity) {
    if (capacity > maxCapacity(context, query)) {
        throw Error(ExitCode::OutOfMemory,
                    fmt::format("{} takes {} rays at a time, not {}", context.info().name,
                                maxCapacity(context, query), capacity));
    }
    gpu::PipelineLayoutInfo info;
    info.bindings = {{TRACE_BINDING_RAYS, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER},
                     {TRACE_BINDING_HITS, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER}};
    info.pushConstantBytes = sizeof(PushConstants);
    info.specialization = {queryConstant(query)};
    info.copies = static_cast<std::uint32_t>(batchCount);
    const gpu::ShaderModule shader(context, shaders.load("trace.comp"), "trace.comp");
    pipeline = gpu::makeComputePipeline(context, shader, info);
    for (std::size_t i = 0; i < batchCount; ++i) {
        const Batch& batch =
            *batches.emplace_back(std::make_unique<Batch>(context, capacity, hitFloats(query)));
        pipeline.bind(TRACE_BINDING_RAYS, batch.rays, i);
        pipeline.bind(TRACE_BINDING_HITS, batch.hits, i);
    }
}

std::span<const float> Tracer::trace(const reference::Torus& torus, std::span<const TraceRay> wanted) {
    if (wanted.empty()) {
        return {};
    }
    if (wanted.size() <= capacity) {
        std::memcpy(rays(0).data(), wanted.data(), wanted.size_bytes());
    }
    start(0, torus, wanted.size());
    return finish(0);
}

std::span<TraceRay> Tracer::rays(std::size_t batch) const {
    return batches.at(batch)->rays.as<TraceRay>().first(capacity);
}

void Tracer::start(std::size_t index, const reference::Torus& torus, std::size_t count) {
    if (count > capacity) {
        throw Error(ExitCode::Internal, fmt::format("{} rays given to a tracer for {}", count, capacity));
    }
    Batch& batch = *batches.at(index);
    batch.count = count;
    const PushConstants constants{torus.majorRadius, torus.minorRadius, static_cast<std::uint32_t>(count)};
    batch.submission.start([&](VkCommandBuffer commands) {
        pipeline.use(commands, std::as_bytes(std::span(&constants, 1)), index);
        vkCmdDispatch(commands, (constants.count + TRACE_GROUP_SIZE - 1) / TRACE_GROUP_SIZE, 1, 1);
        gpu::bufferBarrier(commands, batch.hits, gpu::shaderWrite, gpu::hostRead);
    });
}

std::span<const float> Tracer::finish(std::size_t index) {
    Batch& batch = *batches.at(index);
    batch.submission.finish();
    return batch.hits.as<const float>().first(batch.count * hitFloats(query));
}

}  // namespace raytorus::trace
