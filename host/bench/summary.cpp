// SPDX-License-Identifier: MIT
#include "bench/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "bench/table.hpp"
#include "bench/timed_method.hpp"

namespace raytorus::bench {
namespace {

using trace::Query;

constexpr double wideSpread = 1.1;

bool isMade(const CellResult& cell) {
    return cell.workload.mode == Mode::Made;
}

std::string meanOf(const BenchRun& run, const std::string& name, Pattern pattern, Query query) {
    std::vector<double> ratios;
    for (const CellResult& cell : run.cells) {
        const MethodResult* method = findMethod(cell, name);
        if (isMade(cell) && cell.workload.pattern == pattern && cell.query == query && method != nullptr &&
            method->times.ratio > 0.0) {
            ratios.push_back(method->times.ratio);
        }
    }
    return ratioText(geometricMean(ratios));
}

// The part of all judged answers that were wrong or gross.
double wrongPart(const BenchRun& run, const std::string& name) {
    double judged = 0.0;
    double wrong = 0.0;
    for (const CellResult& cell : run.cells) {
        const MethodResult* method = findMethod(cell, name);
        if (method != nullptr) {
            judged += static_cast<double>(method->correctness.judged);
            wrong += static_cast<double>(method->correctness.wrong + method->correctness.gross);
        }
    }
    return judged > 0.0 ? wrong / judged : 0.0;
}

void add(Aim& aim, const CellResult& cell, double ratio) {
    if (ratio <= 0.0) {
        return;
    }
    aim.measured.push_back(ratio);
    if (ratio > aim.worst) {
        aim.worst = ratio;
        aim.worstWorkload = cell.workload.name();
    }
}

// Nearest hits, against one method, in the workloads that `about` picks.
Aim peerAim(const BenchRun& run, const char* text, double limit, const char* peer,
            const std::function<bool(const Workload&)>& about) {
    Aim aim{text, limit, {}, 0.0, ""};
    for (const CellResult& cell : run.cells) {
        const MethodResult* method = findMethod(cell, peer);
        if (isMade(cell) && cell.query == Query::Nearest && method != nullptr && about(cell.workload)) {
            add(aim, cell, method->times.ratio);
        }
    }
    return aim;
}

Aim anyAim(const BenchRun& run) {
    Aim aim{"raytorus itself: any-hit over nearest", 0.8, {}, 0.0, ""};
    for (const CellResult& any : run.cells) {
        const auto nearest = std::ranges::find_if(run.cells, [&any](const CellResult& cell) {
            return cell.query == Query::Nearest && cell.workload.name() == any.workload.name();
        });
        if (!isMade(any) || any.query != Query::Any || nearest == run.cells.end()) {
            continue;
        }
        const MethodResult* ourAny = findMethod(any, ourName);
        const MethodResult* ourNearest = findMethod(*nearest, ourName);
        if (ourAny != nullptr && ourNearest != nullptr && ourNearest->times.netMinimum > 0.0) {
            add(aim, any, ourAny->times.netMinimum / ourNearest->times.netMinimum);
        }
    }
    return aim;
}

}  // namespace

const MethodResult* findMethod(const CellResult& cell, std::string_view name) {
    const auto found = std::ranges::find(cell.methods, name, &MethodResult::name);
    return found == cell.methods.end() ? nullptr : &*found;
}

double geometricMean(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) {
        sum += std::log(value);
    }
    return values.empty() ? 0.0 : std::exp(sum / static_cast<double>(values.size()));
}

std::string steadinessText(const BenchRun& run) {
    std::size_t ratios = 0;
    std::size_t wide = 0;
    for (const CellResult& cell : run.cells) {
        for (const MethodResult& method : cell.methods) {
            if (method.name != ourName && method.times.lowerQuartile > 0.0) {
                ++ratios;
                wide += method.times.upperQuartile > wideSpread * method.times.lowerQuartile ? 1U : 0U;
            }
        }
    }
    return fmt::format("{} of {} ratios have quartiles more than {:.0f} % apart{}\n", wide, ratios,
                       100.0 * (wideSpread - 1.0),
                       20 * wide > ratios ? ": the machine was busy, trust the minima alone" : "");
}

