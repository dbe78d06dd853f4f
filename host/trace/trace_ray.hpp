// SPDX-License-Identifier: MIT
// A ray as the reference has it and as shaders read it: the same eight floats, so that one becomes the other
// by its bits.
#pragma once

#include <bit>
#include <cstddef>
#include <span>
#include <vector>

#include "reference/torus_reference.hpp"
#include "trace/hits.hpp"

namespace raytorus::trace {

static_assert(offsetof(reference::Ray, origin) == offsetof(TraceRay, origin));
static_assert(offsetof(reference::Ray, tMin) == offsetof(TraceRay, tMin));
static_assert(offsetof(reference::Ray, direction) == offsetof(TraceRay, direction));
static_assert(offsetof(reference::Ray, tMax) == offsetof(TraceRay, tMax));

inline TraceRay asTraceRay(const reference::Ray& ray) {
    return std::bit_cast<TraceRay>(ray);
}

inline reference::Ray asReferenceRay(const TraceRay& ray) {
    return std::bit_cast<reference::Ray>(ray);
}

inline std::vector<TraceRay> asTraceRays(std::span<const reference::Ray> rays) {
    std::vector<TraceRay> traced;
    traced.reserve(rays.size());
    for (const reference::Ray& ray : rays) {
        traced.push_back(asTraceRay(ray));
    }
    return traced;
}

}  // namespace raytorus::trace
