// SPDX-License-Identifier: MIT
#include "fast_rays.hpp"

#include "reference/promise.hpp"
#include "reference/rays.hpp"
#include "support/fresh_seed.hpp"
#include "trace/trace_ray.hpp"

namespace raytorus::test {

using reference::DoubleDouble;
using reference::RayClass;

namespace {

constexpr std::uint64_t raysEach = 40;

}  // namespace

ExactHits exactHitsOf(const Trial& trial) {
    return reference::intersectAs<DoubleDouble>(reference::BasicTorus<DoubleDouble>(trial.torus),
                                                reference::BasicRay<DoubleDouble>(trial.ray));
}

bool FastAnswer::hasClearEnds() const {
    return exact.endClearance() >= reference::clearEndMargin(trial.torus);
}

bool FastAnswer::isClear() const {
    return exact.clearance >= reference::clearMargin && hasClearEnds();
}

bool FastAnswer::nearTip() const {
    return ExactLine(trial, fastTier().reduce(trial.torus, trial.ray)->line()).meetsATip();
}

void forFastRays(const std::function<void(const FastAnswer&)>& check) {
    for (const float r : {0.01F, 0.05F, 0.1F, 0.25F, 0.5F, 0.9F, 1.0F, 1.02F, 1.5F, 10.0F}) {
        for (const double distance : {1.5, 3.0, 10.0, 100.0, 1e4}) {
            for (const RayClass rayClass : reference::allRayClasses) {
                reference::RayParameters parameters;
                parameters.torus = {1.0F, r};
                parameters.distance = distance;
                parameters.margin = 1e-6;
                parameters.seed = freshSeed();
                for (const reference::Ray& ray : reference::generateRays(rayClass, parameters, raysEach)) {
                    const Trial trial{parameters.torus, ray};
                    check({trial, exactHitsOf(trial), fastTier().all(1.0F, r, trace::asTraceRay(ray))});
                    if (testing::Test::HasFatalFailure()) {
                        return;
                    }
                }
            }
        }
    }
}

}  // namespace raytorus::test
