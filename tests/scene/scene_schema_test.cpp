// SPDX-License-Identifier: MIT
// The published schema and the parser accept and reject the same documents, as far as a schema can say it.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "core/error.hpp"
#include "scene/scene_json.hpp"
#include "schema_validation.hpp"
#include "support/scratch_folder.hpp"

namespace raytorus::scene {
namespace {

using nlohmann::json;

/// Accepted by the parser?
bool parses(const json& document) {
    try {
        parseScene(document.dump(), "test");
        return true;
    } catch (const Error&) {
        return false;
    }
}

/// Each key once, each valid.
json fullScene() {
    return json::parse(R"({
        "$schema": "scene.schema.json", "description": "",
        "image": {"width": 10, "height": 10},
        "camera": {"position": [0, -3, 1], "target": [0, 0, 0], "up": [0, 0, 1], "verticalFieldOfView": 40},
        "background": {"top": [1, 1, 1], "bottom": [0, 0, 0]},
        "ambient": {"sky": [1, 1, 1], "ground": [0, 0, 0]},
        "lights": [{"type": "directional", "direction": [0, 0, 1], "radiance": [1, 1, 1]},
                   {"type": "point", "position": [0, 0, 1], "intensity": [1, 1, 1]}],
        "materials": {"gold": {"diffuse": [1, 1, 1], "specular": [0, 0, 0], "roughness": 0.5,
                               "checker": {"counts": [4, 4], "diffuse": [0, 0, 0]}}},
        "tori": [{"majorRadius": 1, "minorRadius": 0.5, "translation": [0, 0, 0],
                  "rotation": {"axis": [1, 0, 0], "degrees": 90}, "scale": 1, "material": "gold"},
                 {"majorRadius": 1, "minorRadius": 0.5, "rotation": {"quaternion": [0, 0, 0, 1]}}],
        "animation": {"turntable": {"secondsPerTurn": 8, "axis": [0, 0, 1], "center": [0, 0, 0]}}
    })");
}

void expectAgreement(const json& document, const std::string& what) {
    const std::string complaint = test::schemaComplaint(document);
    EXPECT_EQ(parses(document), complaint.empty()) << what << "\nschema: " << complaint;
}

/// Every place in the tree.
void collectPointers(const json& value, const json::json_pointer& here,
                     std::vector<json::json_pointer>& all) {
    all.push_back(here);
    if (value.is_object()) {
        for (const auto& [key, member] : value.items()) {
            collectPointers(member, here / key, all);
        }
    } else if (value.is_array()) {
        for (std::size_t i = 0; i < value.size(); ++i) {
            collectPointers(value[i], here / i, all);
        }
    }
}

std::vector<json::json_pointer> placesOf(const json& document) {
    std::vector<json::json_pointer> places;
    collectPointers(document, json::json_pointer(), places);
    return places;
}

TEST(SceneSchema, AcceptsTheFullScene) {
    EXPECT_EQ(test::schemaComplaint(fullScene()), "");
    EXPECT_TRUE(parses(fullScene()));
}

TEST(SceneSchema, AgreesOnWrongValuesInEachPlace) {
    // A schema cannot say that a vector is zero or parallel to another (no value here makes one so), nor that
    // a material has a name that is known (left out below).
    const std::vector<json> values = {nullptr,
                                      true,
                                      "text",
                                      "directional",
                                      -1,
                                      0.5,
                                      2,
                                      17,
                                      181,
                                      16385,
                                      65537,
                                      1e5,
                                      3.5e38,
                                      json::array(),
                                      json::object(),
                                      {1, 2},
                                      {1, 2, 3},
                                      {-1, 2, 3},
                                      {0.5, 0.25, 1},
                                      {1, 2, 3, 4},
                                      {1, 2, "3"},
                                      {{"x", 1}}};
    const json full = fullScene();
    std::size_t rejected = 0;
    std::size_t accepted = 0;
    for (const json::json_pointer& place : placesOf(full)) {
        for (const json& value : values) {
            json document = full;
            document[place] = value;
            const bool isUnknownName = place.to_string().ends_with("/material") && value.is_string();
            if (isUnknownName || (place.to_string() == "/materials" && value.is_object())) {
                continue;
            }
            expectAgreement(document, place.to_string() + " = " + value.dump());
            ++(parses(document) ? accepted : rejected);
        }
    }
    // Both answers are alive.
    EXPECT_GT(accepted, 100U);
    EXPECT_GT(rejected, 500U);
}

TEST(SceneSchema, AgreesOnMissingAndUnknownKeys) {
    const json full = fullScene();
    for (const json::json_pointer& place : placesOf(full)) {
        if (!place.empty() && full[place.parent_pointer()].is_object()) {
            json without = full;
            without[place.parent_pointer()].erase(place.back());
            if (place.to_string() != "/materials" &&
                place.to_string() != "/materials/gold") {  // is named by a torus
                expectAgreement(without, "without " + place.to_string());
            }
        }
        if (full[place].is_object()) {
            json more = full;
            more[place]["unknown"] = json::object();
            expectAgreement(more, "unknown key in " + place.to_string());
        }
    }
}

TEST(SceneSchema, AgreesOnTheEndsOfEachRange) {
    struct Case {
        std::string place;
        double value;
        bool isValid;
    };
    const json full = fullScene();
    for (const Case& end : std::vector<Case>{{"/image/width", 1, true},
                                             {"/image/width", 0, false},
                                             {"/image/height", 16384, true},
                                             {"/image/height", 16385, false},
                                             {"/camera/verticalFieldOfView", 0, false},
                                             {"/camera/verticalFieldOfView", 1e-6, true},
                                             {"/camera/verticalFieldOfView", 179.99, true},
                                             {"/camera/verticalFieldOfView", 180, false},
                                             {"/background/top/0", 0, true},
                                             {"/background/top/0", -1e-9, false},
                                             {"/background/bottom/2", 3.4e38, true},
                                             {"/ambient/sky/1", 3.41e38, false},
                                             {"/lights/0/radiance/1", -1e-9, false},
                                             {"/materials/gold/roughness", 0, false},
                                             {"/materials/gold/roughness", 0.99e-6, false},
                                             {"/materials/gold/roughness", 1e-6, true},
                                             {"/materials/gold/roughness", 1, true},
                                             {"/materials/gold/roughness", 1.000001, false},
                                             {"/materials/gold/diffuse/0", 1, true},
                                             {"/materials/gold/diffuse/0", 1.000001, false},
                                             {"/materials/gold/checker/counts/0", 1, true},
                                             {"/materials/gold/checker/counts/0", 65536, true},
                                             {"/materials/gold/checker/counts/1", 65537, false},
                                             {"/tori/0/majorRadius", 0, true},
                                             {"/tori/0/majorRadius", -1e-9, false},
                                             {"/tori/0/majorRadius", 9e17, true},
                                             {"/tori/0/majorRadius", 1.1e18, false},
                                             {"/tori/0/minorRadius", 1.1e18, false},
                                             {"/tori/0/minorRadius", 0, false},
                                             {"/tori/0/minorRadius", 1e-30, true},
                                             {"/tori/0/minorRadius", 100, true},
                                             {"/animation/turntable/secondsPerTurn", 0, false},
                                             {"/animation/turntable/secondsPerTurn", 1e-30, true},
                                             {"/animation/turntable/secondsPerTurn", -1e-9, false},
                                             {"/tori/0/scale", 0, false},
                                             {"/tori/0/scale", 1e-12, true}}) {
        json document = full;
        document[json::json_pointer(end.place)] = end.value == std::trunc(end.value) && end.value < 1e9
                                                      ? json(static_cast<int>(end.value))
                                                      : json(end.value);
        const std::string what = end.place + " = " + std::to_string(end.value);
        EXPECT_EQ(parses(document), end.isValid) << what;
        EXPECT_EQ(test::schemaComplaint(document).empty(), end.isValid)
            << what << test::schemaComplaint(document);
    }
}

TEST(SceneSchema, AgreesOnTheNumberOfLightsAndTori) {
    for (const int count : {0, 1, 16, 17}) {
        json document = fullScene();
        document["lights"] = json(static_cast<std::size_t>(count), document["lights"][0]);
        expectAgreement(document, std::to_string(count) + " lights");
        EXPECT_EQ(parses(document), count <= 16);
        document = fullScene();
        document["tori"] = json(static_cast<std::size_t>(count), document["tori"][0]);
        expectAgreement(document, std::to_string(count) + " tori");
        EXPECT_EQ(parses(document), count >= 1);
    }
}

TEST(SceneSchema, FitsWhatTheWriterWrites) {
    EXPECT_EQ(test::schemaComplaint(json::parse(writeScene(parseScene(fullScene().dump(), "test")))), "");
}

TEST(SceneSchema, SaysTheDefaultsOfTheParser) {
    const json schema = json::parse(test::fileText(RAYTORUS_SOURCE_DIR "/docs/scene.schema.json"));
    const auto defaultAt = [&](const std::string& pointer) {
        return schema.at(json::json_pointer(pointer + "/default"));
    };
    const Scene scene;
    const Material material;
    const Checker checker;
    EXPECT_EQ(defaultAt("/properties/image/properties/width"), scene.imageWidth);
    EXPECT_EQ(defaultAt("/properties/image/properties/height"), scene.imageHeight);
    EXPECT_EQ(defaultAt("/properties/camera/properties/verticalFieldOfView"),
              scene.camera.verticalFieldOfView);
    EXPECT_EQ(defaultAt("/definitions/material/properties/roughness"), material.roughness);
    EXPECT_EQ(defaultAt("/definitions/material/properties/checker/properties/counts"),
              json({checker.countU, checker.countV}));
    EXPECT_EQ(defaultAt("/definitions/torus/properties/scale"), TorusInstance().scale);

    // Where the schema refers to a definition, the default stands at the end of the description.
    const auto expectInDescription = [&](const std::string& pointer, const glm::dvec3& value) {
        const std::string text = schema.at(json::json_pointer(pointer)).at("description");
        const std::size_t found = text.find("Default ");
        ASSERT_NE(found, std::string::npos) << pointer;
        const json numbers = json::parse(text.substr(found + 8, text.size() - found - 9));
        EXPECT_EQ(numbers, json({value.x, value.y, value.z})) << pointer;
    };
    expectInDescription("/properties/camera/properties/up", scene.camera.up);
    expectInDescription("/properties/background/properties/top", scene.background.top);
    expectInDescription("/properties/background/properties/bottom", scene.background.bottom);
    expectInDescription("/properties/ambient/properties/sky", scene.ambient.sky);
    expectInDescription("/properties/ambient/properties/ground", scene.ambient.ground);
    expectInDescription("/definitions/material/properties/diffuse", material.diffuse);
    expectInDescription("/definitions/material/properties/specular", material.specular);
    expectInDescription("/definitions/material/properties/checker/properties/diffuse", checker.diffuse);
    expectInDescription("/definitions/torus/properties/translation", TorusInstance().translation);
    const std::string turntable = "/properties/animation/properties/turntable/properties/";
    expectInDescription(turntable + "axis", Turntable().axis);
    expectInDescription(turntable + "center", Turntable().center);
}

}  // namespace
}  // namespace raytorus::scene
