// SPDX-License-Identifier: MIT
// The commands that a check prints and reports, pasted into a shell: they do what they say, in the folder
// that was checked, whatever it is called.
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "support/count_of.hpp"
#include "support/program_golden.hpp"

namespace raytorus::test {
namespace {

namespace fs = std::filesystem;

class ProgramGoldenCommands : public ProgramGolden {
protected:
    ProgramGoldenCommands() { copyGoldens(goldens); }

    // As if typed in the folder of the test, with raytorus installed.
    [[nodiscard]] ProgramResult paste(const std::string& command) const {
        ProgramSettings settings;
        settings.folder = folder;
        settings.environment = {
            {"CI", ""},
            {"PATH", fs::path(RAYTORUS_PROGRAM).parent_path().string() + ":" + std::getenv("PATH")}};
        return runProgram("/bin/sh", {"-c", command}, settings);
    }

    [[nodiscard]] nlohmann::json reportOf(const Arguments& options, int exitCode = 0) const {
        Arguments all = {"--folder", goldens, "--report", "report"};
        all.insert(all.end(), options.begin(), options.end());
        const ProgramResult result = check(all);
        EXPECT_EQ(result.exitCode, exitCode) << testing::PrintToString(result);
        return nlohmann::json::parse(fileText(folder / "report" / "report.json"))["results"];
    }

    void expectPasted(const std::string& command, const std::string& words) const {
        const ProgramResult result = paste(command);
        EXPECT_EQ(result.exitCode, 0) << command << "\n" << testing::PrintToString(result);
        EXPECT_EQ(result.err, "");
        EXPECT_NE(result.out.find(words), std::string::npos) << command << "\n" << result.out;
        EXPECT_FALSE(fs::exists(folder / "PWNED")) << command;
    }

    // Without quotes round it, its own quotes would be a pair, and what is after them a command.
    const std::string goldens = "it's my golden's {x},{y}; touch PWNED #";
};

TEST_F(ProgramGoldenCommands, RunAgainChecksThisFolderWithTheseOptions) {
    const auto results = reportOf({"--tolerance-factor", "4", "--validate", "--device", "llvmpipe (LLVM"});
    // Here it would be another picture than there.
    fs::remove(folder / "golden" / "dark.exr");
    expectPasted(results[0]["rerun"], "3 of 3 pictures of 1 cases are right at 4 times the rounding");
    for (const char* words : {" --validate", " --device 'llvmpipe (LLVM'", " --tolerance-factor 4"}) {
        EXPECT_NE(results[0]["rerun"].get<std::string>().find(words), std::string::npos) << words;
    }
}

TEST_F(ProgramGoldenCommands, RunAgainTakesTheShadersThatWereGiven) {
    fs::rename(shaderFolder(), folder / "my shaders");
    const auto results = reportOf({"--shaders", "my shaders"});
    expectPasted(results[0]["rerun"], "3 of 3 pictures");
    fs::remove_all(folder / "my shaders");
    EXPECT_NE(paste(results[0]["rerun"]).exitCode, 0);
}

TEST_F(ProgramGoldenCommands, RenewChangesThisFolderAndNoOther) {
    const auto results = reportOf({});
    const std::string before = fileText(folder / "golden" / "dark.json");
    expectPasted(results[0]["renew"], "renewed " + goldens + "/dark.exr");
    EXPECT_EQ(fileText(folder / "golden" / "dark.json"), before);
    EXPECT_NE(fileText(folder / goldens / "dark.json"), before);
}

TEST_F(ProgramGoldenCommands, ExplainTakesTheMarkedPixelOfThisScene) {
    static_cast<void>(reportOf({}));
    const std::string html = fileText(folder / "report" / "index.html");
    // As the page shows it: the folder is called what it is called, and the pixel stands at the end.
    const std::string shown =
        "raytorus explain --scene &#39;it&#39;\\&#39;&#39;s my golden&#39;\\&#39;&#39;s {x},{y}; "
        "touch PWNED #/scenes/dark.json&#39; "
        "--pixel ";
    const std::size_t begin = html.find(">" + shown);
    ASSERT_NE(begin, std::string::npos);
    std::string command = html.substr(begin + 1, html.find("</code>", begin) - begin - 1);
    for (std::size_t at = command.find("&#39;"); at != std::string::npos; at = command.find("&#39;")) {
        command.replace(at, 5, "'");
    }
    expectPasted(command, "reduced quartic");
    // The other commands have no pixel to be put in.
    EXPECT_EQ(countOf(html, "data-command="), 5U);
}

TEST_F(ProgramGoldenCommands, BitsAreRecordedInThisFolder) {
    write(goldens + "/bits.json", R"({"sha256": {"dark": "0", "horn": "0"}})");
    const std::string before = fileText(folder / "golden" / "bits.json");
    const auto results = reportOf({"--device", "llvmpipe"}, static_cast<int>(ExitCode::ComparisonFailed));
    const std::string sentence = results[0]["sentence"];
    const std::size_t command = sentence.find("raytorus golden bits");
    ASSERT_NE(command, std::string::npos) << sentence;
    expectPasted(sentence.substr(command), "wrote " + goldens + "/bits.json");
    EXPECT_EQ(fileText(folder / "golden" / "bits.json"), before);
    static_cast<void>(reportOf({}));
}

TEST_F(ProgramGoldenCommands, AnUnknownNameTellsHowToListThisFolder) {
    const ProgramResult result = run({"golden", "check", "day", "--folder", goldens});
    EXPECT_EQ(result.exitCode, static_cast<int>(ExitCode::Usage)) << testing::PrintToString(result);
    fs::remove_all(folder / "golden");
    const std::size_t command = result.err.find("(raytorus golden list");
    ASSERT_NE(command, std::string::npos) << result.err;
    expectPasted(result.err.substr(command + 1, result.err.rfind(')') - command - 1), "dark ");
}

}  // namespace
}  // namespace raytorus::test
