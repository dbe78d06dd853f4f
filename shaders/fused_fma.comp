#version 460
// SPDX-License-Identifier: MIT
// Whether fma() rounds once here: it then returns what a product's rounding took, else 0.
layout(local_size_x = 1) in;

layout(set = 0, binding = 0, std430) writeonly buffer Error {
    float error;
};

// What no compiler knows: (1 + 2^-12)^2 = 1 + 2^-11 + 2^-24, of which float32 keeps the first two.
layout(push_constant) uniform Factor {
    float factor;
};

void main() {
    precise float product = factor * factor;
    precise float lost = fma(factor, factor, -product);
    error = lost;
}
