// SPDX-License-Identifier: MIT
// The picture: left of the wipe what the pasted form answers, right of it the library.
uniform ivec2 size;      // pixels
uniform int side;        // samples of a pixel: side * side
uniform float wipe;      // pixels from the left
uniform float turn;      // of the paint
uniform float pixel;     // its width on the torus
out vec4 color;

vec3 sampleColor(ivec2 at, bool pasted) {
    vec3 direction = rayDirection(at);
    Answer answer;
    if (pasted) {
        answer = pastedAnswer(direction);
    } else {
        answer = libraryAnswer(direction);
    }
    float height = float(at.y) / float(size.y * side);
    vec3 light = shadeBackground(height);
    if (answer.found) {
        light = shadeHit(torus.majorRadius, torus.minorRadius, answer.position, answer.normal, normalize(direction), turn, pixel);
    }
    return light;
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    bool pasted = gl_FragCoord.x < wipe;
    vec3 sum = vec3(0.0);
    for (int i = 0; i < side * side; ++i) {
        sum += shadeDisplay(sampleColor(at * side + ivec2(i % side, i / side), pasted));
    }
    // Half a step of eight bits, as a pattern, hides the steps of the background.
    float dither = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5;
    color = vec4(sum / float(side * side) + dither / 255.0, 1.0);
}
