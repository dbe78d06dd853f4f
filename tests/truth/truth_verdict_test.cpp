// SPDX-License-Identifier: MIT
// Clearances and margins: rays that are moved by less do what they say.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "random_scene.hpp"
#include "reference/random.hpp"
#include "support/fresh_seed.hpp"
#include "truth/sample.hpp"
#include "truth/verdicts.hpp"

namespace raytorus::truth {
namespace {

using reference::Random;

constexpr std::uint64_t stream = 2200;

// What a ray sees, as far as verdicts go.
struct RayVerdict {
    int torus, count;
    bool operator==(const RayVerdict&) const = default;
};

SceneRay<DoubleDouble> rayOf(const Vec3<double>& origin, const Vec3<double>& direction) {
    return {fromDoubles<DoubleDouble>(origin), fromDoubles<DoubleDouble>(direction)};
}

RayVerdict verdictOf(const SceneData& scene, const SceneRay<DoubleDouble>& ray, double& t) {
    const Sample<double> sample = traceSample<DoubleDouble, double>(scene, ray);
    t = sample.t;
    return {sample.torus, sample.count};
}

// Turns that are a thousand times as large as floats' make doubtful rays common.
constexpr CameraBounds coarse{1e-3, 0.0};

TEST(TruthVerdict, HoldsWhileTheMarginSaysSo) {
    constexpr std::uint64_t scenes = 300;
    int clear = 0, doubtful = 0, flipped = 0;  // rays
    for (std::uint64_t i = 0; i < scenes; ++i) {
        scene::Scene plain = test::randomScene(test::freshSeed(), i).scene;
        plain.lights.clear();  // verdicts need no shadows
        if (i % 2 == 0) {
            // Two surfaces so close that either may be the nearer one.
            plain.tori.push_back(plain.tori.front());
            plain.tori.back().scale *= 1.003;
        }
        const SceneData scene = makeSceneData(plain, 8, 8);
        for (int pixel = 0; pixel < 64; ++pixel) {
            Random random(test::freshSeed(), stream, 64 * i + static_cast<std::uint64_t>(pixel));
            const PicturePoint<DoubleDouble> point{DoubleDouble(random.uniform(0.0, 8.0)),
                                                   DoubleDouble(random.uniform(0.0, 8.0))};
            const SceneRay<DoubleDouble> ray = cameraRay(scene.frame, point);
            double t = 0.0;
            const RayVerdict verdict = verdictOf(scene, ray, t);
            const VerdictMargins margins = verdictMargins(scene, ray, coarse, verdict.torus, t);
            doubtful += margins.nearest < 1.0 ? 1 : 0;
            clear += margins.nearest >= 1.0 ? 1 : 0;
            bool flips = false;
            for (int turn = 0; turn < 8; ++turn) {
                const Vec3<double> direction = toDoubles(ray.direction);
                const Vec3<double> side = random.onSphere();
                const Vec3<double> across = unit(side - dot(side, direction) * direction);
                const Vec3<double> turned = direction + (coarse.turned * 0.999) * across;
                double otherT = 0.0;
                const RayVerdict other = verdictOf(scene, rayOf(toDoubles(ray.origin), unit(turned)), otherT);
                flips = flips || other.torus != verdict.torus;
                if (margins.nearest >= 1.0) {
                    ASSERT_EQ(other.torus, verdict.torus)
                        << "scene " << i << ", pixel " << pixel << ", margin " << margins.nearest;
                }
                if (margins.count >= 1.0) {
                    ASSERT_EQ(other.count, verdict.count)
                        << "scene " << i << ", pixel " << pixel << ", margin " << margins.count;
                }
            }
            flipped += flips ? 1 : 0;
        }
    }
    fmt::print("{} clear rays, {} doubtful, of which {} flip\n", clear, doubtful, flipped);
    EXPECT_GT(clear, 1000);
    EXPECT_GT(8 * flipped, doubtful) << "margins that are too careful say nothing";
}

TEST(TruthVerdict, ClearanceAgreesWithTheHitsAndGrowsNoFasterThanTheWay) {
    int hidden = 0;
    for (std::uint64_t i = 0; i < 20000; ++i) {
        Random random(test::freshSeed(), stream + 1, i);
        scene::Scene plain;
        plain.tori.emplace_back();
        plain.tori[0].minorRadius = random.uniform(0.01, 1.5);
        const SceneData scene = makeSceneData(plain, 1, 1);
        const Vec3<double> origin = 2.0 * random.inBall();
        const Vec3<double> direction = random.uniform(0.1, 5.0) * random.onSphere();
        const double tMax = random.below(2) == 0 ? 1.0 : farthest;
        const auto clearance = [&](const Vec3<double>& from) {
            return leastClearance(scene, rayOf(from, direction), tMax).length;
        };
        const double exact = clearance(origin);
        const auto hits = reference::intersect(
            shapeOf(scene.tori[0]),
            {fromDoubles<Quad>(origin), Quad(0), fromDoubles<Quad>(direction), Quad(tMax)});
        hidden += hits.count > 0 ? 1 : 0;
        if (std::abs(exact) > 1e-12) {
            ASSERT_EQ(hits.count > 0, exact < 0.0) << "ray " << i << ", clearance " << exact;
        }
        const Vec3<double> shift = 0.01 * random.inBall();
        ASSERT_LE(std::abs(clearance(origin + shift) - exact), length(shift) * (1.0 + 1e-6) + 1e-12)
            << "ray " << i;
    }
    EXPECT_GT(hidden, 1000);
}

}  // namespace
}  // namespace raytorus::truth
