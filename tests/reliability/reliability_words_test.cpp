// SPDX-License-Identifier: MIT
// Words that nobody has looked at, in all that the programs write, and words that are missing: names of files
// above all (docs/reliability.md). Behind each case stands how it ended when it was found.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/console.hpp"
#include "reliability.hpp"

namespace raytorus::test {
namespace {

using nlohmann::json;

class ReliabilityWords : public Reliability {
protected:
    ReliabilityWords() { std::filesystem::create_directory(folder / hostile); }

    // The folder is "$N" there.
    [[nodiscard]] ProgramResult inShell(const std::string& command) const {
        return shell(command, {{"N", hostile}, {"CI", ""}});
    }

    // Nothing is in it that a terminal obeys, and all of it is UTF-8.
    static void expectClean(const std::string& text) { EXPECT_EQ(printable(text), text); }
    static void expectCleanPage(const std::string& text) {
        expectClean(text);
        EXPECT_EQ(text.find("<script>alert"), std::string::npos) << text;
    }
    static json cleanJson(const std::string& text) {
        expectClean(text);
        return json::parse(text);
    }

    // It is the same command again, and nothing else is run.
    [[nodiscard]] ProgramResult pasted(const std::string& command) const {
        ProgramResult result = shell(command);
        EXPECT_FALSE(std::filesystem::exists(folder / "PWNED")) << command;
        return result;
    }

    // A folder of one golden.
    void copyGolden(const std::filesystem::path& copy) const {
        const std::filesystem::path goldens = RAYTORUS_SOURCE_DIR "/golden";
        std::filesystem::create_directories(copy / "scenes");
        for (const char* name : {"dark.exr", "dark.json", "manifest.json", "bits.json", "scenes/dark.json"}) {
            std::filesystem::copy_file(goldens / name, copy / name);
        }
        writeText(copy / "cases.json", R"({"cases": [{"name": "dark", "catches": "no light"}]})");
    }

