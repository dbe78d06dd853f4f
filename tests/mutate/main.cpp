// SPDX-License-Identifier: MIT
// raytorus-mutate: how sharp the tests are, by the faults that they notice.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <functional>
#include <future>
#include <limits>
#include <optional>

#include "core/console.hpp"
#include "core/file.hpp"
#include "mutate/mutation_run.hpp"
#include "options/numbers.hpp"
#include "options/option_text.hpp"
#include "options/program.hpp"

namespace raytorus::mutate {
namespace {

namespace fs = std::filesystem;

constexpr const char* footer =
    R"(Each mutation changes the shaders' text in one place; then the golden pictures and the numeric tests are asked.
Exit codes: 0 the threshold is held (the goldens alone catch 95 % of what pictures can show, both together everything),
2 it is not, 1 a row of the table does not fit the shaders or the unchanged shaders are caught, others as of raytorus.

Examples:
  raytorus-mutate
  raytorus-mutate --only lift-missing,uv-exchanged
  raytorus-mutate --jobs 2 --json found.json --markdown found.md)";

struct Options {
    RunOptions run;
    std::vector<std::string> names;
    bool list = false;
    bool keep = false;
    std::string json;
    std::string markdown;
};

std::optional<Options> parseOptions(const std::vector<std::string>& arguments) {
    Options options;
    CLI::App app("Puts faults into the shaders and counts those that the tests catch.", "raytorus-mutate");
    app.footer(footer);
    app.add_flag("--list", options.list, "Print the mutations and what somebody got wrong in each");
    app.add_option("--only", options.names, "Run these mutations alone")
        ->delimiter(',')
        ->option_text("NAME,...");
    app.add_option("--jobs", options.run.jobs, "Mutations at a time")
        ->check(options::wholeNumber(1, 256))
        ->option_text("N [processors]");
    app.add_option("--rays", options.run.rays.perGroup, "Rays a group of the verifier")
        ->check(options::wholeNumber(1, std::uint64_t{1} << 20U))
        ->option_text("N [500]");
    app.add_option("--seed", options.run.rays.seed, "Of those rays")
        ->check(options::wholeNumber(0, std::numeric_limits<std::uint64_t>::max()))
        ->option_text("N [1]");
    app.add_option("--json", options.json, "Everything into a file")->option_text("FILE");
    app.add_option("--markdown", options.markdown, "The table into a file, for the documentation")
        ->option_text("FILE");
    app.add_flag("--keep", options.keep, "Leave the changed shaders, and say where");
    app.add_option("--device", options.run.device.device,
                   "Device by number, or by a part of its name or driver")
        ->option_text("NAME");
    app.add_flag("--validate", options.run.device.validate, "Run with the Vulkan validation layers");
    if (!options::parse(app, arguments)) {
        return std::nullopt;
    }
    options::refuseSameFile("--json", options.json, "--markdown", options.markdown);
    return options;
}

std::vector<Mutation> chosenMutations(const std::vector<std::string>& names) {
    const std::vector<Mutation> all = allMutations();
    std::vector<Mutation> chosen;
    for (const std::string& name : names) {
        const auto found = std::find_if(all.begin(), all.end(),
                                        [&name](const Mutation& mutation) { return name == mutation.name; });
        if (found == all.end()) {
            throw Error(ExitCode::Usage,
                        fmt::format("no mutation is called \"{}\" (see raytorus-mutate --list)", name));
        }
        chosen.push_back(*found);
    }
    return names.empty() ? all : chosen;
}

void list(const std::vector<Mutation>& mutations) {
    for (const Mutation& mutation : mutations) {
        print("{:<32}{:<24}{}\n", mutation.name, mutation.file, mutation.mistake);
    }
}

void writeText(const std::string& path, const std::string& text) {
    if (!path.empty()) {
        writeFile(path, std::as_bytes(std::span(text)));
    }
}

ExitCode runAll(Options options, const std::vector<Mutation>& mutations) {
    const auto start = std::chrono::steady_clock::now();
    GoldenSuite goldens;
    // Beside the others, because nothing catches it and so everything is run.
    std::future<void> unchanged;
    if (options.names.empty()) {
        unchanged = std::async(std::launch::async, requireUnchangedPasses, std::ref(goldens), options.run);
    }
    print("{}", headText());
    options.run.report = [&](const Outcome& outcome) {
        print("{}", rowText(outcome));
        flushOutput();
    };
    const std::vector<Outcome> outcomes = runMutations(mutations, goldens, options.run);
    if (unchanged.valid()) {
        unchanged.get();
        print("the unchanged shaders pass everything\n");
    }
    const Totals totals = totalsOf(outcomes);
    print("{}\n", totalsText(totals));
    print("in {:.0f} s\n", std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    writeText(options.json, outcomesJson(outcomes));
    writeText(options.markdown, outcomesMarkdown(outcomes));
    const bool held = totals.thresholdHeld();
    print("{}\n", held ? "the threshold is held" : "the threshold is missed");
    return held ? ExitCode::Ok : ExitCode::ComparisonFailed;
}

ExitCode run(Options options) {
    const std::vector<Mutation> mutations = chosenMutations(options.names);
    if (options.list) {
        list(mutations);
        return ExitCode::Ok;
    }
    options.run.folder = fs::temp_directory_path() / fmt::format("raytorus-mutate-{}", getpid());
    const ExitCode code = runAll(options, mutations);
    if (options.keep) {
        print("the changed shaders are in {}\n", options.run.folder.string());
    } else {
        fs::remove_all(options.run.folder);
    }
    return code;
}

}  // namespace
}  // namespace raytorus::mutate

int main(int argc, char** argv) {
    using namespace raytorus;
    return options::exitStatus(options::runProgram("raytorus-mutate", [&] {
        const auto options = mutate::parseOptions({argv + 1, argv + argc});
        return options ? mutate::run(*options) : ExitCode::Ok;
    }));
}
