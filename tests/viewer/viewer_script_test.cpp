// SPDX-License-Identifier: MIT
// What drives the window from the command line, without a window: after which frames it does what.
#include <gtest/gtest.h>

#include <algorithm>
#include <variant>
#include <vector>

#include "viewer/frame.hpp"
#include "viewer/script.hpp"

namespace raytorus::viewer {
namespace {

constexpr bool complete = true;

class ScriptDriving : public testing::Test {
protected:
    static std::vector<Command> drive(ScriptDriver& driver, bool isComplete, double seconds = 0.0) {
        CommandQueue queue;
        driver.drive(isComplete, seconds, queue);
        return queue.take(Moment::AtOnce);
    }

    // A driver that has seen so many frames.
    static ScriptDriver driverAfter(int frames, const Script& script) {
        ScriptDriver driver(script);
        for (int i = 0; i < frames; ++i) {
            driver.noteFrame();
        }
        return driver;
    }

    static bool quits(const std::vector<Command>& commands) {
        return commands.size() == 1 && std::holds_alternative<Quit>(commands[0]);
    }
};

TEST_F(ScriptDriving, IsForWhoAsksForSomething) {
    EXPECT_FALSE(ScriptDriver({}).drives());
    EXPECT_TRUE(ScriptDriver({.frames = 1}).drives());
    EXPECT_TRUE(ScriptDriver({.sequence = {{"a.png", 0.0}}}).drives());
    EXPECT_TRUE(ScriptDriver({.screenshot = "a.png"}).drives());
    EXPECT_TRUE(ScriptDriver({.windowScreenshot = "a.png"}).drives());
    ScriptDriver hands = driverAfter(100, {});
    EXPECT_FALSE(hands.wantsWindow(complete));
    EXPECT_TRUE(drive(hands, complete).empty());
}

TEST_F(ScriptDriving, QuitsWhenAllFramesAreShownAndThePictureIsComplete) {
    for (const int frames : {1, settlingFrames, 7}) {
        const int needed = std::max(frames, settlingFrames);
        ScriptDriver early = driverAfter(needed - 1, {.frames = frames});
        EXPECT_TRUE(drive(early, complete).empty()) << frames;
        early.noteFrame();
        EXPECT_TRUE(drive(early, !complete).empty()) << frames;
        EXPECT_TRUE(quits(drive(early, complete))) << frames;
    }
}

TEST_F(ScriptDriving, WritesThePictureBeforeItQuits) {
    ScriptDriver driver = driverAfter(settlingFrames, {.screenshot = "a.exr"});
    const std::vector<Command> commands = drive(driver, complete);
    ASSERT_EQ(commands.size(), 2U);
    EXPECT_EQ(std::get<WritePicture>(commands[0]).file, "a.exr");
    EXPECT_TRUE(std::holds_alternative<Quit>(commands[1]));
}

TEST_F(ScriptDriving, WritesTheWindowWithTheLastFrameAndStaysUntilThatIsDone) {
    for (const int frames : {0, 7}) {
        // The frame that is shown next counts, and the panels have settled before it.
        const int before = std::max(frames - 1, settlingFrames);
        ScriptDriver driver = driverAfter(before - 1, {.frames = frames, .windowScreenshot = "a.png"});
        EXPECT_FALSE(driver.wantsWindow(complete));
        driver.noteFrame();
        EXPECT_FALSE(driver.wantsWindow(!complete));
        EXPECT_TRUE(driver.wantsWindow(complete));
        driver.noteFrame();
        EXPECT_TRUE(drive(driver, complete).empty());
        driver.noteWindowWritten();
        EXPECT_TRUE(quits(drive(driver, complete)));
    }
}

TEST_F(ScriptDriving, WritesEachPictureOfASequenceAtItsMoment) {
    ScriptDriver driver =
        driverAfter(settlingFrames, {.frames = 1, .sequence = {{"0.png", 2.0}, {"1.png", 2.5}}});
    // The window shows another moment at first.
    std::vector<Command> commands = drive(driver, complete, 0.0);
    ASSERT_EQ(commands.size(), 1U);
    EXPECT_EQ(std::get<ShowTime>(commands[0]).seconds, 2.0);
    EXPECT_TRUE(drive(driver, !complete, 2.0).empty());

    commands = drive(driver, complete, 2.0);
    ASSERT_EQ(commands.size(), 2U);
    EXPECT_EQ(std::get<WritePicture>(commands[0]).file, "0.png");
    EXPECT_EQ(std::get<ShowTime>(commands[1]).seconds, 2.5);

    commands = drive(driver, complete, 2.5);
    ASSERT_EQ(commands.size(), 1U);
    EXPECT_EQ(std::get<WritePicture>(commands[0]).file, "1.png");
    EXPECT_TRUE(quits(drive(driver, complete, 2.5)));
}

}  // namespace
}  // namespace raytorus::viewer
