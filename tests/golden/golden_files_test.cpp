// SPDX-License-Identifier: MIT
// The files of a golden folder: what is wrong in one is said with its place, hides nothing else, and a
// renewal changes all of them or none.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/file.hpp"
#include "failing_rename.hpp"
#include "golden/golden_check.hpp"
#include "golden/golden_folder.hpp"
#include "golden/golden_renew.hpp"
#include "image/manifest.hpp"
#include "support/expect_error.hpp"
#include "support/process_limits.hpp"
#include "support/scratch_folder.hpp"

namespace raytorus::test {
namespace {

namespace fs = std::filesystem;

// A sound golden of its own.
class GoldenFiles : public testing::Test {
protected:
    GoldenFiles() {
        unsetenv("CI");
        const fs::path all = fs::path(RAYTORUS_SOURCE_DIR) / "golden";
        fs::create_directory(folder / "scenes");
        for (const char* name : {"scenes/ring_half.json", "ring_half.json", "ring_half.exr"}) {
            fs::copy_file(all / name, folder / name);
        }
        writeText(folder / "cases.json", R"({"cases": [{"name": "ring_half", "catches": "x"}]})");
        image::writeManifest(folder / "manifest.json", image::manifestOf(folder));
        golden::writeBits(set(), {{"ring_half", "0"}}, "test");
    }

    [[nodiscard]] golden::Set set() const { return golden::Set(folder); }

    // A fault of the truth that names the file and the place in it.
    void expectSidecarFault(const std::string& text, const std::string& words) const {
        writeText(folder / "ring_half.json", text);
        expectError([this] { static_cast<void>(golden::truthFault(set(), set().cases()[0])); },
                    ExitCode::File, {"ring_half.json: ", words});
        expectFaults({words});
    }

    // Of the folder: these and no others.
    void expectFaults(const std::vector<std::string>& words) const {
        const std::vector<std::string> faults = golden::folderFaults(set());
        EXPECT_EQ(faults.size(), words.size()) << testing::PrintToString(faults);
        for (const std::string& word : words) {
            EXPECT_TRUE(std::ranges::any_of(
                faults, [&](const std::string& fault) { return fault.find(word) != std::string::npos; }))
                << word << " is not in " << testing::PrintToString(faults);
        }
    }

    void expectNoRenewal(ExitCode code, std::initializer_list<std::string> words) const {
        const auto before = texts();
        expectError([this] { golden::renew(set(), set().cases(), "test"); }, code, words);
        EXPECT_TRUE(texts() == before) << testing::PrintToString(namesIn(folder));
    }

    [[nodiscard]] std::map<std::string, std::string> texts() const {
        std::map<std::string, std::string> found;
        for (const std::string& name : namesIn(folder)) {
            std::error_code ignored;
            found[name] = fs::is_regular_file(folder / name, ignored) ? fileText(folder / name) : "";
        }
        return found;
    }

