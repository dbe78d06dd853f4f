// SPDX-License-Identifier: MIT
// Every scene by every route against its golden picture, and every way in which a golden can be unfit.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <ostream>

#include "device_fixture.hpp"
#include "golden_check.hpp"
#include "image/comparison_text.hpp"
#include "image/image_io.hpp"
#include "scratch_folder.hpp"

namespace raytorus::test {
namespace {

namespace fs = std::filesystem;

const fs::path goldenFolder = fs::path(RAYTORUS_SOURCE_DIR) / "golden";

struct CaseRun {
    GoldenCase row;
    render::Route route;
};

std::string labelOf(const CaseRun& run) {
    return fmt::format("{}_{}", run.row.name, run.route == render::Route::Fragment ? "fragment" : "compute");
}

void PrintTo(const CaseRun& run, std::ostream* out) {
    *out << labelOf(run);
}

// ctest runs the same cases on several drivers at once: those that it names have a folder each.
fs::path evidenceFolder() {
    const char* driver = std::getenv("RAYTORUS_DRIVER_NAME");
    return fs::path(RAYTORUS_TEST_OUTPUT_DIR) / "golden" / (driver != nullptr ? driver : "");
}

std::vector<CaseRun> allRuns() {
    std::vector<CaseRun> runs;
    for (const GoldenCase& row : goldenCases) {
        runs.push_back({row, render::Route::Fragment});
        runs.push_back({row, render::Route::Compute});
    }
    return runs;
}

class Golden : public DeviceTest, public testing::WithParamInterface<CaseRun> {};

TEST_P(Golden, IsRenderedAgain) {
    const CaseRun& run = GetParam();
    const image::Image actual = renderGolden(device(), run.row, run.route);
    const image::ReportCase result =
        checkGolden(goldenFolder, run.row, labelOf(run), actual, goldenRules(run.row, device().info()));
    const fs::path evidence = evidenceFolder() / labelOf(run);
    fs::remove_all(evidence);
    if (!result.passed) {
        leaveEvidence(evidence, result);
    }
    EXPECT_TRUE(result.passed) << result.sentence << "\n"
                               << (result.comparison ? image::numbersTable(*result.comparison) : "") << "see "
                               << (evidence / "report.html");
}

INSTANTIATE_TEST_SUITE_P(Scenes, Golden, testing::ValuesIn(allRuns()),
                         [](const auto& row) { return labelOf(row.param); });

TEST(GoldenFolder, HoldsTheTableAndNothingElse) {
    for (const std::string& fault : strayGoldens(goldenFolder)) {
        ADD_FAILURE() << fault;
    }
    for (const GoldenCase& row : goldenCases) {
        EXPECT_TRUE(fs::exists(goldenFolder / fmt::format("{}.exr", row.name))) << row.name;
        EXPECT_TRUE(fs::exists(goldenFolder / fmt::format("{}.json", row.name))) << row.name;
    }
}

TEST(GoldenFolder, EverySceneHasACase) {
    for (const fs::directory_entry& entry :
         fs::directory_iterator(fs::path(RAYTORUS_SOURCE_DIR) / "scenes")) {
        const std::string name = entry.path().stem().string();
        EXPECT_TRUE(std::any_of(goldenCases.begin(), goldenCases.end(), [&name](const GoldenCase& row) {
            return name == row.name;
        })) << name;
    }
}

TEST(GoldenFolder, IsSmall) {
    std::uintmax_t bytes = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(goldenFolder)) {
        bytes += entry.file_size();
    }
    EXPECT_LT(bytes, 2U << 20U) << "a clone pays for each golden in each of its versions";
}

// A golden folder with one sound golden, to be spoilt.
class UnfitGolden : public testing::Test {
protected:
    void SetUp() override {
        folder = scratchFolder();
        fs::copy_file(goldenFolder / "ring.exr", folder / "ring.exr");
        sound = image::readImage(folder / "ring.exr");
    }

    // The sentence of the failed check; empty if it passed.
    std::string failure() const {
        const image::ReportCase result = checkGolden(folder, goldenCases[0], "ring", sound, {});
        leaveEvidence(folder / "evidence", result);
        EXPECT_TRUE(fs::exists(folder / "evidence" / "report.html"));
        return result.passed ? "" : result.sentence;
    }

    void expectFailure(const std::string& words) const {
        const std::string sentence = failure();
        EXPECT_NE(sentence.find(words), std::string::npos) << sentence;
        EXPECT_NE(sentence.find("renew ring"), std::string::npos) << sentence;
    }

    fs::path folder;
    image::Image sound;
};

TEST_F(UnfitGolden, NoneOfThemBySparingTheSoundOne) {
    EXPECT_EQ(failure(), "");
}

TEST_F(UnfitGolden, Missing) {
    fs::remove(folder / "ring.exr");
    expectFailure("there is no such file");
}

TEST_F(UnfitGolden, Truncated) {
    fs::resize_file(folder / "ring.exr", fs::file_size(folder / "ring.exr") / 2);
    expectFailure("cannot read");
}

TEST_F(UnfitGolden, NotAnImage) {
    writeText(folder / "ring.exr", "version https://git-lfs.github.com/spec/v1\n");
    expectFailure("cannot read");
}

TEST_F(UnfitGolden, OfAnotherSize) {
    image::writeImage(folder / "ring.exr", image::Image(goldenWidth, goldenHeight - 1, sound.channelNames));
    expectFailure("96 x 63 pixels");
}

TEST_F(UnfitGolden, WithOtherChannels) {
    image::writeImage(folder / "ring.exr", image::Image(goldenWidth, goldenHeight, {"R", "G", "B", "A"}));
    expectFailure("channel");
}

TEST_F(UnfitGolden, WithANan) {
    image::Image spoilt = sound;
    spoilt.pixels[12345] = std::numeric_limits<float>::quiet_NaN();
    image::writeImage(folder / "ring.exr", spoilt);
    expectFailure("not finite");
}

TEST_F(UnfitGolden, OneBitOff) {
    image::Image spoilt = sound;
    const std::size_t at = static_cast<std::size_t>(spoilt.channelIndex("R"));
    spoilt.pixels[at] = std::nextafter(spoilt.pixels[at], 2.0F);
    image::writeImage(folder / "ring.exr", spoilt);
    expectFailure("1 pixel");
    EXPECT_TRUE(fs::exists(folder / "evidence" / "difference.png"));
}

TEST_F(UnfitGolden, ShiftedByAPixel) {
    image::Image spoilt = sound;
    std::rotate(spoilt.pixels.begin(), spoilt.pixels.begin() + spoilt.channelCount(), spoilt.pixels.end());
    image::writeImage(folder / "ring.exr", spoilt);
    expectFailure("pixels");
}

TEST_F(UnfitGolden, Black) {
    image::writeImage(folder / "ring.exr", image::Image(goldenWidth, goldenHeight, sound.channelNames));
    expectFailure("pixels");
}

TEST_F(UnfitGolden, Stray) {
    EXPECT_TRUE(strayGoldens(folder).empty());
    writeText(folder / "ring2.exr", "");
    ASSERT_EQ(strayGoldens(folder).size(), 1U);
    EXPECT_NE(strayGoldens(folder)[0].find("ring2.exr"), std::string::npos);
}

}  // namespace
}  // namespace raytorus::test
