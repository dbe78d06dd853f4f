// SPDX-License-Identifier: MIT
// What is wrong with a scene is said in one sentence, with its place. The table holds the sentences
// themselves.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "scene/scene_json.hpp"
#include "support/expect_error.hpp"
#include "support/scratch_folder.hpp"

namespace raytorus::scene {
namespace {

using test::expectSentence;

struct Fault {
    std::string text;
    std::string message;
};

/// A scene with one torus and more keys before it.
std::string withKeys(const std::string& keys) {
    return "{" + keys + R"(, "tori": [{"majorRadius": 1, "minorRadius": 0.25}]})";
}

/// A scene whose second torus has more keys.
std::string withTorus(const std::string& keys) {
    return R"({"tori": [{"majorRadius": 1, "minorRadius": 0.25}, {)" + keys + "}]}";
}

std::string withPlacedTorus(const std::string& keys) {
    return withTorus(R"("majorRadius": 1, "minorRadius": 0.25, )" + keys);
}

std::string withCamera(const std::string& keys) {
    return withKeys(R"("camera": {)" + keys + "}");
}

std::string withMaterial(const std::string& keys) {
    return withKeys(R"("materials": {"gold": {)" + keys + "}}");
}

/// A torus that asks for this one of the materials gold and silver.
std::string twoMaterials(const std::string& name) {
    return R"({"materials": {"gold": {}, "silver": {}},
               "tori": [{"majorRadius": 1, "minorRadius": 1, "material": ")" +
           name + R"("}]})";
}

void expectFaults(const std::vector<Fault>& faults) {
    for (const Fault& fault : faults) {
        SCOPED_TRACE(fault.text.substr(0, 300));
        expectSentence([&fault] { parseScene(fault.text, "t.json"); }, ExitCode::Scene,
                       "t.json: " + fault.message);
    }
}

TEST(SceneFault, Syntax) {
    expectFaults({
        {"",
         "line 1, column 1: not JSON: while parsing value - unexpected end of input; "
         "expected '[', '{', or a literal"},
        {"{\n  \"tori\": [1,,2]}",
         "line 2, column 14: not JSON: while parsing value - unexpected ','; "
         "expected '[', '{', or a literal"},
        {"{\"tori\": [\n1\n",
         "line 3, column 1: not JSON: while parsing array - unexpected end of input; expected ']'"},
        {"{} x", "line 1, column 4: not JSON: while parsing value - invalid literal; expected end of input"},
        {"{\"a\": NaN}", "line 1, column 7: not JSON: while parsing value - invalid literal"},
        {"{\"a\": Infinity}", "line 1, column 7: not JSON: while parsing value - invalid literal"},
        {"{\"a\": \"\xff\"}",
         "line 1, column 8: not JSON: while parsing value - invalid string: ill-formed UTF-8 byte"},
        {"// hello", "line 1, column 1: not JSON: while parsing value - invalid literal"},
    });
}

TEST(SceneFault, StructureOfTheText) {
    const std::string deep(65, '[');
    std::string pointer;
    for (int i = 0; i < 64; ++i) {
        pointer += "/0";
    }
    expectFaults({
        {"{\"image\": {\"width\": 1,\n \"width\": 2}}", "/image/width: the key is given twice"},
        {R"({"tori": [], "tori": []})", "/tori: the key is given twice"},
        {R"({"materials": {"a/b~": {}, "a/b~": {}}})", "/materials/a~1b~0: the key is given twice"},
        {deep, pointer + ": nested more than 64 levels deep"},
        {withTorus(R"("majorRadius": 1e999)"),
         "/tori/1/majorRadius: 1e999 is beyond the range of float32 (3.4e38)"},
        {withTorus(R"("majorRadius": 1, "minorRadius": -1e39)"),
         "/tori/1/minorRadius: -1e39 is beyond the range of float32 (3.4e38)"},
        {withPlacedTorus(R"("translation": [0, 3.403e38, 0])"),
         "/tori/1/translation/1: 3.403e38 is beyond the range of float32 (3.4e38)"},
        {withPlacedTorus(R"("translation": [0, )" + std::string(500, '1') + "]"),
         "/tori/1/translation/1: " + std::string(60, '1') + "... is beyond the range of float32 (3.4e38)"},
    });
}

