// SPDX-License-Identifier: MIT
// A ray as the reference has it and as shaders read it: the same eight floats, so that one becomes the other
// by its bits.
#pragma once

#include <bit>
#include <cstddef>
#include <span>
#include <vector>

#include "reference/torus_reference.hpp"
#include "render/tracer.hpp"

namespace raytorus::verify {

static_assert(offsetof(reference::Ray, origin) == offsetof(render::TraceRay, origin));
static_assert(offsetof(reference::Ray, tMin) == offsetof(render::TraceRay, tMin));
static_assert(offsetof(reference::Ray, direction) == offsetof(render::TraceRay, direction));
static_assert(offsetof(reference::Ray, tMax) == offsetof(render::TraceRay, tMax));

inline render::TraceRay asTraceRay(const reference::Ray& ray) {
    return std::bit_cast<render::TraceRay>(ray);
}

inline reference::Ray asReferenceRay(const render::TraceRay& ray) {
    return std::bit_cast<reference::Ray>(ray);
}

inline std::vector<render::TraceRay> asTraceRays(std::span<const reference::Ray> rays) {
    std::vector<render::TraceRay> traced;
    traced.reserve(rays.size());
    for (const reference::Ray& ray : rays) {
        traced.push_back(asTraceRay(ray));
    }
    return traced;
}

}  // namespace raytorus::verify
