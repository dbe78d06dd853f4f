// SPDX-License-Identifier: MIT
// The grid of workloads, their names, and views that have the part of hits that they were aimed for.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "bench/timed_method.hpp"
#include "bench/view.hpp"
#include "bench/workload.hpp"
#include "support/expect_error.hpp"
#include "support/patterns.hpp"
#include "support/scratch_folder.hpp"

namespace raytorus::bench {
namespace {

TEST(BenchWorkloads, CoverTheGridUnderDifferentNames) {
    std::set<std::string> names;
    std::size_t made = 0;
    for (const Workload& workload : allWorkloads()) {
        names.insert(workload.name());
        made += workload.mode == Mode::Made ? 1U : 0U;
    }
    EXPECT_EQ(made, 2U * 2U * 5U * 4U) << "patterns, distances, radii, parts of hits";
    EXPECT_EQ(names.size(), made + 2U) << "and a streamed one of each pattern";
    for (const char* name : {"tiles/0.01/near/5", "scattered/0.9/far/80", "tiles/0.25/near/50",
                             "stream-tiles/0.25/near/30", "stream-scattered/0.25/near/30"}) {
        EXPECT_TRUE(names.contains(name)) << name;
    }
}

TEST(BenchWorkloads, AreQuickInPart) {
    const std::vector<Workload> all = allWorkloads();
    const auto quick = std::ranges::count_if(all, isQuick);
    EXPECT_EQ(quick, 2 * 2 * 2 + 2);
    EXPECT_TRUE(std::ranges::any_of(all, [](const Workload& workload) {
        return isQuick(workload) && workload.name() == "scattered/0.5/near/50";
    }));
}

TEST(BenchWorkloads, AreChosenByPatterns) {
    const std::vector<std::string> patterns{"tiles/*/near/30", "*0.01/far/5"};
    EXPECT_TRUE(fits("tiles/0.5/near/30", patterns));
    EXPECT_TRUE(fits("scattered/0.01/far/5", patterns));
    EXPECT_FALSE(fits("stream-tiles/0.5/near/30", patterns)) << "a pattern is the whole name";
    EXPECT_FALSE(fits("tiles/0.5/far/30", patterns));
    EXPECT_TRUE(fits("anything", {}));
}

TEST(BenchMethods, AlwaysHaveTheEmptyOneAndTheLibrary) {
    const std::vector<std::string> names{"ray-sphere", "closed-form-common"};
    const std::vector<TimedMethod> chosen = chooseMethods(names);
    ASSERT_EQ(chosen.size(), 4U);
    EXPECT_EQ(chosen[0].name, emptyName);
    EXPECT_EQ(chosen[1].name, ourName);
    EXPECT_EQ(chosen[2].name, "closed-form-common") << "in the order of the table";
    EXPECT_EQ(chosen[3].name, "ray-sphere");
    EXPECT_EQ(chooseMethods({}).size(), timedMethods().size());
    test::expectError([] { chooseMethods(std::vector<std::string>{"magic"}); }, ExitCode::Usage,
                      {"--method", "\"magic\"", "bracketed-newton", "float64-quartic"});
}

TEST(BenchMethods, HaveARowEachInTheDocumentation) {
    const std::string page = test::fileText(RAYTORUS_SOURCE_DIR "/docs/benchmark.md");
    const std::string section = page.substr(page.find("\n## The methods\n"));
    std::set<std::string> documented{emptyName, ourName};
    for (const test::PatternMatch& row : test::matchesIn(section, R"(\n\| ([a-z0-9-]+) \|)")) {
        EXPECT_TRUE(documented.insert(row[1]).second) << row[1] << " is there twice";
    }
    std::set<std::string> timed;
    for (const TimedMethod& method : timedMethods()) {
        EXPECT_TRUE(timed.insert(method.name).second) << method.name << " is there twice";
    }
    EXPECT_EQ(documented, timed);
}

// A part of hits that falls from 1 to 0 as the opening grows, as that of a ball in a window does.
double partOf(double opening) {
    return 1.0 / (1.0 + opening * opening);
}

TEST(BenchViews, AreAimedForThePartOfHits) {
    for (const Workload& workload : allWorkloads()) {
        const double r = double{workload.minorRadius};
        const auto hitPart = [&](const RayView& view) {
            const double half =
                workload.pattern == Pattern::Scattered
                    ? double{view.spread}
                    : 32.0 * std::hypot(double{view.right[0]}, double{view.right[1]}, double{view.right[2]});
            return partOf(half / r);
        };
        const RayView view = aim(workload, 64, 1, hitPart);
        // Bisection ends within 1e-4 of the opening.
        EXPECT_NEAR(hitPart(view), 0.01 * workload.hitPercent, 1e-3) << workload.name();
    }
}

TEST(BenchViews, LookAtTheMiddleOfTheTubeFromTheDistance) {
    const Workload workload{Mode::Made, Pattern::Tiles, 0.25F, 1000.0, 30};
    const RayView view = makeView(workload, 64, 77, 0.01);
    double origin2 = 0.0;
    double aimed[3];
    for (std::size_t i = 0; i < 3; ++i) {
        origin2 += double{view.origin[i]} * double{view.origin[i]};
        aimed[i] = double{view.origin[i]} + double{view.corner[i]} +
                   31.5 * (double{view.right[i]} + double{view.up[i]});
    }
    // Sums of floats of about 1000.
    EXPECT_NEAR(std::sqrt(origin2), 1000.0, 1e-3);
    EXPECT_NEAR(std::hypot(aimed[0], aimed[1]), 1.0, 2e-4);
    EXPECT_NEAR(aimed[2], 0.0, 2e-4);
}

TEST(BenchViews, FollowFromTheSeed) {
    const Workload workload;
    EXPECT_EQ(makeView(workload, 64, 5, 1.0).origin[0], makeView(workload, 64, 5, 1.0).origin[0]);
    EXPECT_NE(makeView(workload, 64, 5, 1.0).origin[0], makeView(workload, 64, 6, 1.0).origin[0]);
    EXPECT_NE(makeView(workload, 64, 5, 1.0).seed, makeView(workload, 64, 6, 1.0).seed);
}

}  // namespace
}  // namespace raytorus::bench
