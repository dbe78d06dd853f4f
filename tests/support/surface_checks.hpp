// SPDX-License-Identifier: MIT
// What the surface functions have to be, on tori of every shape, held to the reference. Whoever can ask the
// functions can run the checks: each returns a sentence about the first answer that is wrong, or nothing.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "surface_probe.hpp"

namespace raytorus::test {

using AskSurface = std::function<std::vector<SurfaceAnswer>(const std::vector<SurfacePoint>&)>;

struct SurfaceCheck {
    const char* name;
    std::string (*fault)(const AskSurface& ask);
};

/// All of them.
std::span<const SurfaceCheck> surfaceChecks();

}  // namespace raytorus::test
