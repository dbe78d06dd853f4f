// SPDX-License-Identifier: MIT
// Does a document fit docs/scene.schema.json? Answered by a validator that knows nothing of our parser.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace raytorus::test {

/// The first complaint of the validator, or nothing if the document fits.
std::string schemaComplaint(const nlohmann::json& document);

}  // namespace raytorus::test
