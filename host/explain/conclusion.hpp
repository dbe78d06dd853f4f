// SPDX-License-Identifier: MIT
// What an explanation comes to, in one sentence.
#pragma once

#include <string>

#include "explain/explanation.hpp"

namespace raytorus::explain {

/// "the library is right: 2 hits, t off by at most 0.3 ulp; the closed form misses both roots". Of an
/// explanation that has everything else.
std::string conclusionOf(const Explanation& explanation);

/// Counts, agreement of the functions, and no gross error; but for what the contract leaves open at the ends.
bool isRight(const Explanation& explanation);

}  // namespace raytorus::explain
