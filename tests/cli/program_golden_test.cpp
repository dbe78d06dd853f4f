// SPDX-License-Identifier: MIT
// raytorus golden: list, check, renew and bits, as people run them.
#include "support/program_golden.hpp"

#include <filesystem>

#include "image/image_io.hpp"
#include "image/manifest.hpp"

namespace raytorus::test {
namespace {

namespace fs = std::filesystem;

TEST_F(ProgramGolden, ListTellsWhatEachCatches) {
    const std::string list = expectOk({"golden", "list"});
    EXPECT_NE(list.find("dark                    no light\n"), std::string::npos) << list;
    EXPECT_NE(list.find("horn                    the point\n"), std::string::npos) << list;
}

TEST_F(ProgramGolden, CheckDrawsByBothRoutesAndTheMethodsNamed) {
    const ProgramResult result = check({"--validate"});
    EXPECT_EQ(result.exitCode, 0) << testing::PrintToString(result);
    EXPECT_NE(result.out.find("5 of 5 pictures of 2 cases are right"), std::string::npos) << result.out;
}

TEST_F(ProgramGolden, CheckOfTheFolderFindsWhatTheManifestMisses) {
    const ProgramResult result = run({"golden", "check"});
    EXPECT_EQ(result.exitCode, static_cast<int>(ExitCode::File)) << testing::PrintToString(result);
    EXPECT_NE(result.out.find("ring_half.exr"), std::string::npos) << result.out;
}

TEST_F(ProgramGolden, CheckFailsByTheFirstGateThatDoesNotOpen) {
    fs::copy_file(folder / "golden" / "horn.exr", folder / "golden" / "dark.exr",
                  fs::copy_options::overwrite_existing);
    expectCheck(ExitCode::File, "dark_compute: ");
}

TEST_F(ProgramGolden, CheckFindsAnotherPicture) {
    // A scene that has changed is found by its hash; one that was renewed, by its picture.
    write("golden/scenes/dark.json", R"({"image": {"width": 48, "height": 32}, "lights": [],
        "tori": [{"majorRadius": 1, "minorRadius": 0.25}]})");
    expectCheck(ExitCode::File, "the scene has changed");
    renew({"dark"});
    expectCheck(ExitCode::ComparisonFailed, "other bits");
}

// What breaks a 64th of the tolerances keeps the whole of them.
TEST_F(ProgramGolden, CheckForgivesADeviceThatRoundsLoosely) {
    const fs::path path = folder / "golden" / "dark.exr";
    image::Image truth = image::readImage(path);
    const auto tolerance = static_cast<std::size_t>(truth.channelIndex("tolerance.normal"));
    for (std::size_t i = tolerance; i < truth.pixels.size(); i += truth.channelNames.size()) {
        truth.pixels[i] /= 64.0F;
    }
    image::writeImage(path, truth);
    image::writeManifest(folder / "golden" / "manifest.json", image::manifestOf(folder / "golden"));
    expectCheck(ExitCode::ComparisonFailed, "normal");
    EXPECT_EQ(check({"--tolerance-factor", "1"}).exitCode, static_cast<int>(ExitCode::ComparisonFailed));
    const ProgramResult loose = check({"--tolerance-factor", "64", "--report", "report"});
    EXPECT_EQ(loose.exitCode, 0) << testing::PrintToString(loose);
    EXPECT_NE(loose.out.find("are right at 64 times the rounding; "), std::string::npos) << loose.out;
    const std::string report = fileText(folder / "report" / "report.json");
    for (const char* words :
         {"\"tolerance factor\": \"64\"", "raytorus golden check horn --tolerance-factor 64"}) {
        EXPECT_NE(report.find(words), std::string::npos) << words;
    }
}

TEST_F(ProgramGolden, ToleranceFactorIsANumberFrom1To1000) {
    for (const char* factor : {"0", "0.5", "-8", "1001", "nan", "inf"}) {
        expectFailure({"golden", "check", "--tolerance-factor", factor}, ExitCode::Usage,
                      {"--tolerance-factor", "is no number from 1 to 1000", factor});
    }
    expectFailure({"golden", "check", "--tolerance-factor", "eight"}, ExitCode::Usage,
                  {"--tolerance-factor", "eight", "--help"});
}

TEST_F(ProgramGolden, RenewNeedsNamesAReasonAndAPerson) {
    expectFailure({"golden", "renew", "dark"}, ExitCode::Usage, {"--reason"});
    expectFailure({"golden", "renew", "dark", "--reason", " "}, ExitCode::Usage, {"--reason"}, {{"CI", ""}});
    expectFailure({"golden", "renew", "--reason", "test"}, ExitCode::Usage, {"--all"}, {{"CI", ""}});
    expectFailure({"golden", "renew", "dark", "--all", "--reason", "test"}, ExitCode::Usage, {"--all"},
                  {{"CI", ""}});
    expectFailure({"golden", "renew", "day", "--reason", "test"}, ExitCode::Usage, {"\"day\""}, {{"CI", ""}});
    expectFailure({"golden", "renew", "dark", "--reason", "test"}, ExitCode::Usage, {"CI"}, {{"CI", "true"}});
    expectFailure({"golden", "bits", "--reason", "test"}, ExitCode::Usage, {"CI"}, {{"CI", "true"}});
    expectFailure({"golden", "check", "--folder", "none"}, ExitCode::File, {"none", "cases.json"});
    expectFailure({"golden"}, ExitCode::Usage, {"raytorus golden --help"});
}

TEST_F(ProgramGolden, BitsAreThoseThatAreDrawn) {
    write("golden/bits.json", R"({"sha256": {}})");
    expectCheck(ExitCode::ComparisonFailed, "nothing about");
    EXPECT_NE(expectOk({"golden", "bits", "--reason", "test"}, {{"CI", ""}}).find("bits.json"),
              std::string::npos);
    EXPECT_EQ(check().exitCode, 0);
}

}  // namespace
}  // namespace raytorus::test
