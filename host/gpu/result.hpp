// SPDX-License-Identifier: MIT
// From VkResult to Error: no result of a Vulkan call is ever dropped.
#pragma once

#include <vulkan/vulkan.h>

#include <string>
#include <string_view>

#include "core/error.hpp"

namespace raytorus::gpu {

/// A Vulkan call that failed, for those who can do something about some results.
class ResultError : public Error {
public:
    ResultError(ExitCode code, const std::string& message, VkResult failure)
        : Error(code, message), result(failure) {}

    VkResult result;
};

/// "VK_ERROR_DEVICE_LOST" and the like.
std::string_view resultName(VkResult result);

/// Throws a ResultError that names the call, unless the result is VK_SUCCESS.
void check(VkResult result, std::string_view call);

}  // namespace raytorus::gpu
