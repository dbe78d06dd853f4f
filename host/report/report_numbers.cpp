// SPDX-License-Identifier: MIT
// The numbers of a case as HTML: channels, histogram, one pixel.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "compare/channel_judge.hpp"
#include "compare/comparison_text.hpp"
#include "compare/difference.hpp"
#include "core/markup.hpp"
#include "report/report_case.hpp"

namespace raytorus::report {

namespace {

template <typename Cells>
std::string rowHtml(const Cells& cells, std::string_view tag, bool over) {
    std::string row = over ? "<tr class=\"over\">" : "<tr>";
    for (const std::string& cell : cells) {
        row += fmt::format("<{0}>{1}</{0}>", tag, escapeHtml(cell));
    }
    return row + "</tr>\n";
}

std::string barHtml(std::int64_t count, std::int64_t most, std::string_view kind, std::string_view label) {
    // Logarithmic: one wrong value among thousands of right ones is still to be seen.
    const double height =
        100.0 * std::log1p(static_cast<double>(count)) / std::log1p(static_cast<double>(most));
    return fmt::format(
        "<div class=\"bin {}\"><span>{}</span><i style=\"height:{:.1f}%\"></i><b>{}</b></div>\n", kind,
        count > 0 ? fmt::format("{}", count) : "", count > 0 ? height : 0.0, label);
}

}  // namespace

std::string numbersHtml(const compare::Comparison& comparison) {
    if (comparison.channels.empty()) {
        return {};
    }
    const std::vector<compare::NumberRow> rows = compare::numberRows(comparison);
    std::string html = "<div class=\"numbers\"><table>\n" + rowHtml(rows.front(), "th", false);
    for (std::size_t channel = 0; channel < comparison.channels.size(); ++channel) {
        html += rowHtml(rows[channel + 1], "td", comparison.channels[channel].overLimit > 0);
    }
    html +=
        fmt::format("</table></div>\n<p class=\"counts\">{}", escapeHtml(compare::countsLine(comparison)));
    for (const std::string& line : compare::marginLines(comparison)) {
        html += "<br>\n" + escapeHtml(line);
    }
    return html + "</p>\n";
}

std::string histogramHtml(const ReportCase& reported) {
    constexpr std::array<std::string_view, compare::histogramEnds.size() + 1> labels = {
        "equal", "&le; .001", "&le; .01", "&le; .1", "&le; 1", "&le; 10", "&le; 100", "&le; 1000", "more"};
    const compare::DifferenceHistogram histogram =
        compare::differenceHistogram(*reported.expected, *reported.actual, reported.comparison->rules);
    const std::int64_t most = std::max<std::int64_t>(std::ranges::max(histogram.counts), 1);
    std::string html = "<h3>Values by difference over tolerance</h3>\n<div class=\"histogram\">\n";
    for (std::size_t bin = 0; bin < labels.size(); ++bin) {
        const bool within =
            bin == 0 || (bin < compare::histogramEnds.size() && compare::histogramEnds[bin] <= 1.0);
        const char* const kind = bin == 0 ? "equal" : within ? "within" : "beyond";
        html += barHtml(histogram.counts[bin], most, kind, labels[bin]);
    }
    html += "</div>\n";
    if (histogram.marginal > 0) {
        html += fmt::format("<p class=\"counts\">{} values in marginal pixels are not counted.</p>\n",
                            histogram.marginal);
    }
    if (histogram.notFinite > 0) {
        html += fmt::format("<p class=\"counts\">{} values are not finite.</p>\n", histogram.notFinite);
    }
    return html;
}

std::string pixelHtml(const ReportCase& reported, compare::Pixel pixel) {
    const std::span<const float> expectedPixel = reported.expected->pixel(pixel.x, pixel.y);
    const std::span<const float> actualPixel = reported.actual->pixel(pixel.x, pixel.y);
    using Row = std::array<std::string, 5>;
    std::string html = "<div class=\"numbers\"><table>\n" +
                       rowHtml(Row{"channel", "expected", "actual", "difference", "tolerance"}, "th", false);
    for (const compare::ChannelJudge& judge :
         compare::channelJudges(*reported.expected, *reported.actual, reported.comparison->rules)) {
        const double difference = judge.difference(expectedPixel, actualPixel);
        const double limit = judge.limit(expectedPixel);
        if (difference == 0.0) {
            continue;
        }
        const bool marginal = judge.marginal(expectedPixel);
        const bool finite =
            image::isFinite(expectedPixel[judge.expected]) && image::isFinite(actualPixel[judge.actual]);
        html += rowHtml(Row{judge.name, compare::valueText(expectedPixel[judge.expected]),
                            compare::valueText(actualPixel[judge.actual]),
                            finite ? fmt::format("{:.3g}", difference) : "-",
                            marginal ? "marginal" : fmt::format("{:.3g}", limit)},
                        "td", !marginal && !(difference <= limit));
    }
    return html + "</table></div>\n";
}

}  // namespace raytorus::report
