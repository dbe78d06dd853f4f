// SPDX-License-Identifier: MIT
// --method: the pictures and hits of the methods that the library is compared with.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "methods/methods.hpp"
#include "support/program_test.hpp"

namespace raytorus::test {
namespace {

class ProgramMethod : public ProgramTest {
protected:
    // A row of rays across a ring from a thousand radii away, where the quartic in world space has lost it.
    [[nodiscard]] std::string trace(const Arguments& options) const {
        std::string rays;
        for (int i = -20; i <= 20; ++i) {
            rays += fmt::format("{},-1000,30,0,0,1,-0.03,inf\n", 0.07 * i);
        }
        write("rays.csv", rays);
        Arguments arguments = {"trace", "rays.csv", "-o", "hits.csv", "--torus", "1,0.25"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        EXPECT_EQ(expectOk(arguments), "");
        return fileText(folder / "hits.csv");
    }
};

TEST_F(ProgramMethod, RaytorusIsWhatAnswersWithoutTheOption) {
    EXPECT_EQ(trace({"--method", "raytorus"}), trace({}));
    EXPECT_EQ(trace({"--method", "raytorus", "--shaders", RAYTORUS_SHADER_FOLDER}), trace({}));
}

TEST_F(ProgramMethod, EachOtherOneTracesAndRenders) {
    write("scene.json", smallScene);
    for (const Method& method : methods()) {
        SCOPED_TRACE(method.name);
        EXPECT_EQ(expectOk({"render", "scene.json", "-o", "out.exr", "--method", method.name, "--validate"}),
                  "");
        EXPECT_EQ(picture("out.exr").width, 24);
        for (const char* query : {"--all", "--any"}) {
            EXPECT_NE(trace({query, "--method", method.name, "--validate"}), "");
        }
    }
}

TEST_F(ProgramMethod, AnswersDifferWhereAMethodFails) {
    const std::string library = trace({});
    EXPECT_NE(trace({"--method", "closed-form-naive"}), library);
    write("far.json",
          R"({"camera": {"position": [0, -1000, 30], "target": [0, 0, 0], "verticalFieldOfView": 0.2},
                         "image": {"width": 48, "height": 32}, "tori": [{"majorRadius": 1, "minorRadius": 0.25}]})");
    for (const char* method : {"raytorus", "closed-form-naive"}) {
        EXPECT_EQ(expectOk({"render", "far.json", "-o", fmt::format("{}.exr", method), "--method", method}),
                  "");
    }
    EXPECT_NE(picture("raytorus.exr").pixels, picture("closed-form-naive.exr").pixels);
}

TEST_F(ProgramMethod, TheReferenceNeedsNoDevice) {
    write("scene.json", smallScene);
    EXPECT_EQ(expectOk({"render", "scene.json", "-o", "exact.exr", "--method", "reference"}, noDriver()), "");
    EXPECT_EQ(expectOk({"render", "scene.json", "-o", "drawn.exr"}), "");
    // t is 3 to 6 here and rays are off by some 1e-6; normals and colours change twice to ten times as fast.
    EXPECT_NE(expectOk({"compare", "exact.exr", "drawn.exr", "--tolerance", "3e-5"}).find("agree"),
              std::string::npos);

    // The hits of the ray as given: the library's are off by half an ulp and what it promises beyond that.
    for (const Arguments& query : {Arguments{}, Arguments{"--all"}, Arguments{"--any"}}) {
        const std::vector<float> drawn = numbersIn(trace(query));
        Arguments arguments = {"trace",   "rays.csv", "-o",       "hits.csv",
                               "--torus", "1,0.25",   "--method", "reference"};
        arguments.insert(arguments.end(), query.begin(), query.end());
        EXPECT_EQ(expectOk(arguments, noDriver()), "");
        const std::vector<float> exact = numbersIn(fileText(folder / "hits.csv"));
        ASSERT_EQ(exact.size(), drawn.size());
        for (std::size_t i = 0; i < exact.size(); ++i) {
            EXPECT_TRUE(exact[i] == drawn[i] ||
                        std::abs(exact[i] - drawn[i]) <= 2e-7F * std::max(1.0F, exact[i]))
                << i << ": " << exact[i] << ", " << drawn[i];
        }
    }
}

TEST_F(ProgramMethod, TheReferenceTakesNothingThatIsADevices) {
    write("scene.json", smallScene);
    for (const Arguments& options :
         {Arguments{"--validate"}, Arguments{"--device", "0"}, Arguments{"--stats", "json"},
          Arguments{"--shaders", RAYTORUS_SHADER_FOLDER}}) {
        Arguments arguments = {"render", "scene.json", "-o", "out.exr", "--method", "reference"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        expectFailure(arguments, ExitCode::Usage, {"--method reference", options[0]});
    }
}

TEST_F(ProgramMethod, UnknownOnesAreRefusedBeforeAnythingIsDone) {
    write("scene.json", smallScene);
    const std::vector<std::string> words = {"--method", "\"magic\"", "closed-form"};
    expectFailure({"render", "scene.json", "-o", "out.exr", "--method", "magic"}, ExitCode::Usage, words);
    write("rays.csv", "3,0,0,0,-1,0,0,inf\n");
    expectFailure({"trace", "rays.csv", "-o", "hits.csv", "--torus", "1,0.25", "--method", "magic"},
                  ExitCode::Usage, words);
}

TEST_F(ProgramMethod, OfShadersOfTheUsersThereIsOneMethod) {
    write("scene.json", smallScene);
    expectFailure({"render", "scene.json", "-o", "out.exr", "--method", "closed-form", "--shaders",
                   RAYTORUS_SHADER_FOLDER},
                  ExitCode::Usage, {"--shaders", "--method closed-form"});
}

}  // namespace
}  // namespace raytorus::test
