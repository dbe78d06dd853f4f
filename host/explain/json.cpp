// SPDX-License-Identifier: MIT
#include "explain/json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/json_text.hpp"
#include "explain/conclusion.hpp"
#include "explain/number_text.hpp"
#include "explain/table.hpp"
#include "reference/rays.hpp"

namespace raytorus::explain {
namespace {

using Json = nlohmann::ordered_json;

// JSON knows no NaN and no infinity: they are null, and the hexadecimal text beside them says which.
Json number(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

// The decimal of a float is exact as a double.
Json floatJson(float value) {
    return {{"float32", number(double{value})}, {"hex", hexadecimal(value)}};
}

template <class Values>
Json floatsJson(const Values& values) {
    Json list = Json::array();
    for (const float value : values) {
        list.push_back(floatJson(value));
    }
    return list;
}

template <class Values>
Json exactJson(const Values& values) {
    Json list = Json::array();
    for (const Quad& value : values) {
        list.push_back(decimal(value));
    }
    return list;
}

Json rowJson(const Row& row) {
    Json json = row.shader ? floatJson(*row.shader) : Json{{"float32", nullptr}, {"hex", nullptr}};
    json["exact"] = row.exact ? Json(decimal(*row.exact)) : Json(nullptr);
    json["ulp"] = row.shader && row.exact ? number(ulpError(*row.shader, *row.exact)) : Json(nullptr);
    json["equation"] = row.equation;
    return json;
}

const char* nameOf(RootPlace place) {
    return place == RootPlace::Before ? "before" : place == RootPlace::Within ? "within" : "beyond";
}

Json hitJson(const ShaderHit& hit) {
    return {{"t", floatJson(hit.t)},
            {"position", floatsJson(hit.position)},
            {"normal", floatsJson(hit.normal)},
            {"uv", floatsJson(hit.uv)}};
}

Json rootJson(const Explanation& e, const TrueRoot& root) {
    Json json{{"t", decimal(root.t)},
              {"position", exactJson(root.position)},
              {"normal", exactJson(root.normal)},
              {"uv", exactJson(root.uv)},
              {"sheet", root.sheet == Sheet::Outer ? "outer" : "inner"},
              {"entering", root.sheet == Sheet::Outer ? Json(root.entering) : Json(nullptr)},
              {"place", nameOf(root.place)},
              {"hit", nullptr},
              {"closedForm", nullptr}};
    if (root.hit) {
        const ShaderHit& hit = e.hits[*root.hit];
        Json& answer = json["hit"] = hitJson(hit);
        answer["tUlp"] = number(tError(e, root, hit.t));
        answer["positionError"] = number(positionError(e, root, hit.position));
        answer["normalError"] = number(normalError(root, hit));
        answer["uvError"] = number(uvError(root, hit));
    }
    if (root.closedForm) {
        const float t = e.closedForm[*root.closedForm];
        json["closedForm"] = {{"t", floatJson(t)},
                              {"tUlp", number(tError(e, root, t))},
                              {"positionError", number(positionError(e, root, t))}};
    }
    return json;
}

Json errorsJson(const AnswerErrors& list) {
    return {{"expected", list.expected},
            {"found", list.found},
            {"tUlp", number(list.t)},
            {"positionError", number(list.position)}};
}

Json inventedJson(const Explanation& e) {
    Json hits = Json::array(), roots = Json::array();
    for (std::size_t i = 0; i < e.hits.size(); ++i) {
        if (isInvented(e, i)) {
            hits.push_back(hitJson(e.hits[i]));
        }
    }
    for (std::size_t i = 0; i < e.closedForm.size(); ++i) {
        if (isInventedByClosedForm(e, i)) {
            roots.push_back(floatJson(e.closedForm[i]));
        }
    }
    return {{"hits", hits}, {"closedForm", roots}};
}

Json casesJson(const Explanation& e) {
    return {{"float32", describe(e.shader.rootCase)}, {"exact", describe(e.exact.rootCase)}};
}

}  // namespace

std::string jsonOf(const Explanation& e) {
    Json json{{"torus",
               {{"majorRadius", floatJson(e.torus.majorRadius)},
                {"minorRadius", floatJson(e.torus.minorRadius)},
                {"shape", shapeOf(e.torus)}}},
              {"ray",
               {{"origin", floatsJson(e.ray.origin)},
                {"tMin", floatJson(e.ray.tMin)},
                {"direction", floatsJson(e.ray.direction)},
                {"tMax", floatJson(e.ray.tMax)}}},
              {"replay", reference::hexFloats(e.torus, e.ray)},
              {"faults", e.faults},
              {"notes", e.notes}};
    for (const Section& section : sectionsOf(e)) {
        Json& rows = json[section.key] = Json::object();
        for (const Row& row : section.rows) {
            rows[row.key] = rowJson(row);
        }
    }
    json["case"] = casesJson(e);
    json["roots"] = Json::array();
    for (const TrueRoot& root : e.roots) {
        json["roots"].push_back(rootJson(e, root));
    }
    json["invented"] = inventedJson(e);
    json["clearance"] = {{"tangent", number(e.clearance)},
                         {"tMin", number(e.startClearance)},
                         {"tMax", number(e.stopClearance)}};
    json["startsInside"] = e.startsInside;
    json["torusIntersect"] = e.nearest ? hitJson(*e.nearest) : Json(nullptr);
    json["torusOccluded"] = e.occluded;
    json["torusIntersectAll"] = errorsJson(e.library);
    json["closedForm"] = e.closedForms.answers ? errorsJson(e.closedForms) : Json(nullptr);
    json["right"] = isRight(e);
    json["conclusion"] = e.conclusion;
    return dumpJson(json);
}

}  // namespace raytorus::explain
