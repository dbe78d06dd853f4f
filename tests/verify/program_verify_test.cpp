// SPDX-License-Identifier: MIT
// raytorus-verify as users run it.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/error.hpp"
#include "support/patterns.hpp"
#include "support/run_program.hpp"
#include "support/scratch_folder.hpp"
#include "support/touching_rays.hpp"

namespace raytorus::test {
namespace {

using nlohmann::json;

class ProgramVerify : public testing::Test {
protected:
    [[nodiscard]] ProgramResult run(const std::vector<std::string>& arguments) const {
        return runProgram(RAYTORUS_VERIFY, arguments, {folder, {}});
    }
    // As typed in the folder of the test, with the program installed.
    [[nodiscard]] ProgramResult paste(const std::string& command) const {
        const std::string programs = std::filesystem::path(RAYTORUS_VERIFY).parent_path().string();
        return runProgram("/bin/sh", {"-c", command}, {folder, {{"PATH", programs + ":/usr/bin:/bin"}}});
    }

    void expectUsageError(const std::vector<std::string>& arguments, const std::string& sentence) const {
        const ProgramResult result = run(arguments);
        EXPECT_EQ(result.exitCode, static_cast<int>(ExitCode::Usage)) << testing::PrintToString(result);
        EXPECT_EQ(result.out, "");
        EXPECT_EQ(result.err, "raytorus-verify: " + sentence + "\n");
    }

