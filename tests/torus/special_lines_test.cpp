// SPDX-License-Identifier: MIT
// Lines in special positions, through the real SPIR-V.
#include "support/special_lines.hpp"

#include <gtest/gtest.h>

#include "hit_judge.hpp"
#include "support/device_fixture.hpp"

namespace raytorus::test {
namespace {

// Fails for each line, or neighbour of it, with a wrong answer.
void expectRight(const std::vector<SpecialLines>& lines) {
    for (const SpecialLines& some : lines) {
        HitJudge judge(some.rays.size());
        for (const std::string& fault : judge.mismatches(some.torus, some.rays)) {
            EXPECT_EQ(fault, "");
        }
    }
}

using LinesInSpecialPositions = DeviceTest;

TEST_F(LinesInSpecialPositions, TouchTheEquators) {
    expectRight(touchTheEquators());
}

TEST_F(LinesInSpecialPositions, TouchTheTopCircle) {
    expectRight(touchTheTopCircle());
}

TEST_F(LinesInSpecialPositions, RunInVillarceausPlanes) {
    expectRight(runInVillarceausPlanes());
}

TEST_F(LinesInSpecialPositions, RunAlongTheAxisOrBesideIt) {
    expectRight(runAlongTheAxisOrBesideIt());
}

TEST_F(LinesInSpecialPositions, MeetTheTipOfAHorn) {
    expectRight(meetTheTipOfAHorn());
}

TEST_F(LinesInSpecialPositions, MeetTheDimplesOfASpindle) {
    expectRight(meetTheDimplesOfASpindle());
}

TEST_F(LinesInSpecialPositions, HaveHitsManyDecadesApartOrInOneFloat) {
    expectRight(haveHitsManyDecadesApartOrInOneFloat());
}

TEST_F(LinesInSpecialPositions, EndBesideACrossing) {
    expectRight(endBesideACrossing());
}

TEST_F(LinesInSpecialPositions, RunAlongThinTubes) {
    expectRight(runAlongThinTubes());
}

TEST_F(LinesInSpecialPositions, CrossAtSmallAngles) {
    expectRight(crossAtSmallAngles());
}

TEST_F(LinesInSpecialPositions, LeaveThinTubesWhereTheyAreNearestToTheAxis) {
    expectRight(leaveThinTubesWhereTheyAreNearestToTheAxis());
}

}  // namespace
}  // namespace raytorus::test
