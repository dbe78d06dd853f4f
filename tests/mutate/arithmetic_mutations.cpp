// SPDX-License-Identifier: MIT
// Faults of the compensated arithmetic: each term that somebody could take for superfluous.
#include "mutate/mutation.hpp"

namespace raytorus::mutate {
namespace {

constexpr const char* arithmetic = "torus/double_float.glsl";
constexpr const char* ray = "torus/ray.glsl";
constexpr const char* refine = "torus/refine.glsl";
constexpr const char* torus = "torus/torus.glsl";
constexpr const char* crossing = "torus/crossing.glsl";

constexpr Mutation rows[] = {
    {"precise-dropped", "torus/language.glsl", "#define TORUS_PRECISE precise", "#define TORUS_PRECISE",
     "the compiler takes the compensations for zero"},
    {"reciprocal-halved", arithmetic, "0x7f000000u - floatBitsToUint(x)", "0x7e800000u - floatBitsToUint(x)",
     "the bias of the exponent off by one"},
    {"largest-float", arithmetic, "#define TORUS_FLOAT_MAX uintBitsToFloat(0x7f7fffffu)",
     "#define TORUS_FLOAT_MAX 1.0e3", "what stands for an infinite end is too near"},
    {"two-sum-halved", arithmetic, "(a - (sum - bInSum)) + (b - bInSum)", "b - bInSum",
     "right only where a is the larger one", Shows::InNumbers},
    {"two-sum-sign", arithmetic, "(a - (sum - bInSum)) + (b - bInSum)", "(a - (sum - bInSum)) - (b - bInSum)",
     "a sign in the two-sum"},
    {"split-at-the-wrong-bit", arithmetic, "0xfffff000u", "0xfff00000u",
     "halves whose products do not fit into a float"},
    {"product-low-parts", arithmetic, "+ aHigh * bLow + aLow * bHigh) + aLow * bLow", ") + aLow * bLow",
     "the mixed terms of the product dropped"},
    {"product-lowest-part", arithmetic, " + aLow * bLow;", ";", "the last term of the product dropped",
     Shows::InNumbers},
    {"square-mixed-part", arithmetic, "(2.0 * high) * low", "high * low", "a factor of two"},
    {"square-lowest-part", arithmetic, " + low * low;", ";", "the last term of the square dropped"},
    {"advance-sum-rounded", arithmetic,
     "(torus_twoSumError(base, product, sum) +\n"
     "                                torus_twoProductError(factor, direction, product))",
     "torus_twoProductError(factor, direction, product)", "the sum's rounding dropped"},
    {"advance-product-rounded", arithmetic,
     "(torus_twoSumError(base, product, sum) +\n"
     "                                torus_twoProductError(factor, direction, product))",
     "torus_twoSumError(base, product, sum)", "the product's rounding dropped", Shows::InNumbers},
    {"advance-rest-lost", arithmetic, "low = lost", "low = 0.0", "the rest of the sum thrown away"},
    {"advance-base-low", arithmetic, "little = baseLow + factorLow * direction",
     "little = factorLow * direction", "the low part of the base dropped", Shows::InNumbers},
    {"advance-factor-low", arithmetic, "little = baseLow + factorLow * direction", "little = baseLow",
     "position and t are of different points", Shows::InNumbers},
    {"squares-rounded", arithmetic, "(rest + min(aa, bb)) + (errors + lost)", "rest + min(aa, bb)",
     "the squares' roundings dropped"},
    {"squares-one-rounded", arithmetic, " - torus_squareError(c, cc)", "",
     "the third square's rounding dropped"},

    {"nothing-is-far", ray, "#define TORUS_FAR 8.0", "#define TORUS_FAR 1.0e30",
     "the foot of a far ray as it is rounded"},
    {"far-move-forgotten", ray, "moved = shift + move", "moved = move",
     "t counted from where the first move has led", Shows::InNumbers},
    {"far-move-rounded", ray, "gone = moved - shift", "gone = move",
     "position and t of a far ray are of different points", Shows::InNumbers},
    {"far-low-forgotten", ray, "baseLow = low;", "", "what the move of a far origin took in rounding is lost",
     Shows::InNumbers},
    {"base-shift-forgotten", ray, "R, r, base, baseLow, baseShift", "R, r, base, baseLow, 0.0",
     "t counted from the foot of a far ray"},
    {"second-shift-missing", ray, "float shift = -(base.x * d.x + base.y * d.y + base.z * d.z) * invDd",
     "float shift = 0.0", "the base taken for the foot"},

    {"place-rounded", refine, "shiftLow = u - (shift - line.shift)", "shiftLow = 0.0",
     "what the sum of shift and u loses is dropped", Shows::InNumbers},
    {"tube-rounded", refine, "torus_squareDifference(qHigh, p.z, r) +",
     "(qHigh * qHigh + p.z * p.z - r * r) +", "the exact value rounded after all"},
    {"tube-without-low", refine, " + ((2.0 * qHigh + qLow) * qLow + 2.0 * (p.z * low.z))", "",
     "the point's low part dropped from its value"},
    {"tube-low-squared", refine, "(2.0 * qHigh + qLow) * qLow", "2.0 * qHigh * qLow",
     "the square of a low part, which counts in a thin tube", Shows::InNumbers},
    {"root-residual-rounded", refine, "torus_squareDifference(p.x, p.y, rho) + 2.0 *", "2.0 *",
     "the square root's rounding dropped"},
    {"root-without-low", refine, " + 2.0 * (p.x * low.x + p.y * low.y)", "",
     "the point's low part dropped from its distance to the axis"},
    {"ring-distance-rounded", refine, "torus_twoSumError(rho, -R, qHigh) + 0.5", "0.5",
     "the difference's rounding dropped", Shows::InNumbers},
    {"ring-distance-without-low", refine, " + 0.5 * residual * invRho", "", "the root's low part dropped"},
    {"slope-without-height", refine, "halfSlope = rhoSlope * q + rise", "halfSlope = rhoSlope * q",
     "the slope across the axis alone"},
    {"curvature-sign", refine, "line.length2 - point.bend", "line.length2 + point.bend",
     "the bend of rho added"},
    {"bend-by-the-other-product", refine, "(p.x * d.y - p.y * d.x) * invRho",
     "(p.x * d.y + p.y * d.x) * invRho", "a sign of the cross product"},
    {"bend-without-ring", refine, "bend = R * rhoBend", "bend = rhoBend", "a factor of the curvature"},
    {"third-derivative-none", refine, "sixthThird = bendPerRho * rhoSlope", "sixthThird = 0.0",
     "near the axis a parabola is taken for the whole truth", Shows::InNumbers},
    {"fourth-derivative-none", refine, "fourth = bendPerRho * rhoBend", "fourth = 0.0",
     "where the third derivative is 0, a parabola is taken for the whole truth", Shows::InNumbers},
    {"axis-unguarded", refine, "max(rho, TORUS_AXIS)", "rho", "0 / 0 on the axis", Shows::InNumbers},
    {"axis-wide", crossing, "#define TORUS_AXIS 1.0e-12", "#define TORUS_AXIS 1.0e-1",
     "a tenth of the torus is taken for its axis"},
    {"axis-step-long", refine, "#define TORUS_AXIS_STEP 0.25", "#define TORUS_AXIS_STEP 1.0e6",
     "steps past the edge that rho has at the axis", Shows::InNumbers},
    {"position-without-low", refine, "(point.low + x * line.direction)", "(x * line.direction)",
     "the point's low part dropped from the hit", Shows::InNumbers},
    {"t-sum-rounded", torus, "(torus_twoSumError(line.baseShift, crossing.shift, sum) + crossing.rest)",
     "crossing.rest", "the sum's rounding dropped from t", Shows::InNumbers},
    {"t-rest-forgotten", torus, "(torus_twoSumError(line.baseShift, crossing.shift, sum) + crossing.rest)",
     "torus_twoSumError(line.baseShift, crossing.shift, sum)", "the last step dropped from t"},
};

}  // namespace

std::span<const Mutation> arithmeticMutations() {
    return rows;
}

}  // namespace raytorus::mutate