    std::filesystem::path folder = scratchFolder();
};

TEST_F(ProgramVerify, HoldsEveryBarOnFreshRays) {
    const ProgramResult result = run({"--rays", "50", "--validate"});
    EXPECT_EQ(result.exitCode, 0) << testing::PrintToString(result);
    EXPECT_EQ(result.err, "");
    EXPECT_TRUE(result.out.starts_with("seed 20")) << result.out;
    EXPECT_TRUE(result.out.ends_with("every threshold is held\n")) << result.out;
}

TEST_F(ProgramVerify, PrintsARowForWhatItIsToldToKeepApart) {
    const auto rows = [this](const std::string& key) {
        const ProgramResult result = run({"--class", "camera,inside", "--radius", "0.1,1", "--distance",
                                          "3,10,1000", "--rays", "100", "--seed", "4", "--rows", key});
        EXPECT_EQ(result.exitCode, 0) << testing::PrintToString(result);
        std::istringstream lines(result.out);
        std::size_t count = 0;
        for (std::string line; std::getline(lines, line);) {
            count += line.starts_with("camera ") || line.starts_with("inside ") ? 1U : 0U;
        }
        return count;
    };
    EXPECT_EQ(rows("class"), 2U);
    EXPECT_EQ(rows("radius"), 4U);
    EXPECT_EQ(rows("distance"), 4U) << "inside has no distance";
    EXPECT_EQ(rows("group"), 8U);
}

TEST_F(ProgramVerify, WritesWhatItFoundAsJson) {
    const ProgramResult result = run({"--class", "camera,grazing", "--radius", "0.25", "--rays", "300",
                                      "--seed", "9", "--json", "found.json"});
    EXPECT_EQ(result.exitCode, 0) << testing::PrintToString(result);
    const json found = json::parse(fileText(folder / "found.json"));
    EXPECT_EQ(found.at("seed"), 9);
    EXPECT_EQ(found.at("method"), "raytorus");
    EXPECT_TRUE(found.at("thresholdsExceeded").empty());
    ASSERT_EQ(found.at("groups").size(), 7U + 8U);
    for (const json& group : found.at("groups")) {
        EXPECT_EQ(group.at("rays"), 300);
        EXPECT_EQ(group.at("faults").at("missed"), 0);
        std::uint64_t counted = 0;
        for (const json& bin : group.at("position").at("histogram")) {
            counted += bin.at(1).get<std::uint64_t>();
        }
        EXPECT_EQ(counted, group.at("position").at("count"));
        EXPECT_GT(counted, 0U);
        EXPECT_GE(group.at("position").at("max"), group.at("position").at("p99"));
    }
}

TEST_F(ProgramVerify, DrawsTheSameRaysForTheSameSeed) {
    const auto worst = [this](const std::string& seed) {
        EXPECT_EQ(
            run({"--class", "camera", "--rays", "100", "--seed", seed, "--json", "found.json"}).exitCode, 0);
        const json found = json::parse(fileText(folder / "found.json"));
        return found.at("groups").at(0).at("t").at("worst").get<std::string>();
    };
    const std::string first = worst("31");
    EXPECT_EQ(worst("31"), first);
    EXPECT_NE(worst("32"), first);
}

TEST_F(ProgramVerify, SeesEveryKindOfFault) {
    const ProgramResult result =
        run({"--class", "camera", "--radius", "0.5", "--distance", "3", "--rays", "2000", "--seed", "1",
             "--shaders", RAYTORUS_DEFECTIVE_SHADER_FOLDER, "--json", "found.json"});
    EXPECT_EQ(result.exitCode, static_cast<int>(ExitCode::ComparisonFailed))
        << testing::PrintToString(result);
    EXPECT_NE(result.out.find("camera r/R 0.5 D/R 3: "), std::string::npos) << result.out;
    EXPECT_NE(result.out.find(" of 1"), std::string::npos) << result.out;
    const json faults = json::parse(fileText(folder / "found.json")).at("groups").at(0).at("faults");
    EXPECT_EQ(faults.size(), 7U);
    for (const auto& [name, count] : faults.items()) {
        EXPECT_GT(count, 10) << name;
    }
}

TEST_F(ProgramVerify, ReplaysWhatItFaulted) {
    const std::string defective = "it's; touch PWNED";
    std::filesystem::copy(RAYTORUS_DEFECTIVE_SHADER_FOLDER, folder / defective);
    const ProgramResult all =
        run({"--class", "camera", "--radius", "0.5", "--distance", "3", "--rays", "300", "--shaders",
             defective, "--device", "llvmpipe (LLVM", "--timeout", "60", "--json", "found.json"});
    const auto replays = matchesIn(all.out, R"re(  (\S+): (raytorus-verify .* --replay "([^"]*)"))re");
    const json examples = json::parse(fileText(folder / "found.json")).at("groups").at(0).at("examples");
    EXPECT_EQ(examples.at(0).at("replay"), replays.at(0)[2]);
    for (const PatternMatch& replay : replays) {
        // Without the shaders, the ray is judged right.
        const ProgramResult one = paste(replay[2]);
        EXPECT_FALSE(std::filesystem::exists(folder / "PWNED")) << replay[2];
        EXPECT_EQ(one.exitCode, static_cast<int>(ExitCode::ComparisonFailed));
        EXPECT_TRUE(one.out.ends_with("verdict: " + replay[1] + "\n")) << one.out;
        const ProgramResult right = run({"--replay", replay[3]});
        EXPECT_EQ(right.exitCode, 0) << right.out;
        EXPECT_TRUE(right.out.ends_with("verdict: right\n")) << right.out;
    }
    EXPECT_EQ(replays.size(), 5U) << all.out;
}

TEST_F(ProgramVerify, ReplayShowsTruthAndAnswers) {
    const ProgramResult result =
        run({"--replay", "0x1p+0 0x1p-2  -0x1.8p+1 0x0p+0 0x0p+0 0x0p+0  0x1p+0 0x0p+0 0x0p+0 inf"});
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_NE(result.out.find("truth: 4 hit(s)\n  t 1.75 at (-1.25, 0, 0), entering\n"), std::string::npos)
        << result.out;
    EXPECT_NE(result.out.find("  t 1.75 at (-1.25, 0, 0); off by 0 (R + r), 0 ulp of t;"), std::string::npos)
        << result.out;
    EXPECT_NE(result.out.find("torusOccluded: yes\n"), std::string::npos);
}

TEST_F(ProgramVerify, ExplainsWrongArguments) {
    expectUsageError(
        {"--class", "cameras"},
        "--class: there is no class \"cameras\" (there are camera inside hole equatorial axisParallel "
        "throughAxis throughCentre leaving axisAligned nonUnit grazing segment topCircle dimpleCone "
        "hornTip)");
    expectUsageError({"--rows", "rows"}, "--rows is class, radius, distance or group, not \"rows\"");
    expectUsageError({"--seed", "-1"}, "--seed is a whole number below 2^64, or today, not \"-1\"");
    expectUsageError({"--radius", "0"},
                     "--radius: \"0\" is no number from 1e-07 to 10000 (see raytorus-verify --help)");
    expectUsageError({"--distance", "nan"},
                     "--distance: \"nan\" is no number from 1 to 1000000000000 (see raytorus-verify --help)");
    expectUsageError({"--replay", "1 0.25 0"},
                     "--replay takes ten numbers: R r, origin, tMin, direction, tMax; not \"1 0.25 0\"");
}

// Whoever runs several programs in one terminal has to see which one the layers speak of.
TEST_F(ProgramVerify, SpeaksInItsOwnName) {
    const ProgramResult result = run({"--replay", "1 0.25  -3 0 0 0  1 0 0 10", "--shaders",
                                      RAYTORUS_INVALID_SHADER_FOLDER, "--validate"});
    EXPECT_EQ(result.exitCode, static_cast<int>(ExitCode::ValidationMessage))
        << testing::PrintToString(result);
    EXPECT_TRUE(result.err.starts_with("raytorus-verify: ")) << result.err;
    EXPECT_NE(result.err.find("VUID-"), std::string::npos) << result.err;
    EXPECT_EQ(result.err.find("raytorus: "), std::string::npos) << result.err;
}

TEST_F(ProgramVerify, RefusesAFileItCannotWriteBeforeTheWork) {
    const ProgramResult result = run({"--json", "nowhere/found.json", "--rays", "1000000000"});
    EXPECT_EQ(result.exitCode, static_cast<int>(ExitCode::File)) << testing::PrintToString(result);
    EXPECT_NE(result.err.find("nowhere/found.json"), std::string::npos) << result.err;
}

// The words of a command line, where quotes keep words together; the number of rays is made small.
std::vector<std::string> wordsOf(const std::string& line) {
    std::vector<std::string> words;
    for (const PatternMatch& word : matchesIn(line, R"re("([^"]*)"|(\S+))re")) {
        words.push_back(word[1] + word[2]);
    }
    const auto rays = std::find(words.begin(), words.end(), "--rays");
    if (rays != words.end()) {
        *(rays + 1) = "50";
    } else {
        words.insert(words.end(), {"--rays", "50"});
    }
    return words;
}

TEST_F(ProgramVerify, HelpsWithExamplesThatWork) {
    const ProgramResult help = run({"--help"});
    EXPECT_EQ(help.exitCode, 0);
    EXPECT_EQ(run({"--version"}).out.substr(0, 16), "raytorus-verify ");
    const std::string examples = help.out.substr(help.out.find("Examples:\n"));
    // Each stands in docs/cli.md too, some with a remark behind it.
    const std::string page = fileText(RAYTORUS_SOURCE_DIR "/docs/cli.md");
    const auto commands = matchesIn(examples, R"re(\n  (raytorus-verify.*))re");
    EXPECT_GE(commands.size(), 5U);
    for (const PatternMatch& command : commands) {
        const std::string& line = command[1];
        EXPECT_NE(page.find("\n$ " + line), std::string::npos) << line;
        std::vector<std::string> words = wordsOf(line);
        words.erase(words.begin());
        EXPECT_EQ(run(words).exitCode, 0) << line;
    }
}

TEST_F(ProgramVerify, ReplaysTouchingRaysWithBothHitsOrNeither) {
    for (const char* ray : touchingRays) {
        const ProgramResult result = run({"--replay", ray});
        EXPECT_EQ(result.exitCode, 0) << testing::PrintToString(result);
        EXPECT_TRUE(result.out.ends_with("verdict: right\n")) << result.out;
    }
}

TEST_F(ProgramVerify, OtherMethodsHavePromisedNothing) {
    const ProgramResult result =
        run({"--method", "closed-form-naive", "--class", "camera", "--distance", "1000", "--rays", "100"});
    EXPECT_EQ(result.exitCode, 0) << testing::PrintToString(result);
    EXPECT_EQ(result.out.find("replay"), std::string::npos);
    expectUsageError(
        {"--method", "magic"},
        "--method: there is no method \"magic\" (there are raytorus raytorus-fast bracketed-newton "
        "closed-form closed-form-common closed-form-naive closed-form-polished "
        "sphere-tracing sphere-tracing-exact)");
}

}  // namespace
}  // namespace raytorus::test
