// SPDX-License-Identifier: MIT
// The steps of the derivation as rows, for those who print them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "explain/explanation.hpp"

namespace raytorus::explain {

/// A number of the derivation. One that is complex or does not exist has no value.
struct Row {
    const char* name;      ///< "alpha", "beta as a sum"
    const char* key;       ///< "alpha", "betaSum": in JSON
    const char* equation;  ///< of docs/math.md
    std::optional<float> shader;
    std::optional<Quad> exact;
};

struct Section {
    const char* title;
    const char* key;
    std::vector<Row> rows;
};

std::vector<Section> sectionsOf(const Explanation& explanation);

}  // namespace raytorus::explain
