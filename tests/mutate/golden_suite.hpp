// SPDX-License-Identifier: MIT
// The golden pictures as judges of changed shaders.
#pragma once

#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "golden/golden_set.hpp"
#include "gpu/context.hpp"
#include "render/renderer.hpp"

namespace raytorus::mutate {

/// Which case first was off, "ring_half_fragment"; nothing where none was.
struct GoldenVerdict {
    std::optional<std::string> truth;  ///< a picture is not what the reference says
    std::optional<std::string> bits;   ///< it may be, but CPU drivers drew other bits before
};

class GoldenSuite {
public:
    GoldenSuite();

    /// Draws cases by both routes until one is not what its truth says. Cases that have caught most are tried
    /// first. May be called from several threads.
    GoldenVerdict caught(gpu::Context& context, const trace::ShaderSource& shaders);

private:
    struct Trial {
        std::size_t row;  // of the table of golden cases
        render::Route route;
        int catches = 0;
    };
    [[nodiscard]] std::vector<std::size_t> trialsInOrder();

    golden::Set set;
    std::mutex mutex;
    std::vector<Trial> trials;
};

}  // namespace raytorus::mutate
