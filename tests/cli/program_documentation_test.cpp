// SPDX-License-Identifier: MIT
// docs/cli.md is true: its exit codes are those of the program and of error.hpp, its channels those of
// image/channels.hpp, and its examples work.
#include <fmt/format.h>

#include <sstream>

#include "image/channels.hpp"
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

// "`position.x`, `.y`, `.z`".
std::string documentedNames(const image::Quantity& quantity) {
    const std::string_view first = quantity.channels().front();
    const std::size_t dot = std::min(first.find('.'), first.size());
    std::string text = fmt::format("`{}`", first);
    for (const std::string_view other : quantity.channels().subspan(1)) {
        text += fmt::format(", `{}`", other.substr(dot == first.size() ? 0 : dot));
    }
    return text;
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

TEST_F(ProgramDocumentation, ChannelsAreThoseOfTheTable) {
    std::string values = "| Channel | Value | Where nothing is hit |\n|---|---|---|\n";
    std::string truths = "| Channel | Meaning |\n|---|---|\n";
    for (const image::Quantity& quantity : image::quantities) {
        (quantity.isOfTruth() ? truths : values) +=
            fmt::format("| {} | {} |{}\n", documentedNames(quantity), quantity.meaning,
                        quantity.isOfTruth() ? "" : fmt::format(" {} |", quantity.onMiss));
    }
    EXPECT_NE(page.find("\n\n" + values + "\n"), std::string::npos) << "docs/cli.md has not:\n" << values;
    const std::string judged = fileText(RAYTORUS_SOURCE_DIR "/docs/golden.md");
    EXPECT_NE(judged.find("\n\n" + truths + "\n"), std::string::npos) << "docs/golden.md has not:\n"
                                                                      << truths;
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
