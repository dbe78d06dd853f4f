// SPDX-License-Identifier: MIT
// Faults of what becomes of a crossing: its refinement, position and t, and the ends and counts of the
// queries.
#include "mutate/mutation.hpp"

namespace raytorus::mutate {
namespace {

constexpr const char* torus = "torus/torus.glsl";
constexpr const char* refine = "torus/refine.glsl";
constexpr const char* crossing = "torus/crossing.glsl";

constexpr Mutation rows[] = {
    {"refinement-missing", refine, "float x = denominator != 0.0 ? numerator / denominator : 0.0",
     "float x = 0.0", "crossings as the march leaves them"},
    {"refinement-other-root", refine, "float root = sqrt(max(discriminant, 0.0))",
     "float root = -sqrt(max(discriminant, 0.0))", "the parabola's other root"},
    {"refinement-unguarded", refine, "denominator != 0.0 ? numerator / denominator : 0.0",
     "numerator / denominator", "0 / 0 where the parabola is flat", Shows::InNumbers},
    {"refinement-value-side", refine, "g = march.side * point.tube", "g = point.tube", "a side forgotten"},
    {"refinement-bend-side", refine, "C = march.side * (line.length2", "C = (line.length2",
     "a side forgotten"},
    {"refined-start-outside", refine, "(point.tube < 0.0 ? -1.0 : 1.0)", "1.0",
     "a start on the surface is taken for one outside", Shows::InNumbers},
    {"refinement-straight", refine, "C = march.side * (line.length2 - point.bend)", "C = 0.0",
     "the tangent's root, not the parabola's"},
    {"misses-found", refine, "discriminant >= 0.0 && ahead", "ahead",
     "a parabola that passes the surface by is a crossing", Shows::InNumbers},
    {"dips-behind-found", refine, "C > 0.0 && crossing >= march.from", "C > 0.0",
     "a dip that lies behind is a crossing", Shows::InNumbers},
    {"crossed-a-little-lost", refine, "nears || C < 0.0 || g < 0.0 ||", "nears || C < 0.0 ||",
     "a crossing that the march is just past is lost", Shows::InNumbers},
    {"way-out-lost", refine, "nears || C < 0.0 || g < 0.0 ||", "nears || g < 0.0 ||",
     "a way out that first goes deeper is lost", Shows::InNumbers},
    {"passed-dip-lost", refine, " || (C > 0.0 && crossing >= march.from)", "",
     "a dip that the march has passed by rounding is lost", Shows::InNumbers},
    {"flat-found", refine, "(C > 0.0 && crossing >= march.from)", "crossing >= march.from",
     "where the parabola is a rising line it has no root ahead", Shows::InNumbers},
    {"from-forgotten", refine, "march.from = found ? beyond : (passes ? behind : march.from);", "",
     "what has been found is found again", Shows::InNumbers},
    {"passed-by-slowly", refine, "bool passes = !exists && good && nears && x > 0.0", "bool passes = false",
     "a line that passes the surface by keeps the march at its extremum", Shows::InNumbers},
    {"edge-overstepped", refine,
     "bool edge = !beside && (tiny || (abs(g) <= tinyValue && point.rho <= TORUS_SMALL_STEP))",
     "bool edge = false", "a step past rho's edge at the axis moves a crossing", Shows::InNumbers},
    {"touching-way-out-lost", refine, " || touches;", ";", "what enters where the line touches never leaves",
     Shows::InNumbers},

    {"good-whatever", refine, "found = exists && good", "found = exists",
     "the first parabola is good, however long the step"},
    {"good-third-order-coarse", refine, "#define TORUS_THIRD_ORDER 7.450580597e-9",
     "#define TORUS_THIRD_ORDER 7.450580597e-5", "what the parabola leaves out, by a factor"},
    {"good-long-step-coarse", refine, "#define TORUS_LONG_STEP 0.015625", "#define TORUS_LONG_STEP 16.0",
     "the same, by a factor", Shows::InNumbers},
    {"good-though-late", refine, "good = tiny || edge || march.known ||", "good = tiny || edge ||",
     "a crossing that there must be is refined for ever", Shows::InNumbers},
    {"tiny-value-never", refine, " || (size <= TORUS_SMALL_STEP && value <= tinyValue)", "",
     "a step that follows rounding is repeated", Shows::InNumbers},
    {"tiny-value-anywhere", refine, "(size <= TORUS_SMALL_STEP && value <= tinyValue)", "value <= tinyValue",
     "a long step counts as none where the surface is flat", Shows::InNumbers},
    {"tiny-step-coarse", refine, "#define TORUS_TINY_STEP 9.313225746e-10", "#define TORUS_TINY_STEP 1.0e-2",
     "steps that matter count as none"},
    {"tiny-value-coarse", refine, "#define TORUS_TINY_VALUE 5.9604644775e-14",
     "#define TORUS_TINY_VALUE 5.9604644775e-4", "values that matter count as none", Shows::InNumbers},
    {"repeats-never", refine, "march.refines = repeats", "march.refines = false",
     "a step that leads nearer is not followed by another", Shows::InNumbers},
    {"repeats-order-zero", refine, "#define TORUS_LARGE_ORDER 0.125", "#define TORUS_LARGE_ORDER 0.0",
     "a long step that leads nearer is not taken", Shows::InNumbers},
    {"repeats-on-the-spot", refine, "(repeats ? crossing : (passes ? behind : march.u))",
     "(passes ? behind : march.u)", "what is repeated is repeated at the same place"},
    {"repeats-past-the-axis", refine, "!good && beside && order", "!good && order",
     "a step past the edge that rho has at the axis leads nowhere", Shows::InNumbers},

    {"found-again", crossing, "#define TORUS_CLEARANCE 1.9073486328e-6", "#define TORUS_CLEARANCE 0.0",
     "a crossing is found twice"},
    {"clearance-wide", crossing, "#define TORUS_CLEARANCE 1.9073486328e-6", "#define TORUS_CLEARANCE 0.5",
     "the next crossing is jumped over"},
    {"side-kept", refine, "march.side = found ? -march.side : march.side", "march.side = march.side",
     "the way out is searched from outside"},
    {"known-never", refine, "march.known = !found && !repeats", "march.known = false",
     "a refinement that finds nothing decides nothing"},
    {"known-value-of-the-tube", refine, "point.tube * (middle + twoR * point.rho) * invDd2",
     "point.tube * invDd2", "the tube function's value taken for the quartic's"},
    {"known-slope-sign", refine, "(a * point.along + middle * point.rise)",
     "(a * point.along - middle * point.rise)", "a sign of the slope"},

    {"t-without-the-step", refine, "rest = point.shiftLow + x", "rest = point.shiftLow",
     "position and t are of different points"},
    {"t-negated", torus, "(sum + (torus_twoSumError", "(-sum + (torus_twoSumError",
     "counted from the wrong side of the foot"},
    {"t-before-the-start", torus, "t = t >= tMin ? t : tMin", "t = t", "rounding puts t before the start",
     Shows::InNumbers},
    {"position-of-the-start", refine, "position = point.high + (point.low + x * line.direction)",
     "position = point.high + point.low", "the position before the last step"},
    {"position-unscaled", torus, "position = crossing.position * line.unit", "position = crossing.position",
     "the position in units of the torus' size"},

    {"end-sign", crossing, "(line.endShift - crossing.shift)", "(line.endShift + crossing.shift)",
     "a sign of what is left to the end"},
    {"nearest-beyond-the-end", torus,
     "hits = crossing.found && torus_isWithin(line, crossing);\n            if (hits)",
     "hits = crossing.found;\n            if (hits)", "a hit beyond tMax is returned", Shows::InNumbers},
    {"nearest-is-the-farthest", refine, "march.searching && !crossing.found", "march.searching",
     "the search goes on behind the hit"},
    {"all-beyond-the-end", torus, "if (crossing.found && torus_isWithin(line, crossing)) {",
     "if (crossing.found) {", "hits beyond the end are counted", Shows::InNumbers},
    {"all-first-pair", torus, "march.searching && count < 4", "march.searching && count < 2",
     "two hits for four"},
    {"all-one-by-one", torus, "++count;", "count = i + 1;", "searches that find nothing are counted"},
    {"all-out-of-order", torus, "from = hit.t;", "from = tMin;", "rounding swaps a pair that touches",
     Shows::InNumbers},
    {"any-is-the-sphere", refine, "bool crosses = false;\n    bool busy = true;",
     "bool crosses = true;\n    bool busy = false;", "the bounding sphere throws the shadow"},
    {"any-is-never", refine, "bool crosses = false;\n    bool busy = true;",
     "bool crosses = false;\n    bool busy = false;", "no torus throws a shadow"},
    {"any-but-the-certain", refine, "crosses = march.certain;", "crosses = false;",
     "what is certainly hit throws no shadow"},
    {"any-beyond-the-end", refine, "crosses = crossing.found && torus_isWithin(line, crossing)",
     "crosses = crossing.found", "what is behind the light throws a shadow", Shows::InNumbers},
    {"any-without-refinement", refine, "if (march.refines && !march.certain)", "if (false)",
     "what is in doubt is left to the march"},
    {"any-refined-for-nothing", refine, "found = crossing.found;", "found = true;",
     "a refinement that finds nothing ends the search", Shows::InNumbers},
};

}  // namespace

std::span<const Mutation> hitMutations() {
    return rows;
}

}  // namespace raytorus::mutate
