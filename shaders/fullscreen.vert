#version 460
// SPDX-License-Identifier: MIT
// One triangle that covers the picture; needs no vertex buffer.

void main() {
    vec2 corner = vec2(float((gl_VertexIndex << 1) & 2), float(gl_VertexIndex & 2));
    gl_Position = vec4(2.0 * corner - 1.0, 0.0, 1.0);
}
