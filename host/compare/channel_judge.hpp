// SPDX-License-Identifier: MIT
// What one channel of the actual image is held to, pixel by pixel.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compare/compare_rules.hpp"
#include "image/image.hpp"

namespace raytorus::compare {

/// A truth is an image that says beside its values how far each may be off, in margins and tolerances
/// (image/channels.hpp). Where the margin of a channel is below 1, the pixel is marginal for it. Without its
/// margin a channel is never marginal; without its tolerance the rules alone count.
[[nodiscard]] bool isTruthChannel(std::string_view name);

/// Whether an image is a truth: whether it has any of these channels.
[[nodiscard]] bool isTruth(const image::Image& image);

/// How one value channel is judged. Indices are those of channels in the two images.
struct ChannelJudge {
    std::string name;
    std::size_t expected = 0;
    std::size_t actual = 0;
    CompareRule rule;
    std::optional<std::size_t> margin;     ///< channel of the truth
    std::optional<std::size_t> tolerance;  ///< channel of the truth
    bool exact = false;   ///< promised by the truth: id, count and A, unless a rule is given for the channel
    bool cyclic = false;  ///< uv of a truth: 0 and 1 are the same place

    /// Whether the truth leaves open what this value is.
    [[nodiscard]] bool marginal(std::span<const float> expectedPixel) const;

    /// What the value may be off here: the larger of the rule's limit and the truth's tolerance. A tolerance
    /// below 0 allows nothing.
    [[nodiscard]] double limit(std::span<const float> expectedPixel) const;

    /// |actual - expected| in double precision; round the circle where it is one.
    [[nodiscard]] double difference(std::span<const float> expectedPixel,
                                    std::span<const float> actualPixel) const;
};

/// A judge for every value channel, in the order of the expected image, matched by name. Empty when the
/// images cannot be compared: another size, sample type or set of channels. Of a truth the actual image needs
/// the value channels only; when it has all channels of the truth it is a truth itself, and the two are
/// compared as plain images.
[[nodiscard]] std::vector<ChannelJudge> channelJudges(const image::Image& expected,
                                                      const image::Image& actual, const CompareRules& rules);

}  // namespace raytorus::compare
