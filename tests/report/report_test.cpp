// SPDX-License-Identifier: MIT
// The report: one file with everything in it, safe against what names may hold, failures first.
#include "report/report.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "core/markup.hpp"
#include "image/image_codec.hpp"
#include "report/report_picture.hpp"
#include "support/count_of.hpp"
#include "support/expect_error.hpp"
#include "support/scratch_folder.hpp"

namespace raytorus::report {
namespace {

using test::countOf;
using test::fileText;
using test::namesIn;
using test::scratchFolder;

image::Image image(float value, std::vector<std::string> names = {"R", "G", "B", "A"}) {
    image::Image made(6, 4, std::move(names));
    std::ranges::fill(made.pixels, value);
    return made;
}

ReportCase made(const std::string& name, const image::Image& expected, const image::Image& actual) {
    return reportCase(name, expected, actual, compare::compare(expected, actual, {}));
}

ReportCase missing(const std::string& name) {
    ReportCase reported;
    reported.name = name;
    reported.sentence = "There is no expected image.";
    reported.actual = image(0.5f);
    return reported;
}

TEST(Report, IsOneFileThatNeedsNothingElse) {
    const auto folder = scratchFolder();
    const std::vector<ReportCase> cases = {made("same", image(0.5f), image(0.5f)),
                                           made("other", image(0.5f), image(0.75f)), missing("missing")};
    writeReport(folder / "report.html", cases);
    EXPECT_EQ(namesIn(folder), std::vector<std::string>{"report.html"});
    const std::string html = fileText(folder / "report.html");
    EXPECT_EQ(html, reportHtml(cases));
    for (const char* outside : {"http", "://", "src=", "<link", "@import", "file:"}) {
        EXPECT_EQ(countOf(html, outside), 0u) << outside;
    }
    EXPECT_EQ(countOf(html, "url("), countOf(html, "url(data:image/png;base64,"));
    // Three pictures of each compared case, one of the missing one.
    EXPECT_EQ(countOf(html, "url(data:image/png;base64,"), 7u);
    EXPECT_TRUE(html.starts_with("<!DOCTYPE html>\n"));
    EXPECT_TRUE(html.ends_with("</html>\n"));
}

TEST(Report, EscapesWhatCasesAreCalled) {
    const std::string hostile = "<script>alert(\"1\")</script>&'";
    ReportCase reported =
        made(hostile, image(0.5f, {"R", "G", "B", "<i>"}), image(0.75f, {"R", "G", "B", "<i>"}));
    reported.sentence += hostile;
    const std::string html = reportHtml(std::vector{reported});
    EXPECT_EQ(countOf(html, "<script>"), 1u);  // our own
    EXPECT_EQ(countOf(html, "<i>"), 0u);
    EXPECT_EQ(countOf(html, "&lt;script&gt;alert(&quot;1&quot;)&lt;/script&gt;&amp;&#39;"), 2u);
    EXPECT_EQ(countOf(html, "<td>&lt;i&gt;</td>"),
              2u);  // in the table of channels and in that of the worst pixel
    EXPECT_EQ(escapeHtml("plain text, 1 + 1"), "plain text, 1 + 1");
}

// The places of these cases in the page, which must be this order.
void expectOrder(const std::string& html, const std::vector<std::string>& names) {
    std::vector<std::size_t> places;
    for (const std::string& name : names) {
        places.push_back(html.find("<h2>" + name + "</h2>"));
        EXPECT_NE(places.back(), std::string::npos) << name;
    }
    EXPECT_TRUE(std::ranges::is_sorted(places)) << testing::PrintToString(places);
}

TEST(Report, ShowsFailuresFirstAndTheFirstOpen) {
    const std::string html = reportHtml(
        std::vector{made("pass-b", image(0.5f), image(0.5f)), made("fail-b", image(0.5f), image(0.75f)),
                    made("pass-a", image(0.5f), image(0.5f)), missing("fail-a")});
    expectOrder(html, {"fail-b", "fail-a", "pass-b", "pass-a"});
    EXPECT_EQ(countOf(html, "<details class=\"case failed"), 2u);
    EXPECT_EQ(countOf(html, "<details class=\"case\""), 2u);
    EXPECT_EQ(countOf(html, " open style="), 1u);
    EXPECT_LT(html.find(" open style="), html.find("<h2>fail-b</h2>"));
    EXPECT_EQ(countOf(html, "2 of 4 cases failed."), 1u);
    EXPECT_EQ(countOf(reportHtml(std::vector{made("a", image(0.5f), image(0.5f))}), " open style="), 0u);
}

TEST(Report, ShowsTheWorstFirstByDifferenceOverTolerance) {
    const auto within = [](const std::string& name, float difference, double tolerance) {
        compare::CompareRules rules;
        rules.defaultRule.tolerance = tolerance;
        const image::Image actual = image(0.5f + difference);
        return reportCase(name, image(0.5f), actual, compare::compare(image(0.5f), actual, rules));
    };
    const std::vector<ReportCase> cases = {within("quarter", 0.25f, 1.0), within("twice", 0.5f, 0.25),
                                           within("half", 0.125f, 0.25), within("thrice", 0.375f, 0.125),
                                           missing("missing")};
    expectOrder(reportHtml(cases), {"missing", "thrice", "twice", "half", "quarter"});
    EXPECT_EQ(badness(cases[0]), 0.25);
    EXPECT_EQ(badness(cases[4]), std::numeric_limits<double>::infinity());
    EXPECT_EQ(countOf(reportHtml(cases), ">3 &times; tolerance<"), 1u);
}

TEST(Report, TellsVerdictSentenceAndNumbers) {
    const ReportCase reported = made("other", image(0.5f), image(0.75f));
    const std::string html = reportHtml(std::vector{reported});
    EXPECT_EQ(countOf(html, "<span class=\"verdict\">differ</span>"), 1u);
    EXPECT_EQ(countOf(html, escapeHtml(reported.sentence)), 1u);
    EXPECT_EQ(countOf(html, "<tr class=\"over\">"), 8u);  // four channels, four values of the worst pixel
    EXPECT_EQ(countOf(html, "<td>0.25</td>"),
              16u);  // largest, mean and RMS of a channel, and of the worst pixel
    EXPECT_EQ(countOf(reportHtml(std::vector{missing("m")}), "<span class=\"verdict\">failed</span>"), 1u);
    EXPECT_EQ(countOf(reportHtml({}), "There are no cases."), 1u);
}

TEST(Report, ShowsImagesThatCannotBeCompared) {
    image::Image bad = image(0.5f);
    bad.pixels[0] = std::numeric_limits<float>::quiet_NaN();
    const std::string html = reportHtml(
        std::vector{made("bad", bad, image(0.5f)), made("small", image(0.5f), image::Image(2, 2, {"Z"}))});
    EXPECT_EQ(countOf(html, ">non-finite<"), 1u);
    EXPECT_EQ(countOf(html, ">size differs<"), 1u);
    EXPECT_EQ(countOf(html, "data-kind=\"heat\""), 1u);  // there is none of images of other size
}

TEST(Report, ShowsMarginsOnlyAgainstATruth) {
    image::Image truth = image(0.5f, {"R", "G", "B", "A", "margin.color"});
    truth.pixel(5, 3)[4] = 2.0f;
    const std::string html =
        reportHtml(std::vector{made("truth", truth, image(0.5f)), made("plain", image(0.5f), image(0.5f))});
    EXPECT_EQ(countOf(html, "data-kind=\"margin\""), 1u);
    EXPECT_EQ(countOf(html, "margin.color: 23 marginal, 0 flipped"), 1u);
}

TEST(Report, TellsWhoeverReadsItWhatToDo) {
    ReportCase reported = made("other", image(0.5f), image(0.5f));
    EXPECT_EQ(countOf(reportHtml(std::vector{reported}), "class=\"command\""), 0u);
    EXPECT_EQ(countOf(reportHtml(std::vector{reported}), "class=\"catches\""), 0u);
    reported.actual->pixel(4, 2)[1] = 0.75f;
    reported = made("other", *reported.expected, *reported.actual);
    reported.catches = "seams & edges";
    reported.explainCommand = "explain --pixel {x},{y}";
    reported.rerunCommand = "test 'other'";
    reported.renewCommand = "renew other";
    const std::string html = reportHtml(std::vector{reported});
    EXPECT_EQ(countOf(html, "seams &amp; edges"), 1u);
    EXPECT_EQ(countOf(html, ">explain --pixel 4,2</code>"), 1u);
    EXPECT_EQ(countOf(html, "data-command=\"explain --pixel {x},{y}\""), 1u);
    EXPECT_EQ(countOf(html, ">test &#39;other&#39;</code>"), 1u);
    EXPECT_EQ(countOf(html, ">renew other</code>"), 1u);
}

TEST(Report, PutsThePixelWhereItBelongsAndNowhereElse) {
    ReportCase reported = made("same", image(0.5f), image(0.5f));
    reported.explainCommand = "explain '{x},{y}.json' --pixel {x},{y}";
    reported.rerunCommand = "test '{x},{y}'";
    reported.renewCommand = "renew '{x},{y}'";
    const std::string html = reportHtml(std::vector{reported});
    EXPECT_EQ(countOf(html, ">explain &#39;{x},{y}.json&#39; --pixel 0,0</code>"), 1u);
    EXPECT_EQ(countOf(html, "<code>test &#39;{x},{y}&#39;</code>"), 1u);
    EXPECT_EQ(countOf(html, "<code>renew &#39;{x},{y}&#39;</code>"), 1u);
}

TEST(Report, FindsThePixelToLookAtFirst) {
    image::Image expected = image(0.5f, {"R", "G", "B", "id", "margin", "tolerance.color"});
    for (int y = 0; y < expected.height; ++y) {
        for (int x = 0; x < expected.width; ++x) {
            expected.pixel(x, y)[4] = x == 0 ? 0.0f : 1.0f;
            expected.pixel(x, y)[5] = y == 0 ? 1.0f : 0.125f;
        }
    }
    image::Image actual = image(0.5f, {"R", "G", "B", "id"});
    const auto worst = [&] { return worstPixel(made("case", expected, actual)); };
    EXPECT_EQ(worst(), std::nullopt);
    actual.pixel(0, 2)[3] = 7.0f;  // a flip
    EXPECT_EQ(worst(), (compare::Pixel{0, 2}));
    actual.pixel(4, 0)[1] = 1.0f;  // half a tolerance
    EXPECT_EQ(worst(), (compare::Pixel{4, 0}));
    actual.pixel(3, 3)[2] = 0.625f;  // the whole of a smaller one
    EXPECT_EQ(worst(), (compare::Pixel{3, 3}));
    actual.pixel(2, 1)[3] = 7.0f;  // no tolerance at all
    EXPECT_EQ(worst(), (compare::Pixel{2, 1}));
    actual.pixel(5, 1)[0] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(worst(), (compare::Pixel{5, 1}));
    EXPECT_EQ(worstPixel(missing("m")), std::nullopt);
}

TEST(ReportPicture, ColourIsShownAsItIsAndNonFiniteValuesInMagenta) {
    image::Image hdr = image(0.25f, {"Z", "B", "G", "R"});
    std::ranges::copy(std::array{9.0f, 3.0f, -1.0f, 0.5f}, hdr.pixel(0, 0).begin());
    hdr.pixel(1, 0)[1] = std::numeric_limits<float>::infinity();
    hdr.pixel(2, 0)[0] = std::numeric_limits<float>::quiet_NaN();  // Z is not shown
    const image::Image shown = displayImage(hdr, image(0.0f));
    EXPECT_EQ(std::vector(shown.pixels.begin(), shown.pixels.begin() + 9),
              (std::vector{0.5f, 0.0f, 1.0f, 1.0f, 0.0f, 1.0f, 0.25f, 0.25f, 0.25f}));
}

TEST(ReportPicture, WithoutColourTheFirstChannelIsGreyInTheRangeOfTheOther) {
    image::Image depth = image(3.0f, {"Z", "id"});
    depth.pixel(0, 0)[0] = 2.5f;
    depth.pixel(1, 0)[0] = 9.0f;
    image::Image range = image(2.0f, {"Z"});
    range.pixels[5] = 4.0f;
    range.pixels[6] = std::numeric_limits<float>::infinity();
    const image::Image shown = displayImage(depth, range);
    EXPECT_EQ(std::vector(shown.pixels.begin(), shown.pixels.begin() + 9),
              (std::vector{0.25f, 0.25f, 0.25f, 1.0f, 1.0f, 1.0f, 0.5f, 0.5f, 0.5f}));
    EXPECT_EQ(displayImage(depth, image(1.0f, {"Z"})).pixels[0], 0.5f);  // a range of nothing
}

TEST(ReportPicture, TheDataIsThePngOfThePicture) {
    const std::string uri = pngDataUri(image(0.5f, {"R", "G", "B"}));
    const std::string start = "data:image/png;base64,iVBORw0KGgo";  // the PNG signature
    EXPECT_EQ(uri.substr(0, start.size()), start);
    const std::size_t bytes = image::encode(image(0.5f, {"R", "G", "B"}), image::Format::Png, "").size();
    EXPECT_EQ(uri.size(), std::string("data:image/png;base64,").size() + (bytes + 2) / 3 * 4);
    EXPECT_EQ(uri.find('\n'), std::string::npos);
}

}  // namespace
}  // namespace raytorus::report
