// SPDX-License-Identifier: MIT
#include "bench/table.hpp"

#include <fmt/format.h>

#include "bench/timed_method.hpp"

namespace raytorus::bench {
namespace {

// "!" marks who is wrong: its time is no time for the task.
std::string rowText(const MethodResult& method) {
    const Times& times = method.times;
    std::string row = fmt::format("  {:<21} {:>8.2f} {:>8.2f} {:>8.2f}  {:>6} {:>6} - {:<6}", method.name,
                                  times.minimum, times.median, times.netMinimum, ratioText(times.ratio),
                                  ratioText(times.lowerQuartile), ratioText(times.upperQuartile));
    if (method.name != emptyName) {
        const Correctness& correctness = method.correctness;
        row += fmt::format(" {} {:>6} {:>6} {:>8.1e}", correctness.right() ? ' ' : '!', correctness.wrong,
                           correctness.gross, correctness.positionP99);
    }
    return row + (method.checksumHeld ? "\n" : "  runs differ\n");
}

}  // namespace

std::string ratioText(double ratio) {
    return ratio > 0.0 ? fmt::format("{:.{}f}", ratio, ratio < 1.0 ? 3 : 2) : "-";
}

std::string tableText(const CellResult& cell) {
    const std::size_t judged = cell.methods.empty() ? 0 : cell.methods.back().correctness.judged;
    std::string text = fmt::format("{} {}: {:.1f} % of {} rays hit, {} judged\n", cell.workload.name(),
                                   nameOf(cell.query), 100.0 * cell.hitPart, cell.rays, judged);
    text += fmt::format("  {:<21} {:>8} {:>8} {:>8}  {:>6} {:>6} - {:<6}   {:>6} {:>6} {:>8}\n", "method",
                        "ns/ray", "median", "net", "ours/it", "q1", "q3", "wrong", "gross", "p99");
    for (const MethodResult& method : cell.methods) {
        text += rowText(method);
    }
    return text;
}

}  // namespace raytorus::bench
