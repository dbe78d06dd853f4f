// SPDX-License-Identifier: MIT
#include "bench/bench_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <limits>
#include <random>

#include "options/numbers.hpp"
#include "options/option_text.hpp"
#include "options/program.hpp"

namespace raytorus::bench {
namespace {

constexpr const char* footer =
    R"(Every method is first held to the reference on the very rays that are then timed: "wrong" counts verdicts, "gross"
positions off by more than 0.01 r, "p99" is the position error that 99 of 100 hits stay below, in R + r; ! marks whoever
is wrong. "net" is the time less that of making the rays (the method "empty"); "ours/it" compares net minima: below 1 the
library is faster; q1 and q3 are the quartiles of that ratio over the rounds. Nothing fails because of a time.

A workload's name: tiles or scattered / r/R / near (3 R) or far (1000 R) / percent of hits.

Examples:
  raytorus-bench --quick
  raytorus-bench --workload 'tiles/*/near/30' --method closed-form-common,ray-sphere --query nearest,any
  raytorus-bench --json now.json --html now.html --seed 7
  raytorus-bench --quick --against docs/performance/lavapipe-25.0.7.json
  raytorus-bench --isa
  raytorus-bench --groups --json groups.json
  LP_NUM_THREADS=1 raytorus-bench --device llvmpipe

Exit codes: 0 it ran, whatever the times and whoever is wrong; 2 the library was wrong on a ray, or runs of it differ; others
as of raytorus: 4 a file cannot be read or written, 5 wrong command line, 7 shader refused, 8 no device, 9 out of memory,
10 device lost, 11 validation message.)";

struct Texts {
    std::vector<std::string> workloads;
    std::vector<std::string> methods;
    std::vector<std::string> queries;
    bool quick = false;
    std::uint32_t rays = 0;
    unsigned rounds = 0;
};

void addOptions(CLI::App& app, BenchOptions& options, Texts& texts, CLI::Option*& seed) {
    app.add_option("--workload", texts.workloads, "Workloads, * for any characters")
        ->delimiter(',')
        ->option_text("NAME,... [all]");
    app.add_option("--method", texts.methods, "Methods beside the library")
        ->delimiter(',')
        ->option_text("NAME,... [all]");
    app.add_option("--query", texts.queries, "nearest, any, all")
        ->delimiter(',')
        ->option_text("NAME,... [nearest,any,all]");
    app.add_flag("--quick", texts.quick, "An eighth of the workloads, 9 rounds");
    app.add_option("--rays", texts.rays, "Different rays of a workload: 4096, 16384, 65536 or 262144")
        ->check(options::wholeNumber(4096, 262144) & CLI::IsMember({4096, 16384, 65536, 262144}))
        ->option_text("N [65536]");
    app.add_option("--rounds", texts.rounds, "Timed runs of each method, in turns")
        ->check(options::wholeNumber(1, 1000))
        ->option_text("N [15]");
    seed = app.add_option("--seed", options.measure.seed, "A whole number, for the same rays again")
               ->check(options::wholeNumber(0, std::numeric_limits<std::uint64_t>::max()))
               ->option_text("N [fresh]");
    app.add_option("--json", options.json, "Write the results, as --against reads them")->option_text("FILE");
    app.add_option("--html", options.html, "Write the results as a page with plots")->option_text("FILE");
    app.add_option("--against", options.against, "Compare the ratios with those of an earlier --json")
        ->option_text("FILE");
    app.add_flag("--list", options.list, "Print the names of workloads and methods");
    app.add_flag(
        "--isa", options.isa,
        "Count the machine code of every method for an AMD GPU, which need not be there, by Mesa's radv");
    CLI::Option* groups =
        app.add_flag("--groups", options.groups,
                     "Count the steps of the slowest of 8, 32 and 64 rays, and what a group of lanes issues");
    // It has rays of its own, times nothing and is of the library alone.
    for (const char* other :
         {"--workload", "--method", "--query", "--quick", "--rounds", "--html", "--against", "--isa"}) {
        groups->excludes(app.get_option(other));
    }
    app.add_option("--family", options.family,
                   "The GPU that --isa and --groups compile for, as radv calls it")
        ->option_text("NAME [navi21]");
    options::addDeviceOptions(app, options.device);
}

std::vector<trace::Query> parseQueries(const std::vector<std::string>& names) {
    for (const std::string& name : names) {
        if (std::ranges::none_of(allQueries, [&](trace::Query query) { return nameOf(query) == name; })) {
            throw Error(ExitCode::Usage, fmt::format("--query is nearest, any or all, not \"{}\"", name));
        }
    }
    std::vector<trace::Query> queries;
    for (const trace::Query query : allQueries) {
        if (names.empty() || std::ranges::find(names, nameOf(query)) != names.end()) {
            queries.push_back(query);
        }
    }
    return queries;
}

std::vector<Workload> parseWorkloads(const Texts& texts) {
    std::vector<Workload> workloads;
    for (const Workload& workload : allWorkloads()) {
        // Who names workloads wants those, be they quick or not.
        const bool wanted = texts.workloads.empty() ? !texts.quick || isQuick(workload)
                                                    : fits(workload.name(), texts.workloads);
        if (wanted) {
            workloads.push_back(workload);
        }
    }
    if (workloads.empty()) {
        throw Error(ExitCode::Usage, fmt::format("--workload: no workload is called \"{}\" (see --list)",
                                                 fmt::join(texts.workloads, ",")));
    }
    return workloads;
}

}  // namespace

std::optional<BenchOptions> parseOptions(const std::vector<std::string>& arguments) {
    BenchOptions options;
    Texts texts;
    CLI::Option* seed = nullptr;
    CLI::App app("Times ways to intersect a ray and a torus, side by side, after it has verified each.",
                 programName);
    app.set_version_flag("--version", fmt::format("{} {}", programName, version()));
    app.footer(footer);
    options.device.program = programName;
    addOptions(app, options, texts, seed);
    if (!options::parse(app, arguments)) {
        return std::nullopt;
    }
    if (!options.device.shaderFolder.empty()) {
        throw Error(ExitCode::Usage, "--shaders: the benchmark has shaders of its own, built in");
    }
    options::refuseSameFile("--json", options.json, "--html", options.html);
    options::refuseToOverwrite("--json", options.json, options.against);
    options::refuseToOverwrite("--html", options.html, options.against);
    if (options.family.empty()) {
        options.family = "navi21";
    } else if (!options.isa && !options.groups) {
        throw Error(ExitCode::Usage, "--family is for --isa and --groups");
    }
    options.workloads = parseWorkloads(texts);
    options.methods = chooseMethods(texts.methods);
    options.queries = parseQueries(texts.queries);
    options.device.context.float64 = true;
    options.device.context.pipelineStatistics = options.isa;
    options.device.context.compileOnly = options.isa;
    options.measure.rounds = texts.rounds > 0 ? texts.rounds : (texts.quick ? 9 : 15);
    const std::uint32_t rays = texts.rays > 0 ? texts.rays : 65536;
    options.measure.side = 1;
    while (options.measure.side * options.measure.side * 4096 < rays) {
        options.measure.side *= 2;
    }
    if (seed->empty()) {
        options.measure.seed = std::random_device()();
    }
    return options;
}

}  // namespace raytorus::bench
