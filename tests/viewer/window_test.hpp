// SPDX-License-Identifier: MIT
// raytorus-view in a real window on a display of the tests' own, with validation: hands drive it, its events
// tell what happened. Nothing is timed and nothing sleeps: each step waits for the event that it causes.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <initializer_list>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "image/image.hpp"
#include "support/run_program.hpp"
#include "support/scratch_folder.hpp"
#include "window_display.hpp"
#include "window_process.hpp"

namespace raytorus::test {

class WindowTest : public testing::Test {
protected:
    using Json = nlohmann::json;
    using Arguments = std::vector<std::string>;

    void SetUp() override;
    /// A viewer that is still there when the test ends fails it.
    void TearDown() override;

    /// One for all tests of a process.
    static Display& display();

    /// Runs `raytorus-view <arguments> --events --validate` in `folder`.
    void start(const Arguments& arguments, const Environment& environment = {});
    /// The same, then gives the window the keys and waits until its first picture is complete.
    void open(const Arguments& arguments, const Environment& environment = {});

    /// The next event of that name, from the one awaited last onwards; those between are passed over.
    Json await(const std::string& name);
    Json await(const std::string& name, const std::function<bool(const Json&)>& accepts);
    /// The next event, whatever it is.
    Json nextEvent(LiveProcess::Clock::time_point deadline = LiveProcess::Clock::now() +
                                                             LiveProcess::patience);

    /// Presses keys, by xdotool's names ("shift+Left"), and waits until the viewer has taken them.
    void press(std::initializer_list<std::string> keys);
    /// The same, and then for the picture to be complete again.
    void pressAndSettle(std::initializer_list<std::string> keys);

    /// Words of xdotool; pointer positions are pixels of the window, which lies in the display's corner.
    void hand(const Arguments& words) const { (void)display().hand(words); }
    /// Presses the button at the first place, goes over the others and lets it go at the last.
    void drag(int button, std::initializer_list<std::pair<int, int>> places, const std::string& held = {});
    void resize(int width, int height);

    /// Saves the picture by a key, s (as displayed) or e (with every channel), and reads it.
    image::Image screenshot(const std::string& key);

    /// The program must end by itself now: with this exit code, no message of the validation layers and, if
    /// it is 0, silence on standard error. Returns what it said there.
    std::string expectEnd(ExitCode code = ExitCode::Ok);
    /// Key q, then expectEnd().
    void close();

    /// A program run to its end on the display: raytorus-view, or raytorus.
    [[nodiscard]] ProgramResult runViewer(const Arguments& arguments,
                                          const Environment& environment = {}) const;
    std::string runRaytorus(const Arguments& arguments) const;
    /// The picture that `raytorus render` makes.
    [[nodiscard]] image::Image rendered(const Arguments& arguments,
                                        const std::string& file = "rendered.exr") const;

    [[nodiscard]] static std::string scene(const std::string& name);

    std::filesystem::path folder = scratchFolder();
    std::uint32_t window = 0;
    Json lastCamera;  ///< the camera's last event that nextEvent() has passed

private:
    [[noreturn]] void giveUp(const std::string& what) const;

    std::unique_ptr<LiveProcess> viewer;
    std::vector<std::string> lines;  // all events so far, for failures
};

/// Equal in every bit of every channel.
testing::AssertionResult sameBits(const image::Image& expected, const image::Image& actual);

/// The largest difference of R, G and B, in codes of 8 bits, of pictures as displayed. Their sizes must be
/// equal.
double largestCodeDifference(const image::Image& expected, const image::Image& actual);

}  // namespace raytorus::test
