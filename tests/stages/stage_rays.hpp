// SPDX-License-Identifier: MIT
// Random rays for the tests of the solver's stages, and each ray's line as it is exactly.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "reference/random.hpp"
#include "reference/real.hpp"
#include "stages_cxx.hpp"

namespace raytorus::test {

struct Trial {
    reference::Torus torus{};
    reference::Ray ray{};

    /// All that replays it.
    [[nodiscard]] std::string text() const;
};

/// Rings, horns, spindles: r / R from the thinnest to nearly a sphere, and a sphere (0 for R).
std::span<const reference::Torus> everySort();

/// The index-th ray of this run: a torus of everySort in some size, a ray of any class, from the torus' size
/// to `farthest` times as far.
Trial freshTrial(std::uint64_t index, double farthest);

/// A stream of numbers that belongs to the index-th trial.
reference::Random freshNumbers(std::uint64_t index);

using Long = long double;

/// The line of a ray in the library's unit and parameter u. Reduced in 113 bits, and then in the 64 of long
/// double: near the torus those are 2^-40 of what float32 holds.
class ExactLine {
public:
    ExactLine(const Trial& trial, const LineStage& line);

    [[nodiscard]] std::array<Long, 3> point(Long u) const;
    /// (math.md, eq. 24)
    [[nodiscard]] Long tube(Long u) const;
    /// (math.md, eq. 28): positive outside of a ring.
    [[nodiscard]] Long f(Long u) const;
    /// Half of its derivative.
    [[nodiscard]] Long h(Long u) const;
    /// -1 in the solid, 1 outside.
    [[nodiscard]] float side(Long u) const;

    /// Whether it passes the tip of a horn or of a spindle's dimple by r / 20 or less, or crosses the surface
    /// as near to the axis. There f is as flat as a square: the fast tier's float32 may see no crossing, or
    /// two.
    [[nodiscard]] bool meetsATip() const;

    Long R, r, length2, foot2;
    std::array<Long, 3> foot{}, direction{};  ///< where u = 0, and where it leads
    Long b1, edge;
    /// Where the line crosses the outer sheet, ascending: the reference's, of the whole line.
    std::vector<Long> roots;
    double clearance;  ///< of the line, in r: see the reference
};

/// u of a t of the ray.
Long parameterOf(const LineStage& line, reference::Quad t);

/// A place of the clipped line: anywhere, or as often some 1e-9 to 0.1 of r before or behind a crossing.
float anyPlace(const LineStage& line, const ExactLine& exact, reference::Random& random);

/// A fixture for tests of both tiers.
class OfBothTiers : public testing::TestWithParam<const Tier*> {
protected:
    static const Tier& tier() { return *GetParam(); }
};

inline std::string nameOfTier(const testing::TestParamInfo<const Tier*>& row) {
    return row.param->name;
}

}  // namespace raytorus::test
