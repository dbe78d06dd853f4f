// SPDX-License-Identifier: MIT
#include "explain/svg.hpp"

#include <fmt/format.h>

#include <cmath>

#include "explain/number_text.hpp"
#include "explain/svg_parts.hpp"

namespace raytorus::explain {
namespace {

constexpr double pageWidth = 1080.0, pageHeight = 560.0;
constexpr Rectangle sectionFrame{20.0, 70.0, 500.0, 420.0};
constexpr Rectangle quarticFrame{560.0, 70.0, 500.0, 420.0};

using Kind = Line::Mark::Kind;

Kind kindOf(const TrueRoot& root) {
    if (!root.isHit()) {
        return Kind::Root;
    }
    return root.hit ? Kind::Hit : Kind::Missed;
}

const char* nameOf(Kind kind) {
    switch (kind) {
        case Kind::Hit:
            return "hit";
        case Kind::Missed:
            return "missed";
        case Kind::Invented:
            return "invented";
        case Kind::Root:
            break;
    }
    return "root";
}

const char* paintOf(const Line::Mark& mark) {
    return mark.kind == Kind::Hit ? colour::hit : mark.kind == Kind::Root ? colour::faint : colour::wrong;
}

std::string title(const Explanation& e) {
    const auto& [o, tMin, d, tMax] = e.ray;
    return fmt::format("{}R = {}, r = {}    from ({}, {}, {}) along ({}, {}, {}), t from {} to {}",
                       e.faults.empty() ? fmt::format("{}: ", shapeOf(e.torus)) : "",
                       decimal(e.torus.majorRadius), decimal(e.torus.minorRadius), decimal(o[0]),
                       decimal(o[1]), decimal(o[2]), decimal(d[0]), decimal(d[1]), decimal(d[2]),
                       decimal(tMin), decimal(tMax));
}

// A clause a line: together they are too long for one.
void drawConclusion(Canvas& canvas, const std::string& conclusion, double top) {
    const std::size_t cut = conclusion.find("; ");
    canvas.text({sectionFrame.left, top}, conclusion.substr(0, cut));
    if (cut != std::string::npos) {
        canvas.text({sectionFrame.left, top + 18.0}, conclusion.substr(cut + 2));
    }
}

void drawFaults(Canvas& canvas, const std::vector<std::string>& faults) {
    double y = sectionFrame.top;
    for (const std::string& fault : faults) {
        canvas.text({sectionFrame.left, y}, fault, fmt::format("fill=\"{}\"", colour::wrong));
        y += 20.0;
    }
}

}  // namespace

Line lineOf(const Explanation& e) {
    const bool sphere = e.torus.majorRadius == 0.0F;
    const Quad unit = sphere ? e.torus.minorRadius : e.torus.majorRadius;
    const Vec3<Quad> o = reference::toQuad(e.ray.origin), d = reference::toQuad(e.ray.direction);
    const Quad length2 = reference::dot(d, d), length = reference::squareRoot(length2);
    const Quad shift = -reference::dot(o, d) / length2;
    const auto place = [&](Quad t) { return reference::toDouble((t - shift) * length / unit); };
    Line line{};
    line.R = sphere ? 0.0 : 1.0;
    line.r = reference::toDouble(Quad(e.torus.minorRadius) / unit);
    for (std::size_t i = 0; i < 3; ++i) {
        line.foot[i] = reference::toDouble((o[i] + shift * d[i]) / unit);
        line.direction[i] = reference::toDouble(d[i] / length);
    }
    line.start = place(e.ray.tMin);
    line.stop = place(e.ray.tMax);
    for (std::size_t i = 0; i < e.roots.size(); ++i) {
        line.marks.push_back({place(e.roots[i].t), kindOf(e.roots[i]), fmt::format("{}", i + 1)});
    }
    for (std::size_t i = 0; i < e.hits.size(); ++i) {
        if (isInvented(e, i)) {
            line.marks.push_back({place(e.hits[i].t), Kind::Invented, ""});
        }
    }
    return line;
}

void drawMarks(Canvas& canvas, const std::vector<Line::Mark>& marks, Point zero, double scale,
               Labels labels) {
    for (std::size_t i = 0; i < marks.size(); ++i) {
        const char* paint = paintOf(marks[i]);
        const double x = zero.x + scale * marks[i].at;
        const bool found = marks[i].kind == Kind::Hit || marks[i].kind == Kind::Invented;
        canvas.circle(
            {x, zero.y}, 5.0,
            fmt::format("class=\"{}\" fill=\"{}\" stroke=\"{}\" stroke-width=\"1.8\"", nameOf(marks[i].kind),
                        found ? paint : "#ffffff", found ? "#ffffff" : paint));
        // Of marks that lie on each other, as a tangent's do, the first has the label of all.
        std::string label = marks[i].label;
        const auto near = [&](std::size_t k) { return scale * std::abs(marks[k].at - marks[i].at) < 16.0; };
        if (i > 0 && near(i - 1)) {
            continue;
        }
        for (std::size_t k = i + 1; k < marks.size() && near(k); ++k) {
            label += (label.empty() || marks[k].label.empty() ? "" : ", ") + marks[k].label;
        }
        const bool alone = label == marks[i].label;
        const double aside = labels == Labels::Above ? 0.0 : !alone ? 20.0 : i % 2 == 0 ? 9.0 : -9.0;
        canvas.text({x + aside, zero.y - 10.0}, label,
                    fmt::format("text-anchor=\"middle\" font-size=\"12\" fill=\"{}\" {}", paint, halo));
    }
}

double tickStep(double halfWidth) {
    const double decade = std::pow(10.0, std::floor(std::log10(halfWidth)));
    const double part = halfWidth / decade;
    return decade * (part < 2.0 ? 0.5 : part < 5.0 ? 1.0 : 2.0);
}

std::string svgOf(const Explanation& e) {
    Canvas canvas(pageWidth, pageHeight);
    canvas.text({sectionFrame.left, 28.0}, title(e), "font-size=\"15\"");
    if (e.faults.empty()) {
        const Line line = lineOf(e);
        const double scale = drawSection(canvas, sectionFrame, line);
        if (e.exact.reduced) {
            drawQuartic(canvas, quarticFrame, line, e.exact, scale);
        } else {
            canvas.text({quarticFrame.left, quarticFrame.top - 14.0},
                        "R = 0: a sphere has no reduced quartic", fmt::format("fill=\"{}\"", colour::faint));
        }
    } else {
        drawFaults(canvas, e.faults);
    }
    drawConclusion(canvas, e.conclusion, pageHeight - 30.0);
    return canvas.finish();
}

}  // namespace raytorus::explain
