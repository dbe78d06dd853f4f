// SPDX-License-Identifier: MIT
// A ray, and what is answered to it, as shaders and raw files have them.
#pragma once

#include <cstddef>

#include "trace_io.h"

namespace raytorus::trace {

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
constexpr std::size_t hitFloats(Query query) {
    return query == Query::All   ? TRACE_ALL_FLOATS
           : query == Query::Any ? TRACE_ANY_FLOATS
                                 : TRACE_NEAREST_FLOATS;
}

}  // namespace raytorus::trace
