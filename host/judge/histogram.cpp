// SPDX-License-Identifier: MIT
#include "judge/histogram.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace raytorus::judge {

std::size_t Histogram::binOf(double value) {
    if (value < std::ldexp(1.0, lowestExponent)) {
        return 0;
    }
    int exponent = 0;
    const double mantissa = 2.0 * std::frexp(value, &exponent);  // in [1, 2)
    const int octave = exponent - 1 - lowestExponent;
    if (octave >= octaves) {
        return binCount - 1;
    }
    const int part = static_cast<int>((mantissa - 1.0) * binsPerOctave);
    return 1 + static_cast<std::size_t>(octave * binsPerOctave + part);
}

double Histogram::upperEndOf(std::size_t bin) {
    if (bin == 0) {
        return std::ldexp(1.0, lowestExponent);
    }
    const int index = static_cast<int>(bin) - 1;
    return std::ldexp(1.0 + (index % binsPerOctave + 1.0) / binsPerOctave,
                      index / binsPerOctave + lowestExponent);
}

void Histogram::add(double value) {
    const double counted = value >= 0.0 ? value : std::numeric_limits<double>::infinity();
    ++counts[std::isfinite(counted) ? binOf(counted) : binCount - 1];
    ++total;
    largest = std::max(largest, counted);
}

void Histogram::merge(const Histogram& other) {
    for (std::size_t i = 0; i < binCount; ++i) {
        counts[i] += other.counts[i];
    }
    total += other.total;
    largest = std::max(largest, other.largest);
}

double Histogram::quantile(double part) const {
    const auto wanted = static_cast<std::uint64_t>(std::ceil(part * static_cast<double>(total)));
    std::uint64_t below = 0;
    for (std::size_t i = 0; i < binCount; ++i) {
        below += counts[i];
        if (below >= std::max<std::uint64_t>(wanted, 1)) {
            return std::min(upperEndOf(i), largest);
        }
    }
    return 0.0;
}

std::vector<Histogram::Bin> Histogram::bins() const {
    std::vector<Bin> filled;
    for (std::size_t i = 0; i < binCount; ++i) {
        if (counts[i] > 0) {
            filled.push_back({upperEndOf(i), counts[i]});
        }
    }
    return filled;
}

}  // namespace raytorus::judge
