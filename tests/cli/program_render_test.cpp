// SPDX-License-Identifier: MIT
// raytorus render: what is in the files it writes, by size, samples and format.
#include <algorithm>
#include <cmath>
#include <set>

#include "support/program_test.hpp"

namespace raytorus::test {
namespace {

using image::Image;

class ProgramRender : public ProgramTest {
protected:
    ProgramRender() { write("scene.json", smallScene); }

    [[nodiscard]] Image render(const std::string& output, Arguments options = {}) const {
        options.insert(options.begin(), {"render", "scene.json", "-o", output});
        EXPECT_EQ(expectOk(options), "");
        return picture(output);
    }
};

TEST_F(ProgramRender, WritesNothingButThePicture) {
    static_cast<void>(render("out.exr"));
    EXPECT_EQ(namesIn(folder), (std::vector<std::string>{"out.exr", "scene.json"}));
}

TEST_F(ProgramRender, ExrHasExactlyTheseChannels) {
    const Image image = render("out.exr");
    EXPECT_EQ(image.width, 24);
    EXPECT_EQ(image.height, 16);
    const std::set<std::string> channels(image.channelNames.begin(), image.channelNames.end());
    const std::set<std::string> expected = {"R",          "G",          "B",          "A",        "t",
                                            "position.x", "position.y", "position.z", "normal.x", "normal.y",
                                            "normal.z",   "uv.u",       "uv.v",       "count",    "id"};
    EXPECT_EQ(channels, expected);
    EXPECT_EQ(image.channelNames.size(), expected.size());
}

TEST_F(ProgramRender, PngHasColourAlone) {
    const Image image = render("out.png");
    EXPECT_EQ(image.width, 24);
    EXPECT_EQ(image.height, 16);
    EXPECT_EQ(image.channelNames, (std::vector<std::string>{"R", "G", "B", "A"}));
}

TEST_F(ProgramRender, ExtensionInCapitalsIsTheSame) {
    EXPECT_EQ(render("out.EXR").pixels, render("out.exr").pixels);
}

TEST_F(ProgramRender, SizeOverridesTheScenes) {
    for (const auto& [size, width, height] :
         {std::tuple("1x1", 1, 1), std::tuple("7x130", 7, 130), std::tuple("33x2", 33, 2)}) {
        for (const char* route : {"fragment", "compute"}) {
            const Image image = render("out.exr", {"--size", size, "--route", route});
            EXPECT_EQ(image.width, width);
            EXPECT_EQ(image.height, height);
        }
    }
}

// Where the ray hits nothing, id is -1 and the others are 0; where it hits, they describe a torus of the
// scene.
TEST_F(ProgramRender, GeometryIsThatOfTheTorusOrNone) {
    const Image image = render("out.exr", {"--size", "48x32"});
    int hits = 0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            SCOPED_TRACE(testing::Message() << "pixel " << x << ", " << y);
            const auto value = [&](const char* channel) { return image.at(x, y, channel); };
            EXPECT_EQ(value("A"), 1.0F);
            const float normalLength = std::hypot(value("normal.x"), value("normal.y"), value("normal.z"));
            if (value("id") == -1.0F) {
                for (const char* channel :
                     {"t", "position.x", "position.y", "position.z", "uv.u", "uv.v", "count"}) {
                    EXPECT_EQ(value(channel), 0.0F) << channel;
                }
                EXPECT_EQ(normalLength, 0.0F);
                continue;
            }
            ++hits;
            EXPECT_EQ(value("id"), 0.0F);
            EXPECT_GT(value("t"), 0.0F);
            EXPECT_TRUE(value("count") == 2.0F || value("count") == 4.0F) << value("count");
            // A few roundings of float32 (6e-8 each) in each of three components.
            EXPECT_NEAR(normalLength, 1.0F, 1e-6F);
            EXPECT_TRUE(value("uv.u") >= 0.0F && value("uv.u") <= 1.0F) << value("uv.u");
            EXPECT_TRUE(value("uv.v") >= 0.0F && value("uv.v") <= 1.0F) << value("uv.v");
            // On the tube of radius 1/4 round the ring of radius 1, but for roundings of numbers up to 5: the
            // distance of the camera.
            const double ring = std::hypot(double{value("position.x")}, double{value("position.y")}) - 1.0;
            EXPECT_NEAR(std::hypot(ring, double{value("position.z")}), 0.25, 2e-6);
        }
    }
    EXPECT_GT(hits, 48 * 32 / 10);
    EXPECT_LT(hits, 48 * 32 * 9 / 10);
}

// More samples smooth the colour; the geometry stays that of the ray through the middle of the pixel.
TEST_F(ProgramRender, SamplesChangeColourAlone) {
    const Image one = render("one.exr");
    const Image nine = render("nine.exr", {"--spp", "9"});
    const int colourChannels = 4;
    bool colourDiffers = false;
    for (int y = 0; y < one.height; ++y) {
        for (int x = 0; x < one.width; ++x) {
            const auto a = one.pixel(x, y);
            const auto b = nine.pixel(x, y);
            colourDiffers = colourDiffers || !std::equal(a.begin(), a.begin() + colourChannels, b.begin());
            EXPECT_TRUE(std::equal(a.begin() + colourChannels, a.end(), b.begin() + colourChannels))
                << x << ' ' << y;
        }
    }
    EXPECT_TRUE(colourDiffers);
}

// Without the geometry in it, the picture is made by another pipeline.
TEST_F(ProgramRender, PngAndExrShowTheSameColour) {
    const Image exr = render("out.exr");
    const Image png = render("out.png");
    for (int y = 0; y < exr.height; ++y) {
        for (int x = 0; x < exr.width; ++x) {
            for (std::size_t channel = 0; channel < 3; ++channel) {
                const double linear = std::min(double{exr.pixel(x, y)[channel]}, 1.0);
                const double encoded =
                    linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
                // Half a step of 8 bit, and a rounding of float32.
                EXPECT_NEAR(double{png.pixel(x, y)[channel]}, encoded, 0.5 / 255 + 1e-6) << x << ' ' << y;
            }
        }
    }
}

TEST_F(ProgramRender, ReplacesWhatWasThereBefore) {
    write("out.png", "what was there before");
    EXPECT_EQ(render("out.png").width, 24);
}

TEST_F(ProgramRender, FindsTheDeviceByNumberAndByAnyPartOfItsName) {
    const std::string doctor = expectOk({"doctor"});
    const std::string line = doctor.substr(doctor.find("raytorus uses device "));
    const std::string number = line.substr(21, line.find(',') - 21);
    const std::string name = line.substr(line.find(", ") + 2, 4);
    std::string capitals = name;
    std::ranges::transform(capitals, capitals.begin(),
                           [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    for (const std::string& device : {number, name, capitals}) {
        static_cast<void>(render("out.png", {"--device", device}));
    }
}

TEST_F(ProgramRender, TakesShadersFromAFolder) {
    EXPECT_EQ(render("folder.exr", {"--shaders", shaderFolder().string()}).pixels,
              render("built-in.exr").pixels);
}

}  // namespace
}  // namespace raytorus::test
