// SPDX-License-Identifier: MIT
// Private: the solver's seam. The parts of a line that run inside the solid, and its crossings of the surface.
#ifndef TORUS_SPANS_GLSL
#define TORUS_SPANS_GLSL

#include "quartic.glsl"
#include "tube.glsl"

// At most two spans, around the two minima of G. Where both dip below zero and the maximum between them does too,
// they are one.
struct torus_Spans {
    torus_Extrema extrema;
    bool first;      // G dips below zero at the first minimum
    bool second;     // ... at the second
    bool joined;     // ... and stays below between them
};

torus_Spans torus_dips(torus_Line line) {
    torus_Spans spans;
    spans.extrema = torus_extrema(line);
    spans.first = spans.extrema.firstValue <= 0.0;
    spans.second = spans.extrema.hasSecond && spans.extrema.secondValue <= 0.0;
    spans.joined = spans.first && spans.second && spans.extrema.middleValue <= 0.0;
    return spans;
}

// Where the parabola through a minimum of G, with G's curvature there, has its root: near a tangent this is the root.
// Where G is flat the root is out of the bracket, and torus_root starts in the middle.
float torus_parabolaRoot(float minimum, float value, float flatness, bool rising) {
    TORUS_PRECISE float width = sqrt(max(-value, 0.0) * flatness);
    TORUS_PRECISE float root = rising ? minimum + width : minimum - width;
    return root;
}

// The crossing `index` of the whole line (0 into, 1 out of the first span; 2 into, 3 out of the second) if it exists.
// u is near it; the last step makes it exact. `rising` says whether it leads out, where G rises, `outer` whether the solid
// has no crossing beyond it.
bool torus_crossing(torus_Line line, torus_Spans spans, int index, bool wanted, out float u, out bool rising,
                    out bool outer) {
    bool atFirst = index < 2;
    rising = index == 1 || index == 3;
    bool inner = index == 1 || index == 2;
    bool exists = wanted && (atFirst ? spans.first : spans.second) && !(inner && spans.joined);
    // Between the minima the bracket ends at the maximum, also if one of them alone dips: where the other nearly does, G
    // is all rounding. Beyond that nothing else crosses then.
    outer = !(inner && spans.first && spans.second);
    float minimum = atFirst ? spans.extrema.firstMinimum : spans.extrema.secondMinimum;
    float other = atFirst ? spans.extrema.secondMinimum : spans.extrema.firstMinimum;
    float value = atFirst ? spans.extrema.firstValue : spans.extrema.secondValue;
    float flatness = atFirst ? spans.extrema.firstFlatness : spans.extrema.secondFlatness;
    float between = spans.extrema.isBetween ? spans.extrema.middle : other;
    float outside = inner && spans.extrema.hasSecond ? between : (rising ? line.halfChord : -line.halfChord);
    float start = torus_parabolaRoot(minimum, value, flatness, rising);
    u = torus_root(line, min(minimum, outside), max(minimum, outside), rising, start, exists);
    return exists;
}

// The first crossing in the interval: into the solid if the interval starts outside, else out of it.
bool torus_exactFirstCrossing(torus_Line line, out float u, out bool rising, out bool outer) {
    torus_Spans spans = torus_dips(line);
    float slope;
    bool inside = torus_tube(line, line.lower, slope) < 0.0;
    bool firstAhead = spans.first && spans.extrema.firstMinimum >= line.lower;
    bool secondAhead = spans.second && spans.extrema.secondMinimum >= line.lower;
    bool leavesFirst = spans.first && (!spans.second || (!spans.joined && line.lower < spans.extrema.middle));
    int index = inside ? (leavesFirst ? 1 : 3) : (firstAhead ? 0 : 2);
    return torus_crossing(line, spans, index, inside || firstAhead || secondAhead, u, rising, outer);
}

// Whether the interval holds any crossing: its ends lie on different sides, or a dip lies between them, or a gap.
bool torus_exactCrosses(torus_Line line) {
    torus_Spans spans = torus_dips(line);
    float slope;
    bool insideLower = torus_tube(line, line.lower, slope) < 0.0;
    bool insideUpper = torus_tube(line, line.upper, slope) < 0.0;
    float first = spans.extrema.firstMinimum;
    float second = spans.extrema.secondMinimum;
    bool dipBetween = (spans.first && first >= line.lower && first <= line.upper) ||
                      (spans.second && second >= line.lower && second <= line.upper);
    bool gapBetween = spans.first && spans.second && !spans.joined && line.lower < spans.extrema.middle &&
                      line.upper > spans.extrema.middle;
    return insideLower != insideUpper || (insideLower ? gapBetween : dipBetween);
}

// The same, by the filter where that knows it. Of a crossing near the ray's own end it does not.
bool torus_crosses(torus_Line line) {
    torus_Way way = torus_firstWay(line, torus_quartic(line));
    TORUS_PRECISE float left = line.upper - way.u;
    bool ends = line.upper < line.leave && abs(left) <= line.minorRadius;
    bool crosses = way.found && left >= 0.0;
    if (!way.known || (way.found && ends)) {
        torus_Line refined = line;
        torus_refine(refined);
        crosses = torus_exactCrosses(refined);
    }
    return crosses;
}

#endif