    const std::string hostile =
        "a b; touch PWNED #'\"\x1b[31m\u009b\uffff\U0001fffe<script>alert(1)<script>\xff";
};

// 13. What a terminal, a page or a reader of JSON obeys.

TEST_F(ReliabilityWords, InTheReportOfAComparison) {
    ASSERT_EQ(inShell("raytorus render ring.json -o \"$N/a.png\"").exitCode, 0);
    // 0, with the characters in page and JSON as they were
    const ProgramResult result =
        inShell("raytorus compare \"$N/a.png\" \"$N/a.png\" --report \"$N/r\" --json");
    ASSERT_EQ(result.exitCode, 0) << testing::PrintToString(result);
    EXPECT_EQ(cleanJson(result.out)["passed"], true);
    const std::string report = hostile + "/r/";
    const json facts = cleanJson(text(report + "report.json"))["facts"];
    EXPECT_TRUE(facts["expected"].get<std::string>().starts_with("a b; touch PWNED #'\"\x1b[31m\u009b"));
    for (const char* name : {"index.html", "junit.xml"}) {
        expectCleanPage(text(report + name));
    }
    EXPECT_NE(text(report + "index.html")
                  .find("a b; touch PWNED #&#39;&quot;\\u001b[31m\\u009b\\uffff\\U0001fffe&lt;script&gt;"),
              std::string::npos);
}

TEST_F(ReliabilityWords, InWhatIsPrinted) {
    for (const char* command :
         {"raytorus compare \"$N\" \"$N\"", "raytorus golden list --folder \"$N\"",
          "raytorus render \"$N\" -o \"$N/x.png\"", "raytorus render ring.json -o \"$N\"",
          "raytorus render ring.json -o a.png --device \"$N\"",
          "raytorus render ring.json -o a.png --shaders \"$N\"",
          "raytorus trace \"$N\" -o \"$N/h\" --torus 1,1", "raytorus \"$N\"", "raytorus render --\"$N\"",
          "raytorus-verify --json \"$N\" --class camera --rays 1", "raytorus-verify --class \"$N\"",
          "raytorus-bench --method \"$N\"", "raytorus-view \"$N\" --view \"$N\"",
          "VK_DRIVER_FILES=\"$N\" raytorus doctor", "VK_LAYER_PATH=\"$N\" raytorus doctor"}) {
        const ProgramResult result = inShell(command);
        expectClean(result.out + result.err);
        EXPECT_NE((result.out + result.err).find("\\u001b[31m\\u009b"), std::string::npos)
            << command << "\n"
            << testing::PrintToString(result);
    }
}

// 8. Commands that are copied.

TEST_F(ReliabilityWords, TheCommandsOfAGoldenReport) {
    copyGolden(folder / hostile);
    ASSERT_EQ(inShell("raytorus golden check dark --folder \"$N\" --report report").exitCode, 0);
    const json results = cleanJson(text("report/report.json"))["results"];
    expectCleanPage(text("report/index.html"));
    expectCleanPage(text("report/junit.xml"));
    // From here on it is another folder than the one that is checked unless one is named.
    const ProgramResult again = pasted(results[0]["rerun"]);
    EXPECT_EQ(again.exitCode, 0) << testing::PrintToString(again);
    EXPECT_TRUE(again.out.starts_with("2 of 2 pictures of 1 cases are right")) << again.out;
    std::string explain = results[0]["explain"];
    explain.replace(explain.rfind("{x},{y}"), 7, "3,4");
    EXPECT_EQ(pasted(explain).out,
              inShell("raytorus explain --scene \"$N/scenes/dark.json\" --pixel 3,4").out);
}

// 14. Words that are missing.

TEST_F(ReliabilityWords, EmptyWords) {
    writeText(folder / "a.png", "");
    for (const char* command :
         {"raytorus compare a.png a.png --report ''", "raytorus compare a.png a.png --manifest ''",
          "raytorus compare '' a.png", "raytorus render '' -o a.png",
          "raytorus render ring.json -o a.png --shaders ''", "raytorus render ring.json -o a.png --size ''",
          "raytorus explain --replay ''",
          "raytorus explain --torus 1,1 --origin 3,0,0 --direction 1,0,0 --svg ''",
          "raytorus golden check --report ''", "raytorus golden check --folder ''",
          "raytorus-verify --json '' --class camera --rays 1", "raytorus-verify --replay ''",
          "raytorus-bench --list --json ''", "raytorus-view ''", "raytorus-view ring.json --screenshot ''"}) {
        // 0, without what was to be written; or 4
        expectEnd(command, ExitCode::Usage, {"is given, and is empty"});
    }
}

TEST_F(ReliabilityWords, TheEndOfTheOptions) {
    writeText(folder / "-r.json", smallScene);
    expectEnd("raytorus render -o a.png -- -r.json", ExitCode::Ok);
    expectEnd("raytorus render ring.json -o a.png --", ExitCode::Ok);
    // "there is no option -o"
    expectEnd("raytorus render ring.json -- -o a.png", ExitCode::Usage, {"\"-o\" is one argument too many"});
    expectEnd("raytorus -- render ring.json -o a.png", ExitCode::Usage, {"a command is missing: render, "});
    // "there is no option --"
    expectEnd("raytorus-bench --list -- more", ExitCode::Usage, {"\"more\" is one argument too many"});
    expectEnd("raytorus-verify -- more", ExitCode::Usage, {"\"more\" is one argument too many"});
}

TEST_F(ReliabilityWords, OptionsInTheWrongPlace) {
    // "there is no option --folder; did you mean --folder?"
    expectEnd("raytorus golden --folder x check", ExitCode::Usage,
              {"--folder stands behind the command check"});
    expectEnd("raytorus golden chek", ExitCode::Usage, {"no command \"chek\"; did you mean check?"});
    expectEnd("raytorus golden", ExitCode::Usage, {"a command is missing: list, check, renew, bits"});
    // 0, and not those shaders
    expectEnd("raytorus-view ring.json --shaders x", ExitCode::Usage, {"--edit DIR"});
}

// Of two outputs with one name the second was there, with 0.
TEST_F(ReliabilityWords, OutputsThatAreOneFile) {
    for (const char* command :
         {"raytorus-bench --list --json o --html ./o",
          "raytorus-view ring.json --screenshot o.png --window-screenshot \"$PWD/o.png\""}) {
        expectEnd(command, ExitCode::Usage, {"name the same file"});
    }
    writeText(folder / "o", "old");
    for (const char* command :
         {"raytorus-bench --list --against o --json o", "raytorus-bench --list --against o --html ./o",
          "raytorus-view ring.json --golden o.exr --screenshot o.exr"}) {
        expectEnd(command, ExitCode::Usage, {"would overwrite"});
    }
    EXPECT_EQ(text("o"), "old");
}

TEST_F(ReliabilityWords, ALineInAName) {
    const ProgramResult result = shell("raytorus render 'none\nraytorus: all is well' -o a.png");
    // A line of its own
    EXPECT_NE(result.err.find("\n  raytorus: all is well"), std::string::npos) << result.err;
}

// A key twice: which one counts?
TEST_F(ReliabilityWords, KeysThatAreGivenTwice) {
    const auto at = [](const std::string& place) { return ": " + place + ": the key is given twice"; };
    ASSERT_EQ(shell("raytorus render ring.json -o a.png").exitCode, 0);
    // 0: the last one
    writeText(folder / "m.json", R"({"files": {"a.png": {"bytes": 1, "bytes": 2}}})");
    expectEnd("raytorus compare a.png a.png --manifest m.json", ExitCode::File,
              {"m.json" + at("/files/a.png/bytes")});
    writeText(folder / "m.json", R"({"files": {"a.png": {}, "a.png": {}}})");
    expectEnd("raytorus compare a.png a.png --manifest m.json", ExitCode::File,
              {"m.json" + at("/files/a.png")});
    writeText(folder / "before.json", R"({"format": "raytorus-bench", "version": 1, "version": 1})");
    expectEnd(
        "raytorus-bench --quick --rounds 3 --rays 4096 --method ray-sphere --workload tiles/0.25/near/30 "
        "--against before.json",
        ExitCode::File, {"before.json" + at("/version")});
    // as now
    writeText(folder / "twice.json", R"({"tori": [{"majorRadius": 1, "minorRadius": 1, "minorRadius": 2}]})");
    expectEnd("raytorus render twice.json -o a.png", ExitCode::Scene,
              {"twice.json" + at("/tori/0/minorRadius")});
    copyGolden(folder / "g");
    writeText(folder / "g/dark.json", R"({"scene": "", "scene": ""})");
    const ProgramResult sidecar = shell("raytorus golden check dark --folder g");
    EXPECT_EQ(sidecar.exitCode, static_cast<int>(ExitCode::File));
    EXPECT_NE(sidecar.out.find("g/dark.json" + at("/scene")), std::string::npos) << sidecar.out;
    writeText(folder / "g/cases.json", R"({"cases": [], "cases": []})");
    expectEnd("raytorus golden check dark --folder g", ExitCode::Scene, {"g/cases.json" + at("/cases")});
}

// 6. A renewal whose program is killed while it puts files in their places.
TEST_F(ReliabilityWords, ARenewalThatIsKilled) {
    copyGolden(folder / "g");
    for (const char* name : {"dark.exr", "dark.json", "manifest.json"}) {
        Environment killing = failing("g/" + std::string(name), "FAIL_RENAME");
        killing["FAIL_RENAME"] = "kill";
        killing["CI"] = "";
        EXPECT_EQ(
            shell("raytorus golden renew dark --folder g --reason 'for a test'; exit $?", killing).exitCode,
            128 + 9);
        const ProgramResult check = shell("raytorus golden check dark --folder g");
        EXPECT_EQ(check.exitCode, static_cast<int>(ExitCode::File));
        EXPECT_NE(check.out.find("a renewal is under way, or was ended in the middle"), std::string::npos);
    }
    expectEnd("raytorus golden bits --folder g --reason 'for a test'", ExitCode::File,
              {"a renewal is under way"}, {{"CI", ""}});
    const ProgramResult renewed =
        shell("raytorus golden renew dark --folder g --reason 'once more'", {{"CI", ""}});
    EXPECT_TRUE(
        renewed.out.starts_with("put back what a renewal that was ended in the middle had replaced\n"))
        << testing::PrintToString(renewed);
    EXPECT_EQ(shell("raytorus golden check dark --folder g").exitCode, 0);
    EXPECT_NE(text("g/dark.json").find("once more"), std::string::npos);
    EXPECT_EQ(namesIn(folder / "g"), (std::vector<std::string>{"bits.json", "cases.json", "dark.exr",
                                                               "dark.json", "manifest.json", "scenes"}));
}

}  // namespace
}  // namespace raytorus::test
