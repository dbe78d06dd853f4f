// SPDX-License-Identifier: MIT
// Shader modules from SPIR-V in memory.
#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <span>
#include <string>

#include "gpu/context.hpp"

namespace raytorus::gpu {

class ShaderModule {
public:
    /// `name` is for messages. Throws Error{Shader} if the words are no SPIR-V, or of a version the device
    /// lacks.
    ShaderModule(const Context& context, std::span<const std::uint32_t> words, const std::string& name);

    [[nodiscard]] VkShaderModule get() const { return module.get(); }

private:
    Handle<VkShaderModule, vkDestroyShaderModule> module;
};

}  // namespace raytorus::gpu
