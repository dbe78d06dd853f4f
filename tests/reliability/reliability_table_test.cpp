// SPDX-License-Identifier: MIT
// docs/reliability.md: each row names the tests that hold it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "support/scratch_folder.hpp"

namespace raytorus::test {
namespace {

// `Suite.Test`, as a text names it.
std::vector<std::pair<std::string, std::string>> testsNamedIn(const std::string& text) {
    std::vector<std::pair<std::string, std::string>> names;
    for (std::size_t begin = text.find('`'); begin != std::string::npos; begin = text.find('`', begin + 1)) {
        const std::size_t end = std::min(text.find('`', begin + 1), text.size());
        const std::string word = text.substr(begin + 1, end - begin - 1);
        const std::size_t point = word.find('.');
        const bool letters =
            std::ranges::all_of(word, [](unsigned char c) { return std::isalnum(c) != 0 || c == '.'; });
        if (letters && point != std::string::npos &&
            std::isupper(static_cast<unsigned char>(word.front())) != 0) {
            names.emplace_back(word.substr(0, point), word.substr(point + 1));
        }
        begin = end;
    }
    return names;
}

// Every test that the table names is there; that it passes is seen when it runs.
TEST(ReliabilityTable, NamesTestsThatAreThere) {
    std::string sources;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(RAYTORUS_SOURCE_DIR "/tests")) {
        sources += entry.path().extension() == ".cpp" ? fileText(entry.path()) : "";
    }
    std::ifstream table(RAYTORUS_SOURCE_DIR "/docs/reliability.md");
    int rows = 0;
    for (std::string row; std::getline(table, row);) {
        if (!row.starts_with("| ") || row.starts_with("| Kind")) {
            continue;
        }
        ++rows;
        const auto names = testsNamedIn(row);
        EXPECT_FALSE(names.empty()) << "no test holds: " << row;
        for (const auto& [suite, test] : names) {
            EXPECT_NE(sources.find(fmt::format("({}, {})", suite, test)), std::string::npos)
                << suite << "." << test;
        }
    }
    EXPECT_GE(rows, 20);
}

}  // namespace
}  // namespace raytorus::test
