// SPDX-License-Identifier: MIT
// raytorus golden where something is wrong with a case: said before anything is drawn or written, or beside
// the verdicts on all others.
#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "support/count_of.hpp"
#include "support/program_golden.hpp"

namespace raytorus::test {
namespace {

namespace fs = std::filesystem;

class ProgramGoldenFaults : public ProgramGolden {
protected:
    // Nothing can be drawn here: what is found all the same is found before.
    void expectBeforeDrawing(Arguments arguments, ExitCode code,
                             const std::vector<std::string>& words) const {
        Environment environment = noDriver();
        environment["CI"] = "";
        arguments.insert(arguments.begin(), "golden");
        expectFailure(arguments, code, words, environment);
    }

    // Both pictures of "horn" are judged right, and the three of "dark" are an error with these words.
    void expectOnlyDarkFails(ExitCode code, const std::string& words) const {
        const ProgramResult result = check({"--report", "report"});
        EXPECT_EQ(result.exitCode, static_cast<int>(code)) << testing::PrintToString(result);
        EXPECT_EQ(result.err, "");
        EXPECT_NE(result.out.find("2 of 5 pictures of 2 cases are right"), std::string::npos) << result.out;
        for (const char* label : {"dark_fragment: ", "dark_compute: ", "dark_bracketed-newton: "}) {
            EXPECT_NE(result.out.find(label), std::string::npos) << label << result.out;
        }
        EXPECT_EQ(countOf(result.out, words), 3U) << words << " is not in " << result.out;
        const auto report = nlohmann::json::parse(fileText(folder / "report" / "report.json"));
        EXPECT_EQ(report["cases"], 5);
        EXPECT_EQ(report["passed"], 2);
        for (const auto& reported : report["results"]) {
            const bool dark = reported["name"].get<std::string>().starts_with("dark");
            EXPECT_EQ(reported["verdict"] == "error", dark);
            EXPECT_EQ(reported["passed"], !dark);
            EXPECT_EQ(reported["sentence"].get<std::string>().find(words) != std::string::npos, dark);
        }
        EXPECT_EQ(countOf(fileText(folder / "report" / "index.html"), ">error</span>"), 3U);
        EXPECT_EQ(countOf(fileText(folder / "report" / "junit.xml"), "<error type=\"error\""), 3U);
    }
};

TEST_F(ProgramGoldenFaults, AnInvalidSceneHidesNoOtherCase) {
    write("golden/scenes/dark.json", R"({"tori": [{"majorRadius": "one", "minorRadius": 1}]})");
    expectOnlyDarkFails(ExitCode::Scene, "golden/scenes/dark.json: /tori/0/majorRadius: \"one\" is not");
}

TEST_F(ProgramGoldenFaults, AMissingSceneHidesNoOtherCase) {
    fs::remove(folder / "golden" / "scenes" / "dark.json");
    expectOnlyDarkFails(ExitCode::File, "golden/scenes/dark.json\": there is no such file");
}

TEST_F(ProgramGoldenFaults, ASidecarOfAWrongTypeHidesNoOtherCase) {
    write("golden/dark.json", R"({"scene": 5, "samplesPerPixel": 1})");
    expectOnlyDarkFails(ExitCode::File, "golden/dark.json: /scene: 5 is not a string");
}

TEST_F(ProgramGoldenFaults, ADirectoryInPlaceOfASidecarHidesNoOtherCase) {
    fs::remove(folder / "golden" / "dark.json");
    fs::create_directory(folder / "golden" / "dark.json");
    expectOnlyDarkFails(ExitCode::File, "golden/dark.json\": it is a directory");
}

TEST_F(ProgramGoldenFaults, ADanglingLinkInPlaceOfAPictureHidesNoOtherCase) {
    fs::remove(folder / "golden" / "dark.exr");
    fs::create_symlink("nowhere", folder / "golden" / "dark.exr");
    expectOnlyDarkFails(ExitCode::File, "golden/dark.exr\": there is no such file");
}

TEST_F(ProgramGoldenFaults, TheExitCodeIsThatOfTheWorst) {
    write("golden/scenes/dark.json", R"({"tori": 5})");
    fs::remove(folder / "golden" / "horn.json");
    const ProgramResult result = check();
    EXPECT_EQ(result.exitCode, static_cast<int>(ExitCode::File)) << testing::PrintToString(result);
    EXPECT_NE(result.out.find("0 of 5 pictures"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("dark_compute: golden/scenes/dark.json: /tori"), std::string::npos)
        << result.out;
}

TEST_F(ProgramGoldenFaults, UnreadableBitsHideNoPicture) {
    write("golden/bits.json", R"({"sha256": {"dark": 5}})");
    const ProgramResult result = check({"--report", "report"});
    EXPECT_EQ(result.exitCode, static_cast<int>(ExitCode::File)) << testing::PrintToString(result);
    EXPECT_EQ(countOf(result.out, "golden/bits.json: /sha256/dark: 5 is not a string"), 4U) << result.out;
    EXPECT_NE(result.out.find("1 of 5 pictures"), std::string::npos) << result.out;
    const std::string page = fileText(folder / "report" / "index.html");
    EXPECT_EQ(countOf(page, ">error</span>"), 4U);
    EXPECT_EQ(countOf(page, "data-kind=\"actual\""), 5U);
}

// What is wrong with the folder is a case of the report, which would else say that all is well.
TEST_F(ProgramGoldenFaults, AnUnreadableManifestHidesNoPicture) {
    write("golden/manifest.json", "{}");
    const ProgramResult result = run({"golden", "check", "--report", "report"});
    EXPECT_EQ(result.exitCode, static_cast<int>(ExitCode::File)) << testing::PrintToString(result);
    EXPECT_NE(result.out.find("0 of 5 pictures"), std::string::npos) << result.out;
    const auto report = nlohmann::json::parse(fileText(folder / "report" / "report.json"));
    EXPECT_EQ(report["cases"], 6);
    EXPECT_EQ(report["results"][0]["name"], "golden");
    EXPECT_EQ(report["results"][0]["verdict"], "error");
    EXPECT_NE(report["results"][0]["sentence"].get<std::string>().find("manifest.json"), std::string::npos);
}

TEST_F(ProgramGoldenFaults, AShaderThatIsNotThereHidesNoOtherRoute) {
    fs::remove(shaderFolder() / "scene.comp.spv");
    const ProgramResult result = check({"--shaders", "shaders"});
    EXPECT_EQ(result.exitCode, static_cast<int>(ExitCode::File)) << testing::PrintToString(result);
    EXPECT_NE(result.out.find("3 of 5 pictures"), std::string::npos) << result.out;
}

// The device is lost at once, and nothing can be drawn after that.
TEST_F(ProgramGoldenFaults, AReportTellsWhatEndedTheCheckAndWhatWasNotJudged) {
    const ProgramResult result = check({"--timeout", "1e-6", "--report", "report"});
    EXPECT_EQ(result.exitCode, static_cast<int>(ExitCode::DeviceLost)) << testing::PrintToString(result);
    const auto report = nlohmann::json::parse(fileText(folder / "report" / "report.json"));
    EXPECT_EQ("raytorus: " + report["facts"]["ended by"].get<std::string>() + "\n", result.err);
    EXPECT_EQ(report["cases"], 5);
    EXPECT_EQ(report["failed"], 5);
    for (const auto& reported : report["results"]) {
        EXPECT_EQ(reported["verdict"], "skipped");
    }
}

TEST_F(ProgramGoldenFaults, AReportThatCannotBeWrittenIsSaidBeforeDrawing) {
    write("file", "no folder");
    fs::create_directories(folder / "report" / "index.html");
    write("report/report.json", "");
    write("report/junit.xml", "");
    expectBeforeDrawing({"check", "--report", "file"}, ExitCode::File, {"cannot write", "file/"});
    expectBeforeDrawing({"check", "--report", "report"}, ExitCode::File, {"report/index.html", "directory"});
}

TEST_F(ProgramGoldenFaults, BitsLooksAtAllFilesBeforeDrawing) {
    const Arguments bits = {"bits", "--reason", "test"};
    expectBeforeDrawing(bits, ExitCode::NoDevice, {});
    expectBeforeDrawing({"bits", "--reason", "caf\xe9"}, ExitCode::Usage, {"--reason", "UTF-8"});
    const std::string sidecar = fileText(folder / "golden" / "horn.json");
    write("golden/horn.json", R"({"scene": true})");
    expectBeforeDrawing(bits, ExitCode::File, {"golden/horn.json: /scene: true is not a string"});
    write("golden/horn.json", sidecar);
    fs::remove(folder / "golden" / "bits.json");
    fs::create_directory(folder / "golden" / "bits.json");
    expectBeforeDrawing(bits, ExitCode::File, {"golden/bits.json", "it is a directory"});
}

TEST_F(ProgramGoldenFaults, RenewOfTwoCasesChangesBothOrNone) {
    const Arguments renewal = {"renew", "dark", "horn", "--reason", "test"};
    const std::string scene = fileText(folder / "golden" / "scenes" / "horn.json");
    write("golden/scenes/horn.json", R"({"tori": 5})");
    expectBeforeDrawing(renewal, ExitCode::Scene, {"golden/scenes/horn.json: /tori"});
    write("golden/scenes/horn.json", scene);
    fs::remove(folder / "golden" / "horn.json");
    fs::create_directory(folder / "golden" / "horn.json");
    expectBeforeDrawing(renewal, ExitCode::File, {"golden/horn.json", "it is a directory"});
    fs::remove(folder / "golden" / "horn.json");
    renew({"dark", "horn", "dark"});
    EXPECT_EQ(check().exitCode, 0);
}

TEST_F(ProgramGoldenFaults, RenewWithAReasonThatIsNotUtf8ChangesNothing) {
    expectBeforeDrawing({"renew", "dark", "--reason", "caf\xe9"}, ExitCode::Usage, {"--reason", "UTF-8"});
}

TEST_F(ProgramGoldenFaults, AFileInPlaceOfTheFolderIsAFault) {
    write("file", "");
    fs::create_symlink("nowhere", folder / "dangling");
    for (const char* name : {"file", "dangling"}) {
        for (const Arguments& arguments :
             {Arguments{"list"}, Arguments{"check"}, Arguments{"renew", "dark", "--reason", "test"},
              Arguments{"bits", "--reason", "test"}}) {
            Arguments all = arguments;
            all.insert(all.end(), {"--folder", name});
            expectBeforeDrawing(all, ExitCode::File, {fmt::format("{}/cases.json", name)});
        }
    }
}

}  // namespace
}  // namespace raytorus::test
