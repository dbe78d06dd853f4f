// SPDX-License-Identifier: MIT
// A display of the tests' own (Xvfb): windows open on it, and hands move over it (xdotool).
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "image/image.hpp"

namespace raytorus::test {

/// What has to be installed before windows can be tested, as a sentence; nothing where all is there.
std::optional<std::string> missingForWindows();

class Display {
public:
    /// On a number that is free. It ends with the process of the tests. What the server says on standard
    /// error goes to this file. Throws std::exception.
    explicit Display(const std::filesystem::path& errors);
    Display(const Display&) = delete;
    Display& operator=(const Display&) = delete;
    ~Display();

    [[nodiscard]] const std::string& name() const { return displayName; }  ///< ":7"

    /// Runs xdotool with these words, and returns what it prints. Throws std::runtime_error if it fails.
    [[nodiscard]] std::string hand(const std::vector<std::string>& words) const;

    /// The one window there is, when it is there.
    [[nodiscard]] std::uint32_t window() const;

    // What a window manager does; there is none on this display.
    void askToClose(std::uint32_t window) const;
    void minimise(std::uint32_t window) const;
    void restore(std::uint32_t window) const;

    /// What the window shows: R, G, B, multiples of 1/255 as displayed.
    [[nodiscard]] image::Image capture(std::uint32_t window) const;

private:
    struct Server;

    std::unique_ptr<Server> server;
    std::string displayName;
};

}  // namespace raytorus::test
