// SPDX-License-Identifier: MIT
// What displays and devices do once in a while, made to happen by a layer (layer_faults.cpp): each ends in
// recovery, or in one sentence and the exit code for it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "image/image_io.hpp"
#include "window_test.hpp"

namespace raytorus::test {
namespace {

class WindowFault : public WindowTest {
protected:
    [[nodiscard]] Environment faults(const std::string& schedule) const {
        return {{"VK_ADD_LAYER_PATH", RAYTORUS_FAULT_LAYER_FOLDER},
                {"VK_INSTANCE_LAYERS", "VK_LAYER_RAYTORUS_faults"},
                {"RAYTORUS_FAULTS", schedule},
                {"RAYTORUS_FAULT_LOG", (folder / "faults.txt").string()}};
    }

    // The faults that have struck since the last call.
    std::string struck() const {
        const std::filesystem::path file = folder / "faults.txt";
        std::string text = std::filesystem::exists(file) ? fileText(file) : std::string();
        std::filesystem::remove(file);
        return text;
    }

    void expectStruck(const std::string& log, std::initializer_list<const char*> all) const {
        for (const char* fault : all) {
            EXPECT_NE(("\n" + log).find(std::string("\n") + fault + "\n"), std::string::npos)
                << fault << " is not in:\n"
                << log;
        }
    }

    // The window works in spite of the faults, which all strike.
    void expectRecovery(const std::string& schedule, std::initializer_list<const char*> all) {
        SCOPED_TRACE(schedule);
        open({scene("ring"), "--size", "64x48", "--no-panel", "--spp", "1"}, faults(schedule));
        pressAndSettle({"Left"});
        pressAndSettle({"Right", "Up"});
        resize(72, 40);
        await("settled", [](const Json& event) { return event["width"] == 72; });
        press({"Home"});
        await("settled");
        EXPECT_TRUE(sameBits(rendered({scene("ring"), "--size", "72x40", "--spp", "1"}), screenshot("e")));
        press({"shift+s"});
        await("window-screenshot");
        close();
        expectStruck(struck(), all);
    }

    // Nothing is said but the sentence, and the program is gone: it neither hangs nor crashes.
    void expectFailure(const std::string& schedule, ExitCode code, std::initializer_list<const char*> words) {
        SCOPED_TRACE(schedule);
        start({scene("ring"), "--size", "64x48", "--spp", "4", "--frames", "1000000"}, faults(schedule));
        const std::string sentence = expectEnd(code);
        for (const char* word : words) {
            EXPECT_NE(sentence.find(word), std::string::npos) << sentence;
        }
        EXPECT_NE(struck(), "");
    }
};

TEST_F(WindowFault, OutOfDateNowAndThenIsMended) {
    expectRecovery("acquire:out-of-date@2-3;present:out-of-date@4-6;swapchain:out-of-date@2",
                   {"acquire:out-of-date@2", "acquire:out-of-date@3", "present:out-of-date@4",
                    "present:out-of-date@6", "swapchain:out-of-date@2"});
}

TEST_F(WindowFault, OutOfDateForEverEnds) {
    expectFailure("acquire:out-of-date@1-", ExitCode::DeviceLost,
                  {"the window cannot be drawn to", "VK_ERROR_OUT_OF_DATE_KHR", "100"});
    expectFailure("present:out-of-date@4-", ExitCode::DeviceLost,
                  {"the window cannot be drawn to", "VK_ERROR_OUT_OF_DATE_KHR", "100"});
    expectFailure("swapchain:out-of-date@1-", ExitCode::DeviceLost, {"VK_ERROR_OUT_OF_DATE_KHR"});
}

TEST_F(WindowFault, ALostSurfaceIsMadeAnew) {
    expectRecovery("present:surface-lost@3", {"present:surface-lost@3"});
    expectRecovery("acquire:surface-lost@4;swapchain:surface-lost@3;capabilities:surface-lost@5",
                   {"acquire:surface-lost@4", "swapchain:surface-lost@3"});
    expectFailure("acquire:surface-lost@2-", ExitCode::DeviceLost, {"VK_ERROR_SURFACE_LOST_KHR"});
}

TEST_F(WindowFault, SuboptimalIsGoodEnough) {
    expectRecovery("present:suboptimal@1-;acquire:suboptimal@1-",
                   {"present:suboptimal@1", "acquire:suboptimal@1"});
}

TEST_F(WindowFault, AWindowWithoutSizeIsWaitedFor) {
    expectRecovery("capabilities:zero@1-12", {"capabilities:zero@1", "capabilities:zero@12"});
    expectRecovery("capabilities:zero@2-9", {"capabilities:zero@2", "capabilities:zero@9"});
}

TEST_F(WindowFault, AWindowWithoutAFormatIsRefused) {
    expectFailure("formats:none@1-", ExitCode::NoDevice, {"8 bit sRGB format"});
}

TEST_F(WindowFault, AFormatThatEncodesShowsTheSamePicture) {
    // Two codes: the window's colours are encoded once by the shader and once by the blit, each rounds, and
    // the devices' pow is not exact.
    constexpr double twoCodes = 2.0 + 1e-4;
    for (const char* view : {"shaded", "normal"}) {
        SCOPED_TRACE(view);
        start({scene("ring"), "--size", "160x120", "--spp", "1", "--no-panel", "--view", view, "--screenshot",
               "plain.png", "--window-screenshot", "plain_window.png"});
        expectEnd();
        start({scene("ring"), "--size", "160x120", "--spp", "1", "--no-panel", "--view", view, "--screenshot",
               "encoded.png", "--window-screenshot", "encoded_window.png"},
              faults("formats:srgb@1-"));
        expectEnd();
        expectStruck(struck(), {"formats:srgb@1"});
        const image::Image plain = image::readImage(folder / "plain.png");
        EXPECT_LE(largestCodeDifference(plain, image::readImage(folder / "encoded.png")), twoCodes);
        EXPECT_LE(largestCodeDifference(plain, image::readImage(folder / "plain_window.png")), twoCodes);
        EXPECT_LE(largestCodeDifference(plain, image::readImage(folder / "encoded_window.png")), twoCodes);
    }
}

TEST_F(WindowFault, ALostDeviceEndsAtOnce) {
    for (const char* schedule :
         {"submit:device-lost@1-", "submit:device-lost@4-", "submit:device-lost@15-",
          "acquire:device-lost@2-", "present:device-lost@2-", "swapchain:device-lost@1-"}) {
        expectFailure(schedule, ExitCode::DeviceLost, {"VK_ERROR_DEVICE_LOST"});
    }
}

TEST_F(WindowFault, MemoryThatIsOutEnds) {
    for (const char* schedule :
         {"submit:out-of-memory@1-", "submit:out-of-memory@12-", "swapchain:out-of-memory@1-"}) {
        expectFailure(schedule, ExitCode::OutOfMemory, {"VK_ERROR_OUT_OF_DEVICE_MEMORY"});
    }
}

}  // namespace
}  // namespace raytorus::test
