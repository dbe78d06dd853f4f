// SPDX-License-Identifier: MIT
// A third of an angle without trigonometry. Knows nothing of tori, and compiles as C++ too.
#ifndef THIRD_COSINE_GLSL
#define THIRD_COSINE_GLSL

#ifndef TORUS_PRECISE
#define TORUS_PRECISE precise
#endif

// cos(acos(x) / 3) for x = 2 s^2 - 1, s in [0, 1]: the largest root of 4 c^3 - 3 c = x (Vieta's form of the cubic with
// three real roots; Nickalls, The Mathematical Gazette 77, 1993, pp. 354-359). In s it is cos(2/3 acos s), which is
// analytic up to both ends, where acos(x) itself has infinite slopes. The polynomial of degree 7 with the least
// largest error on [0, 1], by Remez' exchange in 40 digits, its coefficients then rounded to float32: off by 2.0e-8
// before, 3.9e-8 after, 1.1e-7 evaluated in float32; exact at both ends. Degree 6 reaches 1.4e-7, 5 reaches 1.1e-6.
float thirdCosine(float s) {
    TORUS_PRECISE float upper = ((0.00117371744 * s - 0.00625147671) * s + 0.0162716191) * s - 0.030389538;
    TORUS_PRECISE float value = (((upper * s + 0.052895885) * s - 0.111047707) * s + 0.577347517) * s + 0.5;
    return value;
}

#endif
