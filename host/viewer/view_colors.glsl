// SPDX-License-Identifier: MIT
// The colours of the views, as displayed (sRGB, not linear).
#ifndef VIEW_COLORS_GLSL
#define VIEW_COLORS_GLSL

#include "view_io.h"

const vec3 nothingColor = vec3(0.045, 0.05, 0.06);
const vec3 wrongColor = vec3(1.0, 0.0, 0.85);

vec3 encodeSrgb(vec3 linear) {
    vec3 v = clamp(linear, 0.0, 1.0);
    return mix(12.92 * v, 1.055 * pow(v, vec3(1.0 / 2.4)) - 0.055, greaterThan(v, vec3(0.0031308)));
}

vec3 decodeSrgb(vec3 stored) {
    return mix(stored / 12.92, pow((stored + 0.055) / 1.055, vec3(2.4)), greaterThan(stored, vec3(0.04045)));
}

// Through VIEW_RAMP's stops, from 0 to 1.
vec3 rampColor(float at) {
    const vec3 stops[VIEW_RAMP_STOPS] = vec3[VIEW_RAMP_STOPS](VIEW_RAMP(vec3));
    float place = clamp(at, 0.0, 1.0) * float(VIEW_RAMP_STOPS - 1);
    int low = min(int(place), VIEW_RAMP_STOPS - 2);
    return mix(stops[low], stops[low + 1], place - float(low));
}

vec3 errorColor(float units) {
    const vec3 stops[VIEW_ERROR_STOPS] = vec3[VIEW_ERROR_STOPS](VIEW_ERROR_RAMP(vec3));
    float decades = log(max(units, VIEW_ERROR_SMALLEST) / VIEW_ERROR_SMALLEST) / log(10.0);
    float place = clamp(decades / VIEW_ERROR_DECADES, 0.0, 1.0) * float(VIEW_ERROR_STOPS - 1);
    int low = min(int(place), VIEW_ERROR_STOPS - 2);
    return mix(stops[low], stops[low + 1], place - float(low));
}

// Even numbers along the ramp; odd ones, which only a ray that starts in a solid has, in green.
vec3 countColor(int count) {
    if (count == 0) {
        return nothingColor;
    }
    return count % 2 == 1 ? vec3(0.15, 0.75, 0.35) : rampColor(float(count) / 8.0);
}

vec3 uvColor(vec2 uv) {
    vec2 field = floor(uv * vec2(24.0, 12.0));
    float other = mod(field.x + field.y, 2.0);
    return mix(vec3(uv, 0.35), vec3(0.93), 0.55 * other);
}

vec3 torusColor(int torus) {
    // Hues a golden angle apart: neighbours in the scene look different.
    vec3 hue = fract(float(torus) * 0.61803399 + vec3(0.0, 0.6667, 0.3333));
    return 0.25 + 0.7 * clamp(abs(6.0 * hue - 3.0) - 1.0, 0.0, 1.0);
}

#endif
