// SPDX-License-Identifier: MIT
// Faults of what the queries make of crossings: last steps, positions, t, ends and counts.
#include "mutate/mutation.hpp"

namespace raytorus::mutate {
namespace {

constexpr const char* torus = "torus/torus.glsl";
constexpr const char* lastStep = "torus/last_step.glsl";

constexpr Mutation rows[] = {
    {"last-step-missing", lastStep, "forwards = denominator != 0.0 ? numerator / denominator : 0.0",
     "forwards = 0.0", "roots as the coarse iteration leaves them"},
    {"last-step-once", lastStep, "#define TORUS_LAST_STEPS 24", "#define TORUS_LAST_STEPS 1",
     "flat crossings need more than one", Shows::InNumbers},
    // Indented as in the loop of the exact steps.
    {"last-step-backwards", lastStep, "        TORUS_PRECISE float step = rising ? forwards : -forwards",
     "        TORUS_PRECISE float step = rising ? -forwards : forwards", "a sign of the parabola's root"},
    {"last-step-direction", lastStep, "        TORUS_PRECISE float step = rising ? forwards : -forwards",
     "        TORUS_PRECISE float step = forwards", "entering crossings step the wrong way"},
    {"last-step-other-root", lastStep, "float root = sqrt(radicand)", "float root = -sqrt(radicand)",
     "the parabola's other root"},
    {"last-step-stays", lastStep, "goesOn = outer &&", "goesOn = false &&",
     "a maximum between two dips taken for the way out", Shows::InNumbers},
    {"clear-step-missing", lastStep, "forwards = tangent + (tangent * quarterE) * (1.0 + 2.0 * quarterE)",
     "forwards = 0.0", "clear roots as the search leaves them"},
    {"clear-step-straight", lastStep, "forwards = tangent + (tangent * quarterE) * (1.0 + 2.0 * quarterE)",
     "forwards = tangent", "the tangent's root, not the parabola's", Shows::InNumbers},
    {"clear-step-direction", lastStep, "step = rising ? forwards : -forwards;\n    TORUS_PRECISE float t =",
     "step = forwards;\n    TORUS_PRECISE float t =", "clear entering crossings step the wrong way"},
    {"clear-step-any", lastStep,
     "bool right = slope2 >=", "bool right = true || slope2 >=", "whatever is not clear is taken for it"},
    {"clear-step-wrong-taken", torus, "reached = end.right && torus_wayTo", "reached = torus_wayTo",
     "a step that was not right is a hit until the long way says otherwise", Shows::InNumbers},
    {"t-of-the-start", lastStep, "shift = point.shift;", "shift = line.shift + u;",
     "t does not follow the last steps but the first"},
    {"t-without-the-step", lastStep, "float exactRest = point.shiftLow + step",
     "float exactRest = point.shiftLow", "position and t are of different points"},
    {"t-negated", torus, "float t = (sum +", "float t = (-sum +", "counted from the wrong side of the foot"},
    {"position-of-the-start", lastStep, "exactPosition = point.high + (point.low + step * line.direction)",
     "exactPosition = point.high + point.low", "the position before the last step"},
    {"position-unscaled", torus, "position = end.position * line.unit", "position = end.position",
     "the position in units of the torus' size"},
    {"nearest-beyond-the-end", torus, "reached = end.right && torus_wayTo(line, end, tMax) >= 0.0",
     "reached = end.right", "a hit beyond tMax is returned"},
    {"all-behind-the-start", torus, "torus_wayTo(line, end, tMin) <= 0.0 && torus", "torus",
     "hits behind the start are counted"},
    {"all-beyond-the-end", torus, " && torus_wayTo(line, end, tMax) >= 0.0) {", ") {",
     "hits beyond the end are counted", Shows::InNumbers},
    {"all-first-pair", torus, "i < places", "i < min(places, 2)", "two hits for four"},
    {"all-one-by-one", torus, "++count;", "count = i + 1;", "entries before the first hit are counted"},
    {"any-is-the-sphere", torus, "crosses = torus_crosses(line)", "crosses = true",
     "the bounding sphere throws the shadow"},
    {"any-is-never", torus, "crosses = torus_crosses(line)", "crosses = false", "no torus throws a shadow"},
};

}  // namespace

std::span<const Mutation> hitMutations() {
    return rows;
}

}  // namespace raytorus::mutate
