// SPDX-License-Identifier: MIT
// The one exception type of the host, and the exit codes that users meet. Thrown anywhere, caught once in
// each main.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace raytorus {

/// What a program returns to its caller. Published: the numbers never change.
enum class ExitCode : int {
    Ok = 0,
    Internal = 1,            ///< a fault of raytorus itself
    ComparisonFailed = 2,    ///< the images were compared, and differ by more than allowed
    SizeDiffers = 3,         ///< size or channels of two images differ: nothing to compare
    File = 4,                ///< a file is missing, unreadable, corrupt or cannot be written
    Usage = 5,               ///< the command line is wrong
    Scene = 6,               ///< the scene is invalid
    Shader = 7,              ///< a shader does not compile or the driver refuses it
    NoDevice = 8,            ///< no suitable Vulkan device
    OutOfMemory = 9,         ///< host or device memory ran out
    DeviceLost = 10,         ///< the device was lost, or did not finish in time
    ValidationMessage = 11,  ///< a Vulkan validation layer reported something
    NonFinite = 12,          ///< NaN or infinity where only numbers may be
};

/// An error whose message is one sentence for the user, with the file, line or value it is about.
class Error : public std::runtime_error {
public:
    Error(ExitCode code, const std::string& message) : std::runtime_error(message), exitCode(code) {}

    ExitCode exitCode;
};

/// "1.2.3", as given to project() in CMakeLists.txt.
std::string_view version();

}  // namespace raytorus
