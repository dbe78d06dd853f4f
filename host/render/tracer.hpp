// SPDX-License-Identifier: MIT
// Rays in, hits out, through trace.comp: the same SPIR-V that pictures are made of, without a picture.
#pragma once

#include <cstddef>
#include <span>

#include "gpu/buffer.hpp"
#include "gpu/pipeline.hpp"
#include "render/shader_source.hpp"

namespace raytorus::render {

enum class Query { Nearest, All, Any };

/// A ray as raw files hold it and as the shader reads it.
struct TraceRay {
    float origin[3];
    float tMin;
    float direction[3];
    float tMax;
};

/// Query::Nearest. No hit: hit = 0, t = tMax, position and normal 0.
struct NearestHit {
    float hit;  ///< 1 or 0
    float t;
    float position[3];
    float normal[3];
};

/// Query::All. Entries past the count: t = tMax, position 0.
struct AllHits {
    float count;  ///< 0 to 4
    float t[4];
    float position[4][3];
};

/// Floats that one ray's answer consists of: as many as the structures above, or 1 for Query::Any.
std::size_t hitFloats(Query query);

/// A torus, one kind of question, and room for a number of rays at a time.
class Tracer {
public:
    /// Throws Error{OutOfMemory} if the device allows no buffer for so many rays; see maxCapacity.
    Tracer(gpu::Context& context, Query query, std::size_t capacity, const ShaderSource& shaders = {});

    /// The most rays that the device takes at a time.
    static std::size_t maxCapacity(const gpu::Context& context, Query query);

    /// Traces up to `capacity` rays. The answer is valid until the next call: hitFloats(query) floats a ray.
    std::span<const float> trace(float majorRadius, float minorRadius, std::span<const TraceRay> rays);

private:
    gpu::Context* context;
    Query query;
    std::size_t capacity;
    gpu::Buffer rayBuffer;
    gpu::Buffer hitBuffer;
    gpu::Pipeline pipeline;
};

}  // namespace raytorus::render
