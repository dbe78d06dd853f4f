// SPDX-License-Identifier: MIT
// Every scene that ships can be read, written, read again, and fits the schema.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "scene/scene_json.hpp"
#include "schema_validation.hpp"
#include "support/scratch_folder.hpp"

namespace raytorus::scene {
namespace {

const std::filesystem::path folder = RAYTORUS_SOURCE_DIR "/scenes";

class ShippedScene : public testing::TestWithParam<std::string> {
protected:
    std::filesystem::path path = folder / (GetParam() + ".json");
};

TEST_P(ShippedScene, IsReadAndWrittenWithoutLoss) {
    const Scene scene = readScene(path);
    EXPECT_EQ(parseScene(writeScene(scene), "written"), scene);
    EXPECT_FALSE(scene.description.empty());
}

TEST_P(ShippedScene, FitsTheSchema) {
    const nlohmann::json document = nlohmann::json::parse(test::fileText(path));
    EXPECT_EQ(test::schemaComplaint(document), "");
    EXPECT_TRUE(std::filesystem::equivalent(folder / document.at("$schema"),
                                            RAYTORUS_SOURCE_DIR "/docs/scene.schema.json"));
}

TEST_P(ShippedScene, UsesEachOfItsMaterials) {
    const Scene scene = readScene(path);
    std::set<std::size_t> used;
    for (const TorusInstance& torus : scene.tori) {
        used.insert(torus.materialIndex);
    }
    EXPECT_EQ(used.size(), scene.materials.size());
}

TEST_P(ShippedScene, IsInTheDocumentation) {
    const std::string text = test::fileText(RAYTORUS_SOURCE_DIR "/docs/scenes.md");
    EXPECT_NE(text.find("(../scenes/" + GetParam() + ".json)"), std::string::npos);
    EXPECT_NE(text.find("(images/" + GetParam() + ".png)"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(All, ShippedScene,
                         testing::Values("ring", "chain", "thin", "far", "inside", "nested", "spindle",
                                         "turntable"),
                         [](const auto& scene) { return scene.param; });

TEST(ShippedScenes, AreAllInTheListAbove) {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        count += entry.path().extension() == ".json" ? 1U : 0U;
    }
    EXPECT_EQ(count, 8U);
}

/// Each ```json block of docs/scenes.md is a scene that works.
TEST(ShippedScenes, TheExamplesOfTheDocumentationWork) {
    const std::string text = test::fileText(RAYTORUS_SOURCE_DIR "/docs/scenes.md");
    const std::string opening = "```json\n";
    std::size_t examples = 0;
    for (std::size_t at = text.find(opening); at != std::string::npos; at = text.find(opening, at + 1)) {
        const std::size_t begin = at + opening.size();
        const std::string example = text.substr(begin, text.find("```", begin) - begin);
        EXPECT_NO_THROW(parseScene(example, "docs/scenes.md")) << example;
        EXPECT_EQ(test::schemaComplaint(nlohmann::json::parse(example)), "");
        ++examples;
    }
    EXPECT_EQ(examples, 3U);
}

}  // namespace
}  // namespace raytorus::scene
