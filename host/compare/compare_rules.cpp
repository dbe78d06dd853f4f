// SPDX-License-Identifier: MIT
// How far an image may be from the one that was expected.
#include "compare/compare_rules.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"

namespace raytorus::compare {

namespace {

[[noreturn]] void fail(const std::string& sentence) {
    throw Error(ExitCode::Usage, sentence);
}

void checkTolerance(double value, std::string_view what) {
    // Written so that NaN is refused too.
    if (!(value >= 0.0 && value <= std::numeric_limits<double>::max())) {
        fail(fmt::format("the {} must be a finite number that is not negative, not {}", what, value));
    }
}

void checkRule(const CompareRule& rule, const std::string& where) {
    checkTolerance(rule.tolerance, "tolerance" + where);
    checkTolerance(rule.relativeTolerance, "relative tolerance" + where);
    if (rule.ulps < 0) {
        fail(fmt::format("the tolerance{} in ulps must not be negative, but is {}", where, rule.ulps));
    }
}

}  // namespace

double CompareRule::limit(float expected) const {
    const double inUlps = ulps > 0 ? static_cast<double>(ulps) * ulpOf(expected) : 0.0;
    return std::max({tolerance, relativeTolerance * std::abs(static_cast<double>(expected)), inUlps});
}

double ulpOf(float value) {
    using Limits = std::numeric_limits<float>;
    const int exponent =
        value == 0.0f ? Limits::min_exponent - 1 : std::max(std::ilogb(value), Limits::min_exponent - 1);
    return std::ldexp(1.0, exponent - (Limits::digits - 1));
}

const CompareRule& CompareRules::ruleFor(std::string_view channelName) const {
    const auto found = channelRules.find(channelName);
    return found == channelRules.end() ? defaultRule : found->second;
}

void checkRules(const CompareRules& rules, std::span<const std::string> channelNames, bool againstTruth) {
    checkRule(rules.defaultRule, "");
    for (const auto& [name, rule] : rules.channelRules) {
        checkRule(rule, fmt::format(" of channel {}", name));
        if (std::ranges::find(channelNames, name) == channelNames.end()) {
            fail(fmt::format("a tolerance is given for the channel {}, but the images have {}", name,
                             fmt::join(channelNames, ", ")));
        }
    }
    if (rules.allowedPixels < 0) {
        fail(
            fmt::format("the number of allowed pixels must not be negative, but is {}", rules.allowedPixels));
    }
    if (rules.windowSize < 1) {
        fail(fmt::format("the window must be at least 1 pixel wide, but is {}", rules.windowSize));
    }
    if (rules.allowedFlips && *rules.allowedFlips < 0) {
        fail(fmt::format("the number of allowed flips must not be negative, but is {}", *rules.allowedFlips));
    }
    if (rules.allowedFlips && !againstTruth) {
        fail(
            "the number of allowed flips is given, but the expected image does not say where a pixel may "
            "flip");
    }
    if (rules.windowLimit && *rules.windowLimit < 0) {
        fail(fmt::format("the window limit must not be negative, but is {}", *rules.windowLimit));
    }
}

}  // namespace raytorus::compare
