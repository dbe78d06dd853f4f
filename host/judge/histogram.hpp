// SPDX-License-Identifier: MIT
// The distribution of many million errors: a count for each sixteenth of each power of two.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace raytorus::judge {

class Histogram {
public:
    /// A value that is not negative; anything else, NaN too, counts as the largest.
    void add(double value);
    void merge(const Histogram& other);

    [[nodiscard]] std::uint64_t count() const { return total; }
    /// Exact; 0 if empty.
    [[nodiscard]] double max() const { return largest; }
    /// The value below which `part` of the values lie, 0 to 1: the upper end of its bin, at most a sixteenth
    /// too large, and never above max(). 0 if empty.
    [[nodiscard]] double quantile(double part) const;

    struct Bin {
        double upperEnd;
        std::uint64_t count;
    };
    /// The bins that hold something, ascending.
    [[nodiscard]] std::vector<Bin> bins() const;

private:
    static constexpr int binsPerOctave = 16;
    static constexpr int lowestExponent = -64;  // below 2^-64: one bin, with 0
    static constexpr int octaves = 128;
    static constexpr std::size_t binCount = std::size_t{octaves} * binsPerOctave + 1;

    static std::size_t binOf(double value);
    static double upperEndOf(std::size_t bin);

    std::array<std::uint64_t, binCount> counts{};
    std::uint64_t total = 0;
    double largest = 0.0;
};

}  // namespace raytorus::judge
