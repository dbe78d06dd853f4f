// SPDX-License-Identifier: MIT
// A folder with two goldens, one of them drawn by other methods as well.
#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <string>

#include "program_test.hpp"

namespace raytorus::test {

class ProgramGolden : public ProgramTest {
protected:
    ProgramGolden() { copyGoldens("golden"); }

    /// "dark" and "horn", into a folder of this name. Its manifest and bits know of all others, too.
    void copyGoldens(const std::string& name) const {
        namespace fs = std::filesystem;
        const fs::path source = fs::path(RAYTORUS_SOURCE_DIR) / "golden";
        const fs::path copy = folder / name;
        fs::create_directories(copy / "scenes");
        writeText(copy / "cases.json",
                  R"({"cases": [{"name": "dark", "catches": "no light", "methods": {"bracketed-newton": 0}},
                            {"name": "horn", "catches": "the point"}]})");
        for (const char* row : {"dark", "horn"}) {
            for (const char* file : {"scenes/{}.json", "{}.json", "{}.exr"}) {
                const std::string path = fmt::format(fmt::runtime(file), row);
                fs::copy_file(source / path, copy / path);
            }
        }
        for (const char* file : {"manifest.json", "bits.json"}) {
            fs::copy_file(source / file, copy / file);
        }
    }

    /// Checks both cases by name.
    [[nodiscard]] ProgramResult check(const Arguments& options = {}) const {
        Arguments arguments = {"golden", "check", "dark", "horn"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        return run(arguments);
    }

    void expectCheck(ExitCode code, const std::string& words) const {
        const ProgramResult result = check();
        EXPECT_EQ(result.exitCode, static_cast<int>(code)) << testing::PrintToString(result);
        EXPECT_NE(result.out.find(words), std::string::npos) << result.out;
    }

    void renew(const Arguments& options) const {
        Arguments arguments = {"golden", "renew", "--reason", "test"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        EXPECT_NE(expectOk(arguments, {{"CI", ""}}).find("renewed"), std::string::npos);
    }
};

}  // namespace raytorus::test
