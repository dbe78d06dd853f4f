// SPDX-License-Identifier: MIT
#include "explain/text.hpp"

#include <fmt/format.h>

#include "explain/number_text.hpp"
#include "explain/table.hpp"
#include "reference/rays.hpp"

namespace raytorus::explain {
namespace {

// Digits of exact values: three times a float's, so that they line up and still show what float32 lost.
constexpr int exactDigits = 24;

std::string given(const char* name, std::initializer_list<float> values) {
    std::string decimals, hexadecimals;
    for (const float value : values) {
        decimals += fmt::format("{:<16}", decimal(value));
        hexadecimals += fmt::format("  {}", hexadecimal(value));
    }
    return fmt::format("  {:<14}{:<48}{}\n", name, decimals, hexadecimals);
}

std::string givenText(const Explanation& e) {
    const auto& [o, tMin, d, tMax] = e.ray;
    std::string text = "torus and ray\n";
    text += given("R, r", {e.torus.majorRadius, e.torus.minorRadius});
    text += given("origin", {o[0], o[1], o[2]});
    text += given("direction", {d[0], d[1], d[2]});
    text += given("tMin, tMax", {tMin, tMax});
    text += fmt::format("  {:<14}\"{}\"\n", "--replay", reference::hexFloats(e.torus, e.ray));
    return text;
}

std::string list(const char* title, const std::vector<std::string>& lines) {
    std::string text = fmt::format("\n{}\n", title);
    for (const std::string& line : lines) {
        text += fmt::format("  {}\n", line);
    }
    return text;
}

std::string shapeNote(const reference::Torus& torus) {
    const double ratio = double{torus.minorRadius} / double{torus.majorRadius};
    return torus.majorRadius > 0.0F ? fmt::format("a {}: r / R = {:.6g}", shapeOf(torus), ratio)
                                    : fmt::format("a {} of radius r", shapeOf(torus));
}

// A side that got so far has every number but a complex one.
const char* missing(bool reduced) {
    return reduced ? "complex" : "-";
}

std::string rowText(const Explanation& e, const Row& row) {
    const std::string exact = row.exact ? decimal(*row.exact, exactDigits) : missing(e.exact.reduced);
    const std::string error = row.shader && row.exact ? roughly(ulpError(*row.shader, *row.exact)) : "-";
    return fmt::format("  {:<16}{:<18}{:<34}{:>8}   ({})\n", row.name,
                       row.shader ? fmt::format("{:.9g}", *row.shader) : missing(e.shader.reduced), exact,
                       error, row.equation);
}

std::string stepsText(const Explanation& e) {
    std::string text;
    for (const Section& section : sectionsOf(e)) {
        text +=
            fmt::format("\n{:<18}{:<18}{:<34}{:>8}   eq.\n", section.title, "float32", "exact", "ulp off");
        for (const Row& row : section.rows) {
            text += rowText(e, row);
        }
    }
    if (e.exact.reduced) {
        text += fmt::format("  {:<16}float32  {}\n  {:<16}exact    {}\n", "case", describe(e.shader.rootCase),
                            "", describe(e.exact.rootCase));
    }
    return text;
}

std::string vectorText(const Vec3<float>& v) {
    return fmt::format("({:.9g}, {:.9g}, {:.9g})", v[0], v[1], v[2]);
}

std::string vectorText(const Vec3<Quad>& v) {
    return fmt::format("({}, {}, {})", decimal(v[0], 17), decimal(v[1], 17), decimal(v[2], 17));
}

std::string describe(const TrueRoot& root) {
    std::string text = root.sheet == Sheet::Inner ? "inner sheet" : root.entering ? "entering" : "leaving";
    if (root.place != RootPlace::Within) {
        text += root.place == RootPlace::Before ? ", before tMin" : ", beyond tMax";
    }
    return text;
}

// An answer's line and what it is off.
std::string tText(const char* who, float t, double ulps, double position) {
    return fmt::format("    {:<20}t {:<34.9g} off by {} ulp, position by {} (R + r)\n", who, t, roughly(ulps),
                       roughly(position));
}

std::string hitText(const TrueRoot& root, const ShaderHit& hit) {
    std::string text;
    text += fmt::format("    position            {}\n      exact             {}\n", vectorText(hit.position),
                        vectorText(root.position));
    text += fmt::format("    normal              {}, off by {}\n      exact             {}\n",
                        vectorText(hit.normal), roughly(normalError(root, hit)), vectorText(root.normal));
    text += fmt::format(
        "    uv                  ({:.9g}, {:.9g}), off by {} turns\n      exact             ({}, {})\n",
        hit.uv[0], hit.uv[1], roughly(uvError(root, hit)), decimal(root.uv[0], 17), decimal(root.uv[1], 17));
    return text;
}

std::string rootText(const Explanation& e, std::size_t index) {
    const TrueRoot& root = e.roots[index];
    std::string text = fmt::format("  {}  {}\n    {:<20}t {}\n", index + 1, describe(root), "exact",
                                   decimal(root.t, exactDigits));
    if (root.hit) {
        const ShaderHit& hit = e.hits[*root.hit];
        text +=
            tText("torusIntersectAll", hit.t, tError(e, root, hit.t), positionError(e, root, hit.position));
    } else if (root.isHit()) {
        text += fmt::format("    {:<20}missed\n", "torusIntersectAll");
    }
    if (root.closedForm) {
        const float t = e.closedForm[*root.closedForm];
        text += tText("closed form", t, tError(e, root, t), positionError(e, root, t));
    } else if (e.closedForms.answers) {
        text += fmt::format("    {:<20}missed\n", "closed form");
    }
    return root.hit ? text + hitText(root, e.hits[*root.hit]) : text;
}

// Answers that no root has.
std::string inventedText(const Explanation& e) {
    std::string text;
    for (std::size_t i = 0; i < e.hits.size(); ++i) {
        if (isInvented(e, i)) {
            text += fmt::format("  -  torusIntersectAll invents t {:.9g} at {}\n", e.hits[i].t,
                                vectorText(e.hits[i].position));
        }
    }
    for (std::size_t i = 0; i < e.closedForm.size(); ++i) {
        if (isInventedByClosedForm(e, i)) {
            text += fmt::format("  -  the closed form invents t {:.9g}\n", e.closedForm[i]);
        }
    }
    return text;
}

std::string rootsText(const Explanation& e) {
    std::string text = fmt::format("\nroots of the line: {}\n", e.roots.size());
    for (std::size_t i = 0; i < e.roots.size(); ++i) {
        text += rootText(e, i);
    }
    text += inventedText(e);
    text += fmt::format("  nearest to a tangent: {} r; from the surface: tMin {} r, tMax {} r\n",
                        roughly(e.clearance), roughly(e.startClearance), roughly(e.stopClearance));
    return text;
}

std::string answersText(const Explanation& e) {
    const std::string nearest =
        e.nearest ? fmt::format("t {:.9g} at {}", e.nearest->t, vectorText(e.nearest->position)) : "no hit";
    return fmt::format("\nanswers\n  {:<20}{}\n  {:<20}{}\n  {:<20}{}\n  {:<20}{}\n", "torusIntersect",
                       nearest, "torusOccluded", e.occluded ? "yes" : "no", "torusIntersectAll",
                       counted(static_cast<int>(e.hits.size()), "hit"), "closed form",
                       counted(static_cast<int>(e.closedForm.size()), "root"));
}

}  // namespace

std::string textOf(const Explanation& e) {
    std::string text = givenText(e);
    if (e.faults.empty()) {
        std::vector<std::string> notes = e.notes;
        notes.insert(notes.begin(), shapeNote(e.torus));
        text += list("notes", notes) + stepsText(e) + rootsText(e);
    } else {
        text += list("bad input: the library answers no hit, t = tMax (0 if that is no number), position 0",
                     e.faults);
    }
    return text + answersText(e) + "\n" + e.conclusion + "\n";
}

}  // namespace raytorus::explain
