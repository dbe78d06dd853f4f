// SPDX-License-Identifier: MIT
// Text, JSON and picture tell the same: as many hits, the same numbers; JSON parses, SVG is well-formed XML.
#include <cctype>
#include <cstring>
#include <nlohmann/json.hpp>

#include "explain/explain.hpp"
#include "explain/json.hpp"
#include "explain/number_text.hpp"
#include "explain/svg.hpp"
#include "explain/table.hpp"
#include "explain/text.hpp"
#include "reference/rays.hpp"
#include "support/count_of.hpp"
#include "support/device_fixture.hpp"
#include "support/special_floats.hpp"

namespace raytorus::test {
namespace {

using explain::Explanation;
using nlohmann::json;
using reference::Quad;

// What is wrong with the tags of an XML text, or nothing: each is closed, in its place, its attributes quoted
// and different, and no character that must be escaped stands alone.
std::string xmlFault(const std::string& xml) {
    std::vector<std::string> open;
    std::size_t at = 0;
    while (at < xml.size()) {
        const std::size_t begin = xml.find('<', at);
        const std::string between = xml.substr(at, begin == std::string::npos ? begin : begin - at);
        for (std::size_t i = between.find('&'); i != std::string::npos; i = between.find('&', i + 1)) {
            if (between.compare(i, 4, "&lt;") != 0 && between.compare(i, 4, "&gt;") != 0 &&
                between.compare(i, 5, "&amp;") != 0) {
                return "a bare & in: " + between;
            }
        }
        if (begin == std::string::npos) {
            break;
        }
        const std::size_t end = xml.find('>', begin);
        if (end == std::string::npos) {
            return "a tag without an end";
        }
        const std::string tag = xml.substr(begin + 1, end - begin - 1);
        if (countOf(tag, "\"") % 2 != 0 || countOf(tag, "=\"") * 2 != countOf(tag, "\"") ||
            tag.find('<') != std::string::npos) {
            return "attributes of: " + tag;
        }
        const std::string name = tag.substr(0, tag.find_first_of(" /", 1));
        if (tag.starts_with('/')) {
            if (open.empty() || "/" + open.back() != tag) {
                return "closes what is not open: " + tag;
            }
            open.pop_back();
        } else if (!tag.ends_with('/')) {
            open.push_back(name);
        }
        at = end + 1;
    }
    return open.empty() ? "" : "never closed: " + open.back();
}

struct Example {
    const char* name;
    reference::Torus torus;
    reference::Ray ray;
    std::size_t hits, roots;  // roots that are no hits
};

// For GoogleTest's messages.
void PrintTo(const Example& row, std::ostream* out) {
    *out << row.name;
}

const Example cases[] = {
    {"Four", {1, 0.35F}, {{-2, 0.4F, 0.45F}, 0, {1, 0, -0.2F}, infinity}, 4, 0},
    {"Two", {1, 0.4F}, {{-3, 0.3F, 1}, 0, {1, 0.1F, -0.5F}, infinity}, 2, 0},
    {"Ends", {1, 0.25F}, {{0, 0, 0}, 0, {1, 0.1F, 0}, 1}, 1, 3},
    {"Tangent", {1, 0.25F}, {{-3, 1.24999F, 0}, 0, {1, 0, 0}, infinity}, 2, 0},
    {"Miss", {1, 0.25F}, {{-3, 0.2F, 0.4F}, 0, {1, 0.1F, 0.02F}, infinity}, 0, 0},
    {"Spindle", {1, 1.5F}, {{-4, 0.2F, 0.3F}, 0, {1, 0, 0.05F}, infinity}, 2, 2},
    {"Horn", {1, 1}, {{0, 0, 2}, 0, {0, 0, -1}, infinity}, 2, 2},
    {"Parallel", {1, 0.25F}, {{0.9F, 0.1F, 3}, 0, {0, 0, -1}, infinity}, 2, 0},
    {"Thin", {1, 0.001F}, {{-3, 0.1F, 0}, 0, {1, 0, 0}, infinity}, 4, 0},
    {"Sphere", {0, 1}, {{-3, 0.1F, 0.5F}, 0, {1, 0, 0}, infinity}, 2, 0},
};

class ExplainOutput : public DeviceTest, public testing::WithParamInterface<Example> {
protected:
    const Explanation e = explain::explain(device(), GetParam().torus, GetParam().ray);
};

TEST_P(ExplainOutput, ThePictureIsWellFormedAndMarksEveryRoot) {
    const std::string svg = explain::svgOf(e);
    EXPECT_EQ(xmlFault(svg), "");
    EXPECT_TRUE(svg.starts_with("<svg xmlns=") && svg.ends_with("</svg>\n"));
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    const std::size_t parts = e.exact.reduced ? 2 : 1;  // of a sphere there is no quartic to see
    EXPECT_EQ(countOf(svg, "class=\"hit\""), parts * GetParam().hits);
    EXPECT_EQ(countOf(svg, "class=\"root\""), parts * GetParam().roots);
    EXPECT_EQ(countOf(svg, "class=\"missed\"") + countOf(svg, "class=\"invented\""), 0U);
}

TEST_P(ExplainOutput, TheJsonHasEveryNumberOfTheText) {
    const json parsed = json::parse(explain::jsonOf(e));
    const std::string text = explain::textOf(e);
    EXPECT_EQ(parsed["conclusion"], e.conclusion);
    EXPECT_TRUE(text.ends_with("\n" + e.conclusion + "\n"));
    EXPECT_EQ(parsed["replay"], reference::hexFloats(e.torus, e.ray));
    EXPECT_NE(text.find(parsed["replay"].get<std::string>()), std::string::npos);
    for (const explain::Section& section : explain::sectionsOf(e)) {
        for (const explain::Row& row : section.rows) {
            const json& entry = parsed[section.key][row.key];
            EXPECT_NE(text.find("\n  " + std::string(row.name) + " "), std::string::npos) << row.name;
            ASSERT_EQ(entry["float32"].is_number(), row.shader.has_value()) << row.name;
            if (row.shader) {
                EXPECT_EQ(entry["float32"].get<float>(), *row.shader);
                EXPECT_EQ(std::strtof(entry["hex"].get<std::string>().c_str(), nullptr), *row.shader);
            }
            if (row.exact) {  // more digits than the text has
                const std::string digits = entry["exact"];
                EXPECT_LT(reference::magnitude(strtoflt128(digits.c_str(), nullptr) - *row.exact),
                          Quad(1e-32) * reference::magnitude(*row.exact) + Quad(1e-300));
            }
        }
    }
    ASSERT_EQ(parsed["roots"].size(), GetParam().hits + GetParam().roots);
    std::size_t hits = 0;
    for (const json& root : parsed["roots"]) {
        hits += root["hit"].is_null() ? 0U : 1U;
        EXPECT_NE(text.find(root["t"].get<std::string>().substr(0, 16)), std::string::npos);
    }
    EXPECT_EQ(hits, GetParam().hits);
    EXPECT_EQ(parsed["torusIntersectAll"]["found"], GetParam().hits);
    EXPECT_EQ(parsed["torusOccluded"], GetParam().hits > 0);
    EXPECT_TRUE(parsed["right"]);
}

INSTANTIATE_TEST_SUITE_P(Rays, ExplainOutput, testing::ValuesIn(cases),
                         [](const testing::TestParamInfo<Example>& row) { return row.param.name; });

// Wrong answers, made by hand from right ones: the picture and the texts show them.
TEST(ExplainWrongOutput, MissedAndInventedAreMarked) {
    Explanation e = explain::explain(device(), {1.0F, 0.4F}, {{-3, 0.3F, 1}, 0, {1, 0.1F, -0.5F}, infinity});
    ASSERT_EQ(e.hits.size(), 2U);
    e.roots[0].hit.reset();
    e.roots[1].closedForm.reset();
    const std::string svg = explain::svgOf(e), text = explain::textOf(e);
    EXPECT_EQ(countOf(svg, "class=\"missed\""), 2U);
    EXPECT_EQ(countOf(svg, "class=\"invented\""), 2U);
    EXPECT_EQ(countOf(svg, "class=\"hit\""), 2U);
    EXPECT_NE(text.find("    torusIntersectAll   missed\n"), std::string::npos);
    EXPECT_NE(text.find("    closed form         missed\n"), std::string::npos);
    EXPECT_NE(text.find("torusIntersectAll invents t"), std::string::npos);
    EXPECT_NE(text.find("the closed form invents t"), std::string::npos);
    const json parsed = json::parse(explain::jsonOf(e));
    EXPECT_EQ(parsed["invented"]["hits"].size(), 1U);
    EXPECT_EQ(parsed["invented"]["closedForm"].size(), 1U);
}

TEST(ExplainWrongOutput, BadInputIsPrintable) {
    const Explanation e = explain::explain(device(), {0.0F, -1.0F}, {{nan, 0, 0}, 0, {0, 0, 0}, infinity});
    EXPECT_EQ(e.faults.size(), 3U);
    EXPECT_EQ(xmlFault(explain::svgOf(e)), "");
    const json parsed = json::parse(explain::jsonOf(e));
    EXPECT_TRUE(parsed["ray"]["origin"][0]["float32"].is_null());
    EXPECT_EQ(parsed["ray"]["origin"][0]["hex"], "nan");
    EXPECT_EQ(parsed["faults"].size(), 3U);
    EXPECT_FALSE(parsed.contains("quartic"));
}

TEST(ExplainWrongOutput, TheXmlCheckSeesFaults) {
    EXPECT_EQ(xmlFault("<a b=\"1\"><c/>x &lt; y</a>"), "");
    for (const char* bad : {"<a>", "<a></b>", "<a b=1\"/>", "<a>x & y</a>", "<a", "</a>"}) {
        EXPECT_NE(xmlFault(bad), "") << bad;
    }
}

}  // namespace
}  // namespace raytorus::test
