// SPDX-License-Identifier: MIT
// Every method of the table answers rays whose hits are known by hand, keeps the library's contract for
// misses and bad input, and agrees with itself. How often each is wrong elsewhere is measured, not tested.
#include "methods/methods.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <vector>

#include "compare/comparison_text.hpp"
#include "judge/queries.hpp"
#include "reference/rays.hpp"
#include "render/renderer.hpp"
#include "scene/scene_json.hpp"
#include "support/device_fixture.hpp"
#include "support/scratch_folder.hpp"
#include "support/special_floats.hpp"

namespace raytorus {

// For GoogleTest's messages.
void PrintTo(const Method& method, std::ostream* out) {
    *out << method.name;
}

namespace {

using judge::Answers;
using reference::Ray;

// The answers of a method to these rays.
std::vector<Answers> answersOf(const Method& method, const reference::Torus& torus,
                               const std::vector<Ray>& rays) {
    judge::Queries queries(test::device(), rays.size(), method.shaders);
    return queries.answer(torus, rays);
}

struct Known {
    const char* name;
    Ray ray;
    std::vector<double> t;
};

// R = 1, r = 0.25.
constexpr reference::Torus ring{1.0F, 0.25F};
const Known knownRays[] = {
    {"in the plane z = 0, through all", {{3, 0, 0}, 0, {-1, 0, 0}, infinity}, {1.75, 2.25, 3.75, 4.25}},
    {"the same in longer steps", {{3, 0, 0}, 0, {-4, 0, 0}, infinity}, {0.4375, 0.5625, 0.9375, 1.0625}},
    {"above it, through the middles", {{3, 0, 0.15F}, 0, {-1, 0, 0}, infinity}, {1.8, 2.2, 3.8, 4.2}},
    {"vertically through the tube", {{1, 0, 3}, 0, {0, 0, -1}, infinity}, {2.75, 3.25}},
    {"vertically beside its middle", {{0, 1.2F, -2}, 0, {0, 0, 1}, infinity}, {1.85, 2.15}},
    {"along the axis", {{0, 0, 3}, 0, {0, 0, -1}, infinity}, {}},
    {"from inside outwards", {{1, 0, 0}, 0, {1, 0, 0}, infinity}, {0.25}},
    {"from inside across the hole", {{1, 0, 0}, 0, {-1, 0, 0}, infinity}, {0.25, 1.75, 2.25}},
    {"from the hole", {{0, 0, 0}, 0, {1, 0, 0}, infinity}, {0.75, 1.25}},
    {"away", {{3, 0, 0}, 0, {1, 0, 0}, infinity}, {}},
    {"past the bounding sphere", {{3, 0, 2}, 0, {-1, 0, 0}, infinity}, {}},
    {"over the tube", {{3, 0, 0.3F}, 0, {-1, 0, 0}, infinity}, {}},
    {"ending before", {{3, 0, 0}, 0, {-1, 0, 0}, 1.5F}, {}},
    {"ending in the tube", {{3, 0, 0}, 0, {-1, 0, 0}, 2}, {1.75}},
    {"beginning in the tube", {{3, 0, 0}, 2, {-1, 0, 0}, 4}, {2.25, 3.75}},
};

std::vector<Ray> raysOf(std::span<const Known> known) {
    std::vector<Ray> rays;
    for (const Known& row : known) {
        rays.push_back(row.ray);
    }
    return rays;
}

class EachMethod : public test::DeviceTest, public testing::WithParamInterface<Method> {};

TEST_P(EachMethod, HasShadersOfItsOwnAndIsFoundByItsName) {
    const Method* found = findMethod(GetParam().name);
    ASSERT_NE(found, nullptr);
    EXPECT_STREQ(found->description, GetParam().description);
    const bool isLibrary = found == &methods().front();
    for (const char* name : {"trace.comp", "scene.frag", "scene.comp", "fullscreen.vert"}) {
        const bool intersects = std::string_view(name) != "fullscreen.vert";
        const bool same = GetParam().shaders.load(name) == trace::ShaderSource().load(name);
        EXPECT_EQ(same, isLibrary || !intersects) << name;
    }
}

// Close to thick rings all of them draw the same picture, but for edges; each by both routes the same.
TEST_P(EachMethod, DrawsThePictureOfTheLibrary) {
    const scene::Scene scene =
        scene::readScene(std::filesystem::path(RAYTORUS_SOURCE_DIR) / "scenes" / "ring.json");
    render::RenderOptions options;
    options.width = 48;
    options.height = 32;
    const image::Image library = render::render(test::device(), scene, options).picture;
    options.shaders = GetParam().shaders;
    const image::Image fragment = render::render(test::device(), scene, options).picture;
    options.route = render::Route::Compute;
    EXPECT_EQ(fragment.pixels, render::render(test::device(), scene, options).picture.pixels);

    compare::CompareRules rules;
    // t is up to 6 long here. Uv turns by a whole turn at its seam, and fields of the checker change at their
    // edges, so some pixels may differ by more than the method is off.
    rules.defaultRule.tolerance = 40 * GetParam().tolerance;
    rules.allowedPixels = 48 * 32 / 50;
    const compare::Comparison comparison = compare::compare(library, fragment, rules);
    EXPECT_TRUE(comparison.passed()) << comparison.sentence << "\n" << compare::numbersTable(comparison);
}

TEST_P(EachMethod, HitsWhereItMust) {
    const std::vector<Answers> answers = answersOf(GetParam(), ring, raysOf(knownRays));
    const double size = static_cast<double>(ring.majorRadius) + static_cast<double>(ring.minorRadius);
    for (std::size_t i = 0; i < std::size(knownRays); ++i) {
        SCOPED_TRACE(knownRays[i].name);
        const Ray& ray = knownRays[i].ray;
        const std::vector<double>& t = knownRays[i].t;
        EXPECT_EQ(answers[i].nearest.hit != 0.0F, !t.empty());
        EXPECT_EQ(answers[i].any != 0.0F, !t.empty());
        ASSERT_EQ(answers[i].all.count, static_cast<float>(t.size()));
        const double speed =
            std::hypot(static_cast<double>(ray.direction[0]), static_cast<double>(ray.direction[1]),
                       static_cast<double>(ray.direction[2]));
        const double tolerance = GetParam().tolerance * size;
        for (std::size_t k = 0; k < t.size(); ++k) {
            EXPECT_NEAR(static_cast<double>(answers[i].all.t[k]), t[k], tolerance / speed) << k;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const double exact =
                    static_cast<double>(ray.origin[axis]) + t[k] * static_cast<double>(ray.direction[axis]);
                EXPECT_NEAR(static_cast<double>(answers[i].all.position[k][axis]), exact, tolerance) << k;
            }
        }
    }
}

TEST_P(EachMethod, NearestIsTheFirstOfAll) {
    const std::vector<Answers> answers = answersOf(GetParam(), ring, raysOf(knownRays));
    for (std::size_t i = 0; i < std::size(knownRays); ++i) {
        EXPECT_EQ(answers[i].nearest.t, answers[i].all.t[0]) << knownRays[i].name;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            EXPECT_EQ(answers[i].nearest.position[axis], answers[i].all.position[0][axis])
                << knownRays[i].name;
        }
    }
}

