// SPDX-License-Identifier: MIT
// docs/viewer.md is true: its views, keys and events are the program's.
#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <sstream>
#include <string>

#include "core/file.hpp"
#include "viewer/keys.hpp"
#include "viewer/view_list.hpp"

namespace raytorus::test {
namespace {

const std::filesystem::path source = RAYTORUS_SOURCE_DIR;

std::string page() {
    return readTextFile(source / "docs" / "viewer.md");
}

// As a block of code stands in the page.
std::string indented(const std::string& text) {
    std::istringstream lines(text);
    std::string result;
    for (std::string line; std::getline(lines, line);) {
        result += "    " + line + "\n";
    }
    return result;
}

// The words between `before` and a quotation mark or a backtick.
std::set<std::string> wordsAfter(const std::string& text, const std::string& before) {
    std::set<std::string> words;
    for (std::size_t at = text.find(before); at != std::string::npos; at = text.find(before, at + 1)) {
        const std::size_t begin = at + before.size();
        words.insert(text.substr(begin, text.find_first_of("\"`", begin) - begin));
    }
    return words;
}

TEST(ViewerDocumentation, ListsTheViews) {
    EXPECT_NE(page().find("\n\n" + indented(viewer::viewTable()) + "\n"), std::string::npos);
}

TEST(ViewerDocumentation, ListsTheKeys) {
    EXPECT_NE(page().find("\n\n" + indented(viewer::keyTable()) + "\n"), std::string::npos);
}

TEST(ViewerDocumentation, ListsTheEvents) {
    std::set<std::string> written;
    for (const auto& entry : std::filesystem::directory_iterator(source / "host" / "viewer")) {
        if (entry.path().extension() == ".cpp") {
            written.merge(wordsAfter(readTextFile(entry.path()), "log.write(\""));
            written.merge(wordsAfter(readTextFile(entry.path()), "log->write(\""));
        }
    }
    EXPECT_GE(written.size(), 20U);
    const std::string text = page();
    const std::size_t table = text.find("| event |");
    ASSERT_NE(table, std::string::npos);
    const std::string rows = text.substr(table, text.find("\n\n", table) - table);
    std::set<std::string> documented;
    std::istringstream lines(rows);
    std::string line;
    std::getline(lines, line);
    std::getline(lines, line);
    while (std::getline(lines, line)) {
        const std::string names = line.substr(0, line.find('|', 1));
        for (std::size_t at = names.find('`'); at != std::string::npos; at = names.find('`', at + 1)) {
            const std::size_t end = names.find('`', at + 1);
            documented.insert(names.substr(at + 1, end - at - 1));
            at = end;
        }
    }
    EXPECT_EQ(written, documented);
}

}  // namespace
}  // namespace raytorus::test
