// SPDX-License-Identifier: MIT
// What MethodFiles.cmake makes of the file of a method: its head, and the shaders that were compiled with it.
#pragma once

#include "trace/shader_source.hpp"

namespace raytorus {

struct EmbeddedMethod {
    const char* name;
    const char* description;
    double tolerance;   ///< as Method has it; infinite where answers may be wrong
    bool needsFloat64;  ///< in the shaders, so of the device
    trace::ShaderSource::Find find;
};

}  // namespace raytorus