TEST(SceneFault, UnknownAndMissingKeys) {
    expectFaults({
        {"3", "3 is not an object"},
        {"[]", "[] is not an object"},
        {"{}", "the key 'tori' is missing"},
        {withKeys(R"("camra": {})"), "/camra: unknown key; did you mean camera?"},
        {withKeys(R"("fog": 1)"),
         "/fog: unknown key; the keys here are $schema, description, image, camera, "
         "background, ambient, lights, materials, tori, animation"},
        {withKeys(R"("a\u001b[31m": 1)"),
         "/a\\u001b[31m: unknown key; the keys here are $schema, description, image, "
         "camera, background, ambient, lights, materials, tori, animation"},
        {withKeys(R"("image": {"widht": 1})"), "/image/widht: unknown key; did you mean width?"},
        {withCamera(R"("fieldOfView": 1)"),
         "/camera/fieldOfView: unknown key; the keys here are position, target, up, verticalFieldOfView"},
        {withKeys(R"("background": {"Top": 1})"), "/background/Top: unknown key; did you mean top?"},
        {withKeys(R"("ambient": {"skies": 1})"),
         "/ambient/skies: unknown key; the keys here are sky, ground"},
        {withMaterial(R"("difuse": [0,0,0])"), "/materials/gold/difuse: unknown key; did you mean diffuse?"},
        {withMaterial(R"("checker": {"count": 1})"),
         "/materials/gold/checker/count: unknown key; did you mean counts?"},
        {withTorus(R"("majorradius": 1)"), "/tori/1/majorradius: unknown key; did you mean majorRadius?"},
        {withPlacedTorus(R"("rotation": {"angle": 1})"),
         "/tori/1/rotation/angle: unknown key; the keys here are axis, degrees, quaternion"},
        {withPlacedTorus(R"("rotation": {"quaternion": [0,0,0,1], "degrees": 1})"),
         "/tori/1/rotation/degrees: unknown key; the keys here are quaternion"},
        {withTorus(R"("majorRadius": 1)"), "/tori/1: the key 'minorRadius' is missing"},
        {withTorus(R"("minorRadius": 1)"), "/tori/1: the key 'majorRadius' is missing"},
        {withPlacedTorus(R"("rotation": {"axis": [1,0,0]})"),
         "/tori/1/rotation: the key 'degrees' is missing"},
        {withPlacedTorus(R"("rotation": {"degrees": 1})"), "/tori/1/rotation: the key 'axis' is missing"},
        {withCamera(R"("target": [0,0,0])"), "/camera: the key 'position' is missing"},
        {withCamera(R"("position": [0,0,0])"), "/camera: the key 'target' is missing"},
    });
}

TEST(SceneFault, Torus) {
    const std::string float32 = ", outside the normal range of float32";
    expectFaults({
        {R"({"tori": []})", "/tori: the array is empty, but a scene has at least one torus"},
        {R"({"tori": {}})", "/tori: an object is not an array"},
        {R"({"tori": [7]})", "/tori/0: 7 is not an object"},
        {withTorus(R"("majorRadius": 1, "minorRadius": -0.1)"),
         "/tori/1/minorRadius: -0.1 is not a positive number"},
        {withTorus(R"("majorRadius": 1, "minorRadius": 0)"),
         "/tori/1/minorRadius: 0 is not a positive number"},
        {withTorus(R"("majorRadius": 1, "minorRadius": "1")"),
         "/tori/1/minorRadius: \"1\" is not a positive number"},
        {withTorus(R"("majorRadius": -1, "minorRadius": 1)"),
         "/tori/1/majorRadius: -1 is not a number that is not negative"},
        {withTorus(R"("majorRadius": null, "minorRadius": 1)"),
         "/tori/1/majorRadius: null is not a number that is not negative"},
        {withTorus(R"("majorRadius": 1, "minorRadius": 1e-38)"),
         "/tori/1/minorRadius: times the scale it is 1e-38" + float32},
        {withTorus(R"("majorRadius": 1e-39, "minorRadius": 1)"),
         "/tori/1/majorRadius: times the scale it is 1e-39" + float32},
        {withTorus(R"("majorRadius": 1, "minorRadius": 1e-20, "scale": 1e-20)"),
         "/tori/1/minorRadius: times the scale it is 1e-40" + float32},
        {withTorus(R"("majorRadius": 0, "minorRadius": 1e20, "scale": 1e20)"),
         "/tori/1/minorRadius: times the scale it is 1e+40" + float32},
        {withTorus(R"("majorRadius": 3e38, "minorRadius": 3e38)"),
         "/tori/1: the radii together, times the scale, are 6e+38; they may be 1e-18 to 1e+18"},
        {withTorus(R"("majorRadius": 9e17, "minorRadius": 2e17)"),
         "/tori/1: the radii together, times the scale, are 1.1e+18; they may be 1e-18 to 1e+18"},
        {withTorus(R"("majorRadius": 0, "minorRadius": 9e-19)"),
         "/tori/1: the radii together, times the scale, are 9e-19; they may be 1e-18 to 1e+18"},
        {withTorus(R"("majorRadius": 1, "minorRadius": 0.25, "scale": 1e18)"),
         "/tori/1: the radii together, times the scale, are 1.25e+18; they may be 1e-18 to 1e+18"},
        {withPlacedTorus(R"("scale": 0)"), "/tori/1/scale: 0 is not a positive number"},
        {withPlacedTorus(R"("scale": -2)"), "/tori/1/scale: -2 is not a positive number"},
        {withPlacedTorus(R"("translation": [1, 2])"),
         "/tori/1/translation: [1,2] is not an array of three numbers"},
        {withPlacedTorus(R"("translation": [1, 2, true])"),
         "/tori/1/translation: [1,2,true] is not an array of three numbers"},
        {withPlacedTorus(R"("rotation": 90)"), "/tori/1/rotation: 90 is not an object"},
        {withPlacedTorus(R"("rotation": {"axis": [0,0,0], "degrees": 1})"),
         "/tori/1/rotation/axis: the vector is zero, and so has no direction"},
        {withPlacedTorus(R"("rotation": {"axis": [1,0,0], "degrees": []})"),
         "/tori/1/rotation/degrees: [] is not a number"},
        {withPlacedTorus(R"("rotation": {"quaternion": [0,0,0,0]})"),
         "/tori/1/rotation/quaternion: the quaternion is zero, and so is no rotation"},
        {withPlacedTorus(R"("rotation": {"quaternion": [0,0,1]})"),
         "/tori/1/rotation/quaternion: [0,0,1] is not an array of four numbers"},
        {withPlacedTorus(R"("rotation": {"quaternion": [0,0,1,"w"]})"),
         "/tori/1/rotation/quaternion/3: \"w\" is not a number"},
        {withPlacedTorus(R"("material": 1)"), "/tori/1/material: 1 is not a string"},
        {withPlacedTorus(R"("material": "gold")"),
         "/tori/1/material: \"gold\" is not the name of a material"},
        {twoMaterials("glod"),
         "/tori/0/material: \"glod\" is not the name of a material; did you mean gold?"},
        {twoMaterials("sliver"),
         "/tori/0/material: \"sliver\" is not the name of a material; did you mean silver?"},
    });
}

TEST(SceneFault, CameraAndImage) {
    const std::string inFront = R"("position": [0,-1,0], "target": [0,0,0])";
    expectFaults({
        {withKeys(R"("description": 1)"), "/description: 1 is not a string"},
        {withKeys(R"("$schema": 1)"), "/$schema: 1 is not a string"},
        {withKeys(R"("image": [9, 9])"), "/image: [9,9] is not an object"},
        {withKeys(R"("image": {"width": 0})"), "/image/width: 0 is not an integer from 1 to 16384"},
        {withKeys(R"("image": {"height": 16385})"), "/image/height: 16385 is not an integer from 1 to 16384"},
        {withKeys(R"("image": {"height": 1.5})"), "/image/height: 1.5 is not an integer from 1 to 16384"},
        {withKeys(R"("image": {"height": "9"})"), "/image/height: \"9\" is not an integer from 1 to 16384"},
        {withKeys(R"("camera": 1)"), "/camera: 1 is not an object"},
        {withCamera(R"("position": [1,2,3], "target": [1,2,3])"),
         "/camera/target: the target is the camera's position, and so gives no direction"},
        {withCamera(inFront + R"(, "up": [0,0,0])"),
         "/camera/up: the vector is zero, and so has no direction"},
        {withCamera(inFront + R"(, "up": [0,-7,0])"),
         "/camera/up: the camera's up direction is parallel to its view"},
        {withCamera(R"("position": [0,0,5], "target": [0,0,0])"),
         "/camera: the camera's up direction is parallel to its view"},
        {withCamera(inFront + R"(, "verticalFieldOfView": 0)"),
         "/camera/verticalFieldOfView: 0 is not an angle in degrees between 0 and 180"},
        {withCamera(inFront + R"(, "verticalFieldOfView": 180)"),
         "/camera/verticalFieldOfView: 180 is not an angle in degrees between 0 and 180"},
        {withCamera(inFront + R"(, "verticalFieldOfView": "wide")"),
         "/camera/verticalFieldOfView: \"wide\" is not an angle in degrees between 0 and 180"},
        {R"({"tori": [{"majorRadius": 1, "minorRadius": 1, "translation": [3e38, 0, 0]},
                       {"majorRadius": 1, "minorRadius": 1, "translation": [-3e38, 0, 0]}]})",
         "/tori: the tori reach too far for the default camera; give a camera"},
    });
}

