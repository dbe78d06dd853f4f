// SPDX-License-Identifier: MIT
// Pictures that must be the same bit for bit: by either route, and however many tori and materials a scene
// has beyond those in view. The validation layers agree with all of it.
#include <fmt/format.h>

#include <random>
#include <set>

#include "support/program_test.hpp"

namespace raytorus::test {
namespace {

class ProgramRoutes : public ProgramTest {
protected:
    void expectIdentical(const std::string& expected, const std::string& actual) const {
        EXPECT_NE(expectOk({"compare", expected, actual}).find("The images are identical."),
                  std::string::npos)
            << expected << ", " << actual;
    }

    // By both routes, under validation. Leaves <name>.exr.
    void expectSameByBothRoutes(const std::string& scenePath, const std::string& size,
                                const std::string& name) const {
        const Arguments common = {"--size", size, "--spp", "4", "--validate"};
        for (const char* route : {"fragment", "compute"}) {
            Arguments arguments = {"render",  scenePath,
                                   "-o",      name + (*route == 'f' ? ".exr" : ".compute.exr"),
                                   "--route", route};
            arguments.insert(arguments.end(), common.begin(), common.end());
            EXPECT_EQ(expectOk(arguments), "");
        }
        expectIdentical(name + ".exr", name + ".compute.exr");
    }
};

class ProgramShippedScene : public ProgramRoutes, public testing::WithParamInterface<std::string> {};

TEST_P(ProgramShippedScene, IsTheSameByBothRoutes) {
    expectSameByBothRoutes(scene(GetParam()), "60x40", "out");
}

std::vector<std::string> shippedScenes() {
    std::vector<std::string> names;
    for (const std::string& name : namesIn(RAYTORUS_SOURCE_DIR "/scenes")) {
        if (name.ends_with(".json")) {
            names.push_back(name.substr(0, name.size() - 5));
        }
    }
    return names;
}

INSTANTIATE_TEST_SUITE_P(Scenes, ProgramShippedScene, testing::ValuesIn(shippedScenes()),
                         [](const testing::TestParamInfo<std::string>& name) { return name.param; });

// A torus in view, `others` behind the camera and below, so that they are neither seen nor between it and a
// light, and `materials` before its own, which nothing has.
std::string sceneWith(int others, int materials) {
    std::string text = R"({"camera": {"position": [1, -4, 2], "target": [0, 0, 0]}, "materials": {)";
    for (int i = 0; i < materials; ++i) {
        text += fmt::format(R"("unused{}": {{"diffuse": [0.1, 0.7, 0.05]}}, )", i);
    }
    text += R"("used": {"diffuse": [0.7, 0.1, 0.05], "checker": {"counts": [8, 4]}})";
    text += R"(}, "tori": [{"majorRadius": 1, "minorRadius": 0.25, "material": "used"})";
    for (int i = 0; i < others; ++i) {
        text += fmt::format(R"(, {{"majorRadius": 0.5, "minorRadius": 0.1, "translation": [{}, -40, {}]}})",
                            i % 30 - 15, -20 - i / 30);
    }
    return text + "]}";
}

// One torus alone needs no hierarchy; up to 512 tori and 256 materials are in uniform blocks, more in storage
// buffers.
TEST_F(ProgramRoutes, TorusLooksTheSameInAnyCompany) {
    expectSameByBothRoutes(write("alone.json", sceneWith(0, 0)), "60x40", "alone");
    for (const auto& [name, others, materials] :
         {std::tuple("other", 1, 0), std::tuple("uniform", 511, 0), std::tuple("storage", 512, 0),
          std::tuple("crowd", 600, 0), std::tuple("materials", 0, 300)}) {
        expectSameByBothRoutes(write(fmt::format("{}.json", name), sceneWith(others, materials)), "60x40",
                               name);
        expectIdentical("alone.exr", fmt::format("{}.exr", name));
    }
}

// The raw bits of the generator, so that the scene is the same everywhere.
std::string crowdedScene(int tori) {
    std::mt19937 random(20240607);
    const auto number = [&random] { return static_cast<double>(random()) / 4294967296.0 * 2.0 - 1.0; };
    std::string text = R"({"camera": {"position": [0, -4, 2], "target": [0, 0, 0]}, "tori": [)";
    for (int i = 0; i < tori; ++i) {
        text += fmt::format(
            R"({}{{"majorRadius":0.02,"minorRadius":0.005,"translation":[{},{},{}],"rotation":{{"quaternion":[{},{},{},1.5]}}}})",
            i > 0 ? "," : "", number(), number(), number(), number(), number(), number());
    }
    return text + "]}";
}

TEST_F(ProgramRoutes, HundredThousandTori) {
    constexpr int tori = 100000;
    expectSameByBothRoutes(write("crowded.json", crowdedScene(tori)), "64x64", "crowded");
    const image::Image image = picture("crowded.exr");
    std::set<float> seen;
    const auto id = static_cast<std::size_t>(image.channelIndex("id"));
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            seen.insert(image.pixel(x, y)[id]);
        }
    }
    EXPECT_EQ(*seen.begin(), -1.0F);
    EXPECT_LT(*seen.rbegin(), static_cast<float>(tori));
    // They fill a quarter of the view and more, far denser than its 4096 pixels.
    EXPECT_GT(seen.size(), 1000U);
}

}  // namespace
}  // namespace raytorus::test
