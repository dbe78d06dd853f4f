// SPDX-License-Identifier: MIT
// The goldens of the project, and every way in which a golden, its folder or a picture can be unfit.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>

#include "core/file.hpp"
#include "golden/golden_check.hpp"
#include "golden/golden_folder.hpp"
#include "golden/golden_renew.hpp"
#include "image/channels.hpp"
#include "image/image_io.hpp"
#include "image/manifest.hpp"
#include "scene/scene_json.hpp"
#include "support/expect_error.hpp"
#include "support/fresh_seed.hpp"
#include "support/scratch_folder.hpp"
#include "truth/truth.hpp"

namespace raytorus::test {
namespace {

namespace fs = std::filesystem;

const fs::path goldenFolder = fs::path(RAYTORUS_SOURCE_DIR) / "golden";

TEST(Goldens, FolderIsSound) {
    const golden::Set set(goldenFolder);
    for (const std::string& fault : golden::folderFaults(set)) {
        ADD_FAILURE() << fault;
    }
    EXPECT_GE(set.cases().size(), 60U);
}

TEST(Goldens, AreSmall) {
    std::uintmax_t bytes = 0;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(goldenFolder)) {
        bytes += entry.is_regular_file() ? entry.file_size() : 0;
    }
    EXPECT_LT(bytes, 6U << 20U) << "a clone pays for each golden in each of its versions";
}

// A dozen cases, others in each run: all of them take a quarter of a minute, and many times that in the
// sanitizers' run.
TEST(Goldens, AreWhatTheReferenceSaysNow) {
    const golden::Set set(goldenFolder);
    const std::size_t first = freshSeed() % 7;
    for (std::size_t i = first; i < set.cases().size(); i += 7) {
        const golden::Case& row = set.cases()[i];
        const scene::Scene scene = scene::readScene(set.scene(row));
        truth::TruthOptions options;
        options.samplesPerSide = row.samplesPerSide;
        options.sharpness = true;
        const image::Image now = truth::renderTruth(scene, scene.imageWidth, scene.imageHeight, options);
        const compare::Comparison comparison = compare::compare(image::readImage(set.truth(row)), now, {});
        EXPECT_EQ(comparison.verdict, compare::Verdict::Identical) << row.name << ": " << comparison.sentence;
    }
}

// An environment variable for a while; null: without it.
class Variable {
public:
    Variable(const char* variable, const char* value) : name(variable) {
        const char* const now = std::getenv(name);
        before = now != nullptr ? std::optional<std::string>(now) : std::nullopt;
        set(value);
    }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;
    ~Variable() { set(before ? before->c_str() : nullptr); }

private:
    void set(const char* value) const { value != nullptr ? setenv(name, value, 1) : unsetenv(name); }

    const char* name;
    std::optional<std::string> before;
};

// A folder with one sound golden, to be spoilt.
class UnfitGolden : public testing::Test {
protected:
    UnfitGolden() {
        const golden::Set all(goldenFolder);
        const golden::Case& row = all.find("ring_half");
        fs::create_directory(folder / "scenes");
        fs::copy_file(all.scene(row), folder / "scenes" / "ring_half.json");
        fs::copy_file(all.truth(row), folder / "ring_half.exr");
        fs::copy_file(all.sidecar(row), folder / "ring_half.json");
        writeText(folder / "cases.json", R"({"cases": [{"name": "ring_half", "catches": "x"}]})");
        truth = image::readImage(folder / "ring_half.exr");
        // What a perfect device draws: the values of the truth.
        std::vector<std::string> names = truth.channelNames;
        std::erase_if(names, [](const std::string& name) { return image::findQuantity(name)->isOfTruth(); });
        perfect = image::Image(truth.width, truth.height, names);
        for (int y = 0; y < truth.height; ++y) {
            for (int x = 0; x < truth.width; ++x) {
                for (std::size_t i = 0; i < names.size(); ++i) {
                    perfect.pixel(x, y)[i] = truth.at(x, y, names[i]);
                }
            }
        }
        acceptGolden();
    }

    // Enters the golden as it is in the manifest, and the perfect picture's bits: what comes next must be
    // caught by another gate.
    void acceptGolden() const {
        image::writeManifest(folder / "manifest.json", image::manifestOf(folder));
        golden::writeBits(golden::Set(folder), {{"ring_half", golden::pictureHash(perfect)}}, "test");
    }

