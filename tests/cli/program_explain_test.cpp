// SPDX-License-Identifier: MIT
// raytorus explain: its options, its three outputs, and that bad numbers are explained while bad text is
// refused.
#include <nlohmann/json.hpp>

#include "support/program_test.hpp"
#include "support/touching_rays.hpp"

namespace raytorus::test {
namespace {

using nlohmann::json;

class ProgramExplain : public ProgramTest {
protected:
    static Arguments explain(Arguments more = {}) {
        Arguments arguments = {"explain",    "--torus",     "1,0.25", "--origin",
                               "-3,0.5,0.1", "--direction", "1,0,0"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return arguments;
    }
};

TEST_F(ProgramExplain, TheLastLineIsTheConclusion) {
    const std::string out = expectOk(explain());
    const std::string last = out.substr(out.rfind('\n', out.size() - 2) + 1);
    EXPECT_TRUE(last.starts_with("the library is right: 4 hits, t off by at most 0.")) << last;
    EXPECT_NE(out.find("  passes the centre at 0.509902 R, the axis at 0.5 R\n"), std::string::npos);
    EXPECT_NE(out.find("\n  alpha "), std::string::npos);
}

TEST_F(ProgramExplain, JsonSaysTheSame) {
    const json parsed = json::parse(expectOk(explain({"--json"})));
    EXPECT_EQ(parsed["roots"].size(), 4U);
    EXPECT_TRUE(expectOk(explain()).ends_with("\n" + parsed["conclusion"].get<std::string>() + "\n"));
    // What cannot be told from the JSON is asked again by its own line.
    EXPECT_EQ(expectOk({"explain", "--replay", parsed["replay"]}), expectOk(explain()));
}

// What is explained is what was drawn, to the bit.
TEST_F(ProgramExplain, APixelIsTheRayThatWasDrawn) {
    const std::string links = RAYTORUS_SOURCE_DIR "/golden/scenes/links.json";
    expectOk({"render", links, "-o", "links.exr", "--size", "60x40"});
    const image::Image drawn = picture("links.exr");
    int hits = 0;
    for (const auto& [x, y] : {std::pair(26, 19), std::pair(18, 21), std::pair(40, 25), std::pair(0, 39)}) {
        const Arguments pixel = {"explain",
                                 "--scene",
                                 links,
                                 "--size",
                                 "60x40",
                                 "--pixel",
                                 std::to_string(x) + "," + std::to_string(y)};
        const std::string text = expectOk(pixel);
        const auto value = [&drawn, x = x, y = y](const char* channel) {
            return drawn.pixel(x, y)[static_cast<std::size_t>(drawn.channelIndex(channel))];
        };
        const bool hit = value("id") >= 0.0F;
        hits += hit ? 1 : 0;
        EXPECT_EQ(text.find("which the ray hits first") != std::string::npos, hit) << text;
        Arguments asJson = pixel;
        asJson.emplace_back("--json");
        const json parsed = json::parse(expectOk(asJson));
        EXPECT_EQ(parsed["right"], true);
        if (hit) {
            EXPECT_NE(text.find("torus " + std::to_string(static_cast<int>(value("id"))) + ","),
                      std::string::npos);
            EXPECT_EQ(parsed["torusIntersect"]["t"]["float32"].get<float>(), value("t"));
        }
    }
    EXPECT_EQ(hits, 2) << "the pixels show too little";
}

TEST_F(ProgramExplain, APixelLiesInThePicture) {
    const std::string scenePath = write("scene.json", smallScene);
    for (const char* pixel : {"24,0", "0,16", "-1,0", "1.5,2", "1", "x,y"}) {
        expectFailure({"explain", "--scene", "scene.json", "--pixel", pixel}, ExitCode::Usage,
                      {"--pixel", "23,15", std::string("\"") + pixel + "\""});
    }
    expectFailure({"explain", "--scene", "scene.json"}, ExitCode::Usage, {"--pixel"});
    expectFailure({"explain", "--pixel", "1,1"}, ExitCode::Usage, {"--scene"});
    expectFailure({"explain", "--scene", "none.json", "--pixel", "1,1"}, ExitCode::File, {"none.json"});
    expectFailure({"explain", "--scene", "scene.json", "--pixel", "1,1", "--torus", "1,0.5"}, ExitCode::Usage,
                  {"--torus"});
    expectFailure({"explain", "--scene", "scene.json", "--pixel", "1,1", "--size", "0x1"}, ExitCode::Usage,
                  {"--size", "\"0x1\""});
}

TEST_F(ProgramExplain, TheEndsOfTheRayCount) {
    const json parsed = json::parse(expectOk(explain({"--t-min", "2", "--t-max", "3", "--json"})));
    EXPECT_EQ(parsed["torusIntersectAll"]["found"], 1);
    EXPECT_EQ(parsed["roots"][0]["place"], "before");
    EXPECT_EQ(parsed["roots"][1]["place"], "within");
    EXPECT_EQ(parsed["roots"][3]["place"], "beyond");
}

TEST_F(ProgramExplain, SvgIsWrittenBesideTheText) {
    EXPECT_EQ(expectOk(explain({"--svg", "ray.svg"})), expectOk(explain()));
    EXPECT_TRUE(fileText(folder / "ray.svg").starts_with("<svg xmlns="));
    expectFailure(explain({"--svg", "missing/ray.svg"}), ExitCode::File, {"missing/ray.svg"}, noDriver());
}

// Made by the command below it in docs/math.md.
TEST_F(ProgramExplain, TheFigureOfTheDerivationIsCurrent) {
    const std::string page = fileText(RAYTORUS_SOURCE_DIR "/docs/math.md");
    const std::string command =
        "raytorus explain --torus 1,0.35 --origin -2,0.4,0.45 --direction 1,0,-0.2 --svg ";
    EXPECT_NE(page.find(command + "docs/images/math-ray.svg\n"), std::string::npos);
    expectOk({"explain", "--torus", "1,0.35", "--origin", "-2,0.4,0.45", "--direction", "1,0,-0.2", "--svg",
              "math-ray.svg"});
    EXPECT_TRUE(fileText(folder / "math-ray.svg") ==
                fileText(RAYTORUS_SOURCE_DIR "/docs/images/math-ray.svg"))
        << "make it again";
}

TEST_F(ProgramExplain, TouchingRaysAreRightWithBothHitsOrNeither) {
    for (const char* ray : touchingRays) {
        const std::string told = expectOk({"explain", "--replay", ray, "--json"});
        EXPECT_TRUE(json::parse(told)["right"]) << told;
        const std::string text = expectOk({"explain", "--replay", ray});
        EXPECT_EQ(text.find("the library invents"), std::string::npos) << text;
        EXPECT_EQ(text.find("the library misses"), std::string::npos) << text;
    }
}

TEST_F(ProgramExplain, BadNumbersAreExplained) {
    const std::string out = expectOk(
        {"explain", "--torus", "-1,0", "--origin", "-inf,nan,0", "--direction", "0,0,0", "--t-min", "nan"});
    for (const char* words : {"R = -1 is negative", "r = 0 is not positive", "the origin is not finite",
                              "the direction is zero", "tMin or tMax is no number", "bad input"}) {
        EXPECT_NE(out.find(words), std::string::npos) << words;
    }
    EXPECT_TRUE(out.ends_with("\nthe library is right: no hit for bad input\n"));
    const std::string replayed =
        expectOk({"explain", "--replay", "nan -0x1p+0 0 0 0 0 0 0 0 -inf", "--json"});
    EXPECT_TRUE(json::parse(replayed)["right"]);
}

TEST_F(ProgramExplain, BadTextIsRefused) {
    const auto refuse = [this](const Arguments& arguments, const std::vector<std::string>& words) {
        expectFailure(arguments, ExitCode::Usage, words, noDriver());
    };
    refuse({"explain"}, {"--torus is required, or --replay"});
    refuse({"explain", "--torus", "1,0.25", "--origin", "1,0,0"}, {"--direction is required"});
    refuse({"explain", "--torus", "1", "--origin", "1,0,0", "--direction", "1,0,0"},
           {"--torus", "R,r", "\"1\""});
    refuse({"explain", "--torus", "1,2", "--origin", "1,0", "--direction", "1,0,0"},
           {"--origin takes a point as x,y,z, not \"1,0\""});
    refuse({"explain", "--torus", "1,2", "--origin", "1,0,0", "--direction", "1,0,0,0"},
           {"--direction", "\"1,0,0,0\""});
    refuse(explain({"--t-max", "far"}), {"--t-max takes a number, not \"far\""});
    refuse(explain({"--t-min", ""}), {"--t-min is given, and is empty"});
    refuse({"explain", "--replay", "1 2 3"}, {"--replay takes ten numbers", "\"1 2 3\""});
    refuse(explain({"--replay", "1 .25 -3 0 0 0 1 0 0 inf"}), {"--replay", "--torus"});
    refuse(explain({"more"}), {"\"more\" is one argument too many"});
}

TEST_F(ProgramExplain, TheShaderCanBeReplacedButNotBeMissing) {
    const std::filesystem::path shaders = shaderFolder();
    EXPECT_EQ(expectOk(explain({"--shaders", shaders.string()})), expectOk(explain()));
    std::filesystem::remove(shaders / "explain.comp.spv");
    expectFailure(explain({"--shaders", shaders.string()}), ExitCode::File, {"explain.comp.spv"});
}

// The validation layers have nothing to say.
TEST_F(ProgramExplain, Validates) {
    EXPECT_EQ(expectOk(explain({"--validate"})), expectOk(explain()));
}

}  // namespace
}  // namespace raytorus::test
