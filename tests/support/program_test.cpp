// SPDX-License-Identifier: MIT
#include "program_test.hpp"

#include <algorithm>
#include <sstream>

#include "image/image_io.hpp"

namespace raytorus::test {
namespace {

namespace fs = std::filesystem;

// Everything in a folder: files with their contents, folders with none.
std::map<std::string, std::string> contentsOf(const fs::path& folder) {
    std::map<std::string, std::string> contents;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
        contents[entry.path().string()] = entry.is_regular_file() ? fileText(entry.path()) : std::string();
    }
    return contents;
}

// The value of -o, if it names a file that could be there.
fs::path outputOf(const std::vector<std::string>& arguments, const fs::path& folder) {
    const auto option = std::find(arguments.begin(), arguments.end(), "-o");
    if (option == arguments.end() || option + 1 == arguments.end()) {
        return {};
    }
    const fs::path output = folder / *(option + 1);
    return fs::is_directory(output.parent_path()) && !fs::exists(output) ? output : fs::path();
}

}  // namespace

ProgramResult ProgramTest::run(const Arguments& arguments, const Environment& environment) const {
    ProgramSettings settings;
    settings.folder = folder;
    settings.environment = environment;
    return runProgram(RAYTORUS_PROGRAM, arguments, settings);
}

std::string ProgramTest::expectOk(const Arguments& arguments, const Environment& environment) const {
    const ProgramResult result = run(arguments, environment);
    EXPECT_EQ(result.exitCode, 0) << testing::PrintToString(result);
    EXPECT_EQ(result.err, "");
    return result.out;
}

void ProgramTest::expectFailureOnce(const Arguments& arguments, ExitCode code,
                                    const std::vector<std::string>& words, const Environment& environment,
                                    bool moreLines) const {
    const auto before = contentsOf(folder);
    const ProgramResult result = run(arguments, environment);
    EXPECT_EQ(result.exitCode, static_cast<int>(code)) << testing::PrintToString(result);
    EXPECT_EQ(result.out, "");
    EXPECT_TRUE(result.err.starts_with("raytorus: ") && result.err.ends_with('\n')) << result.err;
    const auto lines = std::count(result.err.begin(), result.err.end(), '\n');
    EXPECT_TRUE(moreLines ? lines > 1 : lines == 1) << result.err;
    for (const std::string& word : words) {
        EXPECT_NE(result.err.find(word), std::string::npos) << "\"" << word << "\" is not in: " << result.err;
    }
    EXPECT_TRUE(contentsOf(folder) == before) << "now there are: " << testing::PrintToString(namesIn(folder));
}

void ProgramTest::expectFailureTwice(const Arguments& arguments, ExitCode code,
                                     const std::vector<std::string>& words, const Environment& environment,
                                     bool moreLines) const {
    expectFailureOnce(arguments, code, words, environment, moreLines);
    if (const fs::path output = outputOf(arguments, folder); !output.empty()) {
        writeText(output, "what was there before");
        expectFailureOnce(arguments, code, words, environment, moreLines);
        fs::remove(output);
    }
}

void ProgramTest::expectFailure(const Arguments& arguments, ExitCode code,
                                const std::vector<std::string>& words, const Environment& environment) const {
    expectFailureTwice(arguments, code, words, environment, false);
}

void ProgramTest::expectLongFailure(const Arguments& arguments, ExitCode code,
                                    const std::vector<std::string>& words,
                                    const Environment& environment) const {
    expectFailureTwice(arguments, code, words, environment, true);
}

std::string ProgramTest::write(const std::string& name, const std::string& text) const {
    writeText(folder / name, text);
    return (folder / name).string();
}

image::Image ProgramTest::picture(const std::string& name) const {
    return image::readImage(folder / name);
}

std::string ProgramTest::scene(const std::string& name) {
    return RAYTORUS_SOURCE_DIR "/scenes/" + name + ".json";
}

fs::path ProgramTest::shaderFolder() const {
    const fs::path copies = folder / "shaders";
    fs::create_directory(copies);
    for (const fs::directory_entry& entry : fs::directory_iterator(RAYTORUS_SHADER_FOLDER)) {
        if (entry.path().extension() == ".spv") {
            fs::copy_file(entry.path(), copies / entry.path().filename());
        }
    }
    return copies;
}

std::vector<float> numbersIn(const std::string& csv) {
    std::vector<float> numbers;
    std::istringstream lines(csv.substr(csv.find('\n') + 1));
    for (std::string line; std::getline(lines, line);) {
        std::istringstream fields(line);
        for (std::string field; std::getline(fields, field, ',');) {
            numbers.push_back(std::strtof(field.c_str(), nullptr));
        }
    }
    return numbers;
}

Environment noDriver() {
    return {{"VK_DRIVER_FILES", "/there/is/no/driver.json"},
            {"VK_ICD_FILENAMES", "/there/is/no/driver.json"}};
}

}  // namespace raytorus::test