    void expectPass() const {
        const golden::Set set(folder);
        const golden::Checked checked = golden::check(set, set.cases()[0], "label", perfect);
        EXPECT_TRUE(checked.report.passed) << checked.report.sentence;
        EXPECT_EQ(checked.exitCode, ExitCode::Ok);
    }

    void expectFailure(const image::Image& actual, ExitCode code, const std::string& words) const {
        const golden::Set set(folder);
        const golden::Checked checked = golden::check(set, set.cases()[0], "label", actual);
        EXPECT_FALSE(checked.report.passed);
        EXPECT_EQ(checked.exitCode, code) << checked.report.sentence;
        EXPECT_NE(checked.report.sentence.find(words), std::string::npos) << checked.report.sentence;
    }

    // Of the golden, with the manifest as it was and then with one that fits.
    void expectUnfit(ExitCode code, const std::string& words) const {
        expectFailure(perfect, ExitCode::File, "ring_half.exr");
        acceptGolden();
        expectFailure(perfect, code, words);
    }

    void writeGolden(const image::Image& picture) const {
        image::writeImage(folder / "ring_half.exr", picture);
    }

    std::vector<std::string> faults() const { return golden::folderFaults(golden::Set(folder)); }

    void expectFault(const std::string& words) const {
        const std::vector<std::string> found = faults();
        ASSERT_EQ(found.size(), 1U) << testing::PrintToString(found);
        EXPECT_NE(found[0].find(words), std::string::npos) << found[0];
    }

    fs::path folder = scratchFolder();
    image::Image truth, perfect;
};

TEST_F(UnfitGolden, IsNotTheSoundOne) {
    expectPass();
    EXPECT_EQ(faults(), std::vector<std::string>());
}

TEST_F(UnfitGolden, Missing) {
    fs::remove(folder / "ring_half.exr");
    expectFailure(perfect, ExitCode::File, "there is no such file");
    expectFault("there is no such file");
}

TEST_F(UnfitGolden, Truncated) {
    fs::resize_file(folder / "ring_half.exr", fs::file_size(folder / "ring_half.exr") / 2);
    expectUnfit(ExitCode::File, "cannot read");
}

TEST_F(UnfitGolden, WithABitFlipped) {
    std::vector<std::byte> bytes = readFile(folder / "ring_half.exr");
    bytes[bytes.size() / 2] ^= std::byte{1};
    writeFile(folder / "ring_half.exr", bytes);
    expectFailure(perfect, ExitCode::File, "ring_half.exr");
    expectFault("ring_half.exr");
}

TEST_F(UnfitGolden, NoPicture) {
    writeText(folder / "ring_half.exr", "version https://git-lfs.github.com/spec/v1\n");
    expectUnfit(ExitCode::File, "cannot read");
}

TEST_F(UnfitGolden, OfAnotherSize) {
    writeGolden(image::Image(truth.width, truth.height - 1, truth.channelNames));
    expectUnfit(ExitCode::SizeDiffers, "48 x 31 pixels");
}

TEST_F(UnfitGolden, WithOtherChannels) {
    writeGolden(image::Image(truth.width, truth.height, {"R", "G", "B", "A"}));
    expectUnfit(ExitCode::SizeDiffers, "channel");
}

TEST_F(UnfitGolden, WithANan) {
    for (const char* channel : {"R", "t", "margin", "tolerance.t"}) {
        image::Image spoilt = truth;
        spoilt.at(7, 9, channel) = std::numeric_limits<float>::quiet_NaN();
        writeGolden(spoilt);
        expectUnfit(ExitCode::NonFinite, "not finite");
    }
}

TEST_F(UnfitGolden, WithAnInfinity) {
    image::Image spoilt = truth;
    spoilt.at(7, 9, "tolerance.color") = std::numeric_limits<float>::infinity();
    writeGolden(spoilt);
    expectUnfit(ExitCode::NonFinite, "not finite");
}

TEST_F(UnfitGolden, Black) {
    writeGolden(image::Image(truth.width, truth.height, truth.channelNames));
    // All margins are 0 then: every pixel may flip, which no truth says of a picture.
    acceptGolden();
    const golden::Set set(folder);
    const golden::Checked checked = golden::check(set, set.cases()[0], "label", perfect);
    EXPECT_FALSE(checked.report.passed) << checked.report.sentence;
}

TEST_F(UnfitGolden, OfAnotherScene) {
    writeText(folder / "scenes" / "ring_half.json", R"({"tori": [{"majorRadius": 1, "minorRadius": 0.25}]})");
    expectFailure(perfect, ExitCode::File, "the scene has changed since");
    expectFault("the scene has changed since");
}

TEST_F(UnfitGolden, WithOtherSamples) {
    writeText(folder / "cases.json",
              R"({"cases": [{"name": "ring_half", "catches": "x", "samplesPerPixel": 4}]})");
    expectFailure(perfect, ExitCode::File, "another number of samples");
}

TEST_F(UnfitGolden, WithoutSidecarManifestOrBits) {
    for (const char* name : {"ring_half.json", "manifest.json"}) {
        const fs::path path = folder / name;
        const std::string text = readTextFile(path);
        fs::remove(path);
        expectFailure(perfect, ExitCode::File, name);
        writeText(path, text);
        expectPass();
    }
    fs::remove(folder / "bits.json");
    expectFault("bits.json");
    golden::writeBits(golden::Set(folder), {}, "none");
    expectFault("nothing about ring_half");
}

TEST_F(UnfitGolden, WithAStrayBesideIt) {
    for (const char* name : {"ring_halfs.exr", "old.json", "scenes/ring.json"}) {
        writeText(folder / name, "");
        const std::vector<std::string> found = faults();
        EXPECT_TRUE(std::ranges::any_of(
            found, [name](const std::string& fault) { return fault.find(name) != std::string::npos; }))
            << name << ": " << testing::PrintToString(found);
        fs::remove(folder / name);
    }
    EXPECT_EQ(faults(), std::vector<std::string>());
}

// Of what is drawn.
TEST_F(UnfitGolden, PictureBlack) {
    expectFailure(image::Image(perfect.width, perfect.height, perfect.channelNames),
                  ExitCode::ComparisonFailed, "not what the truth is sure of");
}

TEST_F(UnfitGolden, PictureShiftedByAPixel) {
    image::Image spoilt = perfect;
    std::rotate(spoilt.pixels.begin(), spoilt.pixels.begin() + spoilt.channelCount(), spoilt.pixels.end());
    expectFailure(spoilt, ExitCode::ComparisonFailed, "not what the truth is sure of");
}

TEST_F(UnfitGolden, PictureWithANanOrAnInfinity) {
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                            -std::numeric_limits<float>::infinity()}) {
        image::Image spoilt = perfect;
        spoilt.at(20, 15, "G") = bad;
        expectFailure(spoilt, ExitCode::NonFinite, "not finite");
    }
}

