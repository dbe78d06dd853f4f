// SPDX-License-Identifier: MIT
#include "explain/svg_canvas.hpp"

#include <fmt/format.h>

#include "core/markup.hpp"

namespace raytorus::explain {
namespace {

std::string coordinates(const Polyline& points) {
    std::string text;
    for (const Point& point : points) {
        text += fmt::format("{}{:.2f},{:.2f}", text.empty() ? "" : " ", point.x, point.y);
    }
    return text;
}

}  // namespace

Canvas::Canvas(double width, double height)
    : svg(fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:g} {1:g}\" width=\"{0:g}\" "
                      "height=\"{1:g}\" font-family=\"Helvetica, Arial, sans-serif\" font-size=\"13\" "
                      "fill=\"{2}\">\n<rect width=\"{0:g}\" height=\"{1:g}\" fill=\"#ffffff\"/>\n",
                      width, height, colour::ink)) {}

void Canvas::line(Point from, Point to, const std::string& style) {
    svg += fmt::format("<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\" {}/>\n", from.x, from.y,
                       to.x, to.y, style);
}

void Canvas::polyline(const Polyline& points, const std::string& style) {
    svg += fmt::format("<polyline points=\"{}\" fill=\"none\" stroke-linejoin=\"round\" {}/>\n",
                       coordinates(points), style);
}

void Canvas::area(const std::vector<Polyline>& curves, const std::string& style) {
    std::string path;
    for (const Polyline& curve : curves) {
        path += fmt::format("M{}Z", coordinates(curve));
    }
    svg += fmt::format("<path d=\"{}\" fill-rule=\"evenodd\" stroke-linejoin=\"round\" {}/>\n", path, style);
}

void Canvas::circle(Point centre, double radius, const std::string& style) {
    svg += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:g}\" {}/>\n", centre.x, centre.y, radius,
                       style);
}

void Canvas::text(Point at, const std::string& words, const std::string& style) {
    svg += fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\"{}{}>{}</text>\n", at.x, at.y,
                       style.empty() ? "" : " ", style, escapeHtml(words));
}

void Canvas::open(const std::string& name, const Rectangle& frame) {
    svg += fmt::format(
        "<clipPath id=\"{0}-frame\"><rect x=\"{1:g}\" y=\"{2:g}\" width=\"{3:g}\" "
        "height=\"{4:g}\"/></clipPath>\n"
        "<g id=\"{0}\" clip-path=\"url(#{0}-frame)\">\n",
        name, frame.left, frame.top, frame.width, frame.height);
}

void Canvas::close() {
    svg += "</g>\n";
}

std::string label(double value) {
    std::string text = fmt::format("{:.4g}", value == 0.0 ? 0.0 : value);
    if (const std::size_t minus = text.find('-'); minus == 0) {
        text.replace(0, 1, "\u2212");
    }
    return text;
}

}  // namespace raytorus::explain
