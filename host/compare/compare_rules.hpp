// SPDX-License-Identifier: MIT
// How far an image may be from the one that was expected.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace raytorus::compare {

/// A value agrees when |actual - expected| <= limit(expected). The limit itself is still allowed.
struct CompareRule {
    double tolerance = 0.0;          ///< allowed absolute difference
    double relativeTolerance = 0.0;  ///< allowed difference relative to |expected|
    std::int64_t ulps = 0;  ///< allowed difference in ulpOf(expected); the largest of the three counts

    [[nodiscard]] double limit(float expected) const;
};

/// The distance from |value| to the next float32 further from 0, the largest float32 included.
[[nodiscard]] double ulpOf(float value);

/// What two images must keep to. As it stands: equal in every value.
struct CompareRules {
    CompareRule defaultRule;
    std::map<std::string, CompareRule, std::less<>>
        channelRules;                ///< by channel name, instead of the default
    std::int64_t allowedPixels = 0;  ///< pixels that may have a value over its limit
    int windowSize = 5;              ///< side of the square that tells a cluster from scattered pixels
    std::optional<std::int64_t> windowLimit;  ///< pixels over a limit that may lie in one such square
    std::optional<std::int64_t>
        allowedFlips;  ///< marginal pixels of a truth that may flip; unset: all of them

    [[nodiscard]] const CompareRule& ruleFor(std::string_view channelName) const;
};

/// Throws Error{ExitCode::Usage} when a number makes no sense (negative, not finite, an empty window) or a
/// rule is for a channel that is not among these, or flips are limited and there is no truth that knows of
/// any.
void checkRules(const CompareRules& rules, std::span<const std::string> channelNames, bool againstTruth);

}  // namespace raytorus::compare