TEST_F(UnfitGolden, PictureOfAnotherSize) {
    expectFailure(image::Image(perfect.width + 1, perfect.height, perfect.channelNames),
                  ExitCode::SizeDiffers, "49 x 32");
}

// In a pixel that is sure of everything, each channel off by twice what the truth allows there.
TEST_F(UnfitGolden, PictureWithOneValueOff) {
    const int x = 24, y = 21;
    ASSERT_GE(truth.at(x, y, "margin"), 1.0F);
    ASSERT_GE(truth.at(x, y, "id"), 0.0F) << "a pixel without a hit shows little";
    for (const auto& [channel, tolerance] :
         {std::pair("R", "tolerance.color"), std::pair("B", "tolerance.color"), std::pair("t", "tolerance.t"),
          std::pair("position.y", "tolerance.position"), std::pair("normal.z", "tolerance.normal"),
          std::pair("uv.v", "tolerance.uv")}) {
        image::Image spoilt = perfect;
        spoilt.at(x, y, channel) += 2.0F * truth.at(x, y, tolerance);
        expectFailure(spoilt, ExitCode::ComparisonFailed, channel);
    }
    for (const char* channel : {"count", "id", "A"}) {
        image::Image spoilt = perfect;
        spoilt.at(x, y, channel) += 1.0F;
        expectFailure(spoilt, ExitCode::ComparisonFailed, channel);
    }
}

