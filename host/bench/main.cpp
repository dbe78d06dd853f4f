// SPDX-License-Identifier: MIT
// raytorus-bench: verify, then time.
#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <optional>

#include "bench/against.hpp"
#include "bench/bench_options.hpp"
#include "bench/groups.hpp"
#include "bench/html.hpp"
#include "bench/isa.hpp"
#include "bench/json.hpp"
#include "bench/machine.hpp"
#include "bench/summary.hpp"
#include "bench/table.hpp"
#include "core/console.hpp"
#include "core/file.hpp"
#include "options/program.hpp"
#include "options/progress.hpp"
#include "trace/self_check.hpp"

namespace raytorus::bench {
namespace {

// Opened before the work, which can be long, so that a name that cannot be written costs nothing.
std::unique_ptr<OutputFile> openOutput(const std::string& name) {
    return name.empty() ? nullptr : std::make_unique<OutputFile>(name);
}

void writeTo(const std::unique_ptr<OutputFile>& file, const std::string& text) {
    if (file) {
        file->write(text);
        file->commit();
    }
}

ExitCode list(const BenchOptions& options) {
    print("workloads\n");
    for (const Workload& workload : options.workloads) {
        print("  {}\n", workload.name());
    }
    print("methods\n");
    for (const TimedMethod& method : options.methods) {
        print("  {:<21} {}\n", method.name, method.description);
    }
    return ExitCode::Ok;
}

ExitCode countCode(const BenchOptions& options) {
    const std::unique_ptr<OutputFile> json = openOutput(options.json);
    chooseNullDevice(options.family);
    options::withDevice(options.device, [&](gpu::Context& context) {
        print("{} ({} {}), one ray in, one answer out\n\n", context.info().name, context.info().driverName,
              context.info().driverInfo);
        const std::vector<IsaRow> rows = countInstructions(context, options.methods, options.queries);
        print("{}", isaText(rows));
        writeTo(json, isaJson(context.info(), rows));
    });
    return ExitCode::Ok;
}

ExitCode countGroups(const BenchOptions& options) {
    const std::unique_ptr<OutputFile> json = openOutput(options.json);
    const std::optional<PartCosts> costs = countParts(options.family);
    options::withDevice(options.device, [&](gpu::Context& context) {
        print("{} ({} {}), nearest hits, seed {}\n\n", context.info().name, context.info().driverName,
              context.info().driverInfo, options.measure.seed);
        options::Progress progress("counting");
        const std::vector<GroupRow> rows =
            measureGroups(context, {options.measure.seed, options.measure.side}, costs,
                          [&](double part) { progress.show(part); });
        print("{}", groupsText(rows, costs));
        writeTo(json, groupsJson(context.info(), options.measure.seed, rows, costs));
    });
    return ExitCode::Ok;
}

// Who needs what the device does not have is left out, in words.
std::vector<TimedMethod> methodsFor(gpu::Context& context, std::vector<TimedMethod> methods) {
    std::erase_if(methods, [&context](const TimedMethod& method) {
        std::string missing;
        if (method.needs == Needs::Float64 && !context.hasFloat64()) {
            missing = "has no shaderFloat64";
        } else if (method.needs == Needs::FusedFma && !trace::selfCheck(context).fusedFma) {
            missing = "has an fma() that rounds twice";
        }
        if (!missing.empty()) {
            print("{} is left out: {} {}\n", method.name, context.info().name, missing);
        }
        return !missing.empty();
    });
    return methods;
}

BenchRun measureAll(gpu::Context& context, const BenchOptions& options) {
    BenchRun run{describeMachine(context), options.measure.seed, options.measure.rounds, {}};
    print("{}\nseed {}, {} rounds\n", machineText(run.machine), run.seed, run.rounds);
    Measurer measurer(context, methodsFor(context, options.methods), options.measure);
    options::Progress progress("timing");
    for (std::size_t i = 0; i < options.workloads.size(); ++i) {
        const auto show = [&](double part) {
            progress.show((static_cast<double>(i) + part) / static_cast<double>(options.workloads.size()));
        };
        for (CellResult& cell : measurer.measure(options.workloads[i], options.queries, show)) {
            print("\n{}", tableText(cell));
            flushOutput();
            run.cells.push_back(std::move(cell));
        }
    }
    return run;
}

ExitCode measure(const BenchOptions& options) {
    std::optional<ReferenceTable> reference;
    if (!options.against.empty()) {
        reference = readReference(options.against);
    }
    const std::unique_ptr<OutputFile> json = openOutput(options.json);
    const std::unique_ptr<OutputFile> html = openOutput(options.html);
    std::vector<std::string> faults;
    options::withDevice(options.device, [&](gpu::Context& context) {
        const BenchRun run = measureAll(context, options);
        print("\n{}\n{}", steadinessText(run), summaryText(run));
        const std::vector<Aim> aims = measureAims(run);
        if (!aims.empty()) {
            print("\n{}", aimsText(aims));
        }
        if (reference) {
            print("\n{}", againstText(*reference, run));
        }
        writeTo(json, runJson(run));
        writeTo(html, runHtml(run));
        faults = libraryFaults(run);
        for (const std::string& fault : faults) {
            print("{}\n", fault);
        }
    });
    return faults.empty() ? ExitCode::Ok : ExitCode::ComparisonFailed;
}

ExitCode run(const BenchOptions& options) {
    if (options.list) {
        return list(options);
    }
    if (options.groups) {
        return countGroups(options);
    }
    return options.isa ? countCode(options) : measure(options);
}

}  // namespace
}  // namespace raytorus::bench

int main(int argc, char** argv) {
    using namespace raytorus;
    return options::exitStatus(options::runProgram(bench::programName, [&] {
        const auto options = bench::parseOptions({argv + 1, argv + argc});
        return options ? bench::run(*options) : ExitCode::Ok;
    }));
}
