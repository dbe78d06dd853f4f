// SPDX-License-Identifier: MIT
#include "bench_run.hpp"

namespace raytorus::test {
namespace {

bench::MethodResult method(const char* name, double netMinimum, double ratio, std::size_t wrong) {
    bench::MethodResult result;
    result.name = name;
    result.times.minimum = netMinimum + 1.0;
    result.times.median = netMinimum + 1.5;
    result.times.netMinimum = netMinimum;
    result.times.ratio = ratio;
    result.times.lowerQuartile = 0.98 * ratio;
    result.times.middleRatio = ratio;
    result.times.upperQuartile = 1.02 * ratio;
    result.correctness.judged = 1000;
    result.layers = 2;
    result.correctness.wrong = wrong;
    result.correctness.positionP99 = 5e-8;
    return result;
}

}  // namespace

bench::BenchRun madeUpRun(double ratio) {
    bench::BenchRun run;
    run.machine = {"Some <GPU>", "driver 1.2", "discrete GPU", "1.3.0", "a processor", 4, "1", "wall"};
    run.seed = 42;
    run.rounds = 9;
    for (const bench::Pattern pattern : {bench::Pattern::Tiles, bench::Pattern::Scattered}) {
        for (const trace::Query query : {trace::Query::Nearest, trace::Query::Any}) {
            // Any-hit takes us half as long.
            const double ours = query == trace::Query::Nearest ? 20.0 : 10.0;
            bench::CellResult cell;
            cell.workload.pattern = pattern;
            cell.query = query;
            cell.hitPart = 0.301;
            cell.rays = 4096;
            cell.methods = {method("empty", 0.0, 0.0, 0), method("raytorus", ours, 1.0, 0),
                            method("closed-form-common", ours / ratio, ratio, 0),
                            method("ray-sphere", ours / 10.0, 10.0, 100)};
            run.cells.push_back(cell);
        }
    }
    return run;
}

}  // namespace raytorus::test
