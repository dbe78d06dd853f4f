// SPDX-License-Identifier: MIT
// Commands without a window: who pushes which, and when they are taken.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <variant>
#include <vector>

#include "viewer/commands.hpp"
#include "viewer/keys.hpp"
#include "viewer/pointer.hpp"

namespace raytorus::viewer {
namespace {

constexpr Moment moments[] = {Moment::AtOnce, Moment::AtRest, Moment::Complete, Moment::Panel, Moment::Frame};

TEST(CommandQueue, GivesWhatWaitsForAMomentInTheOrderInWhichItCame) {
    CommandQueue queue;
    queue.push(SavePicture{".png"});
    queue.push(CopyText{"first"});
    queue.push(SavePicture{".exr"});
    queue.push(CopyText{"second"});
    queue.push(SavePicture{".exr"});
    const std::vector<Command> pictures = queue.take(Moment::Complete);
    ASSERT_EQ(pictures.size(), 3U);
    EXPECT_EQ(std::get<SavePicture>(pictures[0]).extension, ".png");
    EXPECT_EQ(std::get<SavePicture>(pictures[1]).extension, ".exr");
    EXPECT_EQ(std::get<SavePicture>(pictures[2]).extension, ".exr");
    const std::vector<Command> texts = queue.take(Moment::AtOnce);
    ASSERT_EQ(texts.size(), 2U);
    EXPECT_EQ(std::get<CopyText>(texts[0]).text, "first");
    EXPECT_EQ(std::get<CopyText>(texts[1]).text, "second");
}

TEST(CommandQueue, KeepsWhatWaitsForAnotherMomentAndGivesNothingTwice) {
    CommandQueue queue;
    queue.push(FocusPanel{});
    queue.push(SaveWindow{});
    queue.push(TakeApart{1, 2});
    EXPECT_TRUE(queue.take(Moment::AtOnce).empty());
    EXPECT_TRUE(queue.waits(Moment::Panel));
    EXPECT_TRUE(queue.waits(Moment::Frame));
    EXPECT_TRUE(queue.waits(Moment::AtRest));
    EXPECT_FALSE(queue.waits(Moment::Complete));
    EXPECT_EQ(queue.take(Moment::Frame).size(), 1U);
    EXPECT_FALSE(queue.waits(Moment::Frame));
    EXPECT_TRUE(queue.take(Moment::Frame).empty());
    EXPECT_TRUE(queue.waits(Moment::Panel));
}

TEST(CommandQueue, OfPixelsKeepsTheLastOneAlone) {
    CommandQueue queue;
    queue.push(TakeApart{1, 2});
    queue.push(SavePicture{".png"});
    queue.push(TakeApart{3, 4});
    const std::vector<Command> pixels = queue.take(Moment::AtRest);
    ASSERT_EQ(pixels.size(), 1U);
    EXPECT_EQ(std::get<TakeApart>(pixels[0]).x, 3);
    EXPECT_EQ(std::get<TakeApart>(pixels[0]).y, 4);
    EXPECT_TRUE(queue.waits(Moment::Complete));
}

class Keys : public testing::Test {
protected:
    Keys() {
        state.methods.resize(3);
        state.statistics.extent = {161, 90};
    }

    // What the key asks for.
    std::vector<Command> asked(int key, int modifiers = 0) {
        EXPECT_TRUE(pressKey(key, modifiers, state, queue));
        std::vector<Command> all;
        for (const Moment moment : moments) {
            for (const Command& command : queue.take(moment)) {
                all.push_back(command);
            }
        }
        return all;
    }

    State state;
    CommandQueue queue;
};

TEST_F(Keys, ChangeTheStateOrAskForACommandOrBoth) {
    EXPECT_TRUE(asked(GLFW_KEY_M).empty());
    EXPECT_EQ(state.left.method, 1U);
    EXPECT_TRUE(asked(GLFW_KEY_M, GLFW_MOD_SHIFT).empty());
    EXPECT_TRUE(asked(GLFW_KEY_M, GLFW_MOD_SHIFT).empty());
    EXPECT_EQ(state.left.method, 2U);

    const std::vector<Command> pixels = asked(GLFW_KEY_P);
    ASSERT_EQ(pixels.size(), 1U);
    EXPECT_EQ(std::get<TakeApart>(pixels[0]).x, 80);
    EXPECT_EQ(std::get<TakeApart>(pixels[0]).y, 45);

    state.panel = false;
    const std::vector<Command> focus = asked(GLFW_KEY_F6);
    ASSERT_EQ(focus.size(), 1U);
    EXPECT_TRUE(std::holds_alternative<FocusPanel>(focus[0]));
    EXPECT_TRUE(state.panel);
}

TEST_F(Keys, CopyThePixelThatIsTakenApartIfThereIsOne) {
    EXPECT_TRUE(asked(GLFW_KEY_C).empty());
    state.pick = Pick{1, 2, "text", "command", "test case"};
    EXPECT_EQ(std::get<CopyText>(asked(GLFW_KEY_C).at(0)).text, "command");
    EXPECT_EQ(std::get<CopyText>(asked(GLFW_KEY_C, GLFW_MOD_SHIFT).at(0)).text, "test case");
}

TEST_F(Keys, WithAnUnknownModifierAreBoundToNothing) {
    EXPECT_FALSE(pressKey(GLFW_KEY_Q, GLFW_MOD_CONTROL, state, queue));
    EXPECT_FALSE(pressKey(GLFW_KEY_J, 0, state, queue));
    EXPECT_FALSE(queue.waits(Moment::AtOnce));
    EXPECT_TRUE(pressKey(GLFW_KEY_Q, GLFW_MOD_ALT | GLFW_MOD_CAPS_LOCK, state, queue));
    EXPECT_TRUE(queue.waits(Moment::AtOnce));
}

InputEvent button(bool pressed, double x, double y) {
    InputEvent event;
    event.type = InputEvent::Type::Button;
    event.code = GLFW_MOUSE_BUTTON_LEFT;
    event.pressed = pressed;
    event.x = x;
    event.y = y;
    return event;
}

TEST(PointerClick, TakesThePixelOfThePictureApart) {
    // A picture of 100 x 50 pixels, four times as large in the middle of the window.
    State state;
    state.statistics.extent = {100, 50};
    const PointerField field{{400, 300}, {{0, 50}, {400, 200}}, false};
    CommandQueue queue;
    Pointer pointer;
    pointer.handle(button(true, 47.0, 61.0), field, state, queue);
    EXPECT_FALSE(queue.waits(Moment::AtRest));
    pointer.handle(button(false, 47.0, 61.0), field, state, queue);
    const std::vector<Command> pixels = queue.take(Moment::AtRest);
    ASSERT_EQ(pixels.size(), 1U);
    EXPECT_EQ(std::get<TakeApart>(pixels[0]).x, 11);
    EXPECT_EQ(std::get<TakeApart>(pixels[0]).y, 2);

    // Beside the picture, and on a panel.
    pointer.handle(button(true, 47.0, 20.0), field, state, queue);
    pointer.handle(button(false, 47.0, 20.0), field, state, queue);
    PointerField panel = field;
    panel.panel = true;
    pointer.handle(button(true, 47.0, 61.0), panel, state, queue);
    pointer.handle(button(false, 47.0, 61.0), panel, state, queue);
    EXPECT_FALSE(queue.waits(Moment::AtRest));
}

}  // namespace
}  // namespace raytorus::viewer
