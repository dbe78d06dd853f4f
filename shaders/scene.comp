#version 460
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// The compute route: a pixel of the scene an invocation, in bands of rows.

#include "shade.glsl"

layout(local_size_x = SCENE_GROUP_WIDTH, local_size_y = SCENE_GROUP_HEIGHT) in;

layout(set = 0, binding = SCENE_BINDING_COLOR, rgba32f) uniform writeonly image2D colorImage;
layout(set = 0, binding = SCENE_BINDING_POSITION, rgba32f) uniform writeonly image2D positionImage;
layout(set = 0, binding = SCENE_BINDING_NORMAL, rgba32f) uniform writeonly image2D normalImage;
layout(set = 0, binding = SCENE_BINDING_SURFACE, rgba32f) uniform writeonly image2D surfaceImage;

layout(push_constant) uniform Band { uint firstRow; uint endRow; uint width; };

void main() {
    uvec2 at = gl_GlobalInvocationID.xy + uvec2(0u, firstRow);
    if (at.x >= width || at.y >= endRow) {
        return;
    }
    ScenePixel pixel = scenePixel(at);
    imageStore(colorImage, ivec2(at), pixel.color);
    if (sceneAovs) {
        imageStore(positionImage, ivec2(at), pixel.position);
        imageStore(normalImage, ivec2(at), pixel.normal);
        imageStore(surfaceImage, ivec2(at), pixel.surface);
    }
}
