// SPDX-License-Identifier: MIT
#include "bench/against.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "bench/summary.hpp"
#include "bench/table.hpp"
#include "bench/timed_method.hpp"

namespace raytorus::bench {
namespace {

double magnitude(const Change& change) {
    return std::abs(std::log(change.factor()));
}

std::string machineNote(const ReferenceTable& reference, const Machine& machine) {
    std::string note;
    const auto compare = [&note](const char* what, const std::string& then, const std::string& now) {
        if (then != now) {
            note += fmt::format("another {}: then \"{}\", now \"{}\"\n", what, then, now);
        }
    };
    compare("device", reference.device, machine.device);
    compare("driver", reference.driver, machine.driver);
    compare("LP_NUM_THREADS", reference.lavapipeThreads, machine.lavapipeThreads);
    return note;
}

std::string changeText(const Change& change) {
    return fmt::format("  {:<26} {:<8} {:<21} {:>7} {:>7}  {:>+6.1f} %{}\n", change.workload, change.query,
                       change.method, ratioText(change.before), ratioText(change.now),
                       100.0 * (change.factor() - 1.0), change.becameWrong ? "  now wrong" : "");
}

}  // namespace

std::vector<Change> compareWith(const ReferenceTable& reference, const BenchRun& run) {
    std::map<std::tuple<std::string, std::string, std::string>, const ReferenceRow*> rows;
    for (const ReferenceRow& row : reference.rows) {
        rows[{row.workload, row.query, row.method}] = &row;
    }
    std::vector<Change> changes;
    for (const CellResult& cell : run.cells) {
        for (const MethodResult& method : cell.methods) {
            const auto found = rows.find({cell.workload.name(), nameOf(cell.query), method.name});
            const Times& now = method.times;
            if (found == rows.end() || method.name == emptyName) {
                continue;
            }
            const ReferenceRow& then = *found->second;
            // Of the others, many are wrong on a ray in 10 000: with other rays, once more or once less.
            const bool becameWrong = method.name == ourName && then.wrong == 0 && !method.correctness.right();
            const bool comparable = method.name != ourName && then.ratio > 0.0 && now.ratio > 0.0;
            if (!comparable && !becameWrong) {
                continue;
            }
            Change change;
            change.workload = cell.workload.name();
            change.query = nameOf(cell.query);
            change.method = method.name;
            change.otherRays = then.rays != cell.rays;
            change.becameWrong = becameWrong;
            if (comparable) {
                change.before = then.ratio;
                change.now = now.ratio;
                const double room = 1.0 + runToRun;
                const bool apart = now.lowerQuartile > then.upperQuartile * room ||
                                   now.upperQuartile < then.lowerQuartile / room;
                change.leftSpread = apart && std::max(change.factor(), 1.0 / change.factor()) > room;
            }
            changes.push_back(change);
        }
    }
    return changes;
}

std::string againstText(const ReferenceTable& reference, const BenchRun& run) {
    std::vector<Change> changes = compareWith(reference, run);
    std::string text = fmt::format("against {}\n{}", reference.file, machineNote(reference, run.machine));
    if (changes.empty()) {
        return text + "it has no cell and method in common with this run\n";
    }
    if (std::ranges::any_of(changes, &Change::otherRays)) {
        text += "another number of rays: neighbours lie closer together, or further apart (see --rays)\n";
    }
    std::map<std::string, std::vector<double>> factors;
    for (const Change& change : changes) {
        factors[change.method].push_back(change.factor());
    }
    std::ranges::stable_sort(changes,
                             [](const Change& a, const Change& b) { return magnitude(a) > magnitude(b); });
    const std::size_t all = changes.size();
    std::erase_if(changes, [](const Change& change) { return !change.leftSpread && !change.becameWrong; });
    text += fmt::format("{} of {} ratios left their spread\n", changes.size(), all);
    if (!changes.empty()) {
        text += fmt::format("  {:<26} {:<8} {:<21} {:>7} {:>7}  {:>8}\n", "workload", "query", "ours/it",
                            "then", "now", "change");
    }
    for (const Change& change : changes) {
        text += changeText(change);
    }
    text += "mean change of ours/it; negative: the library gained on it\n";
    for (const auto& [name, values] : factors) {
        text += fmt::format("  {:<21} {:>+6.1f} %\n", name, 100.0 * (geometricMean(values) - 1.0));
    }
    return text;
}

}  // namespace raytorus::bench
