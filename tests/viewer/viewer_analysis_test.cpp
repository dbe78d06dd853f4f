// SPDX-License-Identifier: MIT
// The judge of pixels, on rays whose hits are known by hand: right pixels are found right, each planted fault
// is accused, and errors come out with the right number.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <thread>

#include "render/picture_targets.hpp"
#include "viewer/analysis.hpp"
#include "viewer/view_io.h"

namespace raytorus::viewer {
namespace {

struct Answer {
    double x = 0.0, y = 0.0, z = 0.0;
    int id = -1;
    int count = 0;
};

// A picture of one pixel: what lies on the camera's axis.
image::Image pictureOf(const Answer& answer, int width = 1) {
    image::Image picture(width, 1, {"position.x", "position.y", "position.z", "id", "count"});
    for (int x = 0; x < width; ++x) {
        const std::array<double, 5> values = {answer.x, answer.y, answer.z, static_cast<double>(answer.id),
                                              static_cast<double>(answer.count)};
        std::transform(values.begin(), values.end(), picture.pixel(x, 0).begin(),
                       [](double value) { return static_cast<float>(value); });
    }
    return picture;
}

// A camera that looks along x at a ring in the equator: four surfaces, the first at -R - r.
scene::Scene sceneAlongX() {
    scene::Scene scene;
    scene.camera.position = {-4.0, 0.0, 0.0};
    scene.camera.target = {0.0, 0.0, 0.0};
    scene.camera.up = {0.0, 0.0, 1.0};
    scene.tori.assign(1, scene::TorusInstance{});
    scene.tori[0].majorRadius = 1.0;
    scene.tori[0].minorRadius = 0.25;
    return scene;
}

PixelAnalysis judged(const scene::Scene& scene, const Answer& answer) {
    return PixelJudge(scene, 1, 1).judge(pictureOf(answer), 0, 0);
}

constexpr Answer rightAnswer{-1.25, 0.0, 0.0, 0, 4};
const double unit = std::ldexp(1.25, -24);

TEST(PixelJudge, FindsARightPixelRight) {
    const PixelAnalysis found = judged(sceneAlongX(), rightAnswer);
    EXPECT_EQ(found.state, ANALYSIS_HIT);
    EXPECT_NEAR(found.fromSurface, 0.0, 1e-6);
    EXPECT_NEAR(found.fromReference, 0.0, 1e-6);
}

TEST(PixelJudge, AccusesAWrongVerdict) {
    const scene::Scene scene = sceneAlongX();
    for (const int id : {-1, 1}) {
        Answer answer = rightAnswer;
        answer.id = id;
        EXPECT_EQ(judged(scene, answer).state, ANALYSIS_WRONG) << "id " << id;
    }
    for (const int count : {0, 2, 3, 5}) {
        Answer answer = rightAnswer;
        answer.count = count;
        EXPECT_EQ(judged(scene, answer).state, ANALYSIS_WRONG) << count << " surfaces";
    }
}

TEST(PixelJudge, AccusesAPositionThatIsNoNumber) {
    Answer answer = rightAnswer;
    answer.y = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(judged(sceneAlongX(), answer).state, ANALYSIS_WRONG);
    answer.y = std::numeric_limits<double>::infinity();
    EXPECT_EQ(judged(sceneAlongX(), answer).state, ANALYSIS_WRONG);
}

TEST(PixelJudge, MeasuresAPosition) {
    const scene::Scene scene = sceneAlongX();
    for (const double error : {1.0, 10.0, 1000.0, 1e5}) {
        // Out of the surface, into it, and along it. A float near 1.25 is a multiple of 1.6 units.
        const double rounding = 0.81;
        Answer answer = rightAnswer;
        answer.x -= error * unit;
        const PixelAnalysis outside = judged(scene, answer);
        EXPECT_EQ(outside.state, ANALYSIS_HIT);
        EXPECT_NEAR(outside.fromSurface, error, rounding);
        EXPECT_NEAR(outside.fromReference, error, rounding);

        answer.x = rightAnswer.x + error * unit;
        const PixelAnalysis inside = judged(scene, answer);
        EXPECT_NEAR(inside.fromSurface, -error, rounding);
        EXPECT_NEAR(inside.fromReference, error, rounding);

        answer.x = rightAnswer.x;
        answer.z = error * unit;
        const PixelAnalysis aside = judged(scene, answer);
        // The tube bends away: by d^2 / 2 r to the first order, and less than a thousandth of it more.
        const double sagitta = error * error * unit / (2.0 * 0.25);
        EXPECT_NEAR(aside.fromSurface, sagitta, 1e-3 * sagitta + 1e-6);
        EXPECT_NEAR(aside.fromReference, error, 1e-5 * error);
    }
}

TEST(PixelJudge, KnowsAMiss) {
    scene::Scene scene = sceneAlongX();
    scene.camera.position = {0.0, 0.0, 4.0};  // through the hole
    scene.camera.up = {0.0, 1.0, 0.0};
    EXPECT_EQ(judged(scene, {}).state, ANALYSIS_MISS);
    EXPECT_EQ(judged(scene, {0.0, 0.0, 0.25, 0, 2}).state, ANALYSIS_WRONG);
    EXPECT_EQ(judged(scene, {0.0, 0.0, 0.0, -1, 2}).state, ANALYSIS_WRONG);
}

TEST(PixelJudge, KnowsWhichTorusIsNearestAndCountsAll) {
    scene::Scene scene = sceneAlongX();
    scene.tori.push_back(scene.tori[0]);
    scene.tori[0].translation = {3.0, 0.0, 0.0};
    const Answer answer{-1.25, 0.0, 0.0, 1, 8};
    EXPECT_EQ(judged(scene, answer).state, ANALYSIS_HIT);
    Answer other = answer;
    other.id = 0;
    EXPECT_EQ(judged(scene, other).state, ANALYSIS_WRONG);
    other = answer;
    other.count = 4;
    EXPECT_EQ(judged(scene, other).state, ANALYSIS_WRONG);
}

TEST(PixelJudge, GoesThroughTheTorusPlace) {
    scene::Scene scene = sceneAlongX();
    // Turned round the ray, which meets the same four surfaces; twice as large; elsewhere.
    scene::TorusInstance& torus = scene.tori[0];
    torus.rotation = glm::angleAxis(0.7, glm::dvec3(1.0, 0.0, 0.0));
    torus.scale = 2.0;
    torus.translation = {2.0, -3.0, 8.0};
    scene.camera.position = {-6.0, -3.0, 8.0};
    scene.camera.target = {2.0, -3.0, 8.0};
    const double larger = std::ldexp(2.0 * 1.25 + 8.0, -24);
    const Answer answer{-0.5, -3.0, 8.0, 0, 4};
    const PixelAnalysis found = judged(scene, answer);
    EXPECT_EQ(found.state, ANALYSIS_HIT);
    // The rows of the rotation are floats: what they turn is off by some of their roundings.
    EXPECT_LE(std::abs(found.fromSurface), 1.0);
    EXPECT_LE(found.fromReference, 1.0);
    Answer moved = answer;
    moved.x -= 500.0 * larger;
    EXPECT_NEAR(judged(scene, moved).fromSurface, 500.0, 1.0);
    EXPECT_NEAR(judged(scene, moved).fromReference, 500.0, 1.0);
}

TEST(Analysis, CountsThePixelsThatItAccusesAndKeepsTheLargestError) {
    const scene::Scene scene = sceneAlongX();
    // Of three columns the middle one looks along x, the others beside it, past the ring's middle.
    image::Image picture = pictureOf(rightAnswer, 3);
    Analysis analysis;
    AnalysisPixels pixels;
    const auto finish = [&] {
        Analysis::Progress progress;
        while (progress.part < 1.0) {
            if (!analysis.take(pixels, progress)) {
                std::this_thread::yield();
            }
        }
        return progress;
    };
    analysis.start(scene, picture);
    const Analysis::Progress sides = finish();
    EXPECT_EQ(sides.wrong, 2);  // what stands there is the middle's
    EXPECT_NEAR(sides.largest, 0.0, 1e-6);

    picture.pixel(1, 0)[2] = static_cast<float>(1000.0 * unit);
    analysis.start(scene, picture);
    EXPECT_NEAR(finish().largest, 1000.0, 0.1);

    picture.pixel(1, 0)[3] = 7.0F;
    analysis.start(scene, picture);
    EXPECT_EQ(finish().wrong, 3);
    Analysis::Progress progress;
    EXPECT_FALSE(analysis.take(pixels, progress));  // nothing new
    ASSERT_EQ(pixels.values.size(), 12U);
    EXPECT_EQ(pixels.values[4], static_cast<float>(ANALYSIS_WRONG));

    // Stopped at once, and started on something else at once.
    analysis.start(scene, pictureOf(rightAnswer, 512));
    analysis.start(scene, pictureOf(rightAnswer, 1));
    EXPECT_EQ(finish().wrong, 0);
    analysis.stop();
    analysis.stop();
}

}  // namespace
}  // namespace raytorus::viewer
