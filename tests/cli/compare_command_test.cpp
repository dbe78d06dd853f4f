// SPDX-License-Identifier: MIT
// raytorus compare: its options, what it prints, and its exit codes.
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <limits>
#include <nlohmann/json.hpp>

#include "cli/command.hpp"
#include "image/image_io.hpp"
#include "image/manifest.hpp"
#include "support/expect_error.hpp"
#include "support/scratch_folder.hpp"

namespace raytorus::cli {
namespace {

using image::Image;
using test::expectError;
using test::namesIn;
using test::scratchFolder;

struct Outcome {
    ExitCode code;
    std::string text;
};

// The command line as main takes it. CLI::ParseError is what main turns into ExitCode::Usage.
Outcome run(std::vector<std::string> arguments) {
    CLI::App app("raytorus", "raytorus");
    Action action;
    addCompareCommand(app, action);
    std::ranges::reverse(arguments);  // as CLI11 wants them
    app.parse(arguments);
    testing::internal::CaptureStdout();
    try {
        const ExitCode code = action();
        return {code, testing::internal::GetCapturedStdout()};
    } catch (...) {
        testing::internal::GetCapturedStdout();
        throw;
    }
}

class CompareCommand : public testing::Test {
protected:
    CompareCommand() {
        Image picture(8, 8, {"R", "G", "B", "Z"});
        std::ranges::fill(picture.pixels, 0.5f);
        image::writeImage(expected, picture);
        picture.pixel(3, 2)[0] += 0.125f;
        picture.pixel(4, 2)[3] += 0.25f;
        image::writeImage(actual, picture);
    }

    std::vector<std::string> with(std::vector<std::string> options) const {
        options.insert(options.begin(), {"compare", expected, actual});
        return options;
    }

