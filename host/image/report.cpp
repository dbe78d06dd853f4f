// SPDX-License-Identifier: MIT
// The HTML of a report.
#include "image/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "core/file.hpp"
#include "image/channel_judge.hpp"
#include "image/comparison_text.hpp"
#include "image/difference.hpp"
#include "image/report_picture.hpp"
#include "image/report_style.hpp"

namespace raytorus::image {

namespace {

std::string verdictOf(const ReportCase& reported) {
    if (reported.comparison) {
        return verdictName(reported.comparison->verdict);
    }
    return reported.passed ? "passed" : "failed";
}

std::string figureHtml(std::string_view kind, std::string_view caption, bool swaps) {
    return fmt::format(
        "<figure><figcaption>{1}</figcaption><button class=\"picture {0}{2}\" data-kind=\"{0}\" "
        "aria-label=\"{1}, enlarge\" style=\"aspect-ratio:var(--ratio)\"></button></figure>\n",
        kind, caption, swaps ? " swaps" : "");
}

std::string picturesHtml(const ReportCase& reported) {
    if (!reported.expected && !reported.actual) {
        return {};
    }
    const bool both = reported.expected && reported.actual;
    const Image& scale = reported.expected ? *reported.expected : *reported.actual;
    std::string variables = fmt::format("--ratio:{}/{}", scale.width, scale.height);
    std::string figures;
    if (reported.expected) {
        variables += ";--expected:url(" + pngDataUri(displayImage(*reported.expected, scale)) + ")";
        figures += figureHtml("expected", "Expected", both);
    }
    if (reported.actual) {
        variables += ";--actual:url(" + pngDataUri(displayImage(*reported.actual, scale)) + ")";
        figures += figureHtml("actual", "Actual", both);
    }
    if (both && !channelJudges(*reported.expected, *reported.actual, {}).empty()) {
        const CompareRules rules = reported.comparison ? reported.comparison->rules : CompareRules();
        const Image difference = differenceImage(*reported.expected, *reported.actual, rules);
        variables += ";--difference:url(" + pngDataUri(difference) + ")";
        figures += figureHtml("difference", "Difference", false);
    }
    return fmt::format("<div class=\"pictures\" style=\"{}\">\n{}</div>\n", variables, figures);
}

std::string rowHtml(const NumberRow& cells, std::string_view tag, bool over) {
    std::string row = over ? "<tr class=\"over\">" : "<tr>";
    for (const std::string& cell : cells) {
        row += fmt::format("<{0}>{1}</{0}>", tag, escapeHtml(cell));
    }
    return row + "</tr>\n";
}

std::string numbersHtml(const Comparison& comparison) {
    if (comparison.channels.empty()) {
        return {};
    }
    const std::vector<NumberRow> rows = numberRows(comparison);
    std::string html = "<div class=\"numbers\"><table>\n" + rowHtml(rows.front(), "th", false);
    for (std::size_t channel = 0; channel < comparison.channels.size(); ++channel) {
        html += rowHtml(rows[channel + 1], "td", comparison.channels[channel].overLimit > 0);
    }
    return html + fmt::format("</table></div>\n<p class=\"counts\">{}</p>\n", countsLine(comparison));
}

std::string caseHtml(const ReportCase& reported) {
    return fmt::format(
        "<details class=\"case{}\"{}>\n<summary><h2>{}</h2><span class=\"verdict\">{}</span>"
        "<span class=\"sentence\">{}</span></summary>\n<div class=\"body\">\n{}{}</div>\n</details>\n",
        reported.passed ? "" : " failed", reported.passed ? "" : " open", escapeHtml(reported.name),
        verdictOf(reported), escapeHtml(reported.sentence), picturesHtml(reported),
        reported.comparison ? numbersHtml(*reported.comparison) : std::string());
}

std::string headingHtml(std::size_t failed, std::size_t all) {
    const std::string total = failed == 0 ? fmt::format("All {} cases passed.", all)
                                          : fmt::format("{} of {} cases failed.", failed, all);
    return fmt::format(
        "<h1>Image comparison</h1>\n<p class=\"total\">{}</p>\n"
        "<div class=\"bar\"><i style=\"width:{:.2f}%\"></i></div>\n"
        "<div class=\"help\"><span>Point at a picture to swap expected and actual; click to enlarge.</span>"
        "<span><b style=\"background:#000\"></b>equal</span>"
        "<span><b style=\"background:linear-gradient(90deg,#183080,#60a0ff)\"></b>within the tolerance</span>"
        "<span><b style=\"background:linear-gradient(90deg,#ff7000,#ffe040,#fff)\"></b>over it, up to 1000 "
        "times</span>"
        "<span><b style=\"background:#f0f\"></b>not finite</span></div>\n",
        all == 0 ? "There are no cases." : total,
        all == 0 ? 100.0 : 100.0 * static_cast<double>(failed) / static_cast<double>(all));
}

}  // namespace

ReportCase reportCase(std::string name, Image expected, Image actual, Comparison comparison) {
    ReportCase reported;
    reported.name = std::move(name);
    reported.passed = comparison.passed();
    reported.sentence = comparison.sentence;
    reported.expected = std::move(expected);
    reported.actual = std::move(actual);
    reported.comparison = std::move(comparison);
    return reported;
}

std::string reportHtml(std::span<const ReportCase> cases) {
    std::vector<const ReportCase*> sorted;
    std::ranges::transform(cases, std::back_inserter(sorted),
                           [](const ReportCase& reported) { return &reported; });
    std::ranges::stable_sort(sorted, {}, [](const ReportCase* reported) { return reported->passed; });
    const auto failed = static_cast<std::size_t>(
        std::ranges::count_if(cases, [](const ReportCase& reported) { return !reported.passed; }));

    std::string html =
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<title>Image comparison</title>\n<style>";
    html += reportStyle();
    html += "</style>\n</head>\n<body>\n" + headingHtml(failed, cases.size());
    for (const ReportCase* reported : sorted) {
        html += caseHtml(*reported);
    }
    html += "<dialog><p></p><button class=\"picture\" aria-label=\"Close\"></button></dialog>\n<script>";
    html += reportScript();
    return html + "</script>\n</body>\n</html>\n";
}

void writeReport(const std::filesystem::path& path, std::span<const ReportCase> cases) {
    const std::string html = reportHtml(cases);
    writeFile(path, std::as_bytes(std::span(html)));
}

std::string escapeHtml(std::string_view text) {
    std::string escaped;
    for (const char c : text) {
        switch (c) {
            case '&':
                escaped += "&amp;";
                break;
            case '<':
                escaped += "&lt;";
                break;
            case '>':
                escaped += "&gt;";
                break;
            case '"':
                escaped += "&quot;";
                break;
            case '\'':
                escaped += "&#39;";
                break;
            default:
                escaped += c;
        }
    }
    return escaped;
}

}  // namespace raytorus::image
