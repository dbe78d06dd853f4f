// SPDX-License-Identifier: MIT
// docs/cli.md is true: its exit codes are those of the program and of error.hpp, and its examples work.
#include <sstream>

#include "support/patterns.hpp"
#include "support/program_test.hpp"

namespace raytorus::test {
namespace {

using Rows = std::map<int, std::string>;

// The two groups of every match: number and text.
Rows rowsOf(const std::string& text, const char* pattern) {
    Rows rows;
    for (const PatternMatch& match : matchesIn(text, pattern)) {
        EXPECT_TRUE(rows.emplace(std::stoi(match[1]), match[2]).second) << match[1] << " is there twice";
    }
    return rows;
}

// Every block of this language, one after the other.
std::string blocksOf(const std::string& markdown, const std::string& language) {
    std::string blocks;
    const std::string fence = "```" + language + "\n";
    for (std::size_t at = markdown.find(fence); at != std::string::npos; at = markdown.find(fence, at)) {
        at += fence.size();
        blocks += markdown.substr(at, markdown.find("```", at) - at);
    }
    return blocks;
}

class ProgramDocumentation : public ProgramTest {
protected:
    const std::string page = fileText(RAYTORUS_SOURCE_DIR "/docs/cli.md");
};

TEST_F(ProgramDocumentation, ExitCodesAreThoseOfTheHelp) {
    const Rows documented = rowsOf(page, R"(\n\| (\d+) \| `\w+` \| ([^|\n]+) \|)");
    EXPECT_EQ(documented.size(), 13U);
    EXPECT_EQ(documented, rowsOf(expectOk({"--help"}), R"(\n +(\d+)  ([^\n]+))"));
}

TEST_F(ProgramDocumentation, ExitCodesAreThoseOfTheHeader) {
    const std::string header = fileText(RAYTORUS_SOURCE_DIR "/host/core/error.hpp");
    Rows declared;
    for (const PatternMatch& match : matchesIn(header, R"(\n +(\w+) = (\d+),)")) {
        declared[std::stoi(match[2])] = match[1];
    }
    EXPECT_EQ(declared.size(), 13U);
    EXPECT_EQ(rowsOf(page, R"(\n\| (\d+) \| `(\w+)` \|)"), declared);
}

// In their order, in one folder: later ones read what earlier ones wrote.
TEST_F(ProgramDocumentation, ExamplesWork) {
    std::filesystem::create_directory_symlink(RAYTORUS_SOURCE_DIR "/scenes", folder / "scenes");
    write("rays.csv", blocksOf(page, "csv"));
    write("rays.bin", std::string(32, '\0'));
    std::istringstream lines(blocksOf(page, "sh"));
    int examples = 0;
    for (std::string line; std::getline(lines, line); ++examples) {
        SCOPED_TRACE(line);
        std::istringstream words(line);
        std::string word;
        words >> word;
        EXPECT_EQ(word, "raytorus");
        Arguments arguments;
        while (words >> word) {
            arguments.push_back(word);
        }
        expectOk(arguments);
    }
    EXPECT_EQ(examples, 15);
    EXPECT_TRUE(fileText(folder / "hits.csv").ends_with("\n1,1.75,1.25,0,0,1,0,0\n0,inf,0,0,0,0,0,0\n"));
    for (const char* name : {"ring.png", "chain.exr", "nested.png", "turn-11.png", "all.csv", "hits.bin",
                             "difference.png", "report/index.html", "ray.svg"}) {
        EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
    }
}

}  // namespace
}  // namespace raytorus::test
