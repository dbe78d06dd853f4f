#version 460
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// From a picture's channels to what the window shows: a view of them.

#include "view.glsl"

layout(local_size_x = VIEW_GROUP, local_size_y = VIEW_GROUP) in;

layout(set = 0, binding = 0, rgba32f) uniform readonly image2D leftColor;
layout(set = 0, binding = 1, rgba32f) uniform readonly image2D leftPosition;
layout(set = 0, binding = 2, rgba32f) uniform readonly image2D leftNormal;
layout(set = 0, binding = 3, rgba32f) uniform readonly image2D leftSurface;
layout(set = 0, binding = 4, rgba32f) uniform readonly image2D rightColor;
layout(set = 0, binding = 5, rgba32f) uniform readonly image2D rightPosition;
layout(set = 0, binding = 6, rgba32f) uniform readonly image2D rightNormal;
layout(set = 0, binding = 7, rgba32f) uniform readonly image2D rightSurface;
layout(set = 0, binding = VIEW_BINDING_ANALYSIS, rgba32f) uniform readonly image2D analysis;
layout(set = 0, binding = VIEW_BINDING_OUTPUT, rgba32f) uniform writeonly image2D shown;

layout(push_constant) uniform Push { ViewPush push; };

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (at.x >= int(push.width) || at.y >= int(push.height)) {
        return;
    }
    bool right = at.x >= int(push.wipe);
    vec4 color = right ? imageLoad(rightColor, at) : imageLoad(leftColor, at);
    vec4 position = right ? imageLoad(rightPosition, at) : imageLoad(leftPosition, at);
    vec4 normal = right ? imageLoad(rightNormal, at) : imageLoad(leftNormal, at);
    vec4 surface = right ? imageLoad(rightSurface, at) : imageLoad(leftSurface, at);
    vec3 seen = viewColor(push, color, position, normal, surface, imageLoad(analysis, at));
    imageStore(shown, at, vec4(seen, 1.0));
}
