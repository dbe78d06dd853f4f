// SPDX-License-Identifier: MIT
// host/methods/parts/third_cosine.glsl as C++: `precise` gone (compiled without contraction into fma),
// literals float (-fsingle-precision-constant).
#define TORUS_PRECISE
#include "methods/parts/third_cosine.glsl"

namespace raytorus::test {

float thirdCosineAsCxx(float s);

float thirdCosineAsCxx(float s) {
    return thirdCosine(s);
}

}  // namespace raytorus::test
