// SPDX-License-Identifier: MIT
// Where a workload's rays come from and go to, so that as many of them hit as it wants.
#pragma once

#include <cstdint>
#include <functional>

#include "bench/workload.hpp"

namespace raytorus::bench {

/// What bench_rays.glsl makes rays of: its push constants.
struct RayView {
    float origin[3];
    float majorRadius;
    float corner[3];
    float minorRadius;
    float right[3];
    float tMax;
    float up[3];
    float startDistance;
    float spread;
    std::uint32_t seed;
    std::uint32_t nothing;  ///< 0
};

/// The end of every ray: beyond the torus, as for camera rays.
inline constexpr float rayEnd = 1e30F;

/// The view with this opening, in r. Tiles: half the width of the picture, `pixels` wide, at the distance of
/// the ring; its middle is a point of the ring, and from where the camera looks follows from the seed.
/// Scattered: how far from the ring the rays aim.
RayView makeView(const Workload& workload, std::uint32_t pixels, std::uint64_t seed, double opening);

/// The view that comes closest to the workload's part of hits. `hitPart` says what part of a view's rays hit:
/// all of them where the opening is small, ever fewer as it grows.
RayView aim(const Workload& workload, std::uint32_t pixels, std::uint64_t seed,
            const std::function<double(const RayView&)>& hitPart);

}  // namespace raytorus::bench
