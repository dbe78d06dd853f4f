// SPDX-License-Identifier: MIT
// The viewer's picture is that of `raytorus render`, bit for bit: by each route, at each size, with one
// sample a pixel and more, from wherever the camera has gone.
#include "image/image_io.hpp"
#include "window_test.hpp"

namespace raytorus::test {
namespace {

class WindowPicture : public WindowTest {
protected:
    // Each state of one window against a picture rendered for it.
    void expectRendersPictures(const std::string& name) {
        open({scene(name), "--size", "96x64", "--no-panel"});
        expectSame({scene(name), "--size", "96x64", "--spp", "4"}, "fragment, 4 samples");
        pressAndSettle({"shift+k"});
        expectSame({scene(name), "--size", "96x64", "--spp", "1"}, "fragment, 1 sample");
        pressAndSettle({"r"});
        expectSame({scene(name), "--size", "96x64", "--spp", "1", "--route", "compute"}, "compute, 1 sample");
        pressAndSettle({"k"});
        expectSame({scene(name), "--size", "96x64", "--spp", "4", "--route", "compute"},
                   "compute, 4 samples");

        resize(101, 47);
        await("settled", [](const Json& event) { return event["width"] == 101 && event["height"] == 47; });
        expectSame({scene(name), "--size", "101x47", "--spp", "4"}, "after a resize");

        pressAndSettle({"Left", "Up"});
        press({"ctrl+s"});
        const std::string saved = await("saved")["file"];
        expectSame({saved, "--spp", "4"}, "from elsewhere, saved as a scene");
        close();
    }

    void expectSame(const Arguments& arguments, const char* what) {
        SCOPED_TRACE(what);
        EXPECT_TRUE(sameBits(rendered(arguments), screenshot("e")));
        // The PNG is made of the picture that has just been compared, as the program makes its own.
        image::writeImage(folder / "expected.png", colorsOf(image::readImage(folder / "rendered.exr")));
        EXPECT_TRUE(sameBits(image::readImage(folder / "expected.png"), screenshot("s")));
    }

    static image::Image colorsOf(const image::Image& all) {
        image::Image colors(all.width, all.height, {"R", "G", "B", "A"});
        for (int y = 0; y < all.height; ++y) {
            for (int x = 0; x < all.width; ++x) {
                for (std::size_t i = 0; i < 4; ++i) {
                    const int channel = all.channelIndex(colors.channelNames[i]);
                    colors.pixel(x, y)[i] = all.pixel(x, y)[static_cast<std::size_t>(channel)];
                }
            }
        }
        return colors;
    }
};

TEST_F(WindowPicture, OfARingIsTheRenderedOne) {
    expectRendersPictures("ring");
}

TEST_F(WindowPicture, OfAChainIsTheRenderedOne) {
    expectRendersPictures("chain");
}

TEST_F(WindowPicture, IsWrittenByAScriptWithoutAHand) {
    start({scene("nested"), "--size", "64x48", "--spp", "9", "--route", "compute", "--frames", "6",
           "--screenshot", "picture.exr", "--window-screenshot", "window.png"});
    expectEnd();
    EXPECT_EQ(namesIn(folder), (std::vector<std::string>{"errors.txt", "picture.exr", "window.png"}));
    const Arguments same = {scene("nested"), "--size", "64x48", "--spp", "9"};
    EXPECT_TRUE(sameBits(rendered(same), image::readImage(folder / "picture.exr")));
    EXPECT_TRUE(sameBits(rendered(same, "rendered.png"), [&] {
        start({scene("nested"), "--size", "64x48", "--spp", "9", "--screenshot", "picture.png"});
        expectEnd();
        return image::readImage(folder / "picture.png");
    }()));
}

// One code: the window's colours are encoded by the device's pow and rounded by its blit.
constexpr double oneCode = 1.0 + 1e-4;

TEST_F(WindowPicture, IsWhatTheDisplayShows) {
    open({scene("ring"), "--size", "160x96", "--no-panel", "--spp", "1"});
    const image::Image picture = screenshot("s");
    // The sentence that it was saved lies over the lower part for a while.
    const image::Image shown = display().capture(window);
    const auto upper = [](const image::Image& whole) {
        image::Image part(whole.width, whole.height / 2, {"R", "G", "B"});
        for (int y = 0; y < part.height; ++y) {
            for (int x = 0; x < part.width; ++x) {
                std::copy_n(whole.pixel(x, y).begin(), 3, part.pixel(x, y).begin());
            }
        }
        return part;
    };
    EXPECT_LE(largestCodeDifference(upper(picture), upper(shown)), oneCode);
    close();
}

TEST_F(WindowPicture, IsWhatTheWindowsScreenshotShows) {
    start({scene("ring"), "--size", "160x96", "--no-panel", "--screenshot", "picture.png",
           "--window-screenshot", "window.png"});
    expectEnd();
    EXPECT_LE(largestCodeDifference(image::readImage(folder / "picture.png"),
                                    image::readImage(folder / "window.png")),
              oneCode);
}

}  // namespace
}  // namespace raytorus::test
