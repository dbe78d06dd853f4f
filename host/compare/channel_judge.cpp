// SPDX-License-Identifier: MIT
// What one channel of the actual image is held to, pixel by pixel.
#include "compare/channel_judge.hpp"

#include <algorithm>
#include <cmath>

#include "image/channels.hpp"

namespace raytorus::compare {

namespace {

std::optional<std::size_t> findChannel(const image::Image& image, std::string_view name) {
    const int index = image.channelIndex(name);
    return index < 0 ? std::nullopt : std::optional(static_cast<std::size_t>(index));
}

void applyPromise(ChannelJudge& judge, const image::Image& truth, bool hasRule) {
    const image::Quantity* const promise = image::findQuantity(judge.name);
    if (promise == nullptr || promise->isOfTruth()) {
        return;
    }
    judge.margin = findChannel(truth, promise->margin);
    judge.tolerance = findChannel(truth, promise->tolerance);
    judge.cyclic = promise->cyclic;
    if (promise->tolerance.empty() && !hasRule) {
        judge.exact = true;
        judge.rule = {};
    }
}

}  // namespace

bool isTruthChannel(std::string_view name) {
    const image::Quantity* const quantity = image::findQuantity(name);
    return quantity != nullptr && quantity->isOfTruth();
}

bool isTruth(const image::Image& image) {
    return std::ranges::any_of(image.channelNames, isTruthChannel);
}

bool ChannelJudge::marginal(std::span<const float> expectedPixel) const {
    return margin && expectedPixel[*margin] < 1.0f;
}

double ChannelJudge::limit(std::span<const float> expectedPixel) const {
    const double ruled = rule.limit(expectedPixel[expected]);
    return tolerance ? std::max(ruled, static_cast<double>(expectedPixel[*tolerance])) : ruled;
}

double ChannelJudge::difference(std::span<const float> expectedPixel,
                                std::span<const float> actualPixel) const {
    const double value = actualPixel[actual];
    const double distance = std::abs(value - static_cast<double>(expectedPixel[expected]));
    // Only a value on the circle is let round it: 2 is not the place 0.
    return cyclic && value >= 0.0 && value <= 1.0 ? std::min(distance, std::abs(1.0 - distance)) : distance;
}

std::vector<ChannelJudge> channelJudges(const image::Image& expected, const image::Image& actual,
                                        const CompareRules& rules) {
    if (expected.width != actual.width || expected.height != actual.height ||
        expected.sampleType != actual.sampleType) {
        return {};
    }
    const bool againstTruth = isTruth(expected) && expected.channelNames.size() != actual.channelNames.size();
    std::vector<ChannelJudge> judges;
    for (std::size_t channel = 0; channel < expected.channelNames.size(); ++channel) {
        const std::string& name = expected.channelNames[channel];
        if (againstTruth && isTruthChannel(name)) {
            continue;
        }
        const std::optional<std::size_t> index = findChannel(actual, name);
        if (!index) {
            return {};
        }
        ChannelJudge& judge = judges.emplace_back();
        judge.name = name;
        judge.expected = channel;
        judge.actual = *index;
        judge.rule = rules.ruleFor(name);
        if (againstTruth) {
            applyPromise(judge, expected, rules.channelRules.contains(name));
        }
    }
    return judges.size() == actual.channelNames.size() ? judges : std::vector<ChannelJudge>();
}

}  // namespace raytorus::compare
