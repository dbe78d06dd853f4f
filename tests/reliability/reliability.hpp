// SPDX-License-Identifier: MIT
// Commands as people type them, run by a shell in a folder of its own, and how they end.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "support/program_test.hpp"
#include "support/run_program.hpp"
#include "support/scratch_folder.hpp"

namespace raytorus::test {

class Reliability : public testing::Test {
protected:
    Reliability() {
        writeText(folder / "ring.json", smallScene);
        writeText(folder / "rays.csv", "3,0,0,0,-1,0,0,inf\n");
        writeText(folder / "hits.csv", "old");
    }

    // The programs are on the shell's PATH.
    [[nodiscard]] ProgramResult shell(const std::string& command, Environment environment = {}) const {
        environment["PATH"] = std::string(RAYTORUS_PROGRAMS) + ":/usr/bin:/bin";
        return runProgram("/bin/sh", {"-c", command}, {folder, environment});
    }

    // It ends with this code, and says one line that has the words.
    void expectEnd(const std::string& command, ExitCode code, const std::vector<std::string>& words = {},
                   const Environment& environment = {}) const {
        const ProgramResult result = shell(command, environment);
        EXPECT_EQ(result.exitCode, static_cast<int>(code)) << command << "\n" << result.err;
        if (code != ExitCode::Ok) {
            EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << command << "\n" << result.err;
        }
        for (const std::string& word : words) {
            EXPECT_NE(result.err.find(word), std::string::npos)
                << command << "\nnot \"" << word << "\" in " << result.err;
        }
    }

    // What is written, when a read() of the file named gives EIO from this byte on.
    [[nodiscard]] static Environment failingRead(const std::string& name, int byte) {
        // A sanitizer wants to be the first library.
        return {{"LD_PRELOAD", RAYTORUS_FAILING_CALLS},
                {"ASAN_OPTIONS", "verify_asan_link_order=0:detect_leaks=0"},
                {"FAIL_NAME", name},
                {"FAIL_READ", std::to_string(byte)}};
    }
    [[nodiscard]] static Environment failing(const std::string& name, const std::string& call) {
        Environment environment = failingRead(name, 0);
        environment.erase("FAIL_READ");
        environment[call] = "1";
        return environment;
    }

    [[nodiscard]] std::string text(const std::string& name) const { return fileText(folder / name); }

    std::filesystem::path folder = scratchFolder();
};

inline const std::string traceTo = "raytorus trace rays.csv -o hits.csv --torus 1,0.25";

}  // namespace raytorus::test
