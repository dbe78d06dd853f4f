// SPDX-License-Identifier: MIT
// A report for programs: JSON, and JUnit's XML, which CI systems show.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "compare/comparison_text.hpp"
#include "core/json_text.hpp"
#include "core/markup.hpp"
#include "report/report.hpp"
#include "report/report_case.hpp"

namespace raytorus::report {

namespace {

using Json = nlohmann::ordered_json;

Json caseJson(const ReportCase& reported) {
    Json json = {{"name", reported.name},
                 {"passed", reported.passed},
                 {"verdict", verdictOf(reported)},
                 {"sentence", reported.sentence}};
    const double worst = badness(reported);
    json["badness"] = std::isfinite(worst) ? Json(worst) : Json("+Inf");
    if (const std::optional<compare::Pixel> pixel = worstPixel(reported)) {
        json["worstPixel"] = {pixel->x, pixel->y};
    }
    for (const auto& [key, text] :
         {std::pair("catches", &reported.catches), std::pair("explain", &reported.explainCommand),
          std::pair("rerun", &reported.rerunCommand), std::pair("renew", &reported.renewCommand)}) {
        if (!text->empty()) {
            json[key] = *text;
        }
    }
    if (reported.seconds > 0.0) {
        json["seconds"] = reported.seconds;
    }
    json["comparison"] = reported.comparison ? Json::parse(compare::jsonText(*reported.comparison)) : Json();
    return json;
}

// Something to compare was there, and it was wrong: a failure. Anything else that did not pass: an error.
bool isFailure(const ReportCase& reported) {
    return reported.comparison && reported.comparison->verdict == compare::Verdict::Differ;
}

std::string caseXml(const ReportCase& reported, const std::string& suite) {
    std::string xml = fmt::format(R"(  <testcase classname="{}" name="{}" time="{:.3f}")", escapeHtml(suite),
                                  escapeHtml(reported.name), reported.seconds);
    if (reported.passed) {
        return xml + "/>\n";
    }
    const char* const tag = isFailure(reported) ? "failure" : "error";
    std::string details = reported.comparison ? compare::numbersTable(*reported.comparison) : std::string();
    if (!reported.rerunCommand.empty()) {
        details += "run again: " + reported.rerunCommand + "\n";
    }
    return xml + fmt::format(">\n    <{0} type=\"{1}\" message=\"{2}\">{3}</{0}>\n  </testcase>\n", tag,
                             escapeHtml(verdictOf(reported)), escapeHtml(reported.sentence),
                             escapeHtml(details));
}

}  // namespace

std::string reportJson(std::span<const ReportCase> cases, const ReportHeading& heading) {
    const auto passed = std::ranges::count_if(cases, &ReportCase::passed);
    Json json = {{"title", heading.title},
                 {"facts", Json::object()},
                 {"cases", cases.size()},
                 {"passed", passed},
                 {"failed", static_cast<std::ptrdiff_t>(cases.size()) - passed},
                 {"results", Json::array()}};
    for (const auto& [name, text] : heading.facts) {
        json["facts"][name] = text;
    }
    for (const ReportCase& reported : cases) {
        json["results"].push_back(caseJson(reported));
    }
    return dumpJson(json) + "\n";
}

std::string reportJunit(std::span<const ReportCase> cases, const ReportHeading& heading) {
    std::size_t failures = 0;
    std::size_t errors = 0;
    double seconds = 0.0;
    std::string body;
    for (const ReportCase& reported : cases) {
        const bool failure = isFailure(reported);
        failures += !reported.passed && failure ? 1 : 0;
        errors += !reported.passed && !failure ? 1 : 0;
        seconds += reported.seconds;
        body += caseXml(reported, heading.title);
    }
    return fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"0\" time=\"{:.3f}\">\n"
        "{}</testsuite>\n",
        escapeHtml(heading.title), cases.size(), failures, errors, seconds, body);
}

}  // namespace raytorus::report