    std::filesystem::path folder = scratchFolder();
    std::string expected = (folder / "expected.exr").string();
    std::string actual = (folder / "actual.exr").string();
};

TEST_F(CompareCommand, IdenticalFilesGiveZeroAndTheNumbers) {
    const Outcome outcome = run({"compare", expected, expected});
    EXPECT_EQ(outcome.code, ExitCode::Ok);
    EXPECT_NE(outcome.text.find("channel  tolerance  max diff"), std::string::npos) << outcome.text;
    EXPECT_TRUE(outcome.text.ends_with("\nThe images are identical.\n")) << outcome.text;
}

TEST_F(CompareCommand, DifferentFilesGiveTwo) {
    const Outcome outcome = run(with({}));
    EXPECT_EQ(outcome.code, ExitCode::ComparisonFailed);
    EXPECT_NE(outcome.text.find("The images differ: 2 pixels of 64"), std::string::npos) << outcome.text;
}

TEST_F(CompareCommand, EachOptionReachesItsRule) {
    const auto code = [&](std::vector<std::string> options) { return run(with(std::move(options))).code; };
    EXPECT_EQ(code({"--tolerance", "0.25"}), ExitCode::Ok);
    EXPECT_EQ(code({"--tolerance", "0.2"}), ExitCode::ComparisonFailed);
    EXPECT_EQ(code({"--relative", "0.5"}), ExitCode::Ok);
    EXPECT_EQ(code({"--relative", "0.4"}), ExitCode::ComparisonFailed);
    EXPECT_EQ(code({"--ulp", "4194304"}), ExitCode::Ok);  // 0.25 at 0.5
    EXPECT_EQ(code({"--ulp", "4194303"}), ExitCode::ComparisonFailed);
    EXPECT_EQ(code({"--channel", "R=0.125", "--channel", "Z=4194304ulp"}), ExitCode::Ok);
    EXPECT_EQ(code({"--channel", "R=0.125", "--channel", "Z=4194303ulp"}), ExitCode::ComparisonFailed);
    EXPECT_EQ(code({"--allow", "2"}), ExitCode::Ok);
    EXPECT_EQ(code({"--allow", "1"}), ExitCode::ComparisonFailed);
    EXPECT_EQ(code({"--channel", "R=0.125", "--channel", "Z=2.5e-1"}), ExitCode::Ok);
    EXPECT_EQ(code({"--channel", "R=0.125"}), ExitCode::ComparisonFailed);
    EXPECT_EQ(code({"--channel", "R=0.1", "--tolerance", "1"}), ExitCode::ComparisonFailed);
    EXPECT_EQ(code({"--allow", "2", "--window-limit", "2"}), ExitCode::Ok);
    EXPECT_EQ(code({"--allow", "2", "--window-limit", "1"}), ExitCode::ComparisonFailed);
}

TEST_F(CompareCommand, OptionsMayComeBeforeTheFiles) {
    EXPECT_EQ(run({"compare", "--channel", "R=1", "--channel", "Z=1", expected, actual}).code, ExitCode::Ok);
}

TEST_F(CompareCommand, NamesOfChannelsMayHaveAnEqualsSign) {
    Image odd(1, 1, {"a=b"});
    image::writeImage(expected, odd);
    odd.pixels[0] = 0.5f;
    image::writeImage(actual, odd);
    EXPECT_EQ(run(with({"--channel", "a=b=0.5"})).code, ExitCode::Ok);
}

TEST_F(CompareCommand, OtherSizeGivesThreeAndNonFiniteTwelve) {
    image::writeImage(actual, Image(8, 7, {"R", "G", "B", "Z"}));
    EXPECT_EQ(run(with({})).code, ExitCode::SizeDiffers);
    Image bad(8, 8, {"R", "G", "B", "Z"});
    bad.pixel(5, 6)[3] = std::numeric_limits<float>::quiet_NaN();
    image::writeImage(actual, bad);
    const Outcome outcome = run(with({"--tolerance", "10"}));
    EXPECT_EQ(outcome.code, ExitCode::NonFinite);
    EXPECT_EQ(outcome.text,
              "The images cannot be compared: the actual image has 1 value that is not finite, first NaN in "
              "channel Z at pixel (5, 6).\n");
}

TEST_F(CompareCommand, OtherSampleTypesGiveThree) {
    const std::string png = (folder / "actual.png").string();
    image::writeImage(expected, Image(8, 8, {"R", "G", "B"}));
    image::writeImage(png, Image(8, 8, {"R", "G", "B"}));
    const Outcome outcome = run({"compare", expected, png});
    EXPECT_EQ(outcome.code, ExitCode::SizeDiffers);
    EXPECT_NE(outcome.text.find("32 bit floats, the actual one 8 bit integers"), std::string::npos)
        << outcome.text;
}

TEST_F(CompareCommand, FlipsAreLimitedWhereTheExpectedImageIsATruth) {
    Image truth(8, 8, {"id", "margin"});
    image::writeImage(expected, truth);
    Image picture(8, 8, {"id"});
    picture.pixel(1, 1)[0] = 1.0f;
    picture.pixel(2, 1)[0] = 1.0f;
    image::writeImage(actual, picture);
    EXPECT_EQ(run(with({})).code, ExitCode::Ok);
    EXPECT_EQ(run(with({"--allow-flips", "2"})).code, ExitCode::Ok);
    const Outcome outcome = run(with({"--allow-flips", "1"}));
    EXPECT_EQ(outcome.code, ExitCode::ComparisonFailed);
    EXPECT_NE(outcome.text.find("margin: 64 marginal, 2 flipped, first at (1, 1)\n"), std::string::npos)
        << outcome.text;
    expectError([&] { run({"compare", actual, actual, "--allow-flips", "1"}); }, ExitCode::Usage, {"flip"});
}

TEST_F(CompareCommand, TheManifestIsTheFirstGate) {
    const std::string manifest = (folder / "manifest.json").string();
    image::writeManifest(manifest, image::manifestOf(folder));
    EXPECT_EQ(run({"compare", expected, expected, "--manifest", manifest}).code, ExitCode::Ok);
    EXPECT_EQ(run(with({"--manifest", manifest})).code, ExitCode::ComparisonFailed);
    // The very picture, in another file: the actual image is anybody's, the expected one is not.
    test::writeText(expected, test::fileText(actual));
    expectError(
        [&] {
            run(with({"--manifest", manifest}));
        },
        ExitCode::File, {"expected.exr", "manifest.json", "SHA-256"});
    test::writeText(expected, "truncated");
    expectError([&] { run(with({"--manifest", manifest})); }, ExitCode::File, {"expected.exr", "truncated"});
    const std::string other = (folder / "other.exr").string();
    image::writeImage(other, Image(8, 8, {"R", "G", "B", "Z"}));
    expectError(
        [&] {
            run({"compare", other, actual, "--manifest", manifest});
        },
        ExitCode::File, {"other.exr", "not in the manifest"});
    expectError(
        [&] {
            run(with({"--manifest", (folder / "none.json").string()}));
        },
        ExitCode::File, {"none.json", "no such file"});
}

TEST_F(CompareCommand, FilesThatCannotBeReadGiveFour) {
    expectError(
        [&] {
            run({"compare", expected, (folder / "missing.exr").string()});
        },
        ExitCode::File, {"missing.exr"});
    expectError([&] { run({"compare", folder.string(), actual}); }, ExitCode::File, {"it is a directory"});
}

TEST_F(CompareCommand, OptionsThatMakeNoSenseAreUsage) {
    const std::vector<std::vector<std::string>> wrong = {{"--tolerance", "-1"},
                                                         {"--tolerance", "nan"},
                                                         {"--tolerance", "inf"},
                                                         {"--tolerance", "1e-3x"},
                                                         {"--tolerance", ""},
                                                         {"--tolerance"},
                                                         {"--relative", "-0.5"},
                                                         {"--relative", "many"},
                                                         {"--ulp", "-1"},
                                                         {"--ulp", "1.5"},
                                                         {"--ulp", "4ulp"},
                                                         {"--channel", "R=ulp"},
                                                         {"--channel", "R=-1ulp"},
                                                         {"--channel", "R=1.5ulp"},
                                                         {"--channel", "R=1 ulp"},
                                                         {"--allow-flips", "-1"},
                                                         {"--allow-flips", "all"},
                                                         {"--allow", "-1"},
                                                         {"--allow", "1.5"},
                                                         {"--allow", "x"},
                                                         {"--channel", "R"},
                                                         {"--channel", "=1"},
                                                         {"--channel", "R="},
                                                         {"--channel", "R=-1"},
                                                         {"--channel", "R=1", "--channel", "R=2"},
                                                         {"--window-limit", "-1"},
                                                         {"--window-limit", "x"},
                                                         {"--difference", "d.jpg"},
                                                         {"--difference", "folder"},
                                                         {"--unknown"},
                                                         {"third.exr"}};
    for (const std::vector<std::string>& options : wrong) {
        EXPECT_THROW(run(with(options)), CLI::ParseError) << testing::PrintToString(options);
    }
    EXPECT_THROW(run({"compare", expected}), CLI::ParseError);
    expectError([&] { run(with({"--channel", "Q=1"})); }, ExitCode::Usage, {"channel Q", "R, G, B, Z"});
}

TEST_F(CompareCommand, TheDifferencePictureIsWrittenWhateverTheVerdict) {
    const std::string picture = (folder / "difference.png").string();
    EXPECT_EQ(run(with({"--difference", picture})).code, ExitCode::ComparisonFailed);
    const Image written = image::readImage(picture);
    EXPECT_EQ(written.width, 8);
    EXPECT_EQ(written.pixel(3, 2)[0], 1.0f);
    EXPECT_EQ(written.pixel(0, 0)[0], 0.0f);
    EXPECT_EQ(run({"compare", expected, expected, "--difference", picture}).code, ExitCode::Ok);
    EXPECT_EQ(image::readImage(picture).pixel(3, 2)[0], 0.0f);
}

TEST_F(CompareCommand, ThereIsNoDifferencePictureOfImagesOfOtherSize) {
    image::writeImage(actual, Image(8, 7, {"R", "G", "B", "Z"}));
    EXPECT_EQ(run(with({"--difference", (folder / "difference.png").string()})).code, ExitCode::SizeDiffers);
    EXPECT_EQ(namesIn(folder), (std::vector<std::string>{"actual.exr", "expected.exr"}));
}

TEST_F(CompareCommand, TheDifferencePictureNeverReplacesAnInput) {
    const std::string one = (folder / "one.png").string();
    const std::string other = (folder / "other.png").string();
    image::writeImage(one, Image(2, 2, {"R", "G", "B"}));
    image::writeImage(other, Image(2, 2, {"R", "G", "B"}));
    const std::string before = test::fileText(one);
    const std::string sameByAnotherName = (folder / "." / "one.png").string();
    for (const std::string& path : {sameByAnotherName, other}) {
        expectError(
            [&] {
                run({"compare", one, other, "--difference", path});
            },
            ExitCode::Usage, {"overwrite", std::filesystem::path(path).filename().string()});
    }
    EXPECT_EQ(test::fileText(one), before);
    EXPECT_EQ(namesIn(folder),
              (std::vector<std::string>{"actual.exr", "expected.exr", "one.png", "other.png"}));
}

// It is a picture for people, and was once written as EXR where the name said so.
TEST_F(CompareCommand, TheDifferencePictureIsAPng) {
    for (const char* name : {"d.exr", "d.jpg", "d", "png", ""}) {
        EXPECT_THROW(run(with({"--difference", (folder / name).string()})), CLI::ParseError) << name;
    }
    EXPECT_EQ(namesIn(folder), (std::vector<std::string>{"actual.exr", "expected.exr"}));
}

TEST_F(CompareCommand, TheReportIsWrittenWhateverTheVerdict) {
    const std::filesystem::path report = folder / "report";
    EXPECT_EQ(run(with({"--report", report.string()})).code, ExitCode::ComparisonFailed);
    EXPECT_EQ(namesIn(report), (std::vector<std::string>{"index.html", "junit.xml", "report.json"}));
    const auto json = nlohmann::json::parse(test::fileText(report / "report.json"));
    EXPECT_EQ(json["facts"]["expected"], expected);
    EXPECT_EQ(json["results"][0]["name"], "actual");
    EXPECT_EQ(json["results"][0]["comparison"]["exitCode"], 2);
    image::writeImage(actual, Image(8, 7, {"R", "G", "B", "Z"}));
    EXPECT_EQ(run(with({"--report", report.string()})).code, ExitCode::SizeDiffers);
    EXPECT_NE(test::fileText(report / "junit.xml").find("size differs"), std::string::npos);
    expectError([&] { run(with({"--report", actual})); }, ExitCode::File, {"actual.exr"});
}

TEST_F(CompareCommand, JsonIsAllThatIsPrinted) {
    const auto json = nlohmann::json::parse(run(with({"--json"})).text);
    EXPECT_EQ(json["verdict"], "differ");
    EXPECT_EQ(json["exitCode"], 2);
    EXPECT_EQ(json["channels"].size(), 4u);
}

TEST_F(CompareCommand, HelpHasExamples) {
    CLI::App app("raytorus", "raytorus");
    Action action;
    addCompareCommand(app, action);
    const std::string help = app.get_subcommand("compare")->help();
    for (const char* words : {"--tolerance", "--relative", "--ulp", "--allow", "--allow-flips", "--manifest",
                              "--channel NAME=TOL", "--window-limit", "--difference", "--report", "--json",
                              "Examples:\n  raytorus compare", "Exit codes:"}) {
        EXPECT_NE(help.find(words), std::string::npos) << words << " is not in\n" << help;
    }
}

}  // namespace
}  // namespace raytorus::cli
