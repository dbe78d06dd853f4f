// SPDX-License-Identifier: MIT
// The raytorus program run in a folder of the test's own, and what every failure of it must look like.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <initializer_list>
#include <map>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "image/image.hpp"
#include "run_program.hpp"
#include "scratch_folder.hpp"

namespace raytorus::test {

class ProgramTest : public testing::Test {
protected:
    using Arguments = std::vector<std::string>;

    /// Runs it in `folder`.
    [[nodiscard]] ProgramResult run(const Arguments& arguments, const Environment& environment = {}) const;

    /// Runs it, and expects it to end well and to say nothing on standard error. Returns its standard output.
    std::string expectOk(const Arguments& arguments, const Environment& environment = {}) const;

    /// Runs it, and expects this exit code, nothing on standard output, and on standard error one line that
    /// begins with "raytorus: " and has the words. `more`: other lines may follow it. No file in `folder` is
    /// made, removed or changed. Then the same with a file that is already there under the name of the
    /// output, if `output` names one.
    void expectFailure(const Arguments& arguments, ExitCode code, const std::vector<std::string>& words,
                       const Environment& environment = {}) const;
    void expectLongFailure(const Arguments& arguments, ExitCode code, const std::vector<std::string>& words,
                           const Environment& environment = {}) const;

    /// The path of a file in `folder` that now has this text.
    std::string write(const std::string& name, const std::string& text) const;

    /// A picture that the program has made.
    [[nodiscard]] image::Image picture(const std::string& name) const;

    /// The path of a scene that ships.
    [[nodiscard]] static std::string scene(const std::string& name);

    /// A folder with a copy of the built shaders.
    [[nodiscard]] std::filesystem::path shaderFolder() const;

    std::filesystem::path folder = scratchFolder();

private:
    void expectFailureOnce(const Arguments& arguments, ExitCode code, const std::vector<std::string>& words,
                           const Environment& environment, bool moreLines) const;
    void expectFailureTwice(const Arguments& arguments, ExitCode code, const std::vector<std::string>& words,
                            const Environment& environment, bool moreLines) const;
};

/// A torus, 24 x 16 pixels.
inline constexpr const char* smallScene =
    R"({"image": {"width": 24, "height": 16}, "tori": [{"majorRadius": 1, "minorRadius": 0.25}]})";

/// The numbers of a CSV text with a header, row by row.
std::vector<float> numbersIn(const std::string& csv);

/// What makes the Vulkan loader find no driver.
Environment noDriver();

}  // namespace raytorus::test
