// SPDX-License-Identifier: MIT
#include "explain/match.hpp"

#include <bit>

namespace raytorus::explain {

using reference::Quad;

std::vector<std::size_t> matched(const std::vector<Quad>& shorter, const std::vector<Quad>& longer) {
    std::vector<std::size_t> best;
    Quad bestSum = 0;
    // Every choice of as many entries, as bits.
    for (unsigned chosen = 0; chosen < 1U << longer.size(); ++chosen) {
        if (static_cast<std::size_t>(std::popcount(chosen)) != shorter.size()) {
            continue;
        }
        std::vector<std::size_t> places;
        Quad sum = 0;
        for (std::size_t i = 0; i < longer.size(); ++i) {
            if ((chosen >> i & 1U) != 0U) {
                sum += reference::magnitude(shorter[places.size()] - longer[i]);
                places.push_back(i);
            }
        }
        if (best.empty() || sum < bestSum) {
            best = places;
            bestSum = sum;
        }
    }
    return best;
}

}  // namespace raytorus::explain
