// SPDX-License-Identifier: MIT
// Private: angle and point of a circle, in turns, which the surface's parametrisation needs.
#ifndef TORUS_CIRCLE_GLSL
#define TORUS_CIRCLE_GLSL

#include "double_float.glsl"

// atan(y, x) / (2 pi) in [0, 1): the built-in has no useful precision guarantee in Vulkan (4096 ulp) and differs
// between drivers. Odd polynomial for atan(q) / (2 pi) on [0, 1], minimax error 2.2e-9 of a turn (half an ulp at 1/16); 0 for x = y = 0.
float torus_turn(float y, float x) {
    float ax = abs(x);
    float ay = abs(y);
    float longer = max(ax, ay);
    TORUS_PRECISE float q = longer > 0.0 ? min(ax, ay) / longer : 0.0;
    TORUS_PRECISE float q2 = q * q;
    TORUS_PRECISE float p = (((0.000462114898 * q2 - 0.00259152171) * q2 + 0.00684992922) * q2 - 0.0119902184) * q2;
    p = ((((p + 0.0169574469) * q2 - 0.0226113554) * q2 + 0.0318199322) * q2 - 0.0530512668) * q2 + 0.159154937;
    TORUS_PRECISE float turn = q * p;
    turn = ay > ax ? 0.25 - turn : turn;
    turn = x < 0.0 ? 0.5 - turn : turn;
    turn = y < 0.0 ? 1.0 - turn : turn;
    // 1 - tiny rounds to 1, which is the same place as 0.
    return turn < 1.0 ? turn : 0.0;
}

// (cos, sin) of 2 pi turn. Reduced exactly to an eighth of a turn, where short polynomials are right to an ulp.
vec2 torus_circle(float turn) {
    TORUS_PRECISE float quarter = floor(4.0 * turn + 0.5);
    TORUS_PRECISE float a = 4.0 * turn - quarter;
    TORUS_PRECISE float a2 = a * a;
    TORUS_PRECISE float s = a * ((((0.000158195078 * a2 - 0.00468126079) * a2 + 0.0796925798) * a2 - 0.645964086) * a2 +
                                  1.57079637);
    TORUS_PRECISE float c = (((0.00090336299 * a2 - 0.0208599363) * a2 + 0.253669173) * a2 - 1.23370051) * a2 + 1.0;
    TORUS_PRECISE float quadrant = quarter - 4.0 * floor(0.25 * quarter);
    bool swapped = quadrant == 1.0 || quadrant == 3.0;
    float x = swapped ? s : c;
    float y = swapped ? c : s;
    x = quadrant == 1.0 || quadrant == 2.0 ? -x : x;
    y = quadrant >= 2.0 ? -y : y;
    return vec2(x, y);
}

#endif
