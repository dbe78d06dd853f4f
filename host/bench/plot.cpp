// SPDX-License-Identifier: MIT
#include "bench/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "bench/summary.hpp"
#include "bench/table.hpp"
#include "bench/timed_method.hpp"

namespace raytorus::bench {
namespace {

constexpr double width = 1000.0;
constexpr double plotLeft = 250.0;
constexpr double plotRight = 900.0;
constexpr double top = 46.0;
constexpr double laneHeight = 18.0;
constexpr double rowGap = 8.0;

// More wrong answers than this part, and a mark is a cross.
constexpr double badPart = 1e-3;

struct Mark {
    double value;  // its time over ours
    bool bad;
    std::string title;
};

std::vector<Mark> marksOf(const BenchRun& run, trace::Query query, Pattern pattern, const std::string& name) {
    std::vector<Mark> marks;
    for (const CellResult& cell : run.cells) {
        const MethodResult* method = findMethod(cell, name);
        if (cell.workload.mode != Mode::Made || cell.query != query || cell.workload.pattern != pattern ||
            method == nullptr || method->times.ratio <= 0.0) {
            continue;
        }
        const Correctness& correctness = method->correctness;
        const double wrong = static_cast<double>(correctness.wrong + correctness.gross);
        const double value = 1.0 / method->times.ratio;
        marks.push_back({value, wrong > badPart * static_cast<double>(correctness.judged),
                         fmt::format("{}: {} of our time, {} of {} wrong", cell.workload.name(),
                                     ratioText(value), wrong, correctness.judged)});
    }
    return marks;
}

// The axis spans what is there, in whole steps of 1, 2, 5.
struct Axis {
    double low = 0.5;
    double high = 2.0;

    [[nodiscard]] double x(double value) const {
        return plotLeft + (plotRight - plotLeft) * std::log(value / low) / std::log(high / low);
    }
};

std::vector<double> ticks(double low, double high) {
    std::vector<double> values;
    for (double decade = 1e-3; decade < 1e4; decade *= 10.0) {
        for (const double step : {1.0, 2.0, 5.0}) {
            const double value = decade * step;
            if (value >= low * 0.999 && value <= high * 1.001) {
                values.push_back(value);
            }
        }
    }
    return values;
}

std::string gridText(const Axis& axis, double bottom) {
    std::string svg;
    for (const double value : ticks(axis.low, axis.high)) {
        const bool ours = std::abs(value - 1.0) < 1e-9;
        const double x = axis.x(value);
        svg +=
            fmt::format("<line x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1:.1f}\" y2=\"{2:.1f}\" class=\"{3}\"/>\n",
                        x, top - 6.0, bottom, ours ? "ours" : "grid");
        svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" class=\"tick\">{}</text>\n", x, top - 12.0,
                           ours ? "raytorus" : fmt::format("{:g}x", value));
    }
    svg += fmt::format(
        "<text x=\"{:.1f}\" y=\"14\" class=\"end left\">&#8592; faster than the library</text>\n", plotLeft);
    svg += fmt::format(
        "<text x=\"{:.1f}\" y=\"14\" class=\"end right\">slower than the library &#8594;</text>\n",
        plotRight);
    return svg;
}

std::string laneText(const Axis& axis, const std::vector<Mark>& marks, const char* pattern, double y) {
    std::string svg = fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" class=\"lane {}\">{}</text>\n",
                                  plotLeft - 8.0, y + 4.0, pattern, pattern);
    std::vector<double> values;
    for (const Mark& mark : marks) {
        const double x = axis.x(mark.value);
        values.push_back(mark.value);
        svg +=
            mark.bad
                ? fmt::format(
                      "<path d=\"M{:.1f} {:.1f}l7 7m0 -7l-7 7\" class=\"{} bad\"><title>{}</title></path>\n",
                      x - 3.5, y - 3.5, pattern, mark.title)
                : fmt::format(
                      "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\" class=\"{}\"><title>{}</title>"
                      "</circle>\n",
                      x, y, pattern, mark.title);
    }
    if (values.empty()) {
        return svg;
    }
    const double mean = geometricMean(values);
    svg += fmt::format("<line x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1:.1f}\" y2=\"{2:.1f}\" class=\"mean\"/>\n",
                       axis.x(mean), y - 8.0, y + 8.0);
    svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" class=\"number\">{}x</text>\n", plotRight + 70.0,
                       y + 4.0, ratioText(mean));
    return svg;
}

}  // namespace

std::string ratioPlot(const BenchRun& run, trace::Query query) {
    struct Row {
        std::string name;
        std::array<std::vector<Mark>, 2> lanes;
    };
    std::vector<Row> rows;
    Axis axis;
    for (const TimedMethod& method : timedMethods()) {
        if (method.name == emptyName || method.name == ourName) {
            continue;
        }
        Row row{method.name,
                {marksOf(run, query, Pattern::Tiles, method.name),
                 marksOf(run, query, Pattern::Scattered, method.name)}};
        for (const std::vector<Mark>& lane : row.lanes) {
            for (const Mark& mark : lane) {
                axis.low = std::min(axis.low, mark.value / 1.1);
                axis.high = std::max(axis.high, mark.value * 1.1);
            }
        }
        if (!row.lanes[0].empty() || !row.lanes[1].empty()) {
            rows.push_back(std::move(row));
        }
    }
    const double rowHeight = 2.0 * laneHeight + rowGap;
    const double bottom = top + rowHeight * static_cast<double>(rows.size());
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:g} {:g}\" role=\"img\" aria-label=\"{} "
        "hits: "
        "time over the library's\">\n",
        width, bottom + 10.0, nameOf(query));
    svg += gridText(axis, bottom);
    svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" class=\"number\">mean</text>\n", plotRight + 70.0,
                       top - 12.0);
    double y = top + 0.5 * laneHeight;
    for (const Row& row : rows) {
        svg += fmt::format("<text x=\"8\" y=\"{:.1f}\" class=\"name\">{}</text>\n",
                           y + 0.5 * laneHeight + 4.0, row.name);
        svg += laneText(axis, row.lanes[0], "tiles", y);
        svg += laneText(axis, row.lanes[1], "scattered", y + laneHeight);
        y += rowHeight;
    }
    return svg + "</svg>\n";
}

}  // namespace raytorus::bench
