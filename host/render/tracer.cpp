// SPDX-License-Identifier: MIT
#include "render/tracer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "core/error.hpp"
#include "gpu/commands.hpp"
#include "trace_io.h"

namespace raytorus::render {
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

std::size_t hitFloats(Query query) {
    switch (query) {
        case Query::All:
            return TRACE_ALL_FLOATS;
        case Query::Any:
            return TRACE_ANY_FLOATS;
        case Query::Nearest:
            break;
    }
    return TRACE_NEAREST_FLOATS;
}

std::size_t Tracer::maxCapacity(const gpu::Context& context, Query query) {
    const VkPhysicalDeviceLimits& limits = context.info().limits;
    const std::size_t rayBytes = std::max(std::size_t{TRACE_RAY_FLOATS}, hitFloats(query)) * sizeof(float);
    return std::min<std::size_t>(limits.maxStorageBufferRange / rayBytes,
                                 std::size_t{limits.maxComputeWorkGroupCount[0]} * TRACE_GROUP_SIZE);
}

Tracer::Tracer(gpu::Context& deviceContext, Query wanted, std::size_t rayCapacity,
               const ShaderSource& shaders)
    : context(&deviceContext), query(wanted), capacity(rayCapacity) {
    if (capacity > maxCapacity(deviceContext, query)) {
        throw Error(ExitCode::OutOfMemory,
                    fmt::format("{} takes {} rays at a time, not {}", deviceContext.info().name,
                                maxCapacity(deviceContext, query), capacity));
    }
    rayBuffer = gpu::Buffer(deviceContext, capacity * sizeof(TraceRay), gpu::BufferUse::Storage);
    hitBuffer =
        gpu::Buffer(deviceContext, capacity * hitFloats(query) * sizeof(float), gpu::BufferUse::ReadBack);
    gpu::PipelineLayoutInfo info;
    info.bindings = {{TRACE_BINDING_RAYS, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER},
                     {TRACE_BINDING_HITS, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER}};
    info.pushConstantBytes = sizeof(PushConstants);
    info.specialization = {queryConstant(query)};
    const gpu::ShaderModule shader(deviceContext, shaders.load("trace.comp"), "trace.comp");
    pipeline = gpu::makeComputePipeline(deviceContext, shader, info);
    pipeline.bind(TRACE_BINDING_RAYS, rayBuffer);
    pipeline.bind(TRACE_BINDING_HITS, hitBuffer);
}

std::span<const float> Tracer::trace(float majorRadius, float minorRadius, std::span<const TraceRay> rays) {
    if (rays.size() > capacity) {
        throw Error(ExitCode::Internal,
                    fmt::format("{} rays given to a tracer for {}", rays.size(), capacity));
    }
    if (rays.empty()) {
        return {};
    }
    std::memcpy(rayBuffer.data(), rays.data(), rays.size_bytes());
    const PushConstants constants{majorRadius, minorRadius, static_cast<std::uint32_t>(rays.size())};
    context->submit([&](VkCommandBuffer commands) {
        pipeline.use(commands, std::as_bytes(std::span(&constants, 1)));
        vkCmdDispatch(commands, (constants.count + TRACE_GROUP_SIZE - 1) / TRACE_GROUP_SIZE, 1, 1);
        gpu::bufferBarrier(commands, hitBuffer, gpu::shaderWrite, gpu::hostRead);
    });
    return hitBuffer.as<const float>().first(rays.size() * hitFloats(query));
}

}  // namespace raytorus::render
