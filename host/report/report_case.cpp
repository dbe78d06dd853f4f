// SPDX-License-Identifier: MIT
// One case of a report as HTML. Its pictures are variables of its style, so each is in the page once, however
// many places show it.
#include "report/report_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "compare/channel_judge.hpp"
#include "compare/comparison_text.hpp"
#include "compare/difference.hpp"
#include "core/markup.hpp"
#include "report/report_picture.hpp"

namespace raytorus::report {

namespace {

bool comparable(const ReportCase& reported) {
    return reported.expected && reported.actual && reported.comparison &&
           !compare::channelJudges(*reported.expected, *reported.actual, reported.comparison->rules).empty();
}

// The case's pictures as variables, their size in pixels, and the marked pixel.
std::string variables(const ReportCase& reported) {
    const image::Image& scale = reported.expected ? *reported.expected : *reported.actual;
    const compare::Pixel mark = worstPixel(reported).value_or(compare::Pixel{});
    std::string text = fmt::format("--w:{};--h:{};--x:{};--y:{}", scale.width, scale.height, mark.x, mark.y);
    if (reported.expected) {
        text += ";--expected:url(" + pngDataUri(displayImage(*reported.expected, scale)) + ")";
    }
    if (reported.actual) {
        text += ";--actual:url(" + pngDataUri(displayImage(*reported.actual, scale)) + ")";
    }
    if (comparable(reported)) {
        text += ";--fit:100% 100%";  // all of one shape: no rounding leaves a line of background
        const compare::CompareRules& rules = reported.comparison->rules;
        text += ";--heat:url(" +
                pngDataUri(compare::differenceImage(*reported.expected, *reported.actual, rules)) + ")";
        if (!reported.comparison->margins.empty()) {
            text += ";--margin:url(" +
                    pngDataUri(compare::marginImage(*reported.expected, *reported.actual, rules)) + ")";
        }
    }
    return text;
}

std::string thumbsHtml(const ReportCase& reported) {
    std::string html = "<span class=\"thumbs\" aria-hidden=\"true\">";
    const std::array<std::pair<bool, const char*>, 3> thumbs = {{{reported.expected.has_value(), "expected"},
                                                                 {reported.actual.has_value(), "actual"},
                                                                 {comparable(reported), "heat"}}};
    for (const auto& [exists, kind] : thumbs) {
        html += fmt::format("<i class=\"{}\"></i>", exists ? kind : "none");
    }
    return html + "</span>";
}

std::string figureHtml(std::string_view kind, std::string_view caption, bool swaps = false,
                       std::string_view more = {}) {
    return fmt::format(
        "<figure><figcaption>{1}{3}</figcaption><button class=\"picture {0}{2}\" data-kind=\"{0}\" "
        "aria-label=\"{1}\"><i class=\"mark\"></i></button></figure>\n",
        kind, caption, swaps ? " swaps" : "", more);
}

std::string picturesHtml(const ReportCase& reported) {
    std::string figures;
    const bool both = comparable(reported);
    if (reported.expected) {
        figures += figureHtml("expected", "Expected", both);
    }
    if (reported.actual) {
        figures += figureHtml("actual", "Actual", both);
    }
    if (both) {
        figures +=
            "<figure><figcaption>Split: expected | actual</figcaption><div class=\"picture split expected\">"
            "<i class=\"actual\"></i><input type=\"range\" min=\"0\" max=\"100\" value=\"50\" step=\"0.5\" "
            "aria-label=\"Expected to the left of here, actual to the right\"></div></figure>\n";
        figures += figureHtml("heat", "Difference over tolerance");
        figures += figureHtml("amplified", "Difference", false,
                              " of what is shown &times; <select class=\"gain\" aria-label=\"Times\">"
                              "<option>1<option selected>8<option>64<option>255</select>");
        if (!reported.comparison->margins.empty()) {
            figures += figureHtml("margin", "Marginal pixels and flips");
        }
    }
    return figures.empty() ? figures : "<div class=\"pictures\">\n" + figures + "</div>\n";
}

// What lies round one pixel: the pictures that are there already, enlarged by the style.
std::string worstHtml(const ReportCase& reported) {
    const std::optional<compare::Pixel> worst = worstPixel(reported);
    if (!worst || !comparable(reported)) {
        return {};
    }
    return fmt::format(
        "<section class=\"worst\"><h3>Worst pixel {}</h3>\n<div class=\"zooms\">"
        "<i class=\"zoom expected\" title=\"Expected\"></i><i class=\"zoom actual\" title=\"Actual\"></i>"
        "<i class=\"zoom heat\" title=\"Difference over tolerance\"></i></div>\n"
        "<p class=\"counts\">round the marked pixel <output class=\"place\">{}</output>: "
        "expected, actual, difference over tolerance</p>\n{}</section>\n",
        compare::pixelText(*worst), compare::pixelText(*worst), pixelHtml(reported, *worst));
}

// The last place for it: a name before it may hold the same characters.
std::string withPixel(std::string command, compare::Pixel pixel) {
    constexpr std::string_view place = "{x},{y}";
    if (const std::size_t at = command.rfind(place); at != std::string::npos) {
        command.replace(at, place.size(), fmt::format("{},{}", pixel.x, pixel.y));
    }
    return command;
}

std::string commandHtml(std::string_view label, const std::string& command,
                        const std::string& attribute = {}) {
    if (command.empty()) {
        return {};
    }
    return fmt::format(
        "<div class=\"command\"><span>{}</span><code{}>{}</code><button class=\"copy\">Copy</button></div>\n",
        label, attribute, escapeHtml(command));
}

// The script puts in another pixel when one is picked, hence the command as it was given beside the one to
// show.
std::string explainHtml(const ReportCase& reported) {
    if (!reported.expected && !reported.actual) {
        return {};
    }
    const compare::Pixel pixel = worstPixel(reported).value_or(compare::Pixel{});
    return commandHtml("Explain the marked pixel", withPixel(reported.explainCommand, pixel),
                       fmt::format(" data-command=\"{}\"", escapeHtml(reported.explainCommand)));
}

std::string commandsHtml(const ReportCase& reported) {
    const std::string html = explainHtml(reported) + commandHtml("Run again", reported.rerunCommand) +
                             commandHtml("Renew what is expected", reported.renewCommand);
    return html.empty() ? html : "<div class=\"commands\">\n" + html + "</div>\n";
}

// Where a number says something.
std::string badnessHtml(const ReportCase& reported) {
    const double worst = badness(reported);
    if (!reported.comparison || !std::isfinite(worst) || worst == 0.0) {
        return {};
    }
    return fmt::format("<span class=\"badness\">{:.3g} &times; tolerance</span>", worst);
}

std::string flipsHtml(const ReportCase& reported) {
    const std::int64_t flips = reported.comparison ? reported.comparison->flippedPixels : 0;
    return flips == 0 ? std::string()
                      : fmt::format("<span class=\"flips\">{} flip{}</span>", flips, flips == 1 ? "" : "s");
}

}  // namespace

std::string verdictOf(const ReportCase& reported) {
    if (!reported.verdict.empty()) {
        return reported.verdict;
    }
    if (reported.comparison) {
        return compare::verdictName(reported.comparison->verdict);
    }
    return reported.passed ? "passed" : "failed";
}

std::string caseHtml(const ReportCase& reported, bool open) {
    const bool pictures = reported.expected || reported.actual;
    std::string html = fmt::format("<details class=\"case{}{}\"{}{}>\n", reported.passed ? "" : " failed",
                                   worstPixel(reported) ? " marked" : "", open ? " open" : "",
                                   pictures ? " style=\"" + variables(reported) + "\"" : "");
    html += fmt::format(
        "<summary>{}<h2>{}</h2><span class=\"verdict\">{}</span>{}{}<span class=\"sentence\">{}</span>"
        "</summary>\n<div class=\"body\">\n",
        thumbsHtml(reported), escapeHtml(reported.name), escapeHtml(verdictOf(reported)),
        badnessHtml(reported), flipsHtml(reported), escapeHtml(reported.sentence));
    if (!reported.catches.empty()) {
        html += fmt::format("<p class=\"catches\"><b>Catches</b> {}</p>\n", escapeHtml(reported.catches));
    }
    html += picturesHtml(reported);
    html += "<div class=\"sections\">\n" + worstHtml(reported) + "<section>";
    if (comparable(reported)) {
        html += histogramHtml(reported);
    }
    html += commandsHtml(reported) + "</section>\n</div>\n";
    if (reported.comparison) {
        html += numbersHtml(*reported.comparison);
    }
    return html + "</div>\n</details>\n";
}

}  // namespace raytorus::report
