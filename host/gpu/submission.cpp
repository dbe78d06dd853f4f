// SPDX-License-Identifier: MIT
#include "gpu/submission.hpp"

#include <utility>

#include "gpu/context.hpp"
#include "gpu/result.hpp"

namespace raytorus::gpu {

Submission::Submission(Context& deviceContext) : context(&deviceContext) {
    VkCommandPoolCreateInfo poolInfo{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
    poolInfo.flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT;
    poolInfo.queueFamilyIndex = context->info().queueFamily;
    pool =
        create<vkDestroyCommandPool>(vkCreateCommandPool, context->scope(), poolInfo, "vkCreateCommandPool");
    const VkFenceCreateInfo fenceInfo{VK_STRUCTURE_TYPE_FENCE_CREATE_INFO, nullptr, 0};
    fence = create<vkDestroyFence>(vkCreateFence, context->scope(), fenceInfo, "vkCreateFence");
    VkCommandBufferAllocateInfo bufferInfo{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
    bufferInfo.commandPool = pool.get();
    bufferInfo.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    bufferInfo.commandBufferCount = 1;
    check(vkAllocateCommandBuffers(context->device(), &bufferInfo, &commands), "vkAllocateCommandBuffers");
}

Submission::~Submission() {
    if (context->scope().abandoned) {
        return;
    }
    try {
        finish();
    } catch (...) {
        // Nobody asked for this work's end; who next asks the device for something hears of its loss.
    }
}

void Submission::start(const std::function<void(VkCommandBuffer)>& record, VkSemaphore wait,
                       VkSemaphore signal) {
    VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    check(vkBeginCommandBuffer(commands, &begin), "vkBeginCommandBuffer");
    record(commands);
    check(vkEndCommandBuffer(commands), "vkEndCommandBuffer");
    VkCommandBufferSubmitInfo recorded{VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO};
    recorded.commandBuffer = commands;
    VkSemaphoreSubmitInfo begins{VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO};
    begins.semaphore = wait;
    begins.stageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    VkSemaphoreSubmitInfo ends = begins;
    ends.semaphore = signal;
    VkSubmitInfo2 submission{VK_STRUCTURE_TYPE_SUBMIT_INFO_2};
    submission.waitSemaphoreInfoCount = wait != VK_NULL_HANDLE ? 1 : 0;
    submission.pWaitSemaphoreInfos = &begins;
    submission.signalSemaphoreInfoCount = signal != VK_NULL_HANDLE ? 1 : 0;
    submission.pSignalSemaphoreInfos = &ends;
    submission.commandBufferInfoCount = 1;
    submission.pCommandBufferInfos = &recorded;
    check(vkQueueSubmit2(context->queue(), 1, &submission, fence.get()), "vkQueueSubmit2");
    running = true;
}

void Submission::finish() {
    if (std::exchange(running, false)) {
        context->wait(fence.get());
        check(vkResetFences(context->device(), 1, fence.address()), "vkResetFences");
    }
}

}  // namespace raytorus::gpu
