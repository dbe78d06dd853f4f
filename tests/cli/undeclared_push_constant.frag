#version 460
// SPDX-License-Identifier: MIT
// Breaks a rule of Vulkan without harm: the pipeline that it is for has no push constants.

layout(location = 0) out vec4 color;

layout(push_constant) uniform Constants { float value; };

void main() {
    color = vec4(value);
}