    fs::path folder = scratchFolder();
};

TEST_F(GoldenFiles, AreSound) {
    expectFaults({});
    golden::requireSound(set());
    writeText(folder / "scenes" / "ring_half.json", R"({"tori": [{"majorRadius": 1, "minorRadius": 0.25}]})");
    expectError([this] { golden::requireSound(set()); }, ExitCode::File, {"the scene has changed"});
}

TEST_F(GoldenFiles, ASidecarWithAValueOfAWrongTypeNamesItsPlace) {
    expectSidecarFault(R"({"scene": 5, "samplesPerPixel": 1})", "/scene: 5 is not a string");
    expectSidecarFault(R"({"scene": null, "samplesPerPixel": 1})", "/scene: null is not a string");
    expectSidecarFault(R"({"scene": "x", "samplesPerPixel": "one"})",
                       "/samplesPerPixel: \"one\" is not an integer");
    expectSidecarFault(R"({"scene": "x", "samplesPerPixel": 1.5})",
                       "/samplesPerPixel: 1.5 is not an integer");
    expectSidecarFault(R"({"scene": "x", "samplesPerPixel": 1e30})",
                       "/samplesPerPixel: 1e+30 is not an integer");
    expectSidecarFault(R"({"scene": "x", "samplesPerPixel": 1, "pixels": []})", "/pixels: ");
    expectSidecarFault(R"({"scene": "x", "samplesPerPixel": 1, "reason": 1})", "/reason: 1 is not a string");
    expectSidecarFault(R"({"scene": "x"})", "samplesPerPixel");
    expectSidecarFault("[]", "is not an object");
    expectSidecarFault("", "line 1");
    expectSidecarFault("\"\xff\"", "line 1");
}

TEST_F(GoldenFiles, BitsWithAValueOfAWrongTypeNameItsPlace) {
    for (const auto& [text, words] :
         {std::pair(R"({"sha256": {"ring_half": 5}})", "/sha256/ring_half: 5 is not a string"),
          std::pair(R"({"sha256": ["ring_half"]})", "/sha256: "), std::pair("{}", "'sha256' is missing"),
          std::pair("7", "7 is not an object"), std::pair("{", "line 1")}) {
        writeText(folder / "bits.json", text);
        expectError([this] { static_cast<void>(golden::readBits(set())); }, ExitCode::File,
                    {"bits.json: ", words});
        expectFaults({words});
    }
}

TEST_F(GoldenFiles, NoFaultOfTheFolderHidesAnother) {
    writeText(folder / "manifest.json", R"({"files": {"ring_half.exr": 3}})");
    writeText(folder / "bits.json", "[]");
    writeText(folder / "ring_half.json", R"({"scene": 1})");
    writeText(folder / "old.json", "");
    expectFaults({"manifest.json", "bits.json", "ring_half.json: ", "old.json"});
}

TEST_F(GoldenFiles, AFolderThatCannotBeListedIsAFault) {
    fs::remove_all(folder / "scenes");
    writeText(folder / "scenes", "no folder");
    expectFaults({"cannot list the folder", "ring_half.json\": "});
}

// Each level takes an open file, were they listed.
TEST_F(GoldenFiles, WhatIsInAStrayFolderIsNotLookedAt) {
    fs::path deep = folder / "stray";
    for (int i = 0; i < 100; ++i) {
        deep /= "a";
    }
    fs::create_directories(deep);
    const Limit limit(RLIMIT_NOFILE, 64);
    expectFaults({"stray: no case"});
}

TEST_F(GoldenFiles, AManifestThatCannotBeReadIsNotOneThatIsNotThere) {
    fs::remove(folder / "manifest.json");
    fs::create_symlink("manifest.json", folder / "manifest.json");
    expectNoRenewal(ExitCode::File, {"manifest.json", "symbolic links"});
    fs::remove(folder / "manifest.json");
    fs::create_symlink("nowhere", folder / "manifest.json");
    expectNoRenewal(ExitCode::File, {"manifest.json", "no such file"});
    fs::remove(folder / "manifest.json");
    fs::create_directory(folder / "manifest.json");
    expectNoRenewal(ExitCode::File, {"manifest.json", "it is a directory"});
    fs::remove(folder / "manifest.json");
    golden::renew(set(), set().cases(), "test");
    EXPECT_EQ(image::readManifest(folder / "manifest.json"), image::manifestOf(folder));
}

TEST_F(GoldenFiles, ARenewalLeavesTheEntriesOfOthers) {
    image::Manifest manifest = image::readManifest(folder / "manifest.json");
    const image::ManifestEntry other = {std::string(64, 'a'), 1};
    manifest.files["other.exr"] = other;
    manifest.files["ring_half.exr"] = other;
    image::writeManifest(folder / "manifest.json", manifest);
    golden::renew(set(), set().cases(), "test");
    const image::Manifest after = image::readManifest(folder / "manifest.json");
    EXPECT_EQ(after.files.at("other.exr"), other);
    EXPECT_EQ(after.files.at("ring_half.exr"), image::manifestOf(folder).files.at("ring_half.exr"));
}

// The manifest, which comes last, becomes larger than any file may. It is small enough to be found so only
// when it is finished, with the picture and the sidecar in their places.
TEST_F(GoldenFiles, ARenewalThatFailsInTheMiddleChangesNothing) {
    writeText(folder / "ring_half.exr", "the picture before");
    writeText(folder / "ring_half.json", "the sidecar before");
    const FailingRename failing("/manifest.json");
    expectNoRenewal(ExitCode::File, {"manifest.json", "all files are as they were"});
    EXPECT_EQ(fileText(folder / "ring_half.exr"), "the picture before");
}

TEST_F(GoldenFiles, WhatKeepsCasesFromBeingDrawnIsKnownBefore) {
    writeText(folder / "scenes" / "ring_half.json", R"({"tori": 5})");
    expectError([this] { golden::requireSound(set()); }, ExitCode::Scene, {"scenes/ring_half.json", "/tori"});
    expectNoRenewal(ExitCode::Scene, {"scenes/ring_half.json", "/tori"});
    fs::remove(folder / "scenes" / "ring_half.json");
    expectNoRenewal(ExitCode::File, {"scenes/ring_half.json", "no such file"});
}

TEST_F(GoldenFiles, AReasonThatJsonCannotHoldIsRefused) {
    const auto before = texts();
    expectError([this] { golden::renew(set(), set().cases(), "caf\xe9"); }, ExitCode::Usage,
                {"--reason", "UTF-8"});
    EXPECT_TRUE(texts() == before);
    golden::renew(set(), set().cases(), "caf\xc3\xa9");
    EXPECT_NE(fileText(folder / "ring_half.json").find("caf\xc3\xa9"), std::string::npos);
}

TEST(GoldenExitCode, OfTwoTheOneThatSaysMore) {
    const std::vector<ExitCode> order = {
        ExitCode::File,        ExitCode::Scene,     ExitCode::Shader,           ExitCode::OutOfMemory,
        ExitCode::SizeDiffers, ExitCode::NonFinite, ExitCode::ComparisonFailed, ExitCode::Ok};
    for (std::size_t i = 0; i < order.size(); ++i) {
        for (std::size_t j = i; j < order.size(); ++j) {
            EXPECT_EQ(golden::worse(order[i], order[j]), order[i]);
            EXPECT_EQ(golden::worse(order[j], order[i]), order[i]);
        }
    }
    EXPECT_FALSE(golden::isOfOneCase(ExitCode::DeviceLost));
    EXPECT_FALSE(golden::isOfOneCase(ExitCode::NoDevice));
    EXPECT_TRUE(golden::isOfOneCase(ExitCode::Scene));
}

}  // namespace
}  // namespace raytorus::test
