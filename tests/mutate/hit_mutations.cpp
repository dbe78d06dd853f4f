// SPDX-License-Identifier: MIT
// Faults of what the queries make of crossings: last steps, positions, t, ends and counts.
#include "mutate/mutation.hpp"

namespace raytorus::mutate {
namespace {

constexpr const char* torus = "torus/torus.glsl";
constexpr const char* tube = "torus/tube.glsl";

constexpr Mutation rows[] = {
    {"last-step-missing", torus, "forwards = denominator != 0.0 ? numerator / denominator : 0.0",
     "forwards = 0.0", "roots as the coarse iteration leaves them"},
    {"last-step-once", tube, "#define TORUS_LAST_STEPS 24", "#define TORUS_LAST_STEPS 1",
     "flat crossings need more than one", Shows::InNumbers},
    {"last-step-backwards", torus, "step = rising ? forwards : -forwards",
     "step = rising ? -forwards : forwards", "a sign of the parabola's root"},
    {"last-step-direction", torus, "step = rising ? forwards : -forwards", "step = forwards",
     "entering crossings step the wrong way"},
    {"last-step-other-root", torus, "float root = sqrt(radicand)", "float root = -sqrt(radicand)",
     "the parabola's other root"},
    {"last-step-stays", torus, "goesOn = outer &&", "goesOn = false &&",
     "a maximum between two dips taken for the way out", Shows::InNumbers},
    {"t-of-the-start", torus, "shift = point.shift;", "shift = line.shift + u;",
     "t does not follow the last steps but the first"},
    {"t-without-the-step", torus, "float exactRest = point.shiftLow + step",
     "float exactRest = point.shiftLow", "position and t are of different points"},
    {"t-negated", torus, "float t = (sum +", "float t = (-sum +", "counted from the wrong side of the foot"},
    {"position-of-the-start", torus, "exactPosition = point.high + (point.low + step * line.direction)",
     "exactPosition = point.high + point.low", "the position before the last step"},
    {"position-unscaled", torus, "scaled = position * line.unit", "scaled = position",
     "the position in units of the torus' size"},
    {"nearest-beyond-the-end", torus, "hits = exactU <= line.upper", "hits = true",
     "a hit beyond tMax is returned"},
    {"all-behind-the-start", torus, "exactU >= line.lower && exactU <= line.upper", "exactU <= line.upper",
     "hits behind the start are counted"},
    {"all-beyond-the-end", torus, "exactU >= line.lower && exactU <= line.upper", "exactU >= line.lower",
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
