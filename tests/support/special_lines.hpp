// SPDX-License-Identifier: MIT
// Lines in special positions: exact tangents and their neighbours, Villarceau's planes, the axis, the tip of
// a horn, the dimples of a spindle, hits whose distances are decades apart, ends beside a crossing, thin
// tubes from end to end and across, small angles. Each is judged by the reference (hit_match.hpp), however
// near to a tangent; an exact tangent may have both its hits or neither, but the functions must agree.
#pragma once

#include <span>
#include <vector>

#include "reference/rays.hpp"

namespace raytorus::test {

/// Lines at one torus: special ones, each followed by neighbours of which one number is moved by up to 4
/// floats.
struct SpecialLines {
    reference::Torus torus;
    std::vector<reference::Ray> rays;
};

std::vector<SpecialLines> touchTheEquators();
std::vector<SpecialLines> touchTheTopCircle();
std::vector<SpecialLines> runInVillarceausPlanes();
std::vector<SpecialLines> runAlongTheAxisOrBesideIt();
std::vector<SpecialLines> meetTheTipOfAHorn();
std::vector<SpecialLines> meetTheDimplesOfASpindle();
std::vector<SpecialLines> haveHitsManyDecadesApartOrInOneFloat();
std::vector<SpecialLines> endBesideACrossing();
std::vector<SpecialLines> runAlongThinTubes();
std::vector<SpecialLines> crossAtSmallAngles();
std::vector<SpecialLines> leaveThinTubesWhereTheyAreNearestToTheAxis();

struct SpecialLinesOf {
    const char* name;  ///< "lines that touch the equators"
    std::vector<SpecialLines> (*lines)();
};

/// All of them.
std::span<const SpecialLinesOf> allSpecialLines();

}  // namespace raytorus::test
