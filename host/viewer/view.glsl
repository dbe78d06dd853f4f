// SPDX-License-Identifier: MIT
// What a view shows of a pixel.
#ifndef VIEW_GLSL
#define VIEW_GLSL

#include "view_colors.glsl"

vec3 geometryView(ViewPush push, vec4 position, vec4 normal, vec4 surface) {
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

vec3 analysisView(ViewPush push, vec4 known, vec4 normal, vec4 surface) {
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

// As displayed, or linear for a window that encodes by itself.
vec3 viewColor(ViewPush push, vec4 color, vec4 position, vec4 normal, vec4 surface, vec4 known) {
    bool isLinear = push.view == VIEW_SHADED || push.view == VIEW_GOLDEN;
    vec3 seen = push.view == VIEW_SHADED    ? color.rgb
                : push.view >= VIEW_SURFACE ? analysisView(push, known, normal, surface)
                                            : geometryView(push, position, normal, surface);
    if (isLinear && push.linear == 0u) {
        return encodeSrgb(seen);
    }
    return !isLinear && push.linear == 1u ? decodeSrgb(seen) : seen;
}

#endif
