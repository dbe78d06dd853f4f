// SPDX-License-Identifier: MIT
// host/gpu: devices are picked with reasons, faults become the right Error, and no validation message is
// lost.
#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <numeric>

#include "core/error.hpp"
#include "gpu/commands.hpp"
#include "gpu/pipeline.hpp"
#include "gpu/shader_module.hpp"
#include "gpu/timestamps.hpp"
#include "raytorus_shaders.hpp"
#include "support/device_fixture.hpp"

namespace raytorus {
namespace {

ExitCode codeOf(const std::function<void()>& run, const std::string& word = {}) {
    try {
        run();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
        return error.exitCode;
    }
    return ExitCode::Ok;
}

gpu::DeviceInfo fakeDevice(std::uint32_t index, const std::string& name, const std::string& type) {
    gpu::DeviceInfo info;
    info.index = index;
    info.name = name;
    info.driverInfo = "driver of " + name;
    info.type = type;
    return info;
}

TEST(PickDevice, PrefersTheFastestKindThenTheFirst) {
    const std::vector devices = {fakeDevice(0, "slow", "CPU"), fakeDevice(1, "small", "integrated GPU"),
                                 fakeDevice(2, "big", "discrete GPU"),
                                 fakeDevice(3, "other", "discrete GPU")};
    EXPECT_EQ(gpu::pickDevice(devices, "").index, 2U);
}

TEST(PickDevice, TakesANumberOrAPartOfANameInAnyCase) {
    const std::vector devices = {fakeDevice(0, "llvmpipe", "CPU"), fakeDevice(1, "GeForce", "discrete GPU")};
    EXPECT_EQ(gpu::pickDevice(devices, "0").index, 0U);
    EXPECT_EQ(gpu::pickDevice(devices, "LLVM").index, 0U);
    EXPECT_EQ(gpu::pickDevice(devices, "driver of ge").index, 1U);
}

TEST(PickDevice, SaysWhyEachOneWasRefused) {
    std::vector devices = {fakeDevice(0, "ancient", "discrete GPU"), fakeDevice(1, "odd", "CPU")};
    devices[0].refusals = {"it has Vulkan 1.0.0, and 1.3.0 is needed"};
    devices[1].refusals = {"the feature dynamicRendering is missing"};
    const auto pick = [&devices](const char* selector) {
        return [&, selector] { gpu::pickDevice(devices, selector); };
    };
    EXPECT_EQ(codeOf(pick(""), "1.3.0 is needed"), ExitCode::NoDevice);
    EXPECT_EQ(codeOf(pick(""), "dynamicRendering is missing"), ExitCode::NoDevice);
    EXPECT_EQ(codeOf(pick("quantum"), "quantum"), ExitCode::NoDevice);
    EXPECT_EQ(codeOf([] { gpu::pickDevice({}, ""); }, "mesa-vulkan-drivers"), ExitCode::NoDevice);
}

TEST(Result, EachKindHasItsExitCode) {
    const auto code = [](VkResult result) {
        return codeOf([result] { gpu::check(result, "vkCall"); }, "vkCall");
    };
    EXPECT_EQ(codeOf([] { gpu::check(VK_SUCCESS, "vkCall"); }), ExitCode::Ok);
    EXPECT_EQ(code(VK_ERROR_OUT_OF_DEVICE_MEMORY), ExitCode::OutOfMemory);
    EXPECT_EQ(code(VK_ERROR_OUT_OF_HOST_MEMORY), ExitCode::OutOfMemory);
    EXPECT_EQ(code(VK_ERROR_DEVICE_LOST), ExitCode::DeviceLost);
    EXPECT_EQ(code(VK_ERROR_INITIALIZATION_FAILED), ExitCode::NoDevice);
    EXPECT_EQ(code(VK_ERROR_UNKNOWN), ExitCode::Internal);
}

using Device = test::DeviceTest;

TEST_F(Device, ShaderModulesMustBeWhole) {
    const std::span<const std::uint32_t> good = shaders::find("trace.comp");
    const auto make = [](std::vector<std::uint32_t> words) {
        return [words] { const gpu::ShaderModule module(test::device(), words, "some.spv"); };
    };
    const std::vector<std::uint32_t> whole(good.begin(), good.end());
    EXPECT_EQ(codeOf(make(whole)), ExitCode::Ok);
    EXPECT_EQ(codeOf(make({})), ExitCode::Shader);
    EXPECT_EQ(codeOf(make({whole.begin(), whole.begin() + 5}), "some.spv"), ExitCode::Shader);
    EXPECT_EQ(codeOf(make({whole.begin(), whole.end() - 1}), "some.spv"), ExitCode::Shader);
    std::vector<std::uint32_t> noMagic = whole;
    noMagic[0] ^= 1U;
    EXPECT_EQ(codeOf(make(noMagic), "some.spv"), ExitCode::Shader);
}

TEST_F(Device, TooLargeBuffersAndImagesAreOutOfMemory) {
    const VkDeviceSize huge = VkDeviceSize{1} << 45U;  // 32 TiB
    EXPECT_EQ(codeOf([&] { gpu::Buffer(test::device(), huge, gpu::BufferUse::ReadBack); }, ""),
              ExitCode::OutOfMemory);
    EXPECT_EQ(codeOf([&] { gpu::Buffer(test::device(), huge, gpu::BufferUse::Storage); }, "allows"),
              ExitCode::OutOfMemory);
    EXPECT_EQ(codeOf(
                  [] {
                      gpu::DeviceImage(test::device(), {1U << 20U, 1});
                  },
                  "1048576x1"),
              ExitCode::OutOfMemory);
}

TEST_F(Device, ImagesComeBackAsTheyWereCleared) {
    const gpu::DeviceImage image(test::device(), {5, 3});
    const gpu::Buffer buffer(test::device(), 5 * 3 * gpu::DeviceImage::bytesPerPixel,
                             gpu::BufferUse::ReadBack);
    const gpu::Timestamps timestamps(test::device());
    test::device().submit([&](VkCommandBuffer commands) {
        constexpr gpu::Use clear{VK_PIPELINE_STAGE_2_CLEAR_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT};
        timestamps.begin(commands);
        gpu::imageBarrier(commands, image, {}, VK_IMAGE_LAYOUT_UNDEFINED, clear, VK_IMAGE_LAYOUT_GENERAL);
        const VkClearColorValue color{{1.0F, -2.0F, 1e-30F, 3e38F}};
        const VkImageSubresourceRange all{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
        vkCmdClearColorImage(commands, image.get(), VK_IMAGE_LAYOUT_GENERAL, &color, 1, &all);
        gpu::imageBarrier(commands, image, clear, VK_IMAGE_LAYOUT_GENERAL, gpu::copyRead,
                          VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
        gpu::copyOut(commands, image, image.extent(), buffer);
        gpu::bufferBarrier(commands, buffer, gpu::copyWrite, gpu::hostRead);
        timestamps.end(commands);
    });
    const std::span<const float> values = buffer.as<const float>();
    ASSERT_EQ(values.size(), 5U * 3U * 4U);
    for (std::size_t i = 0; i < values.size(); i += 4) {
        EXPECT_EQ(values[i], 1.0F);
        EXPECT_EQ(values[i + 1], -2.0F);
        EXPECT_EQ(values[i + 2], 1e-30F);
        EXPECT_EQ(values[i + 3], 3e38F);
    }
    ASSERT_TRUE(timestamps.seconds());
    EXPECT_GT(*timestamps.seconds(), 0.0);
}

TEST(Validation, MessagesReachTheLogAndTheResult) {
    const auto log = std::make_shared<gpu::ValidationLog>();
    gpu::ContextOptions options;
    options.validate = true;
    {
        gpu::Context context(options, log);
        ASSERT_TRUE(log->messages().empty()) << log->messages().front();
        const gpu::Buffer small(context, 16, gpu::BufferUse::ReadBack);
        // The copy does not fit; the layer says so while the command is recorded, and it is never run.
        const gpu::DeviceImage image(context, {64, 64});
        const VkCommandPoolCreateInfo poolInfo{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO, nullptr, 0,
                                               context.info().queueFamily};
        const auto pool = gpu::create<vkDestroyCommandPool>(vkCreateCommandPool, context.scope(), poolInfo,
                                                            "vkCreateCommandPool");
        VkCommandBufferAllocateInfo info{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
        info.commandPool = pool.get();
        info.commandBufferCount = 1;
        VkCommandBuffer commands = VK_NULL_HANDLE;
        gpu::check(vkAllocateCommandBuffers(context.device(), &info, &commands), "vkAllocateCommandBuffers");
        const VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
        gpu::check(vkBeginCommandBuffer(commands, &begin), "vkBeginCommandBuffer");
        gpu::copyOut(commands, image, image.extent(), small);
    }
    ASSERT_FALSE(log->messages().empty());
    EXPECT_EQ(codeOf([&log] { log->requireEmpty(); }, "VUID-"), ExitCode::ValidationMessage);
}

TEST(Validation, SynchronizationIsChecked) {
    const auto log = std::make_shared<gpu::ValidationLog>();
    gpu::ContextOptions options;
    options.validate = true;
    gpu::Context context(options, log);
    const gpu::DeviceImage image(context, {8, 8});
    const gpu::Buffer buffer(context, 64 * gpu::DeviceImage::bytesPerPixel, gpu::BufferUse::ReadBack);
    context.submit([&](VkCommandBuffer commands) {
        gpu::imageBarrier(commands, image, {}, VK_IMAGE_LAYOUT_UNDEFINED, gpu::copyRead,
                          VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
        gpu::copyOut(commands, image, image.extent(), buffer);
        gpu::copyOut(commands, image, image.extent(),
                     buffer);  // writes what the first one writes, without a barrier
    });
    EXPECT_EQ(codeOf([&log] { log->requireEmpty(); }, "SYNC-HAZARD-WRITE"), ExitCode::ValidationMessage);
}

TEST(TimeOut, IsAnErrorAndLeavesTheDeviceAlone) {
    gpu::ContextOptions options;
    options.timeoutSeconds = 1e-9;
    const auto log = std::make_shared<gpu::ValidationLog>();
    const auto run = [&] {
        gpu::Context context(options, log);
        const gpu::Buffer buffer(context, std::size_t{1} << 26U, gpu::BufferUse::ReadBack);
        context.submit(
            [&](VkCommandBuffer commands) { vkCmdFillBuffer(commands, buffer.get(), 0, VK_WHOLE_SIZE, 1); });
    };
    EXPECT_EQ(codeOf(run, "did not finish"), ExitCode::DeviceLost);
}

}  // namespace
}  // namespace raytorus
