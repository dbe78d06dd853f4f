// SPDX-License-Identifier: MIT
// Porcelain with a net of thin lines, under one warm light and a cold rim. Only the paint turns: a torus is one of revolution.
const float shadePi = 3.14159265;

vec3 shadeBackground(float height) {
    return mix(vec3(0.0028, 0.003, 0.0038), vec3(0.009, 0.0105, 0.014), height);
}

// How much of a pixel `blur` wide is covered by lines at whole numbers, each `width` wide.
float shadeLines(float x, float width, float blur) {
    vec2 ends = x + 0.5 * width + vec2(0.5, -0.5) * blur;
    vec2 covered = width * floor(ends) + min(fract(ends), width);
    return (covered.x - covered.y) / blur;
}

// The net of meridians and parallels; every sixth meridian is marked. pixel: its width on the torus.
vec3 shadePaint(float R, float r, vec3 p, float facing, float turn, float pixel) {
    float rho = length(p.xy);
    float around = atan(p.y, p.x) + turn;
    float along = atan(p.z, rho - R);
    float blur = pixel / max(facing, 0.08);
    float meridians = 36.0 / (2.0 * shadePi);
    float parallels = 12.0 / (2.0 * shadePi);
    float blurAround = clamp(meridians * blur / max(rho, 1.0e-3), 1.0e-4, 1.0e3);
    float blurAlong = clamp(parallels * blur / r, 1.0e-4, 1.0e3);
    float net = max(shadeLines(meridians * around, 0.035, blurAround), shadeLines(parallels * along, 0.03, blurAlong));
    float marks = shadeLines(meridians * around / 6.0, 0.012, blurAround / 6.0);
    vec3 paint = mix(vec3(0.62, 0.59, 0.54), vec3(0.1, 0.105, 0.115), net);
    return mix(paint, vec3(0.75, 0.13, 0.03), min(marks, 1.0));
}

float shadeGloss(vec3 n, vec3 toLight, vec3 toEye, float sharpness) {
    return pow(max(dot(n, normalize(toLight + toEye)), 0.0), sharpness);
}

// Linear light from a hit. direction: unit, away from the eye.
vec3 shadeHit(float R, float r, vec3 p, vec3 n, vec3 direction, float turn, float pixel) {
    vec3 toEye = -direction;
    float facing = dot(n, toEye);
    vec3 key = normalize(vec3(0.55, -0.5, 0.8));
    vec3 rim = normalize(vec3(-0.7, 0.6, 0.25));
    // The hole is darker: from there the other side of the ring hides a part of the sky.
    float outwards = dot(n.xy, p.xy) / max(length(p.xy), 1.0e-6);
    float open = mix(1.0, 0.35 + 0.65 * smoothstep(-1.1, 0.5, outwards), min(2.0 * r / R, 1.0));
    vec3 light = open * mix(vec3(0.07, 0.07, 0.08), vec3(0.2, 0.22, 0.26), 0.5 + 0.5 * n.z);
    light += open * vec3(1.02, 0.95, 0.84) * max(dot(n, key), 0.0);
    light += vec3(0.1, 0.16, 0.26) * max(dot(n, rim), 0.0);
    vec3 color = light * shadePaint(R, r, p, facing, turn, pixel);
    float fresnel = 0.04 + 0.96 * pow(1.0 - clamp(facing, 0.0, 1.0), 5.0);
    color += open * vec3(1.0, 0.95, 0.87) * 0.35 * shadeGloss(n, key, toEye, 90.0);
    return color + open * fresnel * vec3(0.12, 0.15, 0.2) * (0.6 + 0.4 * n.z);
}

vec3 shadeDisplay(vec3 light) {
    return pow(light / (1.0 + 0.25 * light), vec3(1.0 / 2.2));
}