TEST_P(EachMethod, SeesTheOuterSheetOfASpindleOnly) {
    const std::vector<Ray> rays = {{{0.1F, 0, 3}, 0, {0, 0, -1}, infinity},
                                   {{0.1F, 0, 0}, 0, {0, 0, 1}, infinity},
                                   {{4, 0, 0.5F}, 0, {-1, 0, 0}, infinity}};
    const std::vector<Answers> answers = answersOf(GetParam(), {1.0F, 1.25F}, rays);
    EXPECT_EQ(answers[0].all.count, 2.0F);
    EXPECT_EQ(answers[1].all.count, 1.0F);
    EXPECT_EQ(answers[2].all.count, 2.0F);
    EXPECT_NEAR(static_cast<double>(answers[0].nearest.t), 3 - std::sqrt(1.5625 - 0.81),
                2.25 * GetParam().tolerance);
}

TEST_P(EachMethod, MissesWithTheContractsOutputs) {
    struct Bad {
        reference::Torus torus;
        Ray ray;
        float t;
    };
    const Ray good{{3, 0, 0}, 0, {-1, 0, 0}, 100};
    const Bad rows[] = {
        {ring, {{3, 0, 2}, 0, {-1, 0, 0}, 100}, 100},
        {ring, {{0, 0, 3}, 0, {0, 0, -1}, infinity}, infinity},
        {{1, 0}, good, 100},
        {{1, -0.25F}, good, 100},
        {{-1, 0.25F}, good, 100},
        {{nan, 0.25F}, good, 100},
        {{1, nan}, good, 100},
        {{infinity, 0.25F}, good, 100},
        {ring, {{3, 0, 0}, 0, {0, 0, 0}, 100}, 100},
        {ring, {{3, 0, 0}, 0, {nan, 0, 0}, 100}, 100},
        {ring, {{3, 0, 0}, 0, {-infinity, 0, 0}, 100}, 100},
        {ring, {{nan, 0, 0}, 0, {-1, 0, 0}, 100}, 100},
        {ring, {{infinity, 0, 0}, 0, {-1, 0, 0}, 100}, 100},
        {ring, {{3, 0, 0}, 5, {-1, 0, 0}, 1}, 1},
        {ring, {{3, 0, 0}, 0, {-1, 0, 0}, nan}, 0},
    };
    judge::Queries queries(test::device(), 1, GetParam().shaders);
    for (std::size_t i = 0; i < std::size(rows); ++i) {
        SCOPED_TRACE(i);
        const std::vector<Answers> answers = queries.answer(rows[i].torus, {rows[i].ray});
        EXPECT_EQ(answers[0].any, 0.0F);
        EXPECT_EQ(answers[0].nearest.hit, 0.0F);
        EXPECT_EQ(answers[0].nearest.t, rows[i].t);
        EXPECT_EQ(answers[0].all.count, 0.0F);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            EXPECT_EQ(answers[0].nearest.position[axis], 0.0F);
        }
        for (const float t : answers[0].all.t) {
            EXPECT_EQ(t, rows[i].t);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Methods, EachMethod, testing::ValuesIn(methods().begin(), methods().end()),
                         [](const auto& row) {
                             std::string name = row.param.name;
                             std::erase(name, '-');
                             return name;
                         });

TEST(Methods, TheFirstIsTheLibrary) {
    ASSERT_FALSE(methods().empty());
    EXPECT_STREQ(methods().front().name, "raytorus");
    EXPECT_EQ(findMethod("no such method"), nullptr);
}

TEST(Methods, AreThoseOfTheDocumentation) {
    std::string quoted;
    for (const Method& method : methods().subspan(2)) {
        quoted += fmt::format("{}`{}`", quoted.empty() ? "[" : " ", method.name);
    }
    const std::string page = test::fileText(RAYTORUS_SOURCE_DIR "/docs/cli.md");
    EXPECT_NE(page.find("| `--method NAME` | who intersects"), std::string::npos);
    EXPECT_NE(page.find(quoted + "]"), std::string::npos) << quoted;
}

using Production = test::DeviceTest;

TEST_F(Production, EqualsTorusGlslBitForBit) {
    reference::RayParameters parameters;
    std::vector<Ray> rays;
    for (const reference::RayClass rayClass : reference::allRayClasses) {
        const std::vector<Ray> some = reference::generateRays(rayClass, parameters, 100);
        rays.insert(rays.end(), some.begin(), some.end());
    }
    judge::Queries builtIn(test::device(), rays.size());
    const std::vector<Answers> expected = builtIn.answer(parameters.torus, rays);
    const std::vector<Answers> row = answersOf(methods().front(), parameters.torus, rays);
    static_assert(sizeof(Answers) == sizeof(trace::NearestHit) + sizeof(trace::AllHits) + sizeof(float));
    EXPECT_EQ(std::memcmp(expected.data(), row.data(), rays.size() * sizeof(Answers)), 0);
}

}  // namespace
}  // namespace raytorus
