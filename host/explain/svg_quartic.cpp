// SPDX-License-Identifier: MIT
// The reduced quartic over t', with its zeros and extrema.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "explain/svg_parts.hpp"

namespace raytorus::explain {
namespace {

struct Extremum {
    double at, value;
};

// From the point, by (12): near a thin tube t^4 + 2 alpha t^2 + 8 cz t + beta has nothing left in doubles.
double quartic(const Line& line, double t) {
    Vec3<double> p{};
    for (std::size_t i = 0; i < 3; ++i) {
        p[i] = line.foot[i] + t * line.direction[i];
    }
    const double rho = std::hypot(p[0], p[1]), z2 = p[2] * p[2];
    return ((rho - 1.0 - line.r) * (rho - 1.0 + line.r) + z2) *
           ((rho + 1.0 - line.r) * (rho + 1.0 + line.r) + z2);
}

// The zeros of a quarter of the derivative, t^3 + alpha t + 2 cz, by the trigonometric and by Cardano's
// formula.
std::vector<Extremum> extremaOf(const Line& line, double alpha, double cz) {
    std::vector<double> places;
    const double discriminant = cz * cz + alpha * alpha * alpha / 27.0;
    if (discriminant < 0.0) {
        const double radius = 2.0 * std::sqrt(-alpha / 3.0);
        const double cosine = std::clamp(-8.0 * cz / (radius * radius * radius), -1.0, 1.0);
        for (const double turn : {2.0, 4.0, 0.0}) {
            places.push_back(radius * std::cos((std::acos(cosine) + turn * std::numbers::pi) / 3.0));
        }
    } else {
        const double root = std::sqrt(discriminant);
        const double larger = std::cbrt(cz > 0.0 ? -cz - root : root - cz);  // the sum that does not cancel
        places.push_back(larger == 0.0 ? 0.0 : larger - alpha / (3.0 * larger));
    }
    std::vector<Extremum> extrema;
    for (const double t : places) {
        extrema.push_back({t, quartic(line, t)});
    }
    return extrema;
}

// The vertical scale: linear, or asinh of the value in `unit` where extrema differ too much to be seen
// together.
struct Scale {
    double unit = 0.0;  // 0: linear
    double low = 0.0, high = 1.0;
    Rectangle frame{};

