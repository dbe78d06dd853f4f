// SPDX-License-Identifier: MIT
// raytorus-bench as users run it. How fast anything was is nowhere asked.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "bench/timed_method.hpp"
#include "core/error.hpp"
#include "support/patterns.hpp"
#include "support/run_program.hpp"
#include "support/scratch_folder.hpp"

namespace raytorus::test {
namespace {

using nlohmann::json;
using Arguments = std::vector<std::string>;

// The smallest of everything.
const Arguments small{
    "--workload", "scattered/0.25/near/30", "--method", "closed-form-common", "--rays", "4096", "--rounds",
    "2"};

Arguments operator+(Arguments first, const Arguments& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

class ProgramBench : public testing::Test {
protected:
    [[nodiscard]] ProgramResult run(const Arguments& arguments, const Environment& environment = {}) const {
        ProgramSettings settings;
        settings.folder = folder;
        settings.environment = environment;
        settings.timeLimit = std::chrono::seconds(280);
        return runProgram(RAYTORUS_BENCH, arguments, settings);
    }

    std::string expectOk(const Arguments& arguments) const {
        const ProgramResult result = run(arguments);
        EXPECT_EQ(result.exitCode, 0) << testing::PrintToString(result);
        EXPECT_EQ(result.err, "");
        return result.out;
    }

    void expectError(const Arguments& arguments, ExitCode code, const std::string& sentence) const {
        const ProgramResult result = run(arguments);
        EXPECT_EQ(result.exitCode, static_cast<int>(code)) << testing::PrintToString(result);
        EXPECT_EQ(result.out, "");
        EXPECT_EQ(result.err, "raytorus-bench: " + sentence + "\n");
    }

    [[nodiscard]] json table(const std::string& name) const { return json::parse(fileText(folder / name)); }

    std::filesystem::path folder = scratchFolder();
};

TEST_F(ProgramBench, VerifiesAndTimesWhatItIsToldTo) {
    const std::string out = expectOk(small + Arguments{"--query", "nearest,all", "--seed", "5", "--validate",
                                                       "--json", "now.json", "--html", "now.html"});
    EXPECT_NE(out.find("seed 5, 2 rounds\n"), std::string::npos) << out;
    EXPECT_NE(out.find("\nscattered/0.25/near/30 nearest: "), std::string::npos) << out;
    EXPECT_NE(out.find("\nscattered/0.25/near/30 all: "), std::string::npos) << out;
    EXPECT_EQ(out.find("/30 any: "), std::string::npos) << out;
    const json now = table("now.json");
    EXPECT_EQ(now.at("seed"), 5);
    EXPECT_NE(out.find(now.at("machine").at("device").get<std::string>()), std::string::npos);
    ASSERT_EQ(now.at("cells").size(), 2U);
    for (const json& cell : now.at("cells")) {
        EXPECT_EQ(cell.at("rays"), 4096);
        EXPECT_NEAR(cell.at("hitPart").get<double>(), 0.3, 0.02);
        ASSERT_EQ(cell.at("methods").size(), 3U) << "empty, the library and the one named";
        for (const auto& [name, method] : cell.at("methods").items()) {
            EXPECT_EQ(method.at("checksumHeld"), true) << name;
        }
        const json& ours = cell.at("methods").at("raytorus");
        EXPECT_GT(ours.at("judged"), 3500);
        EXPECT_EQ(ours.at("wrong"), 0);
        EXPECT_EQ(ours.at("gross"), 0);
    }
    EXPECT_NE(fileText(folder / "now.html").find("</html>"), std::string::npos);
}

// float64 among them, where the device has it; the others are RunsEveryMethod's.
TEST_F(ProgramBench, RunsFloat64OrSaysWhyNot) {
    const std::string out = expectOk({"--workload", "scattered/0.25/far/50", "--method", "float64-quartic",
                                      "--rays", "4096", "--rounds", "1", "--validate", "--json", "now.json"});
    const json cells = table("now.json").at("cells");
    ASSERT_EQ(cells.size(), 3U);
    for (const json& cell : cells) {
        const bool present = cell.at("methods").contains("float64-quartic");
        EXPECT_NE(present, out.find("float64-quartic is left out: ") != std::string::npos) << out;
        if (present) {
            const json& method = cell.at("methods").at("float64-quartic");
            EXPECT_EQ(method.at("wrong"), 0) << "clear rays from 1000 R are no trouble in doubles";
            EXPECT_EQ(method.at("gross"), 0);
        }
    }
}

TEST_F(ProgramBench, StreamsToo) {
    const std::string out =
        expectOk({"--workload", "stream-tiles/*", "--method", "ray-sphere", "--rays", "4096", "--rounds", "1",
                  "--query", "nearest,any", "--validate", "--json", "now.json"});
    EXPECT_NE(out.find("\nstream-tiles/0.25/near/30 nearest: "), std::string::npos) << out;
    const json now = table("now.json");
    for (const json& cell : now.at("cells")) {
        EXPECT_EQ(cell.at("methods").at("raytorus").at("layers"), 16) << "copies";
        EXPECT_EQ(cell.at("methods").at("raytorus").at("wrong"), 0);
        EXPECT_GT(cell.at("methods").at("ray-sphere").at("wrong"), 100);
    }
}

// The same seed, the same rays, the same faults.
TEST_F(ProgramBench, DrawsTheSameRaysForTheSameSeed) {
    const auto found = [this](const Arguments& seed) {
        expectOk(Arguments{"--workload", "scattered/0.01/far/50", "--method", "closed-form-common", "--rays",
                           "4096", "--rounds", "1", "--query", "nearest", "--json", "now.json"} +
                 seed);
        const json cell = table("now.json").at("cells").at(0);
        const json& method = cell.at("methods").at("closed-form-common");
        return std::tuple(cell.at("hitPart").get<double>(), method.at("wrong").get<int>(),
                          method.at("gross").get<int>());
    };
    const auto first = found({"--seed", "31"});
    EXPECT_GT(std::get<1>(first), 100) << "from there the closed form is lost";
    EXPECT_EQ(found({"--seed", "31"}), first);
    EXPECT_NE(found({"--seed", "32"}), first);
    EXPECT_NE(found({}), first) << "a fresh seed";
}

TEST_F(ProgramBench, ComparesItselfWithATable) {
    // A method that takes ten times as long as making the rays: less than nothing is left of no busy
    // machine's time for it, and a cell without a net time cannot be compared.
    const Arguments all = {"--workload", "scattered/0.25/near/30",
                           "--method",   "sphere-tracing",
                           "--rays",     "4096",
                           "--rounds",   "2",
                           "--query",    "all"};
    expectOk(all + Arguments{"--json", "then.json"});
    const std::string out = expectOk(all + Arguments{"--against", "then.json"});
    EXPECT_NE(out.find("\nagainst then.json\n"), std::string::npos) << out;
    EXPECT_NE(out.find(" of 1 ratios left their spread\n"), std::string::npos) << out;

    // However much slower it may look: a time is no failure.
    json then = table("then.json");
    json& method = then["cells"][0]["methods"]["sphere-tracing"];
    method["quartiles"] = {0.001, 0.001, 0.001};
    method["ratio"] = 0.001;
    writeText(folder / "then.json", then.dump());
    EXPECT_NE(expectOk(all + Arguments{"--against", "then.json"}).find("1 of 1 ratios left their spread\n"),
              std::string::npos);
}

TEST_F(ProgramBench, RefusesWhatIsNoTableBeforeTheWork) {
    writeText(folder / "other.json", "{\"format\": \"raytorus-bench\", \"version\": 99}");
    expectError({"--against", "other.json"}, ExitCode::File,
                "other.json: this table has version 99 of the format, and 1 is wanted");
    writeText(folder / "other.json", "{}");
    expectError({"--against", "other.json"}, ExitCode::File,
                "other.json: this is no table that raytorus-bench --json has written");
    const ProgramResult unwritable = run({"--json", "nowhere/now.json"});
    EXPECT_EQ(unwritable.exitCode, static_cast<int>(ExitCode::File));
    EXPECT_NE(unwritable.err.find("nowhere/now.json"), std::string::npos) << unwritable.err;
}

TEST_F(ProgramBench, ExplainsWrongArguments) {
    expectError({"--query", "first"}, ExitCode::Usage, "--query is nearest, any or all, not \"first\"");
    expectError({"--workload", "tiles/0.3/*"}, ExitCode::Usage,
                "--workload: no workload is called \"tiles/0.3/*\" (see --list)");
    std::string names;
    for (const bench::TimedMethod& method : bench::timedMethods()) {
        names += " " + method.name;
    }
    expectError({"--method", "magic"}, ExitCode::Usage,
                "--method: there is no method \"magic\" (there are" + names + ")");
    expectError({"--family", "navi31"}, ExitCode::Usage, "--family is for --isa and --groups");
    for (const char* what : {"--isa", "--groups"}) {
        expectError({what, "--family", "navi12345"}, ExitCode::Usage,
                    "--family: radv knows no GPU called \"navi12345\"");
    }
    expectError({"--shaders", "."}, ExitCode::Usage,
                "--shaders: the benchmark has shaders of its own, built in");
    for (const Arguments& arguments :
         {Arguments{"--rays", "5000"}, Arguments{"--rounds", "0"}, Arguments{"--seed", "x"},
          Arguments{"extra"}, Arguments{"--groups", "--isa"}, Arguments{"--groups", "--query", "any"},
          Arguments{"--groups", "--html", "groups.html"}}) {
        const ProgramResult result = run(arguments);
        EXPECT_EQ(result.exitCode, static_cast<int>(ExitCode::Usage)) << testing::PrintToString(result);
        EXPECT_TRUE(result.err.ends_with("(see raytorus-bench --help)\n")) << result.err;
    }
    EXPECT_EQ(run({"--device", "no such device"}).exitCode, static_cast<int>(ExitCode::NoDevice));
}

TEST_F(ProgramBench, ListsWhatItCanTime) {
    const std::string all = expectOk({"--list"});
    for (const char* name :
         {"\n  tiles/0.01/near/5\n", "\n  stream-scattered/0.25/near/30\n", "\n  ray-sphere "}) {
        EXPECT_NE(all.find(name), std::string::npos) << name;
    }
    const std::string quick = expectOk({"--list", "--quick"});
    EXPECT_EQ(quick.find("/far/"), std::string::npos) << quick;
    EXPECT_NE(quick.find("tiles/0.5/near/30"), std::string::npos) << quick;
}

// The driver that Debian installs beside lavapipe's.
TEST_F(ProgramBench, CountsMachineCode) {
    const std::string out = expectOk({"--isa", "--json", "isa.json"});
    EXPECT_NE(out.find("NAVI21"), std::string::npos) << out;
    EXPECT_NE(out.find("\naims for nearest: "), std::string::npos) << out;
    const json rows = table("isa.json").at("rows");
    std::map<std::string, std::map<std::string, int>> instructions;
    for (const json& row : rows) {
        instructions[row.at("query")][row.at("method")] = row.at("Instructions").get<int>();
        // What comes from a cache takes a hundredth of this.
        EXPECT_GT(row.at("compileMs"), 0.2) << row;
        EXPECT_GT(row.at("VGPRs"), 0);
    }
    ASSERT_EQ(instructions.size(), 3U);
    for (const auto& [query, methods] : instructions) {
        EXPECT_EQ(methods.size(), bench::timedMethods().size())
            << query << ": navi21 has float64 and a fused fma, so no method is left out";
        EXPECT_GT(methods.at("ray-sphere"), methods.at("empty")) << query;
        EXPECT_GT(methods.at("raytorus"), methods.at("ray-sphere")) << query;
    }
}

// On the device of the tests; the instructions are radv's all the same.
TEST_F(ProgramBench, CountsWhatGroupsPay) {
    const std::string out = expectOk({"--groups", "--rays", "4096", "--json", "groups.json"});
    EXPECT_NE(out.find("instructions by radv: ends "), std::string::npos) << out;
    const json groups = table("groups.json");
    const json parts = groups.at("parts");
    for (const char* part : {"ends", "step", "refinement", "closedFormCommon"}) {
        EXPECT_GT(parts.at(part), 50) << part;
    }
    EXPECT_EQ(groups.at("rows").size(), 4U * 7U);
    for (const json& row : groups.at("rows")) {
        EXPECT_EQ(row.at("count"), 4096);
        const json& slowest = row.at("slowest");
        EXPECT_LE(slowest.at("8"), slowest.at("32"));
        EXPECT_LE(slowest.at("32"), slowest.at("64"));
        EXPECT_GT(row.at("instructions").at("64"), parts.at("ends"));
        if (row.at("rays") == "inside") {
            EXPECT_EQ(row.at("hitPart"), 1) << row;
            EXPECT_GE(row.at("steps"), 1) << row;
        }
    }
}

TEST_F(ProgramBench, SaysWhyItCannotCountMachineCode) {
    // lavapipe, which has no such statistics.
    const char* lavapipe = "/usr/share/vulkan/icd.d/lvp_icd.x86_64.json";
    const ProgramResult result =
        run({"--isa"}, {{"VK_DRIVER_FILES", lavapipe}, {"VK_ICD_FILENAMES", lavapipe}});
    EXPECT_EQ(result.exitCode, static_cast<int>(ExitCode::NoDevice)) << testing::PrintToString(result);
    EXPECT_NE(result.err.find("--isa needs VK_KHR_pipeline_executable_properties, which llvmpipe"),
              std::string::npos)
        << result.err;
}

// The words of an example, where quotes keep words together.
Arguments wordsOf(const std::string& line) {
    Arguments words;
    for (const PatternMatch& word : matchesIn(line, R"re('([^']*)'|(\S+))re")) {
        words.push_back(word[1] + word[2]);
    }
    return words;
}

// Each example's command line is understood: with --list it says so without the work.
TEST_F(ProgramBench, HelpsWithExamplesThatWork) {
    const std::string help = expectOk({"--help"});
    EXPECT_NE(help.find("Exit codes: "), std::string::npos);
    EXPECT_EQ(expectOk({"--version"}).substr(0, 15), "raytorus-bench ");
    const std::string examples = help.substr(help.find("Examples:\n"));
    const auto commands = matchesIn(examples, R"re(\n  (?:LP_NUM_THREADS=1 )?raytorus-bench(.*))re");
    EXPECT_GE(commands.size(), 6U);
    for (const PatternMatch& command : commands) {
        expectOk(wordsOf(command[1]) + Arguments{"--list"});
    }
}

}  // namespace
}  // namespace raytorus::test
