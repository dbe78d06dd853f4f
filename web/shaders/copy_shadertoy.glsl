// SPDX-License-Identifier: MIT
void mainImage(out vec4 color, in vec2 place) {
    vec2 size = iResolution.xy;
    float pixel = 2.0 * EXTENT / min(size.x, size.y);
    // Drag to look from elsewhere.
    vec2 drag = iMouse.z > 0.0 ? iMouse.xy / size - 0.5 : vec2(0.0);
    float elevation = clamp(ELEVATION - 3.0 * drag.y, -1.57, 1.57);
    color = vec4(picture((place - 0.5 * size) * pixel + vec2(PAN_X, PAN_Y), pixel, elevation, TURN + 0.3 * iTime + 6.0 * drag.x), 1.0);
}