    [[nodiscard]] double flat(double value) const { return unit > 0.0 ? std::asinh(value / unit) : value; }
    [[nodiscard]] double y(double value) const {
        // Far outside the frame nothing is seen, and numbers stay small.
        const double part = std::clamp((flat(value) - low) / (high - low), -1.0, 2.0);
        return frame.bottom() - part * frame.height;
    }
};

// `edge` is the largest t' that is seen.
Scale scaleOf(const Rectangle& frame, const Line& line, const std::vector<Extremum>& extrema, double edge) {
    // Beside a single dip, which may be a tangent's, as high as a part of the picture away from it.
    const double beside = extrema.size() == 1 ? quartic(line, extrema[0].at + 0.15 * edge) : 0.0;
    double lowest = 0.0, highest = std::max(beside, 0.0), largest = std::abs(beside);
    for (const Extremum& extremum : extrema) {
        lowest = std::min(lowest, extremum.value);
        highest = std::max(highest, extremum.value);
        largest = std::max(largest, std::abs(extremum.value));
    }
    double smallest = largest;
    for (const Extremum& extremum : extrema) {
        if (std::abs(extremum.value) > 1e-6 * largest) {  // less is a tangent, and no size to go by
            smallest = std::min(smallest, std::abs(extremum.value));
        }
    }
    Scale scale;
    scale.frame = frame;
    scale.unit = largest > 30.0 * smallest ? smallest : 0.0;
    if (extrema.size() == 1 && scale.unit == 0.0) {
        highest = std::max(highest, lowest < 0.0 ? -lowest : 1.5 * largest);
    }
    highest = std::max(highest, 0.2 * largest);
    const double low = scale.flat(lowest), high = scale.flat(highest);
    scale.low = low - 0.16 * (high - low);
    scale.high = high + 0.22 * (high - low);
    return scale;
}

void drawGrid(Canvas& canvas, const Rectangle& frame, double middle, double pixels, double axis) {
    const double edge = 0.5 * frame.width / pixels, step = tickStep(edge);
    for (double t = -std::floor(edge / step) * step; t <= edge; t += step) {
        const double x = middle + pixels * t;
        canvas.line({x, frame.top}, {x, frame.bottom()},
                    fmt::format("stroke=\"{}\" stroke-width=\"1\"", colour::grid));
        if (std::abs(x - middle) < 0.5 * frame.width - 12.0) {
            canvas.text({x, frame.bottom() - 6.0}, label(std::abs(t) < 0.01 * step ? 0.0 : t),
                        fmt::format("text-anchor=\"middle\" font-size=\"11\" fill=\"{}\"", colour::faint));
        }
    }
    canvas.line({frame.left, axis}, {frame.right(), axis},
                fmt::format("stroke=\"{}\" stroke-width=\"1.2\"", colour::ink));
    canvas.text({frame.right() - 16.0, axis - 6.0}, "t\u2032");
}

}  // namespace

void drawQuartic(Canvas& canvas, const Rectangle& frame, const Line& line, const Steps<Quad>& steps,
                 double pixels) {
    const double alpha = reference::toDouble(steps.alpha), cz = reference::toDouble(steps.cz);
    const std::vector<Extremum> extrema = extremaOf(line, alpha, cz);
    const double middle = frame.left + 0.5 * frame.width, edge = 0.5 * frame.width / pixels;
    const Scale scale = scaleOf(frame, line, extrema, edge);
    const auto place = [&](double t, double value) { return Point{middle + pixels * t, scale.y(value)}; };

    canvas.text(
        {frame.left, frame.top - 14.0},
        fmt::format("t\u2032\u2074 + 2\u03b1 t\u2032\u00b2 + 8cz t\u2032 + \u03b2 with \u03b1 = {}, cz = {}, "
                    "\u03b2 = {}",
                    label(alpha), label(cz), label(reference::toDouble(steps.beta))),
        fmt::format("fill=\"{}\"", colour::faint));
    if (scale.unit > 0.0) {
        canvas.text({frame.right(), frame.bottom() + 16.0},
                    fmt::format("heights: asinh of {} times the value", label(1.0 / scale.unit)),
                    fmt::format("text-anchor=\"end\" font-size=\"11\" fill=\"{}\"", colour::faint));
    }
    canvas.open("quartic", frame);
    drawGrid(canvas, frame, middle, pixels, scale.y(0.0));
    // A point a third of a pixel, and each extremum: the dips of a thin tube are narrow.
    std::vector<double> places;
    const int columns = static_cast<int>(3.0 * frame.width);
    for (int i = 0; i <= columns; ++i) {
        places.push_back(edge * (2.0 * i / columns - 1.0));
    }
    for (const Extremum& extremum : extrema) {
        places.push_back(extremum.at);
    }
    std::sort(places.begin(), places.end());
    Polyline curve;
    for (const double t : places) {
        curve.push_back(place(t, quartic(line, t)));
    }
    canvas.polyline(curve, fmt::format("stroke=\"{}\" stroke-width=\"2\"", colour::torus));
    for (std::size_t i = 0; i < extrema.size(); ++i) {
        const Point at = place(extrema[i].at, extrema[i].value);
        canvas.circle(at, 2.5, fmt::format("fill=\"{}\"", colour::torus));
        const bool maximum = extrema.size() == 3 && i == 1;
        canvas.text(
            {at.x, at.y + (maximum ? -9.0 : 17.0)}, label(extrema[i].value),
            fmt::format("text-anchor=\"middle\" font-size=\"11\" fill=\"{}\" {}", colour::torus, halo));
    }
    drawMarks(canvas, line.marks, place(0.0, 0.0), pixels, Labels::Beside);
    canvas.close();
}

}  // namespace raytorus::explain
