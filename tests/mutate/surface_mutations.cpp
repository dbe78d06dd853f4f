// SPDX-License-Identifier: MIT
// Faults of the surface functions. Pictures use the normal and uv; the others are for the numeric tests
// alone.
#include "mutate/mutation.hpp"

namespace raytorus::mutate {
namespace {

constexpr const char* torus = "torus/torus.glsl";
constexpr const char* circle = "torus/circle.glsl";

constexpr Mutation rows[] = {
    {"normal-not-unit", torus, "float tube = sqrt(q * q + position.z * position.z);\n    if",
     "float tube = 1.0;\n    if", "a gradient that nobody normalised"},
    {"normal-by-radius", torus, "float tube = sqrt(q * q + position.z * position.z);\n    if",
     "float tube = torus.minorRadius;\n    if",
     "divided by r, which is the length only of a position without rounding"},
    {"normal-inward", torus, "return vec3(x, y, z);\n}\n\n// The parameters",
     "return vec3(-x, -y, -z);\n}\n\n// The parameters", "a sign of the normal"},
    {"normal-of-a-sphere", torus, "float radial = q / tube", "float radial = rho / tube",
     "away from the centre, not from the middle of the tube"},
    {"normal-on-the-axis", torus, "rho > 0.0 ? radial / rho : 0.0", "radial / rho", "0 / 0 on the axis",
     Shows::InNumbers},
    {"normal-in-the-middle", torus, "if (!(tube > 0.0)) {", "if (false) {",
     "0 / 0 on the tube's centre circle", Shows::InNumbers},
    {"uv-clockwise", torus, "torus_turn(position.y, position.x)", "torus_turn(-position.y, position.x)",
     "u runs from +x towards -y"},
    {"uv-from-the-y-axis", torus, "torus_turn(position.y, position.x)", "torus_turn(position.x, position.y)",
     "arguments of atan swapped"},
    {"uv-from-the-inner-equator", torus, "torus_turn(position.z, q)", "torus_turn(position.z, -q)",
     "v begins at the inner equator"},
    {"uv-exchanged", torus, "vec2(torus_turn(position.y, position.x), torus_turn(position.z, q))",
     "vec2(torus_turn(position.z, q), torus_turn(position.y, position.x))", "u and v exchanged"},
    {"uv-from-minus-a-half", circle, "y < 0.0 ? 1.0 - turn : turn", "y < 0.0 ? -turn : turn",
     "not wrapped to [0, 1)"},
    {"uv-one-at-the-seam", circle, "return turn < 1.0 ? turn : 0.0", "return turn",
     "1 - tiny rounds to 1, which is no uv", Shows::InNumbers},
    {"uv-octants", circle, "ay > ax ? 0.25 - turn : turn", "turn", "the diagonal's far side is not mirrored"},
    {"uv-coefficient", circle, "0.0226113554", "0.0226131554", "two digits of a coefficient swapped"},

    {"circle-not-reduced", circle, "floor(4.0 * turn + 0.5)", "floor(4.0 * turn)",
     "the polynomials run beyond an eighth of a turn", Shows::InNumbers},
    {"circle-quadrant", circle, "quadrant == 1.0 || quadrant == 2.0 ? -x", "quadrant == 2.0 ? -x",
     "the sign of the cosine in the second quadrant", Shows::InNumbers},
    {"circle-coefficient", circle, "0.253669173", "0.253696173", "two digits of a coefficient swapped",
     Shows::InNumbers},
    {"circle-negative-turns", circle, "quarter - 4.0 * floor(0.25 * quarter)",
     "quarter - 4.0 * float(int(0.25 * quarter))", "truncated towards zero: turns below 0 go wrong",
     Shows::InNumbers},
    {"position-inside-out", torus, "torus.majorRadius + torus.minorRadius * tube.x",
     "torus.majorRadius - torus.minorRadius * tube.x", "v begins at the inner equator", Shows::InNumbers},
    {"tangent-sign", torus, "-rise * sinU", "rise * sinU", "a sign of dPdv", Shows::InNumbers},
    {"tangent-per-radian", torus, "float q = twoPi * (rho - torus.majorRadius)",
     "float q = rho - torus.majorRadius", "a derivative by radians, not turns", Shows::InNumbers},
    {"tangents-exchanged", torus, "dPdu = alongU;\n    dPdv = alongV;", "dPdu = alongV;\n    dPdv = alongU;",
     "the two derivatives exchanged", Shows::InNumbers},
    {"distance-unsigned", torus, "float distance = tube - torus.minorRadius",
     "float distance = abs(tube - torus.minorRadius)", "the inside is positive too", Shows::InNumbers},
    {"distance-past-the-tip", torus, "if (landing < 0.0) {", "if (false) {",
     "inside a spindle the distance to its inner sheet", Shows::InNumbers},
    {"distance-tip-sign", torus, "distance = -toTip", "distance = toTip",
     "the inside of a spindle's middle is outside", Shows::InNumbers},
    {"implicit-outer-sheet", torus, "float value = outerSheet * innerSheet", "float value = outerSheet",
     "half of the equation", Shows::InNumbers},
    {"implicit-inner-radius", torus, "float p = rho + torus.majorRadius", "float p = rho",
     "the inner sheet without R", Shows::InNumbers},
};

}  // namespace

std::span<const Mutation> surfaceMutations() {
    return rows;
}

}  // namespace raytorus::mutate
