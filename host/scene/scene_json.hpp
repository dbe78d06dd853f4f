// SPDX-License-Identifier: MIT
// Scenes as JSON. The form is explained in docs/scenes.md and published for editors as
// docs/scene.schema.json.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "scene/scene.hpp"

namespace raytorus::scene {

/// The scene in a file. Throws Error: ExitCode::File if it cannot be read, else as parseScene.
Scene readScene(const std::filesystem::path& path);

/// The scene in a text. sourceName: what messages call it, usually the file name.
/// Throws Error with ExitCode::Scene on the first fault, as "source: /json/pointer: what is wrong", or
/// "source: line 3, column 5: ..." where the text is not JSON.
Scene parseScene(std::string_view text, std::string_view sourceName);

/// The scene as JSON, with every default written out; parseScene returns an equal scene.
/// The scene is a valid one, and its materials have different names.
std::string writeScene(const Scene& scene);

}  // namespace raytorus::scene
