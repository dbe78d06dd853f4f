// SPDX-License-Identifier: MIT
// The views: each shows something else, and what they say of errors is what the library promises.
#include <cmath>
#include <map>

#include "image/image_io.hpp"
#include "reference/promise.hpp"
#include "viewer/view_list.hpp"
#include "window_test.hpp"

namespace raytorus::test {
namespace {

// The unit of the view "reference" is 2^-24 (R + r + |centre|); the library promises positions in R + r.
const double promised = std::ldexp(reference::positionBound, 24);

class WindowView : public WindowTest {
protected:
    // The numbers of the views that judge.
    Json analysed() { return await("analysed"); }
};

TEST_F(WindowView, EachShowsAnotherPicture) {
    // A golden scene, so that the last view has something to show; two tori, so that the torus is seen.
    open({RAYTORUS_SOURCE_DIR "/golden/scenes/overlap.json", "--size", "96x64", "--no-panel", "--spp", "1"});
    std::map<std::string, image::Image> pictures;
    pictures["shaded"] = screenshot("s");
    for (std::size_t i = 1; i < viewer::views().size(); ++i) {
        press({"v"});
        const std::string name = await("view")["name"];
        EXPECT_EQ(name, viewer::views()[i].name);
        if (name == "steps") {
            await("settled");  // by shaders of its own
        }
        pictures[name] = screenshot("s");
    }
    ASSERT_EQ(pictures.size(), viewer::views().size());
    for (auto one = pictures.begin(); one != pictures.end(); ++one) {
        for (auto other = std::next(one); other != pictures.end(); ++other) {
            EXPECT_FALSE(sameBits(one->second, other->second)) << one->first << " and " << other->first;
        }
    }
    press({"shift+v"});
    EXPECT_EQ(await("view")["name"], "reference");
    close();
}

TEST_F(WindowView, ReferenceAgreesWithTheLibraryAsPromised) {
    // In its own frame: the position is the library's answer, and nothing is added to its error.
    writeText(
        folder / "plain.json",
        R"({"image": {"width": 160, "height": 120}, "camera": {"position": [1.2, -3.3, 2.4], "target": [0, 0, 0]},
                  "tori": [{"majorRadius": 1, "minorRadius": 0.42}]})");
    open({"plain.json", "--no-panel", "--spp", "1", "--view", "reference"});
    const Json plain = analysed();
    EXPECT_EQ(plain["wrong"], 0);
    EXPECT_LE(plain["largest"], promised);
    EXPECT_GT(plain["largest"], 0.2);  // a float's rounding is seen: something was measured
    close();

    // Turned and moved into the world, each coordinate is three products, two sums and one more sum, all
    // of them not longer than the unit: at most 6 roundings a coordinate, sqrt(3) times that in length.
    open({scene("chain"), "--size", "120x80", "--no-panel", "--spp", "1", "--view", "reference"});
    const Json chain = analysed();
    EXPECT_EQ(chain["wrong"], 0);
    EXPECT_LE(chain["largest"], promised + 6.0 * std::sqrt(3.0));
    close();
}

TEST_F(WindowView, ReferenceAccusesTheNaiveClosedForm) {
    open({scene("thin"), "--size", "120x80", "--no-panel", "--spp", "1", "--view", "reference", "--method",
          "closed-form-naive"});
    EXPECT_GT(analysed()["wrong"], 0);
    press({"shift+m"});  // another method is judged anew
    EXPECT_NE(await("method")["left"], "closed-form-naive");
    analysed();
    close();
}

TEST_F(WindowView, GoldenSaysWhetherThePictureIsRight) {
    const std::string ring = RAYTORUS_SOURCE_DIR "/golden/scenes/ring_fat.json";
    open({ring, "--no-panel", "--view", "golden", "--size", "144x96"});
    const std::string right = await("golden")["text"];
    EXPECT_NE(right.find("ring_fat.exr"), std::string::npos) << right;
    EXPECT_NE(right.find("agree"), std::string::npos) << right;
    (void)screenshot("s");
    // Seen from elsewhere it is another picture.
    press({"Left"});
    const std::string moved = await("golden")["text"];
    EXPECT_NE(moved.find("differ"), std::string::npos) << moved;
    close();

    open({scene("ring"), "--no-panel", "--view", "golden", "--size", "64x48"});
    EXPECT_EQ(await("golden")["text"], "this scene has no golden picture (--golden FILE.exr names one)");
    close();

    open({ring, "--no-panel", "--view", "golden", "--size", "96x64", "--golden",
          RAYTORUS_SOURCE_DIR "/golden/ring_half.exr"});
    const std::string other = await("golden")["text"];
    EXPECT_TRUE(other.starts_with("ring_half.exr: ")) << other;
    EXPECT_NE(other.find("differ"), std::string::npos) << other;
    close();
}

}  // namespace
}  // namespace raytorus::test