TEST(SceneFault, LightsAndColours) {
    const std::string notNegative = " is not an array of three numbers that are not negative";
    const std::string upToOne = " is not an array of three numbers from 0 to 1";
    std::string lights;
    for (int i = 0; i < 17; ++i) {
        lights += std::string(i == 0 ? "" : ",") +
                  R"({"type": "point", "position": [0,0,0], "intensity": [1,1,1]})";
    }
    expectFaults({
        {withKeys(R"("background": {"top": [0, -0.1, 0]})"), "/background/top: [0,-0.1,0]" + notNegative},
        {withKeys(R"("background": {"bottom": "red"})"), "/background/bottom: \"red\"" + notNegative},
        {withKeys(R"("ambient": {"sky": [0, 0]})"), "/ambient/sky: [0,0]" + notNegative},
        {withKeys(R"("ambient": {"ground": 0})"), "/ambient/ground: 0" + notNegative},
        {withKeys(R"("lights": {})"), "/lights: an object is not an array"},
        {withKeys(R"("lights": [)" + lights + "]"),
         "/lights: an array of 17 is not an array of at most 16 lights"},
        {withKeys(R"("lights": [1])"), "/lights/0: 1 is not an object"},
        {withKeys(R"("lights": [{}])"), "/lights/0: the key 'type' is missing"},
        {withKeys(R"("lights": [{"type": "spot"}])"),
         "/lights/0/type: \"spot\" is not \"directional\" or \"point\""},
        {withKeys(R"("lights": [{"type": "point", "direction": [0,0,1]}])"),
         "/lights/0/direction: unknown key; the keys here are type, position, intensity"},
        {withKeys(R"("lights": [{"type": "point", "position": [0,0,1]}])"),
         "/lights/0: the key 'intensity' is missing"},
        {withKeys(R"("lights": [{"type": "directional", "direction": [0,0,0], "radiance": [1,1,1]}])"),
         "/lights/0/direction: the vector is zero, and so has no direction"},
        {withKeys(R"("lights": [{"type": "directional", "direction": [0,0,1], "radiance": [1,-1,1]}])"),
         "/lights/0/radiance: [1,-1,1]" + notNegative},
        {withKeys(R"("lights": [{"type": "point", "position": [0,0,1], "intensity": [-1,1,1]}])"),
         "/lights/0/intensity: [-1,1,1]" + notNegative},
        {withKeys(R"("materials": [])"), "/materials: [] is not an object"},
        {withMaterial(R"("diffuse": [0, 1.1, 0])"), "/materials/gold/diffuse: [0,1.1,0]" + upToOne},
        {withMaterial(R"("specular": [0, 0, -0.1])"), "/materials/gold/specular: [0,0,-0.1]" + upToOne},
        {withMaterial(R"("roughness": 0)"), "/materials/gold/roughness: 0 is not a number from 1e-6 to 1"},
        {withMaterial(R"("roughness": 1e-300)"),
         "/materials/gold/roughness: 1e-300 is not a number from 1e-6 to 1"},
        {withMaterial(R"("roughness": 1.01)"),
         "/materials/gold/roughness: 1.01 is not a number from 1e-6 to 1"},
        {withMaterial(R"("checker": {"counts": 4})"),
         "/materials/gold/checker/counts: 4 is not an array of two integers"},
        {withMaterial(R"("checker": {"counts": [4, 0]})"),
         "/materials/gold/checker/counts/1: 0 is not an integer from 1 to 65536"},
        {withMaterial(R"("checker": {"diffuse": [4, 0, 0]})"),
         "/materials/gold/checker/diffuse: [4,0,0]" + upToOne},
    });
}

