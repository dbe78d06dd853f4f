// SPDX-License-Identifier: MIT
// The truth's own facts: values that follow from the definition by hand, and what its channels promise.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "random_scene.hpp"
#include "scene/scene_json.hpp"
#include "support/expect_error.hpp"
#include "support/fresh_seed.hpp"
#include "truth/truth.hpp"

namespace raytorus::truth {
namespace {

// Along the x axis, at a ring that a light from behind the camera shines on.
scene::Scene headOn() {
    scene::Scene scene;
    scene.camera = {{5.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, 40.0};
    scene.background = {{0.25, 0.5, 1.0}, {0.75, 0.0, 0.5}};
    scene.ambient = {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
    scene.lights.push_back({scene::Light::Type::Directional, {1.0, 0.0, 0.0}, {1.0, 0.5, 0.25}});
    scene.materials.emplace_back();
    scene.materials[0].diffuse = {1.0, 0.5, 0.5};
    scene.materials[0].specular = {0.0, 0.0, 0.0};
    scene.tori.emplace_back();
    return scene;
}

TruthOptions sharp() {
    TruthOptions options;
    options.sharpness = true;
    return options;
}

float valueAt(const image::Image& picture, int x, int y, const char* channel) {
    const int index = picture.channelIndex(channel);
    EXPECT_GE(index, 0) << channel;
    return picture.pixel(x, y)[static_cast<std::size_t>(index)];
}

void expectMiddle(const image::Image& picture, const std::vector<std::pair<const char*, float>>& expected) {
    for (const auto& [channel, value] : expected) {
        EXPECT_FLOAT_EQ(valueAt(picture, picture.width / 2, picture.height / 2, channel), value) << channel;
    }
}

TEST(TruthPicture, SeesAMirrorImageOfTheEquation) {
    expectMiddle(renderTruth(headOn(), 9, 9, sharp()), {{"R", 1.0F},
                                                        {"G", 0.25F},
                                                        {"B", 0.125F},
                                                        {"A", 1.0F},
                                                        {"t", 3.75F},
                                                        {"position.x", 1.25F},
                                                        {"position.y", 0.0F},
                                                        {"position.z", 0.0F},
                                                        {"normal.x", 1.0F},
                                                        {"normal.y", 0.0F},
                                                        {"normal.z", 0.0F},
                                                        {"uv.u", 0.0F},
                                                        {"uv.v", 0.0F},
                                                        {"count", 4.0F},
                                                        {"id", 0.0F}});
}

TEST(TruthPicture, ShowsTheBackgroundWhereNothingIs) {
    scene::Scene scene = headOn();
    scene.tori[0].translation = {20.0, 0.0, 0.0};
    expectMiddle(renderTruth(scene, 9, 9, sharp()), {{"R", 0.5F},
                                                     {"G", 0.25F},
                                                     {"B", 0.75F},
                                                     {"t", 0.0F},
                                                     {"normal.x", 0.0F},
                                                     {"count", 0.0F},
                                                     {"id", -1.0F},
                                                     {"tolerance.t", 0.0F},
                                                     {"tolerance.position", 0.0F}});
}

TEST(TruthPicture, IsDarkBehindAnother) {
    scene::Scene scene = headOn();
    scene.tori.push_back(scene.tori[0]);
    scene.tori[1].translation = {40.0, 0.0, 0.0};  // behind the camera, in the light's way
    scene.tori[1].majorRadius = 0.0;
    scene.tori[1].minorRadius = 2.0;
    expectMiddle(renderTruth(scene, 9, 9, sharp()), {{"R", 0.0F}, {"id", 0.0F}, {"count", 4.0F}});
}

TEST(TruthPicture, AveragesSamples) {
    // Two fields meet in the middle of the picture, left and right of the plane y = 0.
    scene::Scene scene = headOn();
    scene.lights.clear();
    scene.ambient = {{1.0, 1.0, 1.0}, {1.0, 1.0, 1.0}};
    scene.materials[0].checker = scene::Checker{2, 2, {0.0, 0.0, 0.0}};
    TruthOptions options;
    options.samplesPerSide = 4;
    const image::Image picture = renderTruth(scene, 1, 1, options);
    const float red = valueAt(picture, 0, 0, "R");
    EXPECT_EQ(red * 16.0F, std::round(red * 16.0F)) << "sixteen samples, each 0, 1 or the background's";
}

TEST(TruthPicture, HasTheChannelsThatWereAskedFor) {
    TruthOptions options;
    EXPECT_EQ(renderTruth(headOn(), 2, 2, options).channelCount(), 15);
    options.aovs = false;
    EXPECT_EQ(renderTruth(headOn(), 2, 2, options).channelNames,
              (std::vector<std::string>{"R", "G", "B", "A"}));
    EXPECT_EQ(renderTruth(headOn(), 2, 2, sharp()).channelNames,
              (std::vector<std::string>{"R",
                                        "G",
                                        "B",
                                        "A",
                                        "t",
                                        "position.x",
                                        "position.y",
                                        "position.z",
                                        "normal.x",
                                        "normal.y",
                                        "normal.z",
                                        "uv.u",
                                        "uv.v",
                                        "count",
                                        "id",
                                        "margin",
                                        "margin.count",
                                        "margin.color",
                                        "tolerance.color",
                                        "tolerance.t",
                                        "tolerance.position",
                                        "tolerance.normal",
                                        "tolerance.uv"}));
}

TEST(TruthPicture, DoesNotDependOnThreads) {
    const scene::Scene scene = test::randomScene(test::freshSeed(), 0).scene;
    TruthOptions options = sharp();
    options.threads = 1;
    const image::Image alone = renderTruth(scene, 12, 9, options);
    options.threads = 5;
    EXPECT_EQ(renderTruth(scene, 12, 9, options).pixels, alone.pixels);
}

TEST(TruthPicture, ReportsProgress) {
    TruthOptions options;
    std::vector<double> parts;
    options.progress = [&parts](double done) { parts.push_back(done); };
    (void)renderTruth(headOn(), 3, 8, options);
    ASSERT_EQ(parts.size(), 8U);
    EXPECT_TRUE(std::is_sorted(parts.begin(), parts.end()));
    EXPECT_EQ(parts.back(), 1.0);
}

TEST(TruthPicture, RefusesAPictureBeyondMemory) {
    test::expectError([] { (void)renderTruth(headOn(), 65536, 65536, {}); }, ExitCode::OutOfMemory,
                      {"too large"});
}

// The middle ray passes the top circle at this height above it.
image::Image overTheTop(double height) {
    scene::Scene scene = headOn();
    scene.camera.position.z = scene.camera.target.z = 0.25 + height;
    return renderTruth(scene, 9, 9, sharp());
}

TEST(TruthSharpness, DoubtsATangent) {
    for (const double height : {-1e-8, 0.0, 1e-8}) {
        const image::Image picture = overTheTop(height);
        EXPECT_LT(valueAt(picture, 4, 4, "margin"), 1.0F) << height;
        EXPECT_LT(valueAt(picture, 4, 4, "margin.count"), 1.0F) << height;
        EXPECT_LT(valueAt(picture, 4, 4, "margin.color"), 1.0F) << height;
    }
    for (const double height : {-1e-3, 1e-3}) {
        EXPECT_GE(valueAt(overTheTop(height), 4, 4, "margin"), 64.0F) << height;
    }
}

TEST(TruthSharpness, DoubtsACameraOnTheSurface) {
    scene::Scene scene = headOn();
    for (const double height : {-1e-7, 0.0, 1e-7}) {
        scene.camera.position.x = 1.25 + height;
        const image::Image picture = renderTruth(scene, 9, 9, sharp());
        EXPECT_LT(valueAt(picture, 4, 4, "margin"), 1.0F) << height;
        EXPECT_LT(valueAt(picture, 4, 4, "margin.count"), 1.0F) << height;
    }
    scene.camera.position.x = 1.25 + 1e-3;
    EXPECT_GE(valueAt(renderTruth(scene, 9, 9, sharp()), 4, 4, "margin"), 64.0F);
}

TEST(TruthSharpness, DoubtsTheColourOnAnEdgeOfTheChecker) {
    scene::Scene scene = headOn();
    scene.materials[0].checker = scene::Checker{};
    const image::Image picture = renderTruth(scene, 9, 9, sharp());
    EXPECT_LT(valueAt(picture, 4, 4, "margin.color"), 1.0F);
    EXPECT_GE(valueAt(picture, 4, 4, "margin"), 1024.0F) << "the hit itself is beyond doubt";
}

TEST(TruthSharpness, DoubtsTheColourOnTheEdgeOfAShadow) {
    const auto margin = [](double aside) {
        scene::Scene scene = headOn();
        scene.tori.push_back(scene.tori[0]);
        scene.tori[1].majorRadius = 0.0;
        scene.tori[1].minorRadius = 2.0;
        scene.tori[1].translation = {40.0, 2.0 + aside, 0.0};  // behind the camera, beside the light's way
        return valueAt(renderTruth(scene, 9, 9, sharp()), 4, 4, "margin.color");
    };
    for (const double aside : {-1e-6, 0.0, 1e-6}) {
        EXPECT_LT(margin(aside), 1.0F) << aside;
    }
    for (const double aside : {-1e-2, 1e-2}) {
        EXPECT_GE(margin(aside), 32.0F) << aside;
    }
}

TEST(TruthSharpness, GrowsWithTheDistance) {
    scene::Scene scene = headOn();
    const float close = valueAt(renderTruth(scene, 9, 9, sharp()), 4, 4, "tolerance.position");
    scene.camera.position.x = 5000.0;
    const float far = valueAt(renderTruth(scene, 9, 9, sharp()), 4, 4, "tolerance.position");
    EXPECT_GT(far, 64.0F * close);
    EXPECT_LT(far, 4096.0F * close);
}

TEST(TruthSharpness, KnowsWhatRoundsAlongTheRay) {
    // Head-on no displacement across the ray changes t. What does is the length of the direction, 3.5
    // roundings, ...
    scene::Scene scene = headOn();
    EXPECT_GE(valueAt(renderTruth(scene, 9, 9, sharp()), 4, 4, "tolerance.t"), 3.75F * 3.5F * 0x1p-24F);
    // ... and close by, the rotation of the origin into the torus' frame, here about its own axis.
    scene.camera.position.x = 1.26;
    scene.tori[0].rotation = {std::cos(0.5), 0.0, 0.0, std::sin(0.5)};
    const float close = valueAt(renderTruth(scene, 9, 9, sharp()), 4, 4, "tolerance.t");
    EXPECT_GE(close, 5e-8F);
    EXPECT_LE(close, 5e-7F);
}

TEST(TruthSharpness, StoresPowersOfTwo) {
    const image::Image picture = renderTruth(test::randomScene(test::freshSeed(), 1).scene, 12, 9, sharp());
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            for (int i = picture.channelIndex("margin"); i < picture.channelCount(); ++i) {
                const float value = picture.pixel(x, y)[static_cast<std::size_t>(i)];
                int exponent = 0;
                ASSERT_TRUE(value == 0.0F || std::frexp(value, &exponent) == 0.5F)
                    << picture.channelNames[static_cast<std::size_t>(i)] << ": " << value;
            }
        }
    }
}

TEST(TruthDisagreements, AreNone) {
    for (std::uint64_t i = 0; i < 20; ++i) {
        const test::RandomScene drawn = test::randomScene(test::freshSeed(), i);
        for (const Disagreement& found : disagreements(drawn.scene, 12, 8, {})) {
            ADD_FAILURE() << drawn.description << ", pixel (" << found.x << ", " << found.y << "), "
                          << found.channel << ": " << found.arbiter << " or " << found.other;
        }
    }
}

}  // namespace
}  // namespace raytorus::truth
