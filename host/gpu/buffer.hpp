// SPDX-License-Identifier: MIT
// Buffers with their memory.
#pragma once

#include <vulkan/vulkan.h>

#include <cstddef>
#include <cstring>
#include <span>

#include "gpu/context.hpp"

namespace raytorus::gpu {

enum class BufferUse {
    Storage,   ///< written and read by shaders; host-visible and filled by the host
    Uniform,   ///< read by shaders; host-visible and filled by the host
    Upload,    ///< copied from by the device; host-visible and filled by the host
    ReadBack,  ///< copied to by the device, or written by shaders, and read by the host (cached memory)
};

class Buffer {
public:
    Buffer() = default;
    /// `size` in bytes; 0 is taken as 4, because Vulkan has no empty buffers.
    Buffer(const Context& context, VkDeviceSize size, BufferUse use);

    [[nodiscard]] VkBuffer get() const { return buffer.get(); }
    [[nodiscard]] VkDeviceSize size() const { return byteCount; }

    /// The whole buffer, mapped for as long as it lives. The memory is coherent.
    [[nodiscard]] std::byte* data() const { return mapped; }

    template <typename T>
    [[nodiscard]] std::span<T> as() const {
        return {reinterpret_cast<T*>(mapped), static_cast<std::size_t>(byteCount) / sizeof(T)};
    }

private:
    // Declared in this order so that the buffer goes before its memory.
    Handle<VkDeviceMemory, vkFreeMemory> memory;
    Handle<VkBuffer, vkDestroyBuffer> buffer;
    VkDeviceSize byteCount = 0;
    std::byte* mapped = nullptr;
};

/// A buffer that holds a copy of `items`.
template <typename T>
Buffer makeBuffer(const Context& context, std::span<const T> items, BufferUse use) {
    Buffer buffer(context, items.size_bytes(), use);
    if (!items.empty()) {
        std::memcpy(buffer.data(), items.data(), items.size_bytes());
    }
    return buffer;
}

}  // namespace raytorus::gpu
