// SPDX-License-Identifier: MIT
// raytorus compare as a program: its exit codes, on pictures that the program itself has made. What it
// measures and prints is the business of compare_test and compare_command_test.
#include <limits>

#include "image/image_io.hpp"
#include "support/program_test.hpp"

namespace raytorus::test {
namespace {

class ProgramCompare : public ProgramTest {
protected:
    ProgramCompare() {
        write("scene.json", smallScene);
        expectOk({"render", "scene.json", "-o", "expected.exr"});
    }

    // A copy of expected.exr with another value in the middle of one channel.
    void writeCopyWith(const std::string& channel, float value) const {
        image::Image copy = picture("expected.exr");
        copy.at(copy.width / 2, copy.height / 2, channel) = value;
        image::writeImage(folder / "actual.exr", copy);
    }

    // A comparison that was made is told on standard output, whatever came out of it.
    void expectVerdict(ExitCode code, const std::vector<std::string>& options,
                       const std::string& words) const {
        Arguments arguments = {"compare", "expected.exr", "actual.exr"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const ProgramResult result = run(arguments);
        EXPECT_EQ(result.exitCode, static_cast<int>(code)) << testing::PrintToString(result);
        EXPECT_EQ(result.err, "");
        EXPECT_NE(result.out.find(words), std::string::npos) << result.out;
    }
};

TEST_F(ProgramCompare, OkWhenIdentical) {
    std::filesystem::copy_file(folder / "expected.exr", folder / "actual.exr");
    expectVerdict(ExitCode::Ok, {}, "identical");
}

TEST_F(ProgramCompare, FailedByOneValueOfOnePixel) {
    writeCopyWith("normal.z", 0.25F);
    expectVerdict(ExitCode::ComparisonFailed, {}, "normal.z");
    expectVerdict(ExitCode::Ok, {"--tolerance", "2"}, "agree");
    expectVerdict(ExitCode::Ok, {"--allow", "1"}, "agree");
}

TEST_F(ProgramCompare, SizeDiffers) {
    expectOk({"render", "scene.json", "-o", "actual.exr", "--size", "25x16"});
    expectVerdict(ExitCode::SizeDiffers, {}, "25");
}

TEST_F(ProgramCompare, ChannelsDiffer) {
    image::Image copy = picture("expected.exr");
    copy.channelNames.back() = "other";
    image::writeImage(folder / "actual.exr", copy);
    expectVerdict(ExitCode::SizeDiffers, {}, "other");
}

TEST_F(ProgramCompare, NonFiniteWhateverIsAllowed) {
    for (const float value :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        writeCopyWith("B", value);
        expectVerdict(ExitCode::NonFinite, {"--tolerance", "1e30", "--allow", "1000"}, "B");
    }
}

TEST_F(ProgramCompare, FileWhenOneIsMissingOrDamaged) {
    expectFailure({"compare", "expected.exr", "missing.exr"}, ExitCode::File, {"missing.exr"});
    expectFailure({"compare", "missing.exr", "expected.exr"}, ExitCode::File, {"missing.exr"});
    std::filesystem::copy_file(folder / "expected.exr", folder / "cut.exr");
    std::filesystem::resize_file(folder / "cut.exr", std::filesystem::file_size(folder / "cut.exr") / 2);
    expectFailure({"compare", "expected.exr", "cut.exr"}, ExitCode::File, {"cut.exr"});
}

}  // namespace
}  // namespace raytorus::test
