// SPDX-License-Identifier: MIT
// What the two parts of the picture share: where things lie on the line, and how they are marked.
#pragma once

#include <string>
#include <vector>

#include "explain/explanation.hpp"
#include "explain/svg_canvas.hpp"

namespace raytorus::explain {

/// The line as the picture counts: in R, or in r where R = 0; t' from the point closest to the centre.
struct Line {
    double R, r;
    Vec3<double> foot, direction;  ///< direction is a unit vector
    double start, stop;            ///< t' of tMin and tMax

    /// What is marked: roots, be they hits or not, and answers without one.
    struct Mark {
        enum class Kind { Hit, Missed, Invented, Root };
        double at;  ///< t'
        Kind kind;
        std::string label;  ///< the number of the root; an invented hit has none
    };
    std::vector<Mark> marks;
};

/// Keeps text readable that lies on a line.
inline constexpr const char* halo = "paint-order=\"stroke\" stroke=\"#ffffff\" stroke-width=\"3\"";

Line lineOf(const Explanation& explanation);

/// Where t' = 0 lies, and the pixels a unit of t'. Beside the mark a label stays off a curve that falls at
/// every first and rises at every second one.
enum class Labels { Above, Beside };
void drawMarks(Canvas& canvas, const std::vector<Line::Mark>& marks, Point zero, double scale, Labels labels);

/// Ticks at round numbers for a range that many units wide on each side of 0.
double tickStep(double halfWidth);

/// Pixels a unit of t', chosen by the section for both parts.
double drawSection(Canvas& canvas, const Rectangle& frame, const Line& line);
void drawQuartic(Canvas& canvas, const Rectangle& frame, const Line& line, const Steps<Quad>& steps,
                 double scale);

}  // namespace raytorus::explain
