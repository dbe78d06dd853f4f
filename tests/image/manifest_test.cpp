// SPDX-License-Identifier: MIT
// The manifest: what it lists is what is there, bit for bit, or a sentence says what is not.
#include "image/manifest.hpp"

#include <gtest/gtest.h>

#include "core/console.hpp"
#include "core/sha256.hpp"
#include "image/image_io.hpp"
#include "support/expect_error.hpp"
#include "support/scratch_folder.hpp"

namespace raytorus::image {
namespace {

namespace fs = std::filesystem;

using test::expectError;
using test::fileText;
using test::scratchFolder;
using test::writeText;

std::string hashOf(std::string_view text) {
    return sha256(std::as_bytes(std::span(text)));
}

// The examples of FIPS 180-4's own test data.
TEST(Sha256, IsThatOfTheStandard) {
    EXPECT_EQ(hashOf(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(hashOf("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(hashOf("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
              "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    EXPECT_EQ(hashOf(std::string(1'000'000, 'a')),
              "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

class ManifestFolder : public testing::Test {
protected:
    ManifestFolder() {
        writeImage(folder / "ring.exr", Image(2, 2, {"R"}));
        writeImage(folder / "chain.exr", Image(3, 2, {"R"}));
        writeText(folder / "README.md", "no picture");
        manifest = manifestOf(folder);
    }

    // The one fault of the folder.
    void expectFault(std::initializer_list<std::string> words) const {
        const std::vector<std::string> faults = manifestFaults(manifest, folder);
        ASSERT_EQ(faults.size(), 1u) << testing::PrintToString(faults);
        for (const std::string& word : words) {
            EXPECT_NE(faults[0].find(word), std::string::npos) << word << " is not in: " << faults[0];
        }
        EXPECT_FALSE(faults[0].ends_with('.'));
    }

    fs::path folder = scratchFolder();
    Manifest manifest;
};

TEST_F(ManifestFolder, ListsThePicturesAndComesBackFromItsFile) {
    ASSERT_EQ(manifest.files.size(), 2u);
    EXPECT_EQ(manifest.files.at("ring.exr").sha256, hashOf(fileText(folder / "ring.exr")));
    EXPECT_EQ(manifest.files.at("ring.exr").bytes, fs::file_size(folder / "ring.exr"));
    writeManifest(folder / "manifest.json", manifest);
    EXPECT_EQ(readManifest(folder / "manifest.json"), manifest);
    EXPECT_TRUE(manifestFaults(manifest, folder).empty());
    const std::string text = fileText(folder / "manifest.json");
    EXPECT_TRUE(text.starts_with("{\n  \"files\": {\n    \"chain.exr\": {\n      \"sha256\": \"")) << text;
    EXPECT_TRUE(text.ends_with("}\n"));
}

TEST_F(ManifestFolder, MissingExtraTruncatedAndChangedEachHaveTheirSentence) {
    fs::remove(folder / "ring.exr");
    expectFault({"ring.exr", "there is no such file", "the manifest lists it"});
    fs::create_directory(folder / "ring.exr");
    expectFault({"ring.exr", "it is a directory"});
    fs::remove(folder / "ring.exr");
    writeImage(folder / "ring.exr", Image(2, 2, {"R"}));
    EXPECT_TRUE(manifestFaults(manifest, folder).empty());  // the same image gives the same bytes

    writeImage(folder / "ring2.exr", Image(2, 2, {"R"}));
    expectFault({"ring2.exr", "is not in the manifest"});
    fs::remove(folder / "ring2.exr");

    const std::uintmax_t size = fs::file_size(folder / "chain.exr");
    fs::resize_file(folder / "chain.exr", size - 1);
    expectFault({"chain.exr", "truncated", std::to_string(size - 1), std::to_string(size)});
    fs::resize_file(folder / "chain.exr", 0);
    expectFault({"chain.exr", "truncated", " 0 of "});

    std::string text = fileText(folder / "ring.exr");
    writeImage(folder / "chain.exr", Image(3, 2, {"R"}));
    text[text.size() / 2] = static_cast<char>(text[text.size() / 2] ^ 1);
    writeText(folder / "ring.exr", text);
    expectFault({"ring.exr", "is not the file that the manifest lists", hashOf(text),
                 manifest.files.at("ring.exr").sha256});
}

TEST_F(ManifestFolder, EveryFaultOfAFolderIsTold) {
    fs::remove(folder / "ring.exr");
    fs::resize_file(folder / "chain.exr", 5);
    writeText(folder / "a.png", "");
    const std::vector<std::string> faults = manifestFaults(manifest, folder);
    ASSERT_EQ(faults.size(), 3u);
    EXPECT_NE(faults[0].find("a.png"), std::string::npos);
    EXPECT_NE(faults[1].find("chain.exr"), std::string::npos);
    EXPECT_NE(faults[2].find("ring.exr"), std::string::npos);
    expectError([&] { std::ignore = manifestFaults(manifest, folder / "none"); }, ExitCode::File,
                {"none", "cannot list"});
}

TEST_F(ManifestFolder, ANameThatIsNotUtf8CannotBeWritten) {
    EXPECT_TRUE(isUtf8("caf\xc3\xa9 \n\xef\xbf\xbd"));
    EXPECT_FALSE(isUtf8("caf\xe9"));
    writeManifest(folder / "manifest.json", manifest);
    writeImage(folder / "caf\xe9.exr", Image(2, 2, {"R"}));
    expectError([&] { writeManifest(folder / "manifest.json", manifestOf(folder)); }, ExitCode::File,
                {".exr", "UTF-8"});
    EXPECT_EQ(readManifest(folder / "manifest.json"), manifest);
}

TEST_F(ManifestFolder, WhatIsNoManifestIsRefused) {
    const fs::path path = folder / "manifest.json";
    const std::string hash(64, 'a');
    const auto refuse = [&](const std::string& text, const std::string& word) {
        writeText(path, text);
        expectError([&] { std::ignore = readManifest(path); }, ExitCode::File, {"manifest.json", word});
    };
    refuse("", "not JSON");
    refuse("{\"files\": ", "not JSON");
    refuse("[]", "files");
    refuse("{}", "files");
    refuse("{\"files\": []}", "files");
    const auto entry = [&](const std::string& name, const std::string& sha256, const std::string& bytes) {
        return R"({"files": {")" + name + R"(": {"sha256": )" + sha256 + R"(, "bytes": )" + bytes + "}}}";
    };
    refuse(R"({"files": {"a.exr": {"bytes": 1}}})", "sha256");
    refuse(R"({"files": {"a.exr": 1}})", "sha256");
    refuse(entry("a.exr", "12", "1"), "sha256");
    refuse(entry("a.exr", "\"" + hash.substr(1) + "\"", "1"), "sha256");
    refuse(entry("a.exr", "\"" + hash.substr(1) + "A\"", "1"), "sha256");
    refuse(entry("a.exr", "\"" + hash + "\"", "-1"), "bytes");
    refuse(entry("a.exr", "\"" + hash + "\"", "\"1\""), "bytes");
    for (const char* name : {"", ".", "..", "../a.exr", "/a.exr", "a/b.exr"}) {
        refuse(entry(name, "\"" + hash + "\"", "1"), "is not the name of a file");
    }
    fs::remove(path);
    expectError([&] { std::ignore = readManifest(path); }, ExitCode::File, {"manifest.json", "no such file"});
}

}  // namespace
}  // namespace raytorus::image
