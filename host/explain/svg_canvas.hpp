// SPDX-License-Identifier: MIT
// The elements of an SVG picture, in pixels from the top left.
#pragma once

#include <string>
#include <vector>

namespace raytorus::explain {

struct Point {
    double x = 0.0, y = 0.0;
};

using Polyline = std::vector<Point>;

/// A rectangle of the picture.
struct Rectangle {
    double left, top, width, height;

    [[nodiscard]] double right() const { return left + width; }
    [[nodiscard]] double bottom() const { return top + height; }
};

namespace colour {
inline constexpr const char* ink = "#222222";
inline constexpr const char* faint = "#777777";
inline constexpr const char* grid = "#e4e4e4";
inline constexpr const char* torus = "#1f5fa8";
inline constexpr const char* solid = "#e3ecf7";
inline constexpr const char* ray = "#c1440e";
inline constexpr const char* hit = "#0b6e4f";
inline constexpr const char* wrong = "#d00000";
}  // namespace colour

class Canvas {
public:
    Canvas(double width, double height);

    /// `style` is further attributes: "stroke=\"#222\" stroke-width=\"2\"".
    void line(Point from, Point to, const std::string& style);
    void polyline(const Polyline& points, const std::string& style);
    /// Closed curves; what lies inside an odd number of them is inside.
    void area(const std::vector<Polyline>& curves, const std::string& style);
    void circle(Point centre, double radius, const std::string& style);
    void text(Point at, const std::string& words, const std::string& style = "");

    /// A group, cut off at the frame. Groups do not nest.
    void open(const std::string& name, const Rectangle& frame);
    void close();

    [[nodiscard]] std::string finish() const { return svg + "</svg>\n"; }

private:
    std::string svg;
};

/// Mathematics in text: "t'", a minus sign, no more than four digits.
std::string label(double value);

}  // namespace raytorus::explain
