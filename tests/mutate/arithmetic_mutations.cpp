// SPDX-License-Identifier: MIT
// Faults of the compensated arithmetic: each term that somebody could take for superfluous.
#include "mutate/mutation.hpp"

namespace raytorus::mutate {
namespace {

constexpr const char* arithmetic = "torus/arithmetic.glsl";
constexpr const char* line = "torus/line.glsl";
constexpr const char* tube = "torus/tube.glsl";
constexpr const char* lastStep = "torus/last_step.glsl";
constexpr const char* torus = "torus/torus.glsl";

constexpr Mutation rows[] = {
    {"precise-dropped", arithmetic, "#define TORUS_PRECISE precise", "#define TORUS_PRECISE",
     "the compiler takes the compensations for zero"},
    {"two-sum-halved", arithmetic, "(a - (sum - bInSum)) + (b - bInSum)", "b - bInSum",
     "right only where a is the larger one", Shows::InNumbers},
    {"two-sum-sign", arithmetic, "(a - (sum - bInSum)) + (b - bInSum)", "(a - (sum - bInSum)) - (b - bInSum)",
     "a sign in the two-sum"},
    {"split-at-the-wrong-bit", arithmetic, "0xfffff000u", "0xfff00000u",
     "halves whose products do not fit into a float"},
    {"product-low-parts", arithmetic, "+ aHigh * bLow + aLow * bHigh) + aLow * bLow", ") + aLow * bLow",
     "the mixed terms of the product dropped"},
    {"product-lowest-part", arithmetic, " + aLow * bLow;", ";", "the last term of the product dropped"},
    {"product-one-mixed-part", arithmetic, "+ aHigh * bLow + aLow * bHigh", "+ aHigh * bLow",
     "a mixed term of the product dropped"},
    {"advance-sum-rounded", arithmetic,
     "torus_sumError(base, product, sum) + torus_productError(factor, direction, product)",
     "torus_productError(factor, direction, product)", "the sum's rounding dropped"},
    {"advance-product-rounded", arithmetic,
     "torus_sumError(base, product, sum) + torus_productError(factor, direction, product)",
     "torus_sumError(base, product, sum)", "the product's rounding dropped", Shows::InNumbers},
    {"advance-rest-lost", arithmetic, "low = lost", "low = 0.0", "the rest of the sum thrown away"},
    {"squares-rounded", arithmetic, "(rest + min(aa, bb)) + (errors + lost)", "rest + min(aa, bb)",
     "the squares' roundings dropped"},
    {"squares-one-rounded", arithmetic, " - torus_productError(c, c, cc)", "",
     "the third square's rounding dropped"},

    {"second-shift-missing", line, "shift = -(base.x * d.x + base.y * d.y + base.z * d.z) * perDd",
     "shift = 0.0", "from far away one shift does not reach the foot"},
    {"base-low-forgotten", line, "R, r, base, baseLow, baseShift", "R, r, base, vec3(0.0), baseShift",
     "what the shift from afar took in rounding is lost", Shows::InNumbers},
    {"nothing-is-afar", line, "> TORUS_AFAR || r > ring", "> 1.0e30 || r > ring",
     "the foot of a far ray as it is rounded"},
    {"afar-without-rounding", line, " + TORUS_AFAR_ROUNDING * (farthest * farthest)", "",
     "rays from very far pass by whose moment has been rounded away", Shows::InNumbers},
    {"afar-without-room", line, "#define TORUS_AFAR_ROOM 1.0626", "#define TORUS_AFAR_ROOM 0.9",
     "rays from afar that meet the outer equator pass by"},
    {"tips-by-rough-feet", line, "> TORUS_AFAR || r > ring", "> TORUS_AFAR",
     "at a horn's tip the foot as it is rounded", Shows::InNumbers},
    {"base-shift-forgotten", line, "R, r, base, baseLow, baseShift", "R, r, base, baseLow, 0.0",
     "t counted from the foot of a far ray"},
    {"place-rounded", tube, "line.baseLow, shift, shiftLow, line.direction",
     "line.baseLow, shift, 0.0, line.direction", "position and t are of different points", Shows::InNumbers},

    {"tube-as-polynomial", tube,
     "(q - line.minorRadius) * (q + line.minorRadius) + z * z;\n    TORUS_PRECISE float along",
     "((x * x + y * y + z * z + line.majorRadius * line.majorRadius - line.minorRadius * line.minorRadius) "
     "-\n"
     "        2.0 * line.majorRadius * rho);\n    TORUS_PRECISE float along",
     "multiplied out, the tube function cancels and loses a thin tube"},
    {"exact-tube-rounded", tube, "torus_squareDifference(q, z, line.minorRadius) +",
     "(q * q + z * z - line.minorRadius * line.minorRadius) +", "the exact value rounded after all"},
    {"exact-tube-without-low", tube,
     " +\n                               ((2.0 * q + qLow) * qLow + 2.0 * (z * allLow.z))", "",
     "the point's low part dropped from its value"},
    {"root-residual-rounded", tube, "torus_squareDifference(x, y, root) + 2.0 * (x", "2.0 * (x",
     "the square root's rounding dropped"},
    {"root-without-low", tube, " + 2.0 * (x * allLow.x + y * allLow.y)", "",
     "the point's low part dropped from its distance to the axis"},
    {"ring-distance-rounded", tube, "torus_sumError(root, -line.majorRadius, q) + rootLow", "rootLow",
     "the difference's rounding dropped", Shows::InNumbers},
    {"ring-distance-without-low", tube, "torus_sumError(root, -line.majorRadius, q) + rootLow",
     "torus_sumError(root, -line.majorRadius, q)", "the root's low part dropped"},
    {"curvature-sign", tube, "line.length2 - bend", "line.length2 + bend", "the bend of rho added"},
    {"position-without-low", lastStep, "(point.low + step * line.direction)", "(step * line.direction)",
     "the point's low part dropped from the hit", Shows::InNumbers},
    {"t-sum-rounded", torus, "(torus_sumError(line.baseShift, end.shift, sum) + end.rest)", "end.rest",
     "the sum's rounding dropped from t", Shows::InNumbers},

    {"clear-split-coarse", arithmetic, "#define TORUS_TO_10_BITS 12288.0", "#define TORUS_TO_10_BITS 1536.0",
     "high parts longer than their squares may be", Shows::InNumbers},
    {"clear-place-split-coarse", arithmetic, "#define TORUS_TO_8_BITS 49152.0",
     "#define TORUS_TO_8_BITS 3072.0", "high parts too long for an exact product", Shows::InNumbers},
    {"clear-place-rounded", lastStep, "(line.baseLow + shiftLow * d)", "line.baseLow",
     "position and t are of different points", Shows::InNumbers},
    {"clear-place-coarse", lastStep, "movedLow = coarse * dLow + fine * d", "movedLow = coarse * dLow",
     "the place rounded to eight bits"},
    {"clear-direction-rounded", lastStep, "movedLow = coarse * dLow + fine * d", "movedLow = fine * d",
     "the direction rounded to eleven bits"},
    {"clear-base-low-forgotten", lastStep, "(line.baseLow + shiftLow * d)", "(shiftLow * d)",
     "what the shift from afar took in rounding is lost", Shows::InNumbers},
    {"clear-point-rounded", lastStep, " + movedLow) + (line.baseLow + shiftLow * d)", ")",
     "the point's low part dropped"},
    {"clear-squares-rounded", lastStep, "more = low * (high + (high + low))", "more = low * 0.0",
     "the low parts dropped from the squares"},
    {"clear-lowest-squares", lastStep, "more = low * (high + (high + low))", "more = low * (high + high)",
     "the square of the low part dropped", Shows::InNumbers},
    {"clear-major-rounded", lastStep, "major2Low = (R - majorHigh) * (majorHigh + R)", "major2Low = 0.0",
     "the major radius rounded to ten bits"},
    {"clear-minor-rounded", lastStep, "minor2Low = (r - minorHigh) * (minorHigh + r)", "minor2Low = 0.0",
     "the minor radius rounded to ten bits"},
    {"clear-scale-rounded", lastStep, "scaleLow = (4.0 * major2High - scaleHigh) + 4.0 * major2Low",
     "scaleLow = 0.0", "4 R^2 rounded to twelve bits"},
    {"clear-a-rounded", lastStep, "aLow = (aSum - aHigh) + aRest", "aLow = aSum - aHigh",
     "the low parts dropped from a"},
    {"clear-b-rounded", lastStep, "bLow = (bSum - bHigh) + bRest", "bLow = bSum - bHigh",
     "the low parts dropped from b"},
    {"clear-value-rounded", lastStep, "(aLow * (aHigh + a) - (scaleHigh * bLow + scaleLow * b))", "0.0",
     "the low parts dropped from the value"},
};

}  // namespace

std::span<const Mutation> arithmeticMutations() {
    return rows;
}

}  // namespace raytorus::mutate
