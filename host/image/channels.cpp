// SPDX-License-Identifier: MIT
#include "image/channels.hpp"

#include <algorithm>

namespace raytorus::image {

const Quantity* findQuantity(std::string_view channel) {
    const auto* const found = std::ranges::find_if(quantities, [channel](const Quantity& quantity) {
        return std::ranges::find(quantity.channels(), channel) != quantity.channels().end();
    });
    return found == quantities.end() ? nullptr : found;
}

std::vector<std::string> channelsOf(std::initializer_list<ChannelKind> kinds) {
    std::vector<std::string> names;
    for (const Quantity& quantity : quantities) {
        if (std::ranges::find(kinds, quantity.kind) != kinds.end()) {
            names.insert(names.end(), quantity.channels().begin(), quantity.channels().end());
        }
    }
    return names;
}

}  // namespace raytorus::image
