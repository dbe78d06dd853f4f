// SPDX-License-Identifier: MIT
// What stands beside the page: report.json and junit.xml, the counting behind the histogram, and the whole at
// the size of a real run.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>

#include "compare/difference.hpp"
#include "report/report.hpp"
#include "report_sample.hpp"
#include "support/count_of.hpp"
#include "support/expect_error.hpp"
#include "support/scratch_folder.hpp"

namespace raytorus::report {
namespace {

using test::countOf;
using test::fileText;
using test::sampleCases;
using test::sampleHeading;
using test::scratchFolder;

TEST(ReportData, TheFolderHasThePageAndItsData) {
    const auto folder = scratchFolder() / "not" / "there" / "yet";
    const std::vector<ReportCase> cases = sampleCases();
    writeReportFolder(folder, cases, sampleHeading());
    EXPECT_EQ(test::namesIn(folder), (std::vector<std::string>{"index.html", "junit.xml", "report.json"}));
    EXPECT_EQ(fileText(folder / "index.html"), reportHtml(cases, sampleHeading()));
    EXPECT_EQ(fileText(folder / "report.json"), reportJson(cases, sampleHeading()));
    EXPECT_EQ(fileText(folder / "junit.xml"), reportJunit(cases, sampleHeading()));
}

TEST(ReportData, AFolderThatCannotHoldTheReportIsKnownBefore) {
    const auto folder = scratchFolder();
    prepareReportFolder(folder / "not" / "there");
    EXPECT_TRUE(std::filesystem::is_empty(folder / "not" / "there"));
    std::filesystem::create_directories(folder / "page" / "index.html");
    test::expectError([&] { prepareReportFolder(folder / "page"); }, ExitCode::File,
                      {"index.html", "directory"});
    test::writeText(folder / "file", "text");
    test::expectError([&] { prepareReportFolder(folder / "file"); }, ExitCode::File, {"file/"});
    EXPECT_EQ(fileText(folder / "file"), "text");
}

TEST(ReportData, JsonHoldsEveryCase) {
    const std::vector<ReportCase> cases = sampleCases();
    const auto json = nlohmann::json::parse(reportJson(cases, sampleHeading()));
    EXPECT_EQ(json["title"], "Golden pictures");
    EXPECT_EQ(json["facts"]["driver"], "Mesa 22.3.6");
    EXPECT_EQ(json["cases"], cases.size());
    EXPECT_EQ(json["passed"], 3);
    EXPECT_EQ(json["failed"], cases.size() - 3);
    ASSERT_EQ(json["results"].size(), cases.size());
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const auto& result = json["results"][i];
        EXPECT_EQ(result["name"], cases[i].name);
        EXPECT_EQ(result["passed"], cases[i].passed);
        EXPECT_EQ(result["sentence"], cases[i].sentence);
        EXPECT_EQ(result["comparison"].is_null(), !cases[i].comparison);
    }
    const auto& far = json["results"][7];
    EXPECT_EQ(far["name"], "far");
    EXPECT_EQ(far["verdict"], "differ");
    EXPECT_GT(far["badness"], 1.0);
    EXPECT_EQ(far["catches"], "t, to the last bits");
    EXPECT_EQ(far["rerun"], cases[7].rerunCommand);
    EXPECT_EQ(far["worstPixel"], far["comparison"]["channels"][4]["maxRatioPixel"]);
    EXPECT_EQ(json["results"][5]["worstPixel"], (nlohmann::json{34, 20}));  // the NaN
    EXPECT_EQ(json["results"][8]["verdict"], "missing");
    EXPECT_EQ(json["results"][8]["badness"], "+Inf");
    EXPECT_EQ(json["results"].back()["verdict"], "skipped");
}

TEST(ReportData, JunitTellsFailuresFromErrorsAndSkipsNothing) {
    const std::string xml = reportJunit(sampleCases(), sampleHeading());
    EXPECT_TRUE(
        xml.starts_with("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"Golden pictures\" "
                        "tests=\"11\" failures=\"4\" errors=\"4\" skipped=\"0\" time=\"1.250\">\n"))
        << xml.substr(0, 300);
    EXPECT_EQ(countOf(xml, "<testcase "), 11u);
    EXPECT_EQ(countOf(xml, "<failure type=\"differ\""), 4u);
    for (const char* type : {"non-finite", "size differs", "missing", "skipped"}) {
        EXPECT_EQ(countOf(xml, fmt::format("<error type=\"{}\"", type)), 1u) << type;
    }
    EXPECT_EQ(countOf(xml, "<skipped"), 0u);
    EXPECT_TRUE(xml.ends_with("</testsuite>\n"));
}

TEST(ReportData, WhatXmlMayNotHoldIsReplaced) {
    ReportCase reported;
    reported.name = "<a> & \"b\" \x01\xff";
    reported.sentence = "]]> it's over";
    const std::string xml = reportJunit(std::vector{reported});
    EXPECT_EQ(countOf(xml, "name=\"&lt;a&gt; &amp; &quot;b&quot; \\u0001\\xff\""), 1u) << xml;
    EXPECT_EQ(countOf(xml, "message=\"]]&gt; it&#39;s over\""), 1u) << xml;
    const auto json = nlohmann::json::parse(reportJson(std::vector{reported}));
    EXPECT_EQ(json["results"][0]["name"], "<a> & \"b\" \x01\xef\xbf\xbd");
}

TEST(ReportData, WhatDidNotRunIsAFailure) {
    std::vector<ReportCase> cases(2);
    cases[0].name = "ring";
    cases[1].name = "chain";
    const std::vector<std::string> names = {"chain", "far", "ring", "thin"};
    const std::vector<ReportCase> skipped = skippedCases(names, cases);
    ASSERT_EQ(skipped.size(), 2u);
    EXPECT_EQ(skipped[0].name, "far");
    EXPECT_EQ(skipped[1].name, "thin");
    EXPECT_FALSE(skipped[0].passed);
    EXPECT_EQ(skipped[0].verdict, "skipped");
    EXPECT_NE(skipped[0].sentence.find("skipped"), std::string::npos);
    EXPECT_TRUE(skippedCases(std::vector<std::string>{"ring"}, cases).empty());
}

TEST(DifferenceHistogram, CountsValuesByTheirLimits) {
    compare::CompareRules rules;
    rules.defaultRule.tolerance = 1.0;
    rules.channelRules["Z"] = {};
    image::Image expected(9, 1, {"R", "Z"});
    image::Image actual = expected;
    const std::vector<float> off = {0.0f, 1e-4f, 2e-3f, -0.1f, 1.0f, -1.5f, 11.0f, 1000.0f, 1001.0f};
    for (int x = 0; x < 9; ++x) {
        actual.pixel(x, 0)[0] = off[static_cast<std::size_t>(x)];
    }
    actual.pixel(3, 0)[1] = 1e-30f;  // where nothing is allowed, everything is too much
    const compare::DifferenceHistogram histogram = compare::differenceHistogram(expected, actual, rules);
    // -0.1f is more than 0.1.
    EXPECT_EQ(histogram.counts, (std::array<std::int64_t, 9>{9, 1, 1, 0, 2, 1, 1, 1, 2}));
    EXPECT_EQ(histogram.notFinite + histogram.marginal, 0);

    actual.pixel(0, 0)[0] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(compare::differenceHistogram(expected, actual, rules).notFinite, 1);
    EXPECT_EQ(compare::differenceHistogram(expected, actual, rules).counts[0], 8);
    const auto none = compare::differenceHistogram(expected, image::Image(2, 2, {"R"}), {});
    EXPECT_EQ(std::accumulate(none.counts.begin(), none.counts.end(), std::int64_t{0}), 0);
}

TEST(DifferenceHistogram, LeavesMarginalValuesOut) {
    image::Image truth(2, 1, {"id", "margin"});
    truth.pixel(1, 0)[1] = 1.0f;
    image::Image actual(2, 1, {"id"});
    actual.pixel(0, 0)[0] = 5.0f;
    const compare::DifferenceHistogram histogram = compare::differenceHistogram(truth, actual, {});
    EXPECT_EQ(histogram.marginal, 1);
    EXPECT_EQ(histogram.counts[0], 1);
    EXPECT_EQ(histogram.counts.back(), 0);
}

TEST(ReportData, AHundredAndFiftyCasesAreOneSmallPage) {
    const std::vector<ReportCase> kinds = sampleCases();
    std::vector<ReportCase> cases;
    for (int i = 0; i < 150; ++i) {
        cases.push_back(kinds[static_cast<std::size_t>(i) % kinds.size()]);
        cases.back().name += fmt::format("-{}", i);
    }
    const std::size_t bytes = reportHtml(cases, sampleHeading()).size();
    EXPECT_LT(bytes, std::size_t{10} << 20U);
    EXPECT_GT(bytes, std::size_t{1} << 20U);
}

}  // namespace
}  // namespace raytorus::report
