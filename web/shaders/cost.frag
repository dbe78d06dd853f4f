// SPDX-License-Identifier: MIT
// One ray a pixel and nothing else, by the method that COST_OF names: to be timed.
uniform int stride;
out vec4 color;

void main() {
    Answer answer = COST_OF(rayDirection(stride * ivec2(gl_FragCoord.xy)));
    color = vec4(answer.normal + answer.position, answer.t) / 256.0;
}