std::string summaryText(const BenchRun& run) {
    std::string text =
        fmt::format("{:<23} {:^23}  {:^23}\n", "ours/it, geometric mean", "tiles", "scattered");
    text += fmt::format("{:<23} {:>7} {:>7} {:>7}  {:>7} {:>7} {:>7}  {:>9}\n", "", "nearest", "any", "all",
                        "nearest", "any", "all", "wrong");
    for (const TimedMethod& method : timedMethods()) {
        const bool present = std::ranges::any_of(run.cells, [&method](const CellResult& cell) {
            return findMethod(cell, method.name) != nullptr;
        });
        if (!present || method.name == emptyName || method.name == ourName) {
            continue;
        }
        text += fmt::format("  {:<21}", method.name);
        for (const Pattern pattern : {Pattern::Tiles, Pattern::Scattered}) {
            for (const Query query : allQueries) {
                text += fmt::format(" {:>7}", meanOf(run, method.name, pattern, query));
            }
            text += pattern == Pattern::Tiles ? " " : "";
        }
        text += fmt::format("  {:>7.3f} %\n", 100.0 * wrongPart(run, method.name));
    }
    return text + fmt::format("  {:<21} {:>59.3f} %\n", ourName, 100.0 * wrongPart(run, ourName));
}

std::vector<Aim> measureAims(const BenchRun& run) {
    const auto always = [](const Workload&) { return true; };
    std::vector<Aim> aims = {
        peerAim(run, "closed-form-common, tiles", 0.7, "closed-form-common",
                [](const Workload& workload) { return workload.pattern == Pattern::Tiles; }),
        peerAim(run, "closed-form-common, scattered, 50 %", 0.9, "closed-form-common",
                [](const Workload& workload) {
                    return workload.pattern == Pattern::Scattered && workload.hitPercent == 50;
                }),
        peerAim(run, "sphere-tracing (to 1e-4 r)", 0.3, "sphere-tracing", always),
        peerAim(run, "bracketed-newton", 0.5, "bracketed-newton", always),
        anyAim(run),
        peerAim(run, "ray-sphere, tiles, 30 %", 3.5, "ray-sphere",
                [](const Workload& workload) {
                    return workload.pattern == Pattern::Tiles && workload.hitPercent == 30;
                }),
    };
    std::erase_if(aims, [](const Aim& aim) { return aim.measured.empty(); });
    return aims;
}

std::vector<std::string> libraryFaults(const BenchRun& run) {
    std::vector<std::string> faults;
    for (const CellResult& cell : run.cells) {
        const MethodResult* ours = findMethod(cell, ourName);
        if (ours != nullptr && !ours->correctness.right()) {
            faults.push_back(fmt::format(
                "{} {}: the library is wrong on {} of {} rays", cell.workload.name(), nameOf(cell.query),
                ours->correctness.wrong + ours->correctness.gross, ours->correctness.judged));
        }
        if (ours != nullptr && !ours->checksumHeld) {
            faults.push_back(
                fmt::format("{} {}: runs of the library differ", cell.workload.name(), nameOf(cell.query)));
        }
    }
    return faults;
}

std::string aimsText(const std::vector<Aim>& aims) {
    std::string text = fmt::format("{:<40} {:>5} {:>7} {:>7}  {:<9} {}\n", "aim: our time over its", "limit",
                                   "mean", "worst", "held in", "worst at");
    for (const Aim& aim : aims) {
        const auto held =
            std::ranges::count_if(aim.measured, [&aim](double ratio) { return ratio <= aim.limit; });
        text += fmt::format("  {:<38} {:>5g} {:>7} {:>7}  {:<9} {}\n", aim.text, aim.limit,
                            ratioText(geometricMean(aim.measured)), ratioText(aim.worst),
                            fmt::format("{} of {}", held, aim.measured.size()), aim.worstWorkload);
    }
    return text;
}

}  // namespace raytorus::bench