// A device that rounds 8 times as loosely may be 8 times as far off, and no further.
TEST_F(UnfitGolden, PictureOfALooseDevice) {
    const golden::Set set(folder);
    const auto codeAt = [&](const image::Image& actual, float factor) {
        return golden::check(set, set.cases()[0], "label", actual, 0, factor).exitCode;
    };
    for (const float off : {7.5F, 8.5F}) {
        image::Image spoilt = perfect;
        spoilt.at(24, 21, "t") += off * truth.at(24, 21, "tolerance.t");
        EXPECT_EQ(codeAt(spoilt, 1.0F), ExitCode::ComparisonFailed);
        EXPECT_EQ(codeAt(spoilt, 8.0F), off < 8.0F ? ExitCode::Ok : ExitCode::ComparisonFailed);
    }
}

// And may flip where the margin is up to 8. What is exact elsewhere stays so.
TEST_F(UnfitGolden, PictureOfALooseDeviceThatFlips) {
    const int x = 24, y = 21;
    for (const float margin : {4.0F, 8.0F}) {
        image::Image edge = truth;
        for (const char* channel : {"margin", "margin.count", "margin.color"}) {
            edge.at(x, y, channel) = margin;
        }
        writeGolden(edge);
        acceptGolden();
        const golden::Set set(folder);
        for (const char* channel : {"id", "count", "R"}) {
            image::Image spoilt = perfect;
            spoilt.at(x, y, channel) += 1.0F;
            EXPECT_EQ(golden::check(set, set.cases()[0], "label", spoilt).exitCode,
                      ExitCode::ComparisonFailed);
            const golden::Checked loose = golden::check(set, set.cases()[0], "label", spoilt, 0, 8.0F);
            EXPECT_EQ(loose.exitCode, margin < 8.0F ? ExitCode::Ok : ExitCode::ComparisonFailed) << channel;
        }
    }
}

TEST_F(UnfitGolden, PictureWithOtherBits) {
    const golden::Set set(folder);
    EXPECT_EQ(golden::bitsFault(set, set.cases()[0], perfect), "");
    image::Image spoilt = perfect;
    spoilt.at(24, 21, "R") = std::nextafter(spoilt.at(24, 21, "R"), 2.0F);
    EXPECT_NE(golden::bitsFault(set, set.cases()[0], spoilt).find("other bits"), std::string::npos);
}

TEST_F(UnfitGolden, RenewedIsTheSameAgain) {
    const golden::Set set(folder);
    const std::vector<std::byte> before = readFile(folder / "ring_half.exr");
    fs::remove(folder / "ring_half.exr");
    fs::remove(folder / "ring_half.json");
    fs::remove(folder / "manifest.json");
    {
        const Variable ci("CI", "true");
        expectError([&] { golden::renew(set, set.cases(), "test"); }, ExitCode::Usage, {"not in CI"});
    }
    EXPECT_FALSE(fs::exists(folder / "ring_half.exr"));
    const Variable ci("CI", nullptr);
    expectError([&] { golden::renew(set, set.cases(), " "); }, ExitCode::Usage, {"--reason"});
    EXPECT_FALSE(fs::exists(folder / "ring_half.exr"));
    EXPECT_EQ(golden::renew(set, set.cases(), "test").at(0).pixels, 48 * 32);
    EXPECT_EQ(readFile(folder / "ring_half.exr"), before);
    expectPass();
    EXPECT_NE(readTextFile(folder / "ring_half.json").find("\"reason\": \"test\""), std::string::npos);
}

TEST_F(UnfitGolden, TableWithAFault) {
    const auto expectRefused = [this](const std::string& text, const std::string& words) {
        writeText(folder / "cases.json", text);
        expectError([this] { golden::Set set(folder); }, ExitCode::Scene, {words});
    };
    const std::string row = R"({"name": "ring_half", "catches": "x")";
    expectRefused(R"({"cases": []})", "there is no case");
    expectRefused(R"({"cases": [)" + row + "}, " + row + "}]}", "two cases called \"ring_half\"");
    expectRefused(R"({"cases": [)" + row + R"(, "sample": 4}]})", "unknown key");
    expectRefused(R"({"cases": [)" + row + R"(, "samplesPerPixel": 5}]})", "square number");
    expectRefused(R"({"cases": [)" + row + R"(, "methods": {"magic": 0}}]})", "no method \"magic\"");
    expectRefused(R"({"cases": [{"name": "../ring", "catches": "x"}]})", "/cases/0/name");
    expectRefused(R"({"cases": [{"name": "ring_half"}]})", "catches");
    fs::remove(folder / "cases.json");
    expectError([this] { golden::Set set(folder); }, ExitCode::File, {"cases.json"});
}

}  // namespace
}  // namespace raytorus::test
