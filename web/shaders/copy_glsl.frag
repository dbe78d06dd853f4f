// SPDX-License-Identifier: MIT
out vec4 color;
uniform vec2 size;  // of the picture, in pixels

void main() {
    float pixel = 2.0 * EXTENT / min(size.x, size.y);
    color = vec4(picture((gl_FragCoord.xy - 0.5 * size) * pixel + vec2(PAN_X, PAN_Y), pixel, ELEVATION, TURN), 1.0);
}
