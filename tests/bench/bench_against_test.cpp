// SPDX-License-Identifier: MIT
// Two runs side by side: what changed is marked, what noise explains is not.
#include <gtest/gtest.h>

#include "bench/against.hpp"
#include "bench_run.hpp"
#include "support/scratch_folder.hpp"

namespace raytorus::bench {
namespace {

using test::madeUpRun;

ReferenceTable tableOf(const BenchRun& run) {
    const std::filesystem::path path = test::scratchFolder() / "then.json";
    test::writeText(path, runJson(run));
    return readReference(path);
}

std::size_t leftSpread(const std::vector<Change>& changes) {
    return static_cast<std::size_t>(std::ranges::count_if(changes, &Change::leftSpread));
}

TEST(BenchAgainst, FindsNothingInTheSameRun) {
    const BenchRun run = madeUpRun(0.5);
    const std::vector<Change> changes = compareWith(tableOf(run), run);
    EXPECT_EQ(changes.size(), 8U) << "two methods in four cells; the library is the baseline";
    EXPECT_EQ(leftSpread(changes), 0U);
    for (const Change& change : changes) {
        EXPECT_DOUBLE_EQ(change.factor(), 1.0);
    }
    const std::string text = againstText(tableOf(run), run);
    EXPECT_NE(text.find("0 of 8 ratios left their spread"), std::string::npos) << text;
    EXPECT_EQ(text.find("another"), std::string::npos) << text;
}

// Quartiles of 2 % to each side on both, and 5 % for another run: 9 % and a bit are within, more is not.
TEST(BenchAgainst, MarksWhatLeftTheSpread) {
    const ReferenceTable then = tableOf(madeUpRun(0.5));
    EXPECT_EQ(leftSpread(compareWith(then, madeUpRun(0.5 * 1.09))), 0U);
    EXPECT_EQ(leftSpread(compareWith(then, madeUpRun(0.5 * 1.10))), 4U);
    EXPECT_EQ(leftSpread(compareWith(then, madeUpRun(0.5 / 1.09))), 0U);
    EXPECT_EQ(leftSpread(compareWith(then, madeUpRun(0.5 / 1.10))), 4U);
    const std::string text = againstText(then, madeUpRun(0.4));
    EXPECT_NE(text.find("4 of 8 ratios left their spread"), std::string::npos) << text;
    EXPECT_NE(text.find("closed-form-common      0.500   0.400   -20.0 %"), std::string::npos) << text;
}

// One of the two alone is noise.
TEST(BenchAgainst, WantsMinimaAndQuartilesToHaveMoved) {
    const ReferenceTable then = tableOf(madeUpRun(0.5));
    BenchRun minima = madeUpRun(0.5);
    minima.cells[0].methods[2].times.ratio = 0.6;
    EXPECT_EQ(leftSpread(compareWith(then, minima)), 0U);
    BenchRun quartiles = madeUpRun(0.6);
    for (CellResult& cell : quartiles.cells) {
        cell.methods[2].times.ratio = 0.52;
    }
    EXPECT_EQ(leftSpread(compareWith(then, quartiles)), 0U);
    quartiles.cells[0].methods[2].times.ratio = 0.53;
    EXPECT_EQ(leftSpread(compareWith(then, quartiles)), 1U);
}

TEST(BenchAgainst, PutsTheGreatestChangeFirst) {
    const ReferenceTable then = tableOf(madeUpRun(0.5));
    BenchRun now = madeUpRun(0.6);
    Times& times = now.cells[3].methods[3].times;
    times.ratio = times.lowerQuartile = times.upperQuartile = 2.0;
    const std::string text = againstText(then, now);
    EXPECT_LT(text.find("-80.0 %"), text.find("+20.0 %")) << text;
}

TEST(BenchAgainst, SaysThatTheLibraryBecameWrong) {
    const ReferenceTable then = tableOf(madeUpRun(0.5));
    BenchRun now = madeUpRun(0.5);
    now.cells[0].methods[1].correctness.gross = 1;
    const std::string text = againstText(then, now);
    EXPECT_NE(text.find("now wrong"), std::string::npos) << text;
    EXPECT_EQ(againstText(tableOf(now), now).find("now wrong"), std::string::npos) << "it was before";
}

TEST(BenchAgainst, NamesAnotherMachine) {
    const ReferenceTable then = tableOf(madeUpRun(0.5));
    BenchRun now = madeUpRun(0.5);
    now.machine.driver = "driver 1.3";
    now.machine.lavapipeThreads = "";
    const std::string text = againstText(then, now);
    EXPECT_NE(text.find("another driver: then \"driver 1.2\", now \"driver 1.3\""), std::string::npos)
        << text;
    EXPECT_NE(text.find("another LP_NUM_THREADS: then \"1\", now \"\""), std::string::npos) << text;
    EXPECT_EQ(text.find("another device"), std::string::npos) << text;
    EXPECT_EQ(text.find("another number of rays"), std::string::npos) << text;
    now.cells[1].rays = 16384;
    EXPECT_NE(againstText(then, now).find("another number of rays"), std::string::npos);
}

TEST(BenchAgainst, SaysWhenThereIsNothingToCompare) {
    ReferenceTable then = tableOf(madeUpRun(0.5));
    then.rows.clear();
    EXPECT_NE(againstText(then, madeUpRun(0.5)).find("no cell and method in common"), std::string::npos);
}

}  // namespace
}  // namespace raytorus::bench
