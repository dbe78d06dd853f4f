// SPDX-License-Identifier: MIT
// That a mutation run can be believed: its table fits the shaders, its unchanged shaders are those of the
// build and pass, its faults are caught, and what is stale or does not compile ends it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "core/file.hpp"
#include "mutate/mutant.hpp"
#include "mutate/mutation_run.hpp"
#include "support/expect_error.hpp"
#include "support/run_program.hpp"
#include "support/scratch_folder.hpp"

namespace raytorus::mutate {
namespace {

Mutation mutationCalled(const std::string& name) {
    for (const Mutation& mutation : allMutations()) {
        if (name == mutation.name) {
            return mutation;
        }
    }
    throw Error(ExitCode::Internal, "no mutation is called " + name);
}

RunOptions optionsOfTest() {
    RunOptions options;
    options.folder = test::scratchFolder();
    options.device.validate = true;
    options.rays.perGroup = 50;
    return options;
}

TEST(Mutations, FitTheShaders) {
    EXPECT_GE(allMutations().size(), 48U);
    std::set<std::string> names;
    for (const Mutation& mutation : allMutations()) {
        EXPECT_TRUE(names.insert(mutation.name).second) << mutation.name << " is there twice";
        const std::string text =
            readTextFile(std::filesystem::path(RAYTORUS_SOURCE_DIR) / "shaders" / mutation.file);
        EXPECT_NO_THROW(EXPECT_NE(mutated(mutation, text), text)) << mutation.name;
    }
}

TEST(Mutations, ThatAreStaleEndTheRun) {
    const Mutation mutation{"stale", "shade.glsl", "no such text", "", ""};
    test::expectError([&mutation] { mutated(mutation, "text"); }, ExitCode::Internal,
                      {"mutation stale: shaders/shade.glsl has \"no such text\" 0 times, the table says 1"});
    EXPECT_EQ(mutated({"twice", "", "a", "aa", "", Shows::InPictures, 2}, "abab"), "aabaab");
    GoldenSuite goldens;
    test::expectError([&] { runMutations(std::span(&mutation, 1), goldens, optionsOfTest()); },
                      ExitCode::Internal, {"mutation stale"});
}

TEST(Mutations, ThatDoNotCompileEndTheRun) {
    const Mutation mutation{"broken", "shade.glsl", "vec4(mean, 1.0)", "vec4(mean)", ""};
    GoldenSuite goldens;
    test::expectError([&] { runMutations(std::span(&mutation, 1), goldens, optionsOfTest()); },
                      ExitCode::Shader, {"mutation broken: scene.frag does not compile", "shade.glsl:"});
}

TEST(Mutations, ThatChangeNoShaderEndTheRun) {
    const Mutation mutation{"comment", "shade.glsl", "// SPDX", "// spdx", ""};
    GoldenSuite goldens;
    test::expectError([&] { runMutations(std::span(&mutation, 1), goldens, optionsOfTest()); },
                      ExitCode::Internal, {"mutation comment: no shader that a suite runs is changed"});
}

TEST(Mutations, NoneLeavesTheBuildsOwnShaders) {
    const Mutant unchanged(nullptr, test::scratchFolder());
    for (const char* shader : {"fullscreen.vert", "scene.frag", "scene.comp", "trace.comp", "probe.comp"}) {
        EXPECT_FALSE(unchanged.changes(shader)) << shader;
    }
    EXPECT_FALSE(unchanged.changesFast());
}

// The goldens' own tests show the same of the built-in shaders, which are the unchanged ones.
TEST(Mutations, NoneIsCaughtByNumbers) {
    const RunOptions options = optionsOfTest();
    const Mutant unchanged(nullptr, options.folder);
    const auto log = std::make_shared<gpu::ValidationLog>();
    gpu::Context context(options.device, log);
    EXPECT_EQ(caughtByNumbers(context, unchanged, options.rays), std::nullopt);
    EXPECT_TRUE(log->messages().empty());
}

TEST(Mutations, AreCaughtWhereTheyShow) {
    const std::vector<Mutation> mutations = {
        mutationCalled("camera-upside-down"), mutationCalled("second-dip-forgotten"),
        mutationCalled("tangent-sign"), mutationCalled("fast-side-kept")};
    GoldenSuite goldens;
    const std::vector<Outcome> outcomes = runMutations(mutations, goldens, optionsOfTest());
    ASSERT_EQ(outcomes.size(), 4U);
    EXPECT_TRUE(outcomes[0].goldens.caught);
    EXPECT_FALSE(outcomes[0].numbers.caught) << "rays have no camera, and the positions are on the torus";
    EXPECT_TRUE(outcomes[1].goldens.caught);
    EXPECT_TRUE(outcomes[1].numbers.caught);
    EXPECT_FALSE(outcomes[2].goldens.asked) << "no picture uses tangents";
    EXPECT_TRUE(outcomes[2].numbers.caught);
    EXPECT_TRUE(outcomes[3].numbers.caught.value_or("nothing").starts_with("fast "))
        << "the exact tier does not have this file";
}

Outcome outcome(Shows shows, bool goldens, bool numbers) {
    Outcome result;
    result.mutation.name = "some";
    result.mutation.shows = shows;
    result.goldens = {shows == Shows::InPictures, goldens ? std::optional("ring_compute") : std::nullopt};
    result.numbers = {true, numbers ? std::optional("uv: is off") : std::nullopt};
    return result;
}

TEST(MutationThreshold, IsHeldFrom95PercentByGoldensAndAllByBoth) {
    std::vector<Outcome> outcomes(19, outcome(Shows::InPictures, true, false));
    outcomes.push_back(outcome(Shows::InPictures, false, true));
    outcomes.push_back(outcome(Shows::InNumbers, false, true));
    EXPECT_TRUE(totalsOf(outcomes).thresholdHeld());
    outcomes.front() = outcome(Shows::InPictures, false, true);
    EXPECT_FALSE(totalsOf(outcomes).thresholdHeld()) << "18 of 20 by goldens";
    outcomes.front() = outcome(Shows::InPictures, true, false);
    outcomes.push_back(outcome(Shows::InNumbers, false, false));
    EXPECT_FALSE(totalsOf(outcomes).thresholdHeld()) << "one survives";
    EXPECT_TRUE(rowText(outcomes.back()).ends_with("SURVIVED\n")) << rowText(outcomes.back());
    EXPECT_EQ(nlohmann::json::parse(outcomesJson(outcomes)).at("totals").at("caught"), 21);
}

TEST(ProgramMutate, AnswersAsDocumented) {
    const auto run = [](const std::vector<std::string>& arguments) {
        return test::runProgram(RAYTORUS_MUTATE, arguments);
    };
    EXPECT_NE(run({"--list"}).out.find("lift-missing"), std::string::npos);
    const test::ProgramResult unknown = run({"--only", "nothing"});
    EXPECT_EQ(unknown.exitCode, static_cast<int>(ExitCode::Usage));
    EXPECT_EQ(unknown.err,
              "raytorus-mutate: no mutation is called \"nothing\" (see raytorus-mutate --list)\n");
    const test::ProgramResult found = run({"--only", "fragment-next-pixel"});
    EXPECT_EQ(found.exitCode, 0) << testing::PrintToString(found);
    EXPECT_TRUE(found.out.ends_with("the threshold is held\n")) << found.out;
    const test::ProgramResult missed = run({"--only", "far-move-rounded", "--rays", "1"});
    EXPECT_EQ(missed.exitCode, static_cast<int>(ExitCode::ComparisonFailed)) << "one ray a group is too few";
    EXPECT_TRUE(missed.out.ends_with("the threshold is missed\n")) << missed.out;
}

}  // namespace
}  // namespace raytorus::mutate
