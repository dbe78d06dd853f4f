#version 460
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// From a picture's channels to what the window shows: a view of them.

#include "view_colors.glsl"
#include "view_io.h"

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

vec3 geometryView(vec4 position, vec4 normal, vec4 surface) {
    bool hit = surface.z >= 0.0;
    if (push.view == VIEW_COUNT) {
        return countColor(int(normal.w));
    }
    if (push.view == VIEW_STEPS) {
        return rampColor(surface.w / push.mostSteps);
    }
    if (!hit) {
        return nothingColor;
    }
    switch (push.view) {
    case VIEW_NORMAL:
        return 0.5 + 0.5 * normal.xyz;
    case VIEW_UV:
        return uvColor(surface.xy);
    case VIEW_DEPTH:
        return vec3(1.0 - 0.9 * clamp((position.w - push.nearest) / (push.farthest - push.nearest), 0.0, 1.0));
    default:
        return torusColor(int(surface.z));
    }
}

vec3 analysisView(vec4 known, vec4 normal, vec4 surface) {
    switch (int(known.x)) {
    case ANALYSIS_PENDING:  // a grey sketch of what is there to be judged
        return surface.z >= 0.0 ? vec3(0.10 + 0.10 * abs(normal.z)) : nothingColor;
    case ANALYSIS_MISS:
        return nothingColor;
    case ANALYSIS_WRONG:
        return wrongColor;
    case ANALYSIS_COLOR:
        return known.yzw;
    default:
        return errorColor(push.view == VIEW_SURFACE ? known.y : known.z);
    }
}

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (at.x >= int(push.width) || at.y >= int(push.height)) {
        return;
    }
    bool right = at.x >= int(push.wipe);
    vec3 color = vec3(0.0);  // linear for VIEW_SHADED and VIEW_GOLDEN, as displayed for the others
    if (push.view == VIEW_SHADED) {
        color = right ? imageLoad(rightColor, at).rgb : imageLoad(leftColor, at).rgb;
    } else {
        vec4 position = right ? imageLoad(rightPosition, at) : imageLoad(leftPosition, at);
        vec4 normal = right ? imageLoad(rightNormal, at) : imageLoad(leftNormal, at);
        vec4 surface = right ? imageLoad(rightSurface, at) : imageLoad(leftSurface, at);
        color = push.view >= VIEW_SURFACE ? analysisView(imageLoad(analysis, at), normal, surface)
                                          : geometryView(position, normal, surface);
    }
    bool isLinear = push.view == VIEW_SHADED || push.view == VIEW_GOLDEN;
    if (isLinear && push.linear == 0u) {
        color = encodeSrgb(color);
    } else if (!isLinear && push.linear == 1u) {
        color = decodeSrgb(color);
    }
    imageStore(shown, at, vec4(color, 1.0));
}
