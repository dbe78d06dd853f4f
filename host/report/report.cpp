// SPDX-License-Identifier: MIT
// The page of a report, and what of a case decides its place there.
#include "report/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <system_error>

#include "core/markup.hpp"
#include "core/output_file.hpp"
#include "report/report_case.hpp"

namespace raytorus::report {

// report.css and report.js, as they stand in this folder: embed.cmake.
extern const std::string_view styleSheet, script;

namespace {

std::size_t countFailed(std::span<const ReportCase> cases) {
    return static_cast<std::size_t>(
        std::ranges::count_if(cases, [](const ReportCase& reported) { return !reported.passed; }));
}

std::vector<const ReportCase*> worstFirst(std::span<const ReportCase> cases) {
    std::vector<const ReportCase*> sorted;
    std::ranges::transform(cases, std::back_inserter(sorted),
                           [](const ReportCase& reported) { return &reported; });
    std::ranges::stable_sort(sorted, [](const ReportCase* one, const ReportCase* other) {
        return std::pair(one->passed, -badness(*one)) < std::pair(other->passed, -badness(*other));
    });
    return sorted;
}

std::string headingHtml(std::span<const ReportCase> cases, const ReportHeading& heading) {
    const std::size_t all = cases.size();
    const std::size_t failed = countFailed(cases);
    const std::string total = failed == 0 ? fmt::format("All {} cases passed.", all)
                                          : fmt::format("{} of {} cases failed.", failed, all);
    std::string facts;
    for (const auto& [name, text] : heading.facts) {
        facts += fmt::format("<dt>{}</dt><dd>{}</dd>\n", escapeHtml(name), escapeHtml(text));
    }
    return fmt::format(
        "<h1>{}</h1>\n<p class=\"total\">{}</p>\n"
        "<div class=\"bar\"><i style=\"width:{:.2f}%\"></i></div>\n{}",
        escapeHtml(heading.title), all == 0 ? "There are no cases." : total,
        all == 0 ? 100.0 : 100.0 * static_cast<double>(failed) / static_cast<double>(all),
        facts.empty() ? facts : "<dl class=\"facts\">\n" + facts + "</dl>\n");
}

constexpr const char* tools = R"html(<div class="tools">
<input id="filter" type="search" placeholder="Filter, all of these words" aria-label="Filter">
<label><input id="failed" type="checkbox"> Failed only</label>
<button id="open">Open all</button><button id="close">Close all</button><output id="shown"></output></div>
<div class="help"><span><b style="background:#000"></b>equal</span>
<span><b style="background:linear-gradient(90deg,#183080,#60a0ff)"></b>within the tolerance</span>
<span><b style="background:linear-gradient(90deg,#ff7000,#ffe040,#fff)"></b>over it, up to 1000 times</span>
<span><b style="background:#40c060"></b>flip where the truth leaves it open</span>
<span><b style="background:#f0f"></b>not finite</span></div>
<p class="help">Point at a picture to swap expected and actual; click to mark a pixel; double click to enlarge.
<span class="keys"><kbd>/</kbd> filter, <kbd>f</kbd> failed only, <kbd>j</kbd> <kbd>k</kbd> next and previous case;
in a picture the <kbd>arrows</kbd> move the mark and <kbd>Enter</kbd> enlarges.</span></p>
)html";

void makeFolder(const std::filesystem::path& folder) {
    std::error_code problem;
    std::filesystem::create_directories(folder, problem);  // what is wrong, writing the first file tells
}

}  // namespace

ReportCase reportCase(std::string name, image::Image expected, image::Image actual,
                      compare::Comparison comparison) {
    ReportCase reported;
    reported.name = std::move(name);
    reported.passed = comparison.passed();
    reported.sentence = comparison.sentence;
    reported.expected = std::move(expected);
    reported.actual = std::move(actual);
    reported.comparison = std::move(comparison);
    return reported;
}

std::vector<ReportCase> skippedCases(std::span<const std::string> names, std::span<const ReportCase> cases) {
    std::vector<ReportCase> skipped;
    for (const std::string& name : names) {
        if (std::ranges::find(cases, name, &ReportCase::name) == cases.end()) {
            ReportCase& reported = skipped.emplace_back();
            reported.name = name;
            reported.verdict = "skipped";
            reported.sentence = "The case was skipped: it should have run, and nothing came of it.";
        }
    }
    return skipped;
}

double badness(const ReportCase& reported) {
    if (!reported.comparison || reported.comparison->channels.empty()) {
        return reported.passed ? 0.0 : std::numeric_limits<double>::infinity();
    }
    return std::ranges::max(reported.comparison->channels, {}, &compare::ChannelComparison::maxRatio)
        .maxRatio;
}

std::optional<compare::Pixel> worstPixel(const ReportCase& reported) {
    if (!reported.comparison) {
        return std::nullopt;
    }
    const compare::Comparison& comparison = *reported.comparison;
    for (const compare::NonFiniteValues* values :
         {&comparison.actualNonFinite, &comparison.expectedNonFinite}) {
        if (values->count > 0) {
            return values->pixel;
        }
    }
    const auto worst =
        std::ranges::max_element(comparison.channels, {}, [](const compare::ChannelComparison& channel) {
            return std::pair(channel.maxRatio, channel.maxDifference);
        });
    if (worst != comparison.channels.end() && worst->maxRatio > 0.0) {
        return worst->maxRatioPixel;
    }
    const auto flips = std::ranges::max_element(comparison.margins, {}, &compare::MarginalPixels::flips);
    if (flips != comparison.margins.end() && flips->flips > 0) {
        return flips->firstFlip;
    }
    return std::nullopt;
}

std::string reportHtml(std::span<const ReportCase> cases, const ReportHeading& heading) {
    std::string html = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n{}{}<main>\n",
        escapeHtml(heading.title), styleSheet, headingHtml(cases, heading), tools);
    const std::vector<const ReportCase*> sorted = worstFirst(cases);
    for (const ReportCase* reported : sorted) {
        // The worst failure is there to be looked at; the others are a list to choose from.
        html += caseHtml(*reported, reported == sorted.front() && !reported->passed);
    }
    html +=
        "</main>\n<p id=\"none\" hidden>No case has all of these words.</p>\n"
        "<dialog><p></p><button class=\"picture\" aria-label=\"Close\"></button></dialog>\n<script>";
    html += script;
    return html + "</script>\n</body>\n</html>\n";
}

void writeReport(const std::filesystem::path& path, std::span<const ReportCase> cases) {
    const std::string html = reportHtml(cases);
    writeFile(path, std::as_bytes(std::span(html)));
}

void prepareReportFolder(const std::filesystem::path& folder) {
    makeFolder(folder);
    for (const char* name : {"report.json", "junit.xml", "index.html"}) {
        requireWritable(folder / name);
    }
}

void writeReportFolder(const std::filesystem::path& folder, std::span<const ReportCase> cases,
                       const ReportHeading& heading) {
    makeFolder(folder);
    const auto write = [&folder](const char* name, const std::string& text) {
        writeFile(folder / name, std::as_bytes(std::span(text)));
    };
    write("report.json", reportJson(cases, heading));
    write("junit.xml", reportJunit(cases, heading));
    write("index.html", reportHtml(cases, heading));
}

}  // namespace raytorus::report
