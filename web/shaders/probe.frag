// SPDX-License-Identifier: MIT
// Bits of rays and of their answers, of every stride-th sample: what WebGL 2 reads back from any device.
uniform ivec2 first;
uniform int stride;
uniform bool pasted;
layout(location = 0) out uvec4 rayBegin;
layout(location = 1) out uvec4 rayAlong;
layout(location = 2) out uvec4 hitPlace;
layout(location = 3) out uvec4 hitNormal;

void main() {
    vec3 direction = rayDirection(first + stride * ivec2(gl_FragCoord.xy));
    Answer answer;
    if (pasted) {
        answer = pastedAnswer(direction);
    } else {
        answer = libraryAnswer(direction);
    }
    rayBegin = floatBitsToUint(vec4(eye, 0.0));
    rayAlong = floatBitsToUint(vec4(direction, rayEnd));
    hitPlace = floatBitsToUint(vec4(answer.found ? 1.0 : 0.0, answer.t, answer.position.xy));
    hitNormal = floatBitsToUint(vec4(answer.position.z, answer.normal));
}
