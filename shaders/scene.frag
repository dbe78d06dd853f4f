#version 460
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// The fragment route: a pixel of the scene a fragment.

#include "shade.glsl"

layout(location = 0) out vec4 color;
layout(location = 1) out vec4 position;
layout(location = 2) out vec4 normal;
layout(location = 3) out vec4 surface;

void main() {
    ScenePixel pixel = scenePixel(uvec2(gl_FragCoord.xy));
    color = pixel.color;
    position = pixel.position;
    normal = pixel.normal;
    surface = pixel.surface;
}
