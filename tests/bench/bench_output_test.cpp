// SPDX-License-Identifier: MIT
// What is written of a run: text, JSON that can be read again, a page with a mark for every workload.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "bench/html.hpp"
#include "bench/json.hpp"
#include "bench/plot.hpp"
#include "bench/summary.hpp"
#include "bench/table.hpp"
#include "bench_run.hpp"
#include "support/count_of.hpp"
#include "support/expect_error.hpp"
#include "support/scratch_folder.hpp"

namespace raytorus::bench {
namespace {

using nlohmann::json;
using test::countOf;
using test::madeUpRun;

TEST(BenchJson, HoldsEveryNumberOfTheRun) {
    const json table = json::parse(runJson(madeUpRun(0.5)));
    EXPECT_EQ(table.at("format"), "raytorus-bench");
    EXPECT_EQ(table.at("version"), 1);
    EXPECT_EQ(table.at("seed"), 42);
    EXPECT_EQ(table.at("rounds"), 9);
    const json machine = table.at("machine");
    EXPECT_EQ(machine.at("device"), "Some <GPU>");
    EXPECT_EQ(machine.at("driver"), "driver 1.2");
    EXPECT_EQ(machine.at("lavapipeThreads"), "1");
    EXPECT_EQ(machine.at("clock"), "wall");
    ASSERT_EQ(table.at("cells").size(), 4U);
    const json& cell = table.at("cells").at(1);
    EXPECT_EQ(cell.at("workload"), "tiles/0.25/near/30");
    EXPECT_EQ(cell.at("query"), "any");
    EXPECT_EQ(cell.at("hitPart"), 0.301);
    EXPECT_EQ(cell.at("rays"), 4096);
    EXPECT_EQ(cell.at("methods").size(), 4U);
    const json& method = cell.at("methods").at("closed-form-common");
    EXPECT_EQ(method.at("min"), 21.0);
    EXPECT_EQ(method.at("median"), 21.5);
    EXPECT_EQ(method.at("net"), 20.0);
    EXPECT_EQ(method.at("ratio"), 0.5);
    EXPECT_EQ(method.at("quartiles"), json({0.49, 0.5, 0.51}));
    EXPECT_EQ(method.at("judged"), 1000);
    EXPECT_EQ(method.at("wrong"), 0);
    EXPECT_EQ(method.at("gross"), 0);
    EXPECT_EQ(method.at("p99"), 5e-8);
    EXPECT_EQ(method.at("layers"), 2);
    EXPECT_EQ(method.at("checksumHeld"), true);
    EXPECT_EQ(method.size(), 11U) << "nothing that this test has not seen";
    EXPECT_EQ(cell.at("methods").at("ray-sphere").at("wrong"), 100);
}

TEST(BenchJson, IsReadAgain) {
    const std::filesystem::path path = test::scratchFolder() / "table.json";
    test::writeText(path, runJson(madeUpRun(0.5)));
    const ReferenceTable table = readReference(path);
    EXPECT_EQ(table.device, "Some <GPU>");
    EXPECT_EQ(table.driver, "driver 1.2");
    EXPECT_EQ(table.lavapipeThreads, "1");
    ASSERT_EQ(table.rows.size(), 16U);
    const auto found = std::ranges::find_if(table.rows, [](const ReferenceRow& row) {
        return row.workload == "scattered/0.25/near/30" && row.query == "any" && row.method == "ray-sphere";
    });
    ASSERT_NE(found, table.rows.end());
    EXPECT_DOUBLE_EQ(found->ratio, 10.0);
    EXPECT_DOUBLE_EQ(found->lowerQuartile, 9.8);
    EXPECT_DOUBLE_EQ(found->upperQuartile, 10.2);
    EXPECT_EQ(found->wrong, 100U);
}

TEST(BenchJson, IsRefusedInAnotherFormat) {
    const std::filesystem::path path = test::scratchFolder() / "table.json";
    const auto expectRefused = [&path](const std::string& text, std::initializer_list<std::string> words) {
        test::writeText(path, text);
        test::expectError([&] { readReference(path); }, ExitCode::File, words);
    };
    expectRefused("{\"format\": ", {"table.json", "not JSON"});
    expectRefused("[1, 2]", {"table.json", "no table that raytorus-bench --json has written"});
    expectRefused("{\"format\": \"raytorus-bench-isa\"}",
                  {"no table that raytorus-bench --json has written"});
    expectRefused("{\"format\": \"raytorus-bench\", \"version\": 7}", {"version 7", "1 is wanted"});
    expectRefused("{\"format\": \"raytorus-bench\"}", {"version null", "1 is wanted"});
    json table = json::parse(runJson(madeUpRun(0.5)));
    table["cells"][2]["methods"]["raytorus"].erase("quartiles");
    expectRefused(table.dump(), {"table.json", "incomplete"});
    table = json::parse(runJson(madeUpRun(0.5)));
    table["machine"].erase("device");
    expectRefused(table.dump(), {"incomplete"});
    test::expectError([&] { readReference(path.parent_path() / "none.json"); }, ExitCode::File,
                      {"none.json"});
}

TEST(BenchTable, MarksWhoIsWrong) {
    BenchRun run = madeUpRun(0.5);
    run.cells[0].methods[2].checksumHeld = false;
    const std::string text = tableText(run.cells[0]);
    EXPECT_NE(text.find("tiles/0.25/near/30 nearest: 30.1 % of 4096 rays hit, 1000 judged"),
              std::string::npos)
        << text;
    EXPECT_EQ(countOf(text, " ! "), 1U) << text;
    EXPECT_LT(text.find("ray-sphere"), text.find(" ! "));
    EXPECT_EQ(countOf(text, "runs differ"), 1U) << text;
    EXPECT_LT(text.find("closed-form-common"), text.find("runs differ"));
}

TEST(BenchSummary, HoldsTheAimsAgainstTheRatios) {
    BenchRun run = madeUpRun(0.5);
    run.cells[2].methods[2].times.ratio = 2.0;  // scattered, nearest
    const std::vector<Aim> aims = measureAims(run);
    // Of scattered rays with 50 % hits, sphere tracing and Newton there are none.
    ASSERT_EQ(aims.size(), 3U);
    EXPECT_EQ(aims[0].measured, std::vector<double>{0.5}) << aims[0].text;
    EXPECT_EQ(aims[1].measured, (std::vector<double>{0.5, 0.5})) << "any-hit over nearest";
    EXPECT_EQ(aims[2].measured, std::vector<double>{10.0}) << "the sphere";
    EXPECT_EQ(aims[2].worstWorkload, "tiles/0.25/near/30");
    const std::string text = aimsText(aims);
    EXPECT_NE(text.find("1 of 1"), std::string::npos) << text;
    EXPECT_NE(text.find("2 of 2"), std::string::npos) << text;
    EXPECT_NE(text.find("0 of 1"), std::string::npos) << text;
    // 100 of 1000 of the sphere's answers.
    EXPECT_NE(summaryText(run).find("10.000 %"), std::string::npos) << summaryText(run);
    EXPECT_DOUBLE_EQ(geometricMean({1.0, 4.0}), 2.0);
    EXPECT_EQ(geometricMean({}), 0.0);
}

TEST(BenchSummary, NamesTheFaultsOfTheLibraryAlone) {
    BenchRun run = madeUpRun(0.5);
    EXPECT_TRUE(libraryFaults(run).empty()) << "the sphere is wrong, and that is no fault of ours";
    run.cells[1].methods[1].correctness.gross = 3;
    run.cells[2].methods[1].checksumHeld = false;
    EXPECT_EQ(libraryFaults(run),
              (std::vector<std::string>{"tiles/0.25/near/30 any: the library is wrong on 3 of 1000 rays",
                                        "scattered/0.25/near/30 nearest: runs of the library differ"}));
}

TEST(BenchSummary, SaysWhenTheMachineWasBusy) {
    BenchRun run = madeUpRun(0.5);
    EXPECT_EQ(steadinessText(run), "0 of 8 ratios have quartiles more than 10 % apart\n");
    run.cells[0].methods[2].times.upperQuartile = 0.6;
    EXPECT_EQ(steadinessText(run),
              "1 of 8 ratios have quartiles more than 10 % apart: the machine was busy, trust "
              "the minima alone\n");
}

TEST(BenchSummary, LeavesStreamsOut) {
    BenchRun run = madeUpRun(0.5);
    for (CellResult& cell : run.cells) {
        cell.workload.mode = Mode::Streamed;
    }
    EXPECT_TRUE(measureAims(run).empty());
    EXPECT_EQ(countOf(ratioPlot(run, trace::Query::Nearest), "<circle"), 0U);
}

TEST(BenchPage, HasAMarkForEachWorkloadOfEachMethod) {
    const std::string page = runHtml(madeUpRun(0.5));
    EXPECT_EQ(countOf(page, "<svg"), 2U) << "nearest and any";
    EXPECT_EQ(countOf(page, "</svg>"), 2U);
    EXPECT_EQ(countOf(page, "<circle"), 4U) << "closed-form-common in each cell";
    EXPECT_EQ(countOf(page, "class=\"tiles bad\"") + countOf(page, "class=\"scattered bad\""), 4U)
        << "and the sphere, which is wrong";
    EXPECT_NE(page.find("tiles/0.25/near/30: 2.00 of our time, 0 of 1000 wrong"), std::string::npos);
    EXPECT_NE(page.find("Some &lt;GPU&gt;"), std::string::npos);
    EXPECT_EQ(page.find("<GPU>"), std::string::npos);
    EXPECT_EQ(page.find("src="), std::string::npos) << "nothing is loaded";
    EXPECT_EQ(page.find("nan"), std::string::npos);
    EXPECT_EQ(page.find("inf"), std::string::npos);
}

}  // namespace
}  // namespace raytorus::bench
