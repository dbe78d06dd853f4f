// SPDX-License-Identifier: MIT
// Pointer and wheel: what each gesture does to the camera, to the wipe and to the pixel under it.
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "window_test.hpp"

namespace raytorus::test {
namespace {

glm::dvec3 vectorOf(const nlohmann::json& numbers) {
    return {numbers[0].get<double>(), numbers[1].get<double>(), numbers[2].get<double>()};
}

struct Seen {
    glm::dvec3 position;
    glm::dvec3 target;

    [[nodiscard]] double distance() const { return glm::length(position - target); }
};

// Coordinates of some units go through a few dozen operations in double.
constexpr double rounding = 1e-12;

class WindowHand : public WindowTest {
protected:
    // When the picture has settled again after what the hand did.
    Seen cameraAfter() {
        await("camera");
        await("settled");
        return camera();
    }

    [[nodiscard]] Seen camera() const {
        return {vectorOf(lastCamera["position"]), vectorOf(lastCamera["target"])};
    }
};

TEST_F(WindowHand, LeftDragOrbitsRightDragAndShiftDragPanAndTheWheelDollies) {
    open({scene("ring"), "--size", "240x160", "--no-panel", "--spp", "1"});
    const Seen before = camera();

    drag(1, {{100, 80}, {110, 84}, {125, 90}, {140, 100}});
    const Seen turned = cameraAfter();
    EXPECT_NEAR(turned.distance(), before.distance(), rounding);
    EXPECT_LE(glm::length(turned.target - before.target), rounding);
    EXPECT_GT(glm::length(turned.position - before.position), 0.1 * before.distance());

    drag(3, {{100, 80}, {120, 80}, {148, 80}});
    const Seen panned = cameraAfter();
    const glm::dvec3 step = panned.position - turned.position;
    EXPECT_LE(glm::length(panned.target - turned.target - step), rounding);
    // 48 of 160 pixels of height; what is at the target's distance follows the hand.
    const double height = 2.0 * turned.distance() * std::tan(0.5 * 36.0 * std::acos(-1.0) / 180.0);
    EXPECT_NEAR(glm::length(step), height * 48.0 / 160.0, 1e-9);

    drag(1, {{148, 80}, {120, 80}, {100, 80}}, "shift");
    const Seen back = cameraAfter();
    EXPECT_LE(glm::length(back.position - turned.position), 1e-9);
    EXPECT_LE(glm::length(back.target - turned.target), 1e-9);

    drag(2, {{100, 80}, {100, 90}, {100, 96}});
    const Seen raised = cameraAfter();
    EXPECT_NEAR(glm::length(raised.position - back.position), height * 16.0 / 160.0, 1e-9);

    hand({"click", "4"});
    const Seen nearer = cameraAfter();
    EXPECT_NEAR(nearer.distance(), raised.distance() / 1.1, 1e-9);
    hand({"click", "5"});
    EXPECT_NEAR(cameraAfter().distance(), raised.distance(), 1e-9);
    close();
}

TEST_F(WindowHand, AClickTakesThatPixelApartAsExplainDoes) {
    open({scene("chain"), "--size", "160x100", "--no-panel", "--spp", "1"});
    // Not (0, 0): GLFW takes a motion to there for one of its own, and does not tell.
    for (const auto& [x, y] : {std::pair(80, 50), std::pair(0, 1), std::pair(159, 99), std::pair(31, 64)}) {
        hand({"mousemove", std::to_string(x), std::to_string(y), "click", "1"});
        const Json picked = await("picked");
        EXPECT_EQ(picked["x"], x);
        EXPECT_EQ(picked["y"], y);
        const std::string command = picked["command"];
        const std::string start = "raytorus explain --validate --replay \"";
        ASSERT_TRUE(command.starts_with(start) && command.ends_with('"')) << command;
        const std::string ray = command.substr(start.size(), command.size() - start.size() - 1);
        const std::string text = picked["text"];
        EXPECT_TRUE(
            text.starts_with("pixel (" + std::to_string(x) + ", " + std::to_string(y) + ") of 160 x 100"))
            << text;
        const std::string told = runRaytorus({"explain", "--replay", ray});
        EXPECT_TRUE(text.ends_with("\n\n" + told)) << text << "\nbut raytorus explain says\n" << told;
        const std::string again = runRaytorus({"explain", "--scene", scene("chain"), "--size", "160x100",
                                               "--pixel", std::to_string(x) + "," + std::to_string(y)});
        EXPECT_TRUE(again.ends_with(told)) << again;
        press({"x"});
    }

    // Copies of the last one.
    press({"p"});
    const Json middle = await("picked");
    EXPECT_EQ(middle["x"], 80);
    EXPECT_EQ(middle["y"], 50);
    press({"c"});
    EXPECT_EQ(await("copied")["text"], middle["command"]);
    press({"shift+c"});
    const std::string testCase = await("copied")["text"];
    EXPECT_TRUE(testCase.starts_with("{\"pixel_80_50\", ")) << testCase;
    close();
}

TEST_F(WindowHand, ATremblingClickIsNoDrag) {
    open({scene("ring"), "--size", "160x100", "--no-panel", "--spp", "1"});
    drag(1, {{60, 50}, {61, 51}, {62, 50}});
    bool moved = false;
    for (Json event = nextEvent(); event["event"] != "picked"; event = nextEvent()) {
        moved = moved || event["event"] == "camera";
    }
    EXPECT_FALSE(moved);
    close();
}

TEST_F(WindowHand, TheWipesLineIsDraggedAndNothingElseMoves) {
    open({scene("ring"), "--size", "200x120", "--no-panel", "--spp", "1", "--wipe", "closed-form@0.5"});
    drag(1, {{101, 60}, {90, 60}, {70, 61}, {50, 60}});
    bool turned = false;
    Json wipe;
    do {
        const Json event = nextEvent();
        turned = turned || event["event"] == "camera";
        wipe = event["event"] == "wipe" ? event : wipe;
    } while (!wipe.contains("at") || wipe["at"] != 0.25);
    EXPECT_FALSE(turned);
    EXPECT_EQ(wipe["on"], true);

    drag(1, {{50, 60}, {20, 60}, {0, 60}});
    await("wipe", [](const Json& event) { return event["at"] == 0.0; });
    // Elsewhere a drag still turns the camera.
    drag(1, {{150, 60}, {160, 60}, {170, 60}});
    await("camera");
    close();
}

TEST_F(WindowHand, APointerOverThePanelMovesThePanelOnly) {
    open({scene("ring"), "--size", "640x480", "--spp", "1"});
    press({"F3"});
    await("settled");
    hand({"mousemove", "560", "60"});
    press({"h"});
    press({"h"});  // some frames with the pointer there: the panel knows
    hand({"click", "4", "click", "5"});
    drag(3, {{560, 60}, {550, 80}, {540, 100}});
    press({"w"});
    bool moved = false;
    for (Json event = nextEvent(); event["event"] != "settled"; event = nextEvent()) {
        moved = moved || event["event"] == "camera";
    }
    EXPECT_FALSE(moved);
    close();
}

}  // namespace
}  // namespace raytorus::test
