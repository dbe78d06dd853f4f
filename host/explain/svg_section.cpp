// SPDX-License-Identifier: MIT
// The section of the torus by a plane through its centre, exact: in polar coordinates it is a quadratic.
//
// The plane is tilted by phi against the equator; psi counts from the line where the two meet. A point at the
// distance s has rho = s k, k^2 = 1 - sin^2 psi sin^2 phi, and |z|^2 = s^2 (1 - k^2), so (rho - R)^2 + z^2 =
// r^2 is
//     s^2 - 2 R k s + R^2 - r^2 = 0,    s = R k +- sqrt(r^2 - R^2 sin^2 psi sin^2 phi).
// Where sin phi > r / R the plane cuts the tube twice, and sin psi = r / (R sin phi) sin tau makes the root r
// cos tau: each lobe is one turn of tau. Otherwise there are two curves, one inside the other; for a spindle
// the second s is negative, -s being the inner sheet opposite.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "explain/svg_parts.hpp"

namespace raytorus::explain {
namespace {

using Direction = Vec3<double>;

Direction cross(const Direction& a, const Direction& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Direction unit(const Direction& v) {
    const double length = std::sqrt(reference::dot(v, v));
    return {v[0] / length, v[1] / length, v[2] / length};
}

// The plane's own axes, and where in it the equator runs.
struct Plane {
    Direction along, up;  // the ray's direction; from the centre to the ray
    Direction equator;    // of unit length, in the plane and in the equatorial plane
    Direction rise;       // across it
    Direction normal;     // towards who looks
    double sinTilt;

    [[nodiscard]] Point of(const Direction& p) const {
        return {reference::dot(p, along), reference::dot(p, up)};
    }
};

// A line through the centre lies in many such planes: the one with the axis in it, which cuts the tube
// squarely.
Direction upFrom(const Line& line) {
    const double distance = std::sqrt(reference::dot(line.foot, line.foot));
    if (distance > 1e-9 * (line.R + line.r)) {
        return unit(line.foot);
    }
    const Direction& d = line.direction;
    const Direction wanted = std::abs(d[2]) < 0.999999 ? Direction{0, 0, 1} : Direction{1, 0, 0};
    const double along = reference::dot(wanted, d);
    return unit({wanted[0] - along * d[0], wanted[1] - along * d[1], wanted[2] - along * d[2]});
}

Plane planeOf(const Line& line) {
    Plane plane{line.direction, upFrom(line), line.direction, {}, {}, 0.0};
    plane.normal = cross(plane.along, plane.up);
    const Direction& normal = plane.normal;
    plane.sinTilt = std::hypot(normal[0], normal[1]);
    if (plane.sinTilt > 1e-12) {
        plane.equator = unit({-normal[1], normal[0], 0.0});
    }
    plane.rise = cross(normal, plane.equator);
    return plane;
}

constexpr int steps = 720;

// s(k, root) over a turn of psi.
template <class Distance>
Polyline turn(const Line& line, const Plane& plane, Distance distance) {
    Polyline curve;
    for (int i = 0; i < steps; ++i) {
        const double psi = 2.0 * std::numbers::pi * i / steps;
        const double sine = std::sin(psi) * plane.sinTilt;
        const double root = std::sqrt(std::max(line.r * line.r - line.R * line.R * sine * sine, 0.0));
        const double s = distance(std::sqrt(1.0 - sine * sine), root);
        Direction p{};
        for (std::size_t k = 0; k < 3; ++k) {
            p[k] = s * (std::cos(psi) * plane.equator[k] + std::sin(psi) * plane.rise[k]);
        }
        curve.push_back(plane.of(p));
    }
    return curve;
}

// `side` is 1 or -1.
Polyline lobe(const Line& line, const Plane& plane, double side) {
    Polyline curve;
    for (int i = 0; i < steps; ++i) {
        const double tau = 2.0 * std::numbers::pi * i / steps;
        const double sinPsi = line.r / (line.R * plane.sinTilt) * std::sin(tau);
        const double cosPsi = std::sqrt(1.0 - sinPsi * sinPsi);
        const double k = std::sqrt(1.0 - sinPsi * sinPsi * plane.sinTilt * plane.sinTilt);
        const double s = side * (line.R * k + line.r * std::cos(tau));
        Direction p{};
        for (std::size_t n = 0; n < 3; ++n) {
            p[n] = s * (cosPsi * plane.equator[n] + sinPsi * plane.rise[n]);
        }
        curve.push_back(plane.of(p));
    }
    return curve;
}

struct Curves {
    std::vector<Polyline> surface;
    std::vector<Polyline> innerSheet;
};

Curves sectionOf(const Line& line, const Plane& plane) {
    const double R = line.R;
    if (line.r < R * plane.sinTilt) {
        return {{lobe(line, plane, 1.0), lobe(line, plane, -1.0)}, {}};
    }
    Curves section{{turn(line, plane, [R](double k, double root) { return R * k + root; })}, {}};
    const Polyline second = turn(line, plane, [R](double k, double root) { return R * k - root; });
    if (line.r < R) {
        section.surface.push_back(second);
    } else if (line.r > R && R > 0.0) {
        section.innerSheet.push_back(second);
    }
    return section;
}

// From plane coordinates to pixels.
struct ToPixels {
    Point centre;
    double scale;

    [[nodiscard]] Point operator()(Point p) const { return {centre.x + scale * p.x, centre.y - scale * p.y}; }
    [[nodiscard]] Polyline operator()(const Polyline& points) const {
        Polyline placed;
        for (const Point& point : points) {
            placed.push_back((*this)(point));
        }
        return placed;
    }
    [[nodiscard]] std::vector<Polyline> operator()(const std::vector<Polyline>& curves) const {
        std::vector<Polyline> placed;
        for (const Polyline& curve : curves) {
            placed.push_back((*this)(curve));
        }
        return placed;
    }
};

void drawAxis(Canvas& canvas, const Plane& plane, const ToPixels& place, double size) {
    const std::string faint = fmt::format("stroke=\"{}\" stroke-width=\"1\"", colour::faint);
    const std::string style = fmt::format("font-size=\"11\" fill=\"{}\" {}", colour::faint, halo);
    const Point centre = place({0.0, 0.0});
    canvas.line({centre.x - 4.0, centre.y}, {centre.x + 4.0, centre.y}, faint);
    canvas.line({centre.x, centre.y - 4.0}, {centre.x, centre.y + 4.0}, faint);
    const Point axis = plane.of({0, 0, 1});
    const double length = std::hypot(axis.x, axis.y);
    if (length < 0.05) {
        canvas.text({centre.x, centre.y + 18.0},
                    plane.normal[2] > 0.0 ? "+z towards you" : "+z away from you",
                    fmt::format("text-anchor=\"middle\" {}", style));
        return;
    }
    const double reach = 1.08 * size / length;
    const Point end = place({reach * axis.x, reach * axis.y});
    canvas.line(place({-reach * axis.x, -reach * axis.y}), end, faint + " stroke-dasharray=\"8 3 2 3\"");
    const bool leftwards = axis.x < 0.0;
    canvas.text({end.x + (leftwards ? -5.0 : 5.0), end.y + 4.0}, "+z",
                fmt::format("text-anchor=\"{}\" {}", leftwards ? "end" : "start", style));
}

void drawRay(Canvas& canvas, const Rectangle& frame, const Line& line, const ToPixels& place, double height) {
    const double edge = 0.5 * frame.width / place.scale;
    const double from = std::clamp(line.start, -edge, edge), to = std::clamp(line.stop, -edge, edge);
    canvas.line(place({-edge, height}), place({edge, height}),
                fmt::format("stroke=\"{}\" stroke-width=\"1\" stroke-dasharray=\"3 3\"", colour::ray));
    if (!(from < to)) {
        return;
    }
    canvas.line(place({from, height}), place({to, height}),
                fmt::format("stroke=\"{}\" stroke-width=\"2\"", colour::ray));
    const Point tip = place({to, height});
    canvas.polyline({{tip.x - 12.0, tip.y - 5.0}, {tip.x - 2.0, tip.y}, {tip.x - 12.0, tip.y + 5.0}},
                    fmt::format("stroke=\"{}\" stroke-width=\"2\"", colour::ray));
    if (line.start > -edge) {
        canvas.circle(place({from, height}), 3.0, fmt::format("fill=\"{}\"", colour::ray));
    }
}

}  // namespace

double drawSection(Canvas& canvas, const Rectangle& frame, const Line& line) {
    const Plane plane = planeOf(line);
    const Curves section = sectionOf(line, plane);
    const double size = line.R + line.r;
    // A ray that passes far above stays in the picture as long as the torus does not become small.
    const double height = std::sqrt(reference::dot(line.foot, line.foot));
    const double above = std::clamp(1.1 * height, 1.12 * size, 2.0 * size), below = 1.12 * size;
    const double scale = std::min(frame.width / (2.3 * size), frame.height / (above + below));
    const ToPixels place{{frame.left + 0.5 * frame.width, frame.top + scale * above}, scale};

    const double degrees = std::asin(std::min(plane.sinTilt, 1.0)) * 180.0 / std::numbers::pi;
    canvas.text({frame.left, frame.top - 14.0},
                fmt::format("Section by the plane of ray and centre, {:.0f}\u00b0 from the equator", degrees),
                fmt::format("fill=\"{}\"", colour::faint));
    canvas.open("section", frame);
    canvas.area(place(section.surface),
                fmt::format("fill=\"{}\" stroke=\"{}\" stroke-width=\"1.6\"", colour::solid, colour::torus));
    canvas.area(place(section.innerSheet),
                fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"1\" stroke-dasharray=\"4 3\"",
                            colour::torus));
    drawAxis(canvas, plane, place, size);
    if (height <= above) {
        drawRay(canvas, frame, line, place, height);
        drawMarks(canvas, line.marks, place({0.0, height}), scale, Labels::Above);
    } else {
        canvas.text({frame.left + 0.5 * frame.width, frame.top + 14.0},
                    fmt::format("\u2191 the ray passes {} {} above", label(height), line.R > 0.0 ? "R" : "r"),
                    fmt::format("text-anchor=\"middle\" fill=\"{}\"", colour::ray));
    }
    canvas.close();
    return scale;
}

}  // namespace raytorus::explain
