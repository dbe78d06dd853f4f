// SPDX-License-Identifier: MIT
// One ray, its truth and its answers side by side.
#pragma once

#include <string>

#include "verify/verifier.hpp"

namespace raytorus::verify {

std::string replayText(const reference::Torus& torus, const reference::Ray& ray,
                       const Verifier::Replay& replay);

}  // namespace raytorus::verify
