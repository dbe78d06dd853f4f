// SPDX-License-Identifier: MIT
// Work that the host does not wait for: several pieces at once, each with its own end, and a tracer's
// batches.
#include "gpu/submission.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <vector>

#include "gpu/commands.hpp"
#include "support/device_fixture.hpp"
#include "support/expect_error.hpp"
#include "trace/tracer.hpp"

namespace raytorus {
namespace {

using trace::Query;
using trace::TraceRay;

class Submission : public test::DeviceTest {};

constexpr std::size_t bytes = std::size_t{1} << 22U;

void fill(gpu::Submission& submission, const gpu::Buffer& buffer, std::uint32_t value) {
    submission.start([&](VkCommandBuffer commands) {
        vkCmdFillBuffer(commands, buffer.get(), 0, VK_WHOLE_SIZE, value);
        gpu::bufferBarrier(commands, buffer, gpu::clearWrite, gpu::hostRead);
    });
}

bool holds(const gpu::Buffer& buffer, std::uint32_t value) {
    return std::ranges::all_of(buffer.as<const std::uint32_t>(),
                               [value](std::uint32_t found) { return found == value; });
}

TEST_F(Submission, SeveralRunAtOnceAndEachIsWaitedForAlone) {
    const gpu::Buffer first(test::device(), bytes, gpu::BufferUse::ReadBack);
    const gpu::Buffer second(test::device(), bytes, gpu::BufferUse::ReadBack);
    gpu::Submission one(test::device());
    gpu::Submission two(test::device());
    for (std::uint32_t turn = 1; turn <= 3; ++turn) {
        fill(one, first, turn);
        fill(two, second, 10 * turn);
        two.finish();
        EXPECT_TRUE(holds(second, 10 * turn));
        one.finish();
        one.finish();  // nothing runs, nothing is waited for
        EXPECT_TRUE(holds(first, turn));
    }
}

// The validation layers tell of what is destroyed while it is in use.
TEST_F(Submission, EndsBeforeItGoes) {
    const gpu::Buffer buffer(test::device(), bytes, gpu::BufferUse::ReadBack);
    {
        gpu::Submission submission(test::device());
        fill(submission, buffer, 7);
    }
    EXPECT_TRUE(holds(buffer, 7));
}

TEST(SubmissionTimeOut, IsAnErrorAndLeavesTheDeviceAlone) {
    gpu::ContextOptions options;
    options.timeoutSeconds = 1e-9;
    const auto log = std::make_shared<gpu::ValidationLog>();
    test::expectError(
        [&] {
            gpu::Context context(options, log);
            const gpu::Buffer buffer(context, std::size_t{1} << 26U, gpu::BufferUse::ReadBack);
            gpu::Submission one(context);
            gpu::Submission two(context);
            fill(one, buffer, 1);
            fill(two, buffer, 2);
            one.finish();
        },
        ExitCode::DeviceLost, {"did not finish"});
}

class TracerBatches : public test::DeviceTest {};

// From x = 3 + i along -x: meets the torus at 1.25.
std::vector<TraceRay> raysFrom(std::size_t first, std::size_t count) {
    std::vector<TraceRay> rays(count);
    for (std::size_t i = 0; i < count; ++i) {
        rays[i].origin[0] = 3.0F + static_cast<float>(first + i);
        rays[i].direction[0] = -1.0F;
        rays[i].tMax = std::numeric_limits<float>::infinity();
    }
    return rays;
}

TEST_F(TracerBatches, AreAnsweredAsOneAfterTheOther) {
    constexpr std::size_t capacity = 1000;
    for (const Query query : {Query::Nearest, Query::All, Query::Any}) {
        trace::Tracer single(test::device(), query, capacity);
        trace::Tracer tracer(test::device(), query, capacity, {}, 3);
        const std::array<std::size_t, 3> counts = {capacity, 1, 77};
        for (std::size_t turn = 0; turn < 2; ++turn) {
            for (std::size_t batch = 0; batch < counts.size(); ++batch) {
                EXPECT_EQ(tracer.rays(batch).size(), capacity);
                std::ranges::copy(raysFrom(100 * batch + turn, counts[batch]), tracer.rays(batch).begin());
                tracer.start(batch, {1.0F, 0.25F}, counts[batch]);
            }
            for (std::size_t batch = 0; batch < counts.size(); ++batch) {
                const std::span<const float> expected =
                    single.trace({1.0F, 0.25F}, raysFrom(100 * batch + turn, counts[batch]));
                const std::span<const float> found = tracer.finish(batch);
                EXPECT_EQ(found.size(), counts[batch] * hitFloats(query));
                EXPECT_TRUE(std::ranges::equal(found, expected)) << "batch " << batch << ", turn " << turn;
            }
        }
    }
}

TEST_F(TracerBatches, MoreRaysThanThereIsRoomForAreRefused) {
    trace::Tracer tracer(test::device(), Query::Any, 10);
    test::expectError([&] { tracer.start(0, {1.0F, 0.25F}, 11); }, ExitCode::Internal, {"11 rays", "for 10"});
    test::expectError(
        [&] {
            tracer.trace({1.0F, 0.25F}, raysFrom(0, 11));
        },
        ExitCode::Internal, {"11 rays", "for 10"});
}

}  // namespace
}  // namespace raytorus
