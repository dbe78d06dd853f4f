// SPDX-License-Identifier: MIT
// What --help and --version print, and that the examples in the help are made of options that exist.
#include <cctype>
#include <set>
#include <sstream>

#include "support/program_test.hpp"

namespace raytorus::test {
namespace {

std::vector<std::string> wordsOf(const std::string& line) {
    std::istringstream stream(line);
    std::vector<std::string> words;
    for (std::string word; stream >> word;) {
        words.push_back(word);
    }
    return words;
}

// "-o,--output FILE ..." has two.
std::set<std::string> optionsIn(const std::string& help) {
    std::set<std::string> options;
    std::istringstream lines(help);
    for (std::string line; std::getline(lines, line);) {
        const std::vector<std::string> words = wordsOf(line);
        if (words.empty() || !words.front().starts_with('-')) {
            continue;
        }
        std::istringstream names(words.front());
        for (std::string name; std::getline(names, name, ',');) {
            options.insert(name);
        }
    }
    return options;
}

// The lines of the part "Examples:", up to the next empty one, that call the program.
std::vector<std::string> examplesIn(const std::string& help) {
    std::istringstream lines(help.substr(std::min(help.find("Examples:\n"), help.size())));
    std::vector<std::string> examples;
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line) && !line.empty()) {
        if (const std::size_t call = line.find("raytorus "); call != std::string::npos) {
            examples.push_back(line.substr(call));
        }
    }
    return examples;
}

class ProgramHelp : public ProgramTest {
protected:
    // The examples of one help text, which may call any command.
    void expectGoodExamples(const std::string& help) const {
        const std::vector<std::string> examples = examplesIn(help);
        EXPECT_FALSE(examples.empty()) << help;
        for (const std::string& example : examples) {
            const std::vector<std::string> words = wordsOf(example);
            ASSERT_GE(words.size(), 2U) << example;
            const std::set<std::string> options = optionsIn(expectOk({words[1], "--help"}));
            EXPECT_TRUE(options.contains("--help")) << example;
            for (const std::string& word : words) {
                // A negative number is no option.
                const bool option = word.starts_with('-') && std::isdigit(word[1]) == 0;
                EXPECT_TRUE(!option || options.contains(word)) << word << " in: " << example;
            }
        }
    }
};

TEST_F(ProgramHelp, NamesEveryCommand) {
    const std::string help = expectOk({"--help"});
    for (const char* command : {"render", "trace", "compare", "explain", "doctor"}) {
        EXPECT_NE(help.find(std::string("\n  ") + command + " "), std::string::npos) << command;
    }
    expectGoodExamples(help);
}

TEST_F(ProgramHelp, ShortOptionIsTheSame) {
    EXPECT_EQ(expectOk({"-h"}), expectOk({"--help"}));
    EXPECT_EQ(expectOk({"render", "-h"}), expectOk({"render", "--help"}));
}

TEST_F(ProgramHelp, OfRender) {
    const std::string help = expectOk({"render", "--help"});
    const std::set<std::string> expected = {"-h",        "--help",   "-o",    "--output", "--route",
                                            "--method",  "--size",   "--spp", "--stats",  "--repeat",
                                            "--time",    "--frames", "--fps", "--device", "--validate",
                                            "--timeout", "--shaders"};
    EXPECT_EQ(optionsIn(help), expected);
    expectGoodExamples(help);
}

TEST_F(ProgramHelp, OfTrace) {
    const std::string help = expectOk({"trace", "--help"});
    const std::set<std::string> expected = {"-h",       "--help",     "-o",        "--output",
                                            "--method", "--torus",    "--all",     "--any",
                                            "--device", "--validate", "--timeout", "--shaders"};
    EXPECT_EQ(optionsIn(help), expected);
    expectGoodExamples(help);
}

TEST_F(ProgramHelp, OfCompare) {
    const std::string help = expectOk({"compare", "--help"});
    const std::set<std::string> expected = {
        "-h",       "--help",        "--tolerance", "--relative",     "--ulp",
        "--allow",  "--allow-flips", "--channel",   "--window-limit", "--manifest",
        "--report", "--difference",  "--json"};
    EXPECT_EQ(optionsIn(help), expected);
    expectGoodExamples(help);
}

TEST_F(ProgramHelp, OfExplain) {
    const std::string help = expectOk({"explain", "--help"});
    const std::set<std::string> expected = {"-h",        "--help",   "--torus", "--origin", "--direction",
                                            "--t-min",   "--t-max",  "--scene", "--pixel",  "--size",
                                            "--replay",  "--json",   "--svg",   "--device", "--validate",
                                            "--timeout", "--shaders"};
    EXPECT_EQ(optionsIn(help), expected);
    expectGoodExamples(help);
}

TEST_F(ProgramHelp, OfDoctor) {
    const std::string help = expectOk({"doctor", "--help"});
    EXPECT_EQ(optionsIn(help), (std::set<std::string>{"-h", "--help"}));
    expectGoodExamples(help);
}

TEST_F(ProgramHelp, VersionIsTheProjects) {
    EXPECT_EQ(expectOk({"--version"}), "raytorus " RAYTORUS_PROJECT_VERSION "\n");
}

// Help is for those too whose Vulkan does not work.
TEST_F(ProgramHelp, NeedsNoDriver) {
    EXPECT_NE(expectOk({"render", "--help"}, noDriver()), "");
    EXPECT_NE(expectOk({"--version"}, noDriver()), "");
}

}  // namespace
}  // namespace raytorus::test
