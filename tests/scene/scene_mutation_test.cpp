// SPDX-License-Identifier: MIT
// Whatever bytes come in, the reader returns a scene or throws Error: no other exception, no crash.
#include <gtest/gtest.h>

#include <random>
#include <string>

#include "core/error.hpp"
#include "scene/scene_json.hpp"
#include "support/scratch_folder.hpp"

namespace raytorus::scene {
namespace {

TEST(SceneMutation, EndsInASceneOrAnError) {
    // Pieces of JSON and of scenes; random bytes alone rarely get past the first character.
    const std::string pieces[] = {"{",
                                  "}",
                                  "[",
                                  "]",
                                  ",",
                                  ":",
                                  "\"",
                                  "1e999",
                                  "-1",
                                  "0",
                                  "1e-40",
                                  "null",
                                  "true",
                                  "\"x\"",
                                  "[0,0,0]",
                                  "{}",
                                  "\\u0000",
                                  "\xff",
                                  std::string(1, '\0'),
                                  "1e38",
                                  "\n"};
    std::size_t scenes = 0;
    std::size_t errors = 0;
    for (const std::string name : {"ring.json", "inside.json", "thin.json"}) {
        const std::string original = test::fileText(std::string(RAYTORUS_SOURCE_DIR "/scenes/") + name);
        ASSERT_FALSE(original.empty()) << name;
        for (unsigned seed = 0; seed < 3000; ++seed) {
            std::mt19937 engine(seed);
            const auto below = [&](std::size_t bound) { return static_cast<std::size_t>(engine()) % bound; };
            std::string text = original;
            for (std::size_t edits = 1 + below(3); edits > 0; --edits) {
                const std::size_t place = below(text.size());
                text.replace(place, below(3), pieces[below(std::size(pieces))]);
            }
            try {
                parseScene(text, name);
                ++scenes;
            } catch (const Error& error) {
                ASSERT_EQ(error.exitCode, ExitCode::Scene)
                    << name << ", seed " << seed << ": " << error.what();
                ++errors;
            } catch (const std::exception& other) {
                FAIL() << name << ", seed " << seed << ": " << other.what();
            }
        }
    }
    EXPECT_GT(scenes, 100U);
    EXPECT_GT(errors, 1000U);
}

}  // namespace
}  // namespace raytorus::scene
