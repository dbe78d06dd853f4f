// SPDX-License-Identifier: MIT
// From VkResult to Error: no result of a Vulkan call is ever dropped.
#pragma once

#include <vulkan/vulkan.h>

#include <string_view>

namespace raytorus::gpu {

/// "VK_ERROR_DEVICE_LOST" and the like.
std::string_view resultName(VkResult result);

/// Throws an Error that names the call, unless the result is VK_SUCCESS.
void check(VkResult result, std::string_view call);

}  // namespace raytorus::gpu
