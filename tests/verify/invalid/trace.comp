#version 460
// SPDX-License-Identifier: MIT
// Breaks a rule of Vulkan without harm: the push constants of trace.comp end where the one here begins.

layout(local_size_x = 64) in;

layout(set = 0, binding = 1, std430) writeonly buffer Hits { float hits[]; };
layout(push_constant) uniform Constants { layout(offset = 12) float value; };

void main() {
    hits[0] = value;
}
