// SPDX-License-Identifier: MIT
// Hands on a camera: what each movement keeps and what it changes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>
#include <random>
#include <vector>

#include "scene/scene.hpp"
#include "support/fresh_seed.hpp"
#include "viewer/navigation.hpp"

namespace raytorus::viewer {
namespace {

// A few dozen operations in double on numbers of this size.
double roundings(double size) {
    return 1e-12 * size;
}

class Navigation : public testing::Test {
protected:
    double number(double low, double high) { return std::uniform_real_distribution(low, high)(engine); }

    glm::dvec3 vector(double size) { return {number(-size, size), number(-size, size), number(-size, size)}; }

    scene::Camera camera() {
        scene::Camera made;
        made.target = vector(10.0);
        do {
            made.position = made.target + vector(20.0);
            made.up = vector(1.0);
        } while (glm::length(made.position - made.target) < 0.1 || glm::length(made.up) < 0.1 ||
                 std::abs(std::cos(fromPole(made))) > 0.999);
        made.verticalFieldOfView = number(5.0, 120.0);
        return made;
    }

    std::vector<scene::TorusInstance> tori() {
        std::vector<scene::TorusInstance> made(static_cast<std::size_t>(number(1.0, 6.0)));
        for (scene::TorusInstance& torus : made) {
            torus.majorRadius = number(0.1, 3.0);
            torus.minorRadius = number(0.01, 1.0);
            torus.scale = number(0.2, 4.0);
            torus.translation = vector(8.0);
        }
        return made;
    }

    static double fromPole(const scene::Camera& camera) {
        const glm::dvec3 back = glm::normalize(camera.position - camera.target);
        return std::acos(std::clamp(glm::dot(back, glm::normalize(camera.up)), -1.0, 1.0));
    }

    static double distance(const scene::Camera& camera) {
        return glm::length(camera.position - camera.target);
    }

    // What of the camera's place lies round the pole.
    static glm::dvec3 aroundPole(const scene::Camera& camera) {
        const glm::dvec3 pole = glm::normalize(camera.up);
        const glm::dvec3 back = camera.position - camera.target;
        return back - glm::dot(back, pole) * pole;
    }

    // Every torus' sphere within the pyramid of sight. Returns the largest part of the way to its sides that
    // any takes: 1 touches.
    static double filled(const scene::Camera& camera, const std::vector<scene::TorusInstance>& tori,
                         double aspectRatio) {
        const glm::dvec3 forward = glm::normalize(camera.target - camera.position);
        const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up));
        const glm::dvec3 up = glm::cross(right, forward);
        const double vertical = 0.5 * glm::radians(camera.verticalFieldOfView);
        const double horizontal = std::atan(std::tan(vertical) * aspectRatio);
        double most = 0.0;
        for (const scene::TorusInstance& torus : tori) {
            const glm::dvec3 centre = torus.translation - camera.position;
            const double radius = torus.scale * (torus.majorRadius + torus.minorRadius);
            for (const auto& [axis, half] : {std::pair(right, horizontal), std::pair(up, vertical)}) {
                // Distance to a side's plane, whose normal points inwards.
                const double ahead = glm::dot(centre, forward) * std::sin(half);
                const double aside = std::abs(glm::dot(centre, axis)) * std::cos(half);
                most = std::max(most, (aside + radius) / ahead);
            }
        }
        return most;
    }

    std::mt19937_64 engine{test::freshSeed()};
};

TEST_F(Navigation, OrbitKeepsDistanceAndTargetAndTurnsByTheAngle) {
    for (int i = 0; i < 300; ++i) {
        const scene::Camera before = camera();
        const double across = number(-7.0, 7.0);
        const double room = std::min(fromPole(before), glm::pi<double>() - fromPole(before)) - 0.011;
        const double upwards = number(-room, room);
        const scene::Camera after = orbit(before, across, upwards);
        EXPECT_EQ(after.target, before.target);
        EXPECT_EQ(after.up, before.up);
        EXPECT_NEAR(distance(after), distance(before), roundings(distance(before)));
        // acos near 1 loses half the digits.
        EXPECT_NEAR(fromPole(after), fromPole(before) - upwards, 1e-7);
        // Round the pole, counter-clockwise from above.
        const glm::dvec3 from = glm::normalize(aroundPole(before));
        const glm::dvec3 to = glm::normalize(aroundPole(after));
        EXPECT_NEAR(glm::dot(from, to), std::cos(across), 1e-9);
        EXPECT_NEAR(glm::dot(glm::cross(from, to), glm::normalize(before.up)), std::sin(across), 1e-9);
    }
}

TEST_F(Navigation, OrbitNeverCrossesAPole) {
    for (int i = 0; i < 300; ++i) {
        const scene::Camera before = camera();
        const double upwards = number(-20.0, 20.0);
        const scene::Camera after = orbit(before, 0.0, upwards);
        EXPECT_GE(fromPole(after), 0.0099);
        EXPECT_LE(fromPole(after), glm::pi<double>() - 0.0099);
        // On the same meridian: not beyond the pole.
        EXPECT_NEAR(glm::dot(glm::normalize(aroundPole(before)), glm::normalize(aroundPole(after))), 1.0,
                    1e-9);
        EXPECT_NEAR(distance(after), distance(before), roundings(distance(before)));
    }
}

TEST_F(Navigation, OrbitLeavesThePoleWhereASceneHasPutTheCamera) {
    scene::Camera above;
    above.position = {0.002, 0.0, 5.0};
    above.target = {0.0, 0.0, 0.0};
    const double angle = fromPole(above);
    ASSERT_LT(angle, 0.01);
    EXPECT_NEAR(fromPole(orbit(above, 0.0, 0.5)), angle, 1e-7);
    EXPECT_NEAR(fromPole(orbit(above, 0.0, -0.5)), angle + 0.5, 1e-7);
}

