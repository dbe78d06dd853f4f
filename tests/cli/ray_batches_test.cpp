// SPDX-License-Identifier: MIT
// Batches of rays go through reading, answering and writing in their order and at the same time, and an error
// comes back as if one were done after the other.
#include "cli/ray_batches.hpp"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <semaphore>
#include <string>
#include <thread>
#include <vector>

#include "core/error.hpp"
#include "support/expect_error.hpp"

namespace raytorus::cli {
namespace {

// Batch k, from 1, has k rays, whose answers are all k.
struct Stages {
    explicit Stages(int batchCount) : batches(batchCount) {}

    BatchStages stages() {
        return {.read = [this](std::size_t place) { return read(place); },
                .start = [this](std::size_t place, std::size_t count) { start(place, count); },
                .finish = [this](std::size_t place) { return finish(place); },
                .write = [this](std::span<const float> values) { write(values); }};
    }

    std::size_t read(std::size_t place) {
        const int batch = ++lastRead;
        if (batch == brokenRead) {
            throw Error(ExitCode::File, "line 7 is no ray");
        }
        EXPECT_NE(place, running) << "the device reads these rays";
        rays.at(place) = batch <= batches ? batch : 0;
        return static_cast<std::size_t>(rays.at(place));
    }

    void start(std::size_t place, std::size_t count) {
        EXPECT_EQ(count, static_cast<std::size_t>(rays.at(place)));
        EXPECT_EQ(running, none);
        running = place;
    }

    std::span<const float> finish(std::size_t place) {
        EXPECT_EQ(place, running);
        running = none;
        if (rays.at(place) == brokenAnswer) {
            throw Error(ExitCode::DeviceLost, "the device is lost");
        }
        answers.at(place).assign(static_cast<std::size_t>(rays.at(place)),
                                 static_cast<float>(rays.at(place)));
        return answers.at(place);
    }

    void write(std::span<const float> values) {
        if (values.empty()) {
            return;
        }
        if (static_cast<int>(values.front()) == brokenWrite) {
            throw Error(ExitCode::File, "the disk is full");
        }
        written.insert(written.end(), values.begin(), values.end());
    }

    static constexpr std::size_t none = 2;
    int batches;
    int brokenRead = 0;
    int brokenAnswer = 0;
    int brokenWrite = 0;
    int lastRead = 0;
    std::size_t running = none;
    std::array<int, 2> rays{};
    std::array<std::vector<float>, 2> answers;
    std::vector<float> written;  // by one thread at a time
};

std::vector<float> answersTo(int batches) {
    std::vector<float> answers;
    for (int k = 1; k <= batches; ++k) {
        answers.insert(answers.end(), static_cast<std::size_t>(k), static_cast<float>(k));
    }
    return answers;
}

TEST(RayBatches, AreWrittenInTheirOrder) {
    for (const int count : {0, 1, 2, 3, 4, 9}) {
        Stages stages(count);
        runBatches(stages.stages());
        EXPECT_EQ(stages.written, answersTo(count)) << count;
    }
}

// Writing batch k and reading batch k + 2 each wait for the other to begin: done in turn, one would wait in
// vain.
TEST(RayBatches, AreReadAndWrittenAtTheSameTimeWhileOneIsAnswered) {
    Stages stages(6);
    std::binary_semaphore reading(0);
    std::binary_semaphore writing(0);
    constexpr std::chrono::seconds never(60);
    BatchStages meeting = stages.stages();
    meeting.read = [&](std::size_t place) {
        if (stages.lastRead >= 2) {
            EXPECT_NE(stages.running, Stages::none) << "the device has nothing to do";
            reading.release();
            EXPECT_TRUE(writing.try_acquire_for(never));
        }
        return stages.read(place);
    };
    meeting.write = [&](std::span<const float> answers) {
        if (!answers.empty() && answers.front() < 6.0F) {  // with the last, nothing is left to read
            writing.release();
            EXPECT_TRUE(reading.try_acquire_for(never));
        }
        stages.write(answers);
    };
    runBatches(meeting);
    EXPECT_EQ(stages.written, answersTo(6));
}

TEST(RayBatches, AnErrorEndsThemAll) {
    const auto expectEnd = [](auto breakOne, ExitCode code, const std::string& word, int written) {
        Stages stages(5);
        breakOne(stages);
        test::expectError([&] { runBatches(stages.stages()); }, code, {word});
        EXPECT_EQ(stages.written, answersTo(written)) << word;
    };
    expectEnd([](Stages& stages) { stages.brokenRead = 1; }, ExitCode::File, "line 7", 0);
    expectEnd([](Stages& stages) { stages.brokenRead = 4; }, ExitCode::File, "line 7", 2);
    expectEnd([](Stages& stages) { stages.brokenAnswer = 3; }, ExitCode::DeviceLost, "lost", 2);
    expectEnd([](Stages& stages) { stages.brokenWrite = 3; }, ExitCode::File, "full", 2);
    expectEnd([](Stages& stages) { stages.brokenWrite = 5; }, ExitCode::File, "full", 4);
}

// Batch 2 is written while batch 3 is answered and batch 4 is read.
TEST(RayBatches, OfSeveralErrorsTheFirstInOrderIsThrown) {
    const auto expectFirst = [](int read, int answer, int write, const std::string& word) {
        Stages stages(5);
        stages.brokenRead = read;
        stages.brokenAnswer = answer;
        stages.brokenWrite = write;
        try {
            runBatches(stages.stages());
            ADD_FAILURE() << "no Error was thrown";
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
        }
    };
    expectFirst(4, 3, 2, "full");
    expectFirst(4, 3, 0, "lost");
    expectFirst(4, 0, 2, "full");
    expectFirst(0, 3, 2, "full");
}

}  // namespace
}  // namespace raytorus::cli
