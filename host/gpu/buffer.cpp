// SPDX-License-Identifier: MIT
#include "gpu/buffer.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "gpu/result.hpp"

namespace raytorus::gpu {
namespace {

VkBufferUsageFlags usageOf(BufferUse use) {
    switch (use) {
        case BufferUse::Uniform:
            return VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT;
        case BufferUse::Upload:
            return VK_BUFFER_USAGE_TRANSFER_SRC_BIT;
        case BufferUse::ReadBack:
            return VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;
        case BufferUse::Storage:
            break;
    }
    return VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
}

}  // namespace

Buffer::Buffer(const Context& context, VkDeviceSize size, BufferUse use)
    : byteCount(std::max<VkDeviceSize>(size, 4)) {
    const VkPhysicalDeviceLimits& limits = context.info().limits;
    const VkDeviceSize limit = use == BufferUse::Storage   ? limits.maxStorageBufferRange
                               : use == BufferUse::Uniform ? limits.maxUniformBufferRange
                                                           : byteCount;
    if (byteCount > limit) {
        throw Error(ExitCode::OutOfMemory, fmt::format("a buffer of {} bytes is needed, and {} allows {}",
                                                       byteCount, context.info().name, limit));
    }
    VkBufferCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
    info.size = byteCount;
    info.usage = usageOf(use);
    buffer = create<vkDestroyBuffer>(vkCreateBuffer, context.scope(), info, "vkCreateBuffer");
    VkMemoryRequirements requirements{};
    vkGetBufferMemoryRequirements(context.device(), buffer.get(), &requirements);
    memory = context.allocate(requirements,
                              VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT,
                              use == BufferUse::ReadBack ? VK_MEMORY_PROPERTY_HOST_CACHED_BIT
                                                         : VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
    check(vkBindBufferMemory(context.device(), buffer.get(), memory.get(), 0), "vkBindBufferMemory");
    void* address = nullptr;
    check(vkMapMemory(context.device(), memory.get(), 0, VK_WHOLE_SIZE, 0, &address), "vkMapMemory");
    mapped = static_cast<std::byte*>(address);
}

}  // namespace raytorus::gpu