TEST_F(Navigation, PanMovesPlaceAndTargetAlike) {
    for (int i = 0; i < 300; ++i) {
        const scene::Camera before = camera();
        const double x = number(-2.0, 2.0);
        const double y = number(-2.0, 2.0);
        const scene::Camera after = pan(before, x, y);
        const glm::dvec3 step = after.position - before.position;
        const double size = 1.0 + distance(before) + glm::length(before.target) + glm::length(step);
        EXPECT_LE(glm::length(after.target - before.target - step), roundings(size));
        EXPECT_NEAR(glm::dot(step, before.target - before.position), 0.0, roundings(size * size));
        const double height =
            2.0 * distance(before) * std::tan(0.5 * glm::radians(before.verticalFieldOfView));
        EXPECT_NEAR(glm::length(step), height * std::hypot(x, y), 1e-10 * size * (1.0 + height));
        // What the hand draws to the right comes from the left: the camera goes left.
        const glm::dvec3 right = glm::cross(before.target - before.position, before.up);
        EXPECT_EQ(glm::dot(step, right) < 0.0, x > 0.0);
    }
}

TEST_F(Navigation, DollyDividesTheDistance) {
    for (int i = 0; i < 300; ++i) {
        const scene::Camera before = camera();
        const double factor = number(0.2, 5.0);
        const scene::Camera after = dolly(before, factor);
        EXPECT_EQ(after.target, before.target);
        EXPECT_NEAR(distance(after), distance(before) / factor, roundings(20.0 * distance(before)));
        EXPECT_NEAR(glm::dot(glm::normalize(before.position - before.target),
                             glm::normalize(after.position - after.target)),
                    1.0, 1e-12);
    }
}

TEST_F(Navigation, DollyEndsBeforeTheTargetAndBeforeInfinity) {
    scene::Camera in = camera();
    scene::Camera out = in;
    for (int i = 0; i < 2000; ++i) {
        in = dolly(in, 1.5);
        out = dolly(out, 1.0 / 1.5);
    }
    EXPECT_GT(distance(in), 1e-7);
    EXPECT_LT(distance(in), 1e-3);
    EXPECT_GT(distance(out), 1e8);
    EXPECT_LT(distance(out), 1e10);
    // In floats, which the shaders are given, place and target are still two points.
    EXPECT_NE(glm::vec3(in.position), glm::vec3(in.target));
    // And back again.
    EXPECT_GT(distance(dolly(in, 0.5)), 1.9 * distance(in));
    EXPECT_LT(distance(dolly(out, 2.0)), 0.51 * distance(out));
}

TEST_F(Navigation, BoundsHoldEveryTorus) {
    for (int i = 0; i < 300; ++i) {
        const std::vector<scene::TorusInstance> all = tori();
        const scene::Sphere bounds = scene::enclosingSphere(all);
        double touched = 0.0;
        for (const scene::TorusInstance& torus : all) {
            const double reach = glm::length(torus.translation - bounds.center) +
                                 torus.scale * (torus.majorRadius + torus.minorRadius);
            EXPECT_LE(reach, bounds.radius * (1.0 + 1e-12));
            touched = std::max(touched, reach);
        }
        EXPECT_NEAR(touched, bounds.radius, roundings(bounds.radius));
    }
}

TEST_F(Navigation, FitFramesTheTori) {
    for (int i = 0; i < 300; ++i) {
        const std::vector<scene::TorusInstance> all = tori();
        const scene::Camera before = camera();
        const double aspectRatio = number(0.3, 3.0);
        const scene::Camera after = fit(before, all, aspectRatio);
        const double part = filled(after, all, aspectRatio);
        EXPECT_LE(part, 1.0 + 1e-9);
        // The sphere round all touches the sides; the tori themselves may hide behind one another.
        const scene::Sphere sphere = scene::enclosingSphere(all);
        scene::TorusInstance round;
        round.translation = sphere.center;
        round.scale = 1.0;
        round.majorRadius = 0.0;
        round.minorRadius = sphere.radius;
        EXPECT_NEAR(filled(after, {round}, aspectRatio), 1.0, 1e-9);
        EXPECT_NEAR(glm::dot(glm::normalize(before.position - before.target),
                             glm::normalize(after.position - after.target)),
                    1.0, 1e-9);
    }
}

TEST_F(Navigation, PresetsLookAlongTheirAxesAndFrameTheTori) {
    const std::vector<std::pair<Preset, glm::dvec3>> cases = {
        {Preset::Front, {0.0, 1.0, 0.0}}, {Preset::Back, {0.0, -1.0, 0.0}},
        {Preset::Left, {1.0, 0.0, 0.0}},  {Preset::Right, {-1.0, 0.0, 0.0}},
        {Preset::Top, {0.0, 0.0, -1.0}},  {Preset::Bottom, {0.0, 0.0, 1.0}}};
    for (const auto& [which, sight] : cases) {
        const std::vector<scene::TorusInstance> all = tori();
        const scene::Camera after = preset(which, camera(), all, 1.5);
        EXPECT_LE(glm::length(glm::normalize(after.target - after.position) - sight), 1e-12);
        EXPECT_NEAR(glm::dot(after.up, sight), 0.0, 1e-12);
        EXPECT_LE(filled(after, all, 1.5), 1.0 + 1e-9);
    }
    const scene::Camera corner = preset(Preset::Corner, camera(), tori(), 1.5);
    EXPECT_GT(std::sin(fromPole(corner)), 0.1);
}

}  // namespace
}  // namespace raytorus::viewer
