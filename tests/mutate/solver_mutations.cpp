// SPDX-License-Identifier: MIT
// Faults of the solver: extrema, spans and crossings of a line.
#include "mutate/mutation.hpp"

namespace raytorus::mutate {
namespace {

constexpr const char* line = "torus/line.glsl";
constexpr const char* tube = "torus/tube.glsl";
constexpr const char* quartic = "torus/quartic.glsl";
constexpr const char* spans = "torus/spans.glsl";

constexpr Mutation rows[] = {
    {"sphere-too-small", line, "outer2 = (R + r) * (R + r)", "outer2 = (R + 0.95 * r) * (R + 0.95 * r)",
     "a bounding sphere that cuts the outer equator off"},
    {"sphere-without-room", line, "TORUS_SPHERE_ROOM * outer2", "outer2",
     "rounding puts the equator's hits outside"},
    {"t-min-ignored", line, "max(begins, -halfChord)", "-halfChord", "what is behind the start is hit"},
    {"t-max-ignored", line, "min(ends, halfChord)", "halfChord", "what is beyond the end is hit"},
    {"t-min-epsilon", line, "max(tMin, -TORUS_FLOAT_MAX)", "max(tMin + 1.0e-4, -TORUS_FLOAT_MAX)",
     "a hidden epsilon against self-intersection"},
    {"radius-epsilon", line, "torus_Ray(meets, R, r,", "torus_Ray(meets, R, r + 1.0e-5,",
     "a torus that is a little fatter"},
    {"t-scale-inverted", line, "directionUnit * perUnit", "perDirectionUnit * perUnit",
     "lengths of the direction divided by, not multiplied with"},
    {"t-unit-forgotten", line, "tPerU = unit * perDirectionUnit", "tPerU = perDirectionUnit",
     "t in units of the torus' size"},

    {"slab-too-thin", line, "(line.minorRadius + TORUS_ROOM) * perRise", "0.9 * line.minorRadius * perRise",
     "the planes cut the tube's top and bottom off"},
    {"slab-upside-down", line, "rise < 0.0 ? perRise : -perRise", "rise > 0.0 ? perRise : -perRise",
     "the planes on the other side of the foot"},
    {"hole-too-wide", line, "line.majorRadius - line.minorRadius - TORUS_ROOM",
     "line.majorRadius - 0.9 * line.minorRadius", "rays that graze the hole's wall pass through it"},
    {"hole-by-one-end", line, "max(lower * lower, upper * upper)", "lower * lower",
     "what enters above the hole goes through it"},

    {"filter-slope-of-a-sphere", quartic, "slope = 4.0 * u * a + twoB1 * b", "slope = 4.0 * u * a",
     "Newton with the slope of a sphere"},
    {"filter-one-search", quartic, "goesOn = past ? early : !found", "goesOn = !past && !found",
     "what misses the near side of the ring misses the far side"},
    {"filter-early-out", quartic, "#define TORUS_SEARCH_ERROR 0.0009765625", "#define TORUS_SEARCH_ERROR 1.0",
     "errors of a whole tube count as none", Shows::InNumbers},
    {"filter-without-pieces", quartic, "sqrt(max(-bend, 0.0))", "0.0",
     "pieces that are not convex taken for convex"},
    {"filter-knows-all", quartic, "known = known && (!found || depth > shallow)", "known = true",
     "what is not certain is answered all the same"},
    {"filter-knows-tangents", quartic, "(met > least && mayMiss)", "mayMiss",
     "a search that passes a tangent within rounding is sure", Shows::InNumbers},
    {"filter-knows-shallow", quartic, "(!found || depth > shallow)", "true", "a dip within rounding is sure",
     Shows::InNumbers},
    {"filter-starts-anywhere", quartic, "torus_quarticAt(quartic, quartic.b1, line.lower).f > quartic.clear",
     "true", "a start in the solid is taken for one outside"},
    {"filter-spindles", line, "#define TORUS_RING 0.9375", "#define TORUS_RING 9.0",
     "a spindle's inner sheet is hit"},
    {"filter-beyond-the-end", spans, "way.found && left >= 0.0", "way.found",
     "what is behind the light throws a shadow"},
    {"filter-leaves-as-it-enters", quartic, "mirrored ? -quartic.b1 : quartic.b1", "quartic.b1",
     "the last way out searched on a line that is not mirrored"},
    {"filter-fills-the-hole", quartic, "bool outer = wayIn.early && wayOut.early", "bool outer = false",
     "two dips are always one span"},

    {"axis-mirrored-wrongly", tube, "m > 0.0 ? -1.0 : 1.0", "m < 0.0 ? -1.0 : 1.0",
     "lines that come towards the axis are mirrored, not those that leave it"},
    {"second-dip-forgotten", tube, "extrema.hasSecond = hasRight", "extrema.hasSecond = false",
     "the second pair of hits is dropped"},
    {"extrema-three-steps", tube, "#define TORUS_EXTREMUM_STEPS 16", "#define TORUS_EXTREMUM_STEPS 3",
     "a loop that ends before Newton is there", Shows::InNumbers},
    {"extrema-early-out", tube, "#define TORUS_EXTREMUM_STEP 0.00390625", "#define TORUS_EXTREMUM_STEP 1.0",
     "steps of a whole tube count as none", Shows::InNumbers},
    {"roots-one-step", tube, "#define TORUS_ROOT_STEPS 48", "#define TORUS_ROOT_STEPS 1",
     "the last steps are left with what they cannot reach", Shows::InNumbers},
    {"roots-anywhere", tube, "start > lo && start < hi ? start : 0.5 * (lo + hi)", "hi",
     "Newton from the end of the bracket, where nothing makes it converge", Shows::InNumbers},
    {"roots-other-side", tube, "rising == (value > 0.0)", "rising != (value > 0.0)",
     "the bracket shrinks to the wrong half", Shows::InNumbers},
    {"doubt-removed", tube, "return abs(value) <= room;", "return false;",
     "extrema that rounding put on the other side stay there", Shows::InNumbers},
    {"inner-sheet-of-a-spindle", tube,
     "(q - line.minorRadius) * (q + line.minorRadius) + z * z;\n    TORUS_PRECISE float along",
     "((q - line.minorRadius) * (q + line.minorRadius) + z * z) *\n"
     "        sign((rho + line.majorRadius - line.minorRadius) * (rho + line.majorRadius + line.minorRadius) "
     "+ z * z);"
     "\n    TORUS_PRECISE float along",
     "the quartic's sign, which turns on a spindle's inner sheet too"},
    {"maximum-never-inside", spans, "spans.first && spans.second && spans.extrema.middleValue <= 0.0",
     "false", "two dips are always two spans: a gap where the line stays inside"},
    {"maximum-always-inside", spans, "spans.first && spans.second && spans.extrema.middleValue <= 0.0",
     "spans.first && spans.second", "two dips are always one span: the hole is filled"},
    {"dip-at-zero-lost", spans, "spans.first = spans.extrema.firstValue <= 0.0",
     "spans.first = spans.extrema.firstValue < -0.01",
     "a tolerance in the wrong direction drops near misses"},
    {"crossing-though-joined", spans, "&& !(inner && spans.joined)", "",
     "crossings in the middle of one span are counted"},
    {"moment-sign", line, "float y = a.z * b.x - a.x * b.z", "float y = a.z * b.x + a.x * b.z",
     "rays through the bounding sphere are taken for passing it by"},
    {"bracket-past-a-near-miss", spans, "inner && spans.extrema.hasSecond ?",
     "inner && spans.first && spans.second ?",
     "the bracket of a crossing reaches past a dip that just misses", Shows::InNumbers},
    {"last-crossing-entering", spans, "rising = index == 1 || index == 3", "rising = index == 1",
     "the second span's end taken for a beginning"},
    {"first-behind-the-start", spans, "spans.first && spans.extrema.firstMinimum >= line.lower",
     "spans.first", "a span that the start has left behind is the first one", Shows::InNumbers},
    {"second-behind-the-start", spans, "spans.second && spans.extrema.secondMinimum >= line.lower",
     "spans.second", "the same of the second span", Shows::InNumbers},
    {"leaves-the-wrong-span", spans, "(!spans.joined && line.lower < spans.extrema.middle)", "!spans.joined",
     "a start in the second span leaves the first one"},
    {"any-ignores-the-ends", spans, "return insideLower != insideUpper ||", "return",
     "a shadow ray that ends inside meets nothing"},
    {"any-ignores-the-gap", spans, "(insideLower ? gapBetween : dipBetween)", "dipBetween && !insideLower",
     "a shadow ray through the hole meets nothing"},
    {"any-beyond-the-end", spans, "(spans.first && first >= line.lower && first <= line.upper)",
     "(spans.first && first >= line.lower)", "what is behind the light throws a shadow", Shows::InNumbers},
    {"any-ignores-the-second", spans, "(spans.second && second >= line.lower && second <= line.upper)",
     "false", "the far side throws no shadow"},
};

}  // namespace

std::span<const Mutation> solverMutations() {
    return rows;
}

}  // namespace raytorus::mutate