TEST(SceneFault, Animation) {
    const auto withTurntable = [](const std::string& keys) {
        return withKeys(R"("animation": {"turntable": {)" + keys + "}}");
    };
    const std::string turntable = "/animation/turntable";
    expectFaults({
        {withKeys(R"("animation": 1)"), "/animation: 1 is not an object"},
        {withKeys(R"("animation": null)"), "/animation: null is not an object"},
        {withKeys(R"("animation": {})"), "/animation: the key 'turntable' is missing"},
        {withKeys(R"("animation": {"turntabel": {}})"),
         "/animation/turntabel: unknown key; did you mean turntable?"},
        {withKeys(R"("animation": {"turntable": 8})"), turntable + ": 8 is not an object"},
        {withTurntable(""), turntable + ": the key 'secondsPerTurn' is missing"},
        {withTurntable(R"("secondsPerTurn": 0)"), turntable + "/secondsPerTurn: 0 is not a positive number"},
        {withTurntable(R"("secondsPerTurn": -8)"),
         turntable + "/secondsPerTurn: -8 is not a positive number"},
        {withTurntable(R"("secondsPerTurn": "8")"),
         turntable + "/secondsPerTurn: \"8\" is not a positive number"},
        {withTurntable(R"("secondsPerTurn": 1e39)"),
         turntable + "/secondsPerTurn: 1e39 is beyond the range of float32 (3.4e38)"},
        {withTurntable(R"("secondsPerTurn": NaN)"),
         "line 1, column 48: not JSON: while parsing value - invalid literal"},
        {withTurntable(R"("secondsPerTurn": 8, "axis": [0, 0, 0])"),
         turntable + "/axis: the vector is zero, and so has no direction"},
        {withTurntable(R"("secondsPerTurn": 8, "axis": [0, 1])"),
         turntable + "/axis: [0,1] is not an array of three numbers"},
        {withTurntable(R"("secondsPerTurn": 8, "center": 0)"),
         turntable + "/center: 0 is not an array of three numbers"},
        {withTurntable(R"("secondsPerTurn": 8, "centre": [0, 0, 0])"),
         turntable + "/centre: unknown key; did you mean center?"},
        {withTurntable(R"("secondsPerTurn": 8, "center": [2e38, 0, 0])"),
         turntable + ": the tori turn beyond the range of float32 (3.4e38)"},
    });
}

TEST(SceneFault, File) {
    const std::filesystem::path folder = test::scratchFolder();
    const std::filesystem::path file = folder / "bad.json";
    const auto read = [](const std::filesystem::path& path) { return [path] { readScene(path); }; };
    const auto unreadable = [](const std::filesystem::path& path) {
        return "cannot read \"" + path.string() + "\": ";
    };
    expectSentence(read(file), ExitCode::File, unreadable(file) + "there is no such file");
    expectSentence(read(folder), ExitCode::File, unreadable(folder) + "it is a directory");
    test::writeText(file, "{\"tori\": []}");
    expectSentence(read(file), ExitCode::Scene,
                   file.string() + ": /tori: the array is empty, but a scene has at least one torus");
}

}  // namespace
}  // namespace raytorus::scene
