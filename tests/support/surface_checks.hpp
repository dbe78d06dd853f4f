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

std::string normalFault(const AskSurface& ask);
/// On the tube's centre circle and on the axis, where no direction is distinguished.
std::string undistinguishedNormalFault(const AskSurface& ask);
std::string uvFault(const AskSurface& ask);
/// On the axes of both circles, and an ulp below the seams, where 1 - tiny rounds to 1.
std::string seamFault(const AskSurface& ask);
std::string positionFault(const AskSurface& ask);
std::string tangentFault(const AskSurface& ask);
std::string distanceFault(const AskSurface& ask);

struct SurfaceCheck {
    const char* name;
    std::string (*fault)(const AskSurface& ask);
};

/// All of them.
std::span<const SurfaceCheck> surfaceChecks();

}  // namespace raytorus::test
