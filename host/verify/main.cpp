// SPDX-License-Identifier: MIT
// raytorus-verify: fresh rays through the real SPIR-V, held to the reference.
#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <optional>

#include "core/console.hpp"
#include "core/file.hpp"
#include "methods/methods.hpp"
#include "options/program.hpp"
#include "options/progress.hpp"
#include "verify/report.hpp"
#include "verify/thresholds.hpp"
#include "verify/verifier.hpp"
#include "verify/verify_options.hpp"

namespace raytorus::verify {
namespace {

std::vector<RayGroupResult> verifyRayGroups(Verifier& verifier, const VerifyOptions& options) {
    const std::vector<RayGroup> groups = chooseRayGroups(options.groups);
    std::vector<RayGroupResult> results;
    options::Progress progress("verifying");
    for (const RayGroup& group : groups) {
        const auto show = [&](std::uint64_t done) {
            progress.show((static_cast<double>(results.size()) +
                           static_cast<double>(done) / static_cast<double>(options.rays)) /
                          static_cast<double>(groups.size()));
        };
        results.push_back({group, verifier.verify(group, options.seed, options.rays, show)});
    }
    return results;
}

// The faults, first of all those with a replay; then the thresholds that they exceed.
std::vector<std::string> listFaults(const VerifyOptions& options, const std::vector<RayGroupResult>& results,
                                    reference::Tier tier) {
    std::vector<std::string> all;
    for (const RayGroupResult& result : results) {
        const std::vector<std::string> exceeded = exceededThresholds(result.group, result.statistics, tier);
        if (exceeded.empty()) {
            continue;
        }
        all.insert(all.end(), exceeded.begin(), exceeded.end());
        for (const std::string& sentence : exceeded) {
            print("{}\n", sentence);
        }
        for (const Example& example : result.statistics.examples) {
            print("  {}: {}\n", judge::nameOf(example.fault),
                  replayCommand(options.command(), example.torus, example.ray));
        }
        if (result.statistics.faultCount() == 0) {
            print("  position: {}\n  t: {}\n",
                  replayCommand(options.command(), result.statistics.position.worstTorus,
                                result.statistics.position.worstRay),
                  replayCommand(options.command(), result.statistics.t.worstTorus,
                                result.statistics.t.worstRay));
        }
    }
    return all;
}

ExitCode verifyAll(gpu::Context& context, Verifier& verifier, const VerifyOptions& options) {
    // Before the work, which can be long, so that a name that cannot be written costs nothing.
    std::optional<OutputFile> file;
    if (!options.json.empty()) {
        file.emplace(options.json);
    }
    print("seed {}{}, {} rays a group, {} ({})\n", options.seed, options.seedOfTheDay ? " (today)" : "",
          options.rays, context.info().name, context.info().driverInfo);
    flushOutput();
    const auto start = std::chrono::steady_clock::now();
    const std::vector<RayGroupResult> results = verifyRayGroups(verifier, options);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    print("{}", tableText(results, options.rows));
    // Thresholds are the library's promises; other methods have made none.
    const std::optional<reference::Tier> tier = findMethod(options.method)->tier;
    const std::vector<std::string> exceeded =
        tier ? listFaults(options, results, *tier) : std::vector<std::string>();
    const auto rays = static_cast<double>(options.rays) * static_cast<double>(results.size());
    print("{:.3g} rays in {:.1f} s: {:.3g} million a minute\n", rays, seconds, 60e-6 * rays / seconds);
    if (file) {
        const Run run{options.method,      options.command(),        options.seed, options.rays, seconds,
                      context.info().name, context.info().driverInfo};
        file->write(resultsJson(run, results, exceeded));
        file->commit();
    }
    if (!tier) {
        return ExitCode::Ok;
    }
    print("{}\n", exceeded.empty() ? "every threshold is held"
                                   : fmt::format("{} threshold(s) exceeded", exceeded.size()));
    return exceeded.empty() ? ExitCode::Ok : ExitCode::ComparisonFailed;
}

ExitCode run(const VerifyOptions& options) {
    ExitCode code = ExitCode::Ok;
    options::withDevice(options.device, [&](gpu::Context& context) {
        Verifier verifier(context, options.shaders, options.threads);
        if (options.replay) {
            const auto& [torus, ray] = *options.replay;
            const Verifier::Replay replay = verifier.replay(torus, ray);
            print("{}", replayText(torus, ray, replay));
            code = replay.judgement.fault == judge::Fault::None ? ExitCode::Ok : ExitCode::ComparisonFailed;
        } else {
            code = verifyAll(context, verifier, options);
        }
    });
    return code;
}

}  // namespace
}  // namespace raytorus::verify

int main(int argc, char** argv) {
    using namespace raytorus;
    return options::exitStatus(options::runProgram(verify::programName, [&] {
        const auto options = verify::parseOptions({argv + 1, argv + argc});
        return options ? verify::run(*options) : ExitCode::Ok;
    }));
}
