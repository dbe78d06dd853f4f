// SPDX-License-Identifier: MIT
// Pictures are written in their order by another thread, few are held, and an error comes back to the
// renderer.
#include "cli/picture_writer.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "support/expect_error.hpp"
#include "support/semaphore.hpp"

namespace raytorus::cli {
namespace {

// The writer's hand: notes what is written, and stops at each picture until it is let go.
struct Hand {
    PictureWriter::Write write() {
        return [this](const std::filesystem::path& path, const image::Image& picture) {
            began.release();
            go.acquire();
            EXPECT_NE(std::this_thread::get_id(), renderer);
            if (path == failing) {
                throw Error(ExitCode::File, "cannot write \"" + path.string() + "\": the disk is full");
            }
            written.push_back(path.string() + " " + std::to_string(picture.width));
        };
    }

    const std::thread::id renderer = std::this_thread::get_id();
    test::Semaphore began;
    test::Semaphore go;
    std::filesystem::path failing;
    std::vector<std::string> written;  // read after finish() or the writer's end
};

image::Image wide(int width) {
    return {width, 1, {"R"}};
}

TEST(PictureWriter, WritesInOrder) {
    Hand hand;
    PictureWriter writer(2, hand.write());
    hand.go.release(100);
    std::vector<std::string> expected;
    for (int i = 1; i <= 20; ++i) {
        writer.write(std::to_string(i), wide(i));
        expected.push_back(std::to_string(i) + " " + std::to_string(i));
    }
    writer.finish();
    EXPECT_EQ(hand.written, expected);
}

TEST(PictureWriter, RendererGoesOnWhileAPictureIsWritten) {
    Hand hand;
    PictureWriter writer(1, hand.write());
    writer.write("a", wide(1));
    hand.began.acquire();        // "a" is being written, and stays so
    writer.write("b", wide(2));  // returns all the same
    std::atomic<bool> third = false;
    std::thread renderer([&] {
        writer.write("c", wide(3));
        third = true;
    });
    // "a" is held by the hand, so there is no room for "c", however long one waits.
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    EXPECT_FALSE(third);
    hand.go.release(3);
    renderer.join();
    writer.finish();
    EXPECT_EQ(hand.written, (std::vector<std::string>{"a 1", "b 2", "c 3"}));
}

TEST(PictureWriter, ErrorsComeBackAndEndTheWriting) {
    Hand hand;
    hand.failing = "b";
    hand.go.release(100);
    PictureWriter writer(1, hand.write());
    const std::initializer_list<std::string> words = {"\"b\"", "the disk is full"};
    test::expectError(
        [&] {
            for (const char* name : {"a", "b", "c", "d", "e", "f"}) {
                writer.write(name, wide(1));
            }
        },
        ExitCode::File, words);
    test::expectError([&] { writer.write("g", wide(1)); }, ExitCode::File, words);
    test::expectError([&] { writer.finish(); }, ExitCode::File, words);
    EXPECT_EQ(hand.written, std::vector<std::string>{"a 1"});
}

TEST(PictureWriter, RendererThatWaitsForRoomHearsOfTheError) {
    Hand hand;
    hand.failing = "a";
    PictureWriter writer(1, hand.write());
    writer.write("a", wide(1));
    hand.began.acquire();
    writer.write("b", wide(1));
    std::thread renderer([&] {
        test::expectError([&] { writer.write("c", wide(1)); }, ExitCode::File, {"the disk is full"});
    });
    hand.go.release(1);
    renderer.join();
    EXPECT_TRUE(hand.written.empty());
}

TEST(PictureWriter, ErrorOfTheLastPictureComesBackAtTheEnd) {
    Hand hand;
    hand.failing = "a";
    hand.go.release(100);
    PictureWriter writer(1, hand.write());
    writer.write("a", wide(1));
    test::expectError([&] { writer.finish(); }, ExitCode::File, {"the disk is full"});
}

TEST(PictureWriter, GivenUpItEndsWhatItHasBegunAndNoMore) {
    Hand hand;
    std::future<void> end;
    {
        auto writer = std::make_unique<PictureWriter>(2, hand.write());
        for (const char* name : {"a", "b", "c"}) {
            writer->write(name, wide(1));
        }
        hand.began.acquire();
        end = std::async(std::launch::async, [owned = std::move(writer)]() mutable { owned.reset(); });
    }
    // Long enough for the destructor to take "b" and "c" away; if it were not, this test would pass too
    // often, never fail wrongly.
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    hand.go.release(1);
    end.get();
    EXPECT_EQ(hand.written, std::vector<std::string>{"a 1"});
}

TEST(PictureWriter, NothingToWrite) {
    Hand hand;
    PictureWriter(1, hand.write()).finish();
    PictureWriter(1, hand.write());
    EXPECT_TRUE(hand.written.empty());
}

}  // namespace
}  // namespace raytorus::cli
