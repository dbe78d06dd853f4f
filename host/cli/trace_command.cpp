// SPDX-License-Identifier: MIT
// raytorus trace: a file of rays against one torus.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <filesystem>
#include <memory>

#include "cli/command.hpp"
#include "cli/ray_batches.hpp"
#include "cli/ray_file.hpp"
#include "core/console.hpp"
#include "options/device_options.hpp"
#include "options/method_option.hpp"
#include "options/numbers.hpp"
#include "options/option_text.hpp"
#include "options/progress.hpp"
#include "trace/tracer.hpp"
#include "truth/reference_tracer.hpp"

namespace raytorus::cli {
namespace {

constexpr const char* traceFooter =
    R"(Files are CSV if their name ends in .csv, otherwise raw little-endian float32.
  rays  8 values a ray: origin x, y, z, tMin, direction x, y, z, tMax. CSV may have a header line, blank lines and
        lines that start with #. tMax may be inf
  hits  a row a ray, in the same order:
          nearest  8 values: hit (1 or 0), t, position x, y, z, normal x, y, z
          --all    17 values: count, four t, four positions
          --any    1 value: 1 or 0
        where there is no hit, t is tMax (0 if that is no number) and position and normal are 0

Examples:
  raytorus trace rays.csv -o hits.csv --torus 1,0.25
  raytorus trace rays.bin -o hits.bin --torus 1640,6 --all
  raytorus trace rays.csv -o hits.csv --torus 1,0.01 --method closed-form)";

// Rays of one submission: large enough to keep a GPU busy, small enough that no watchdog minds.
constexpr std::size_t batchRays = std::size_t{1} << 17U;
// Of the reference: so that progress is seen.
constexpr std::size_t exactBatchRays = std::size_t{1} << 14U;

struct TraceCommand {
    std::string rays;
    std::string hits;
    std::string torus;
    bool all = false;
    bool any = false;
    std::string method;
    options::DeviceOptions device;
};

void traceExactly(BatchStages& stages, const std::function<std::size_t(std::span<trace::TraceRay>)>& readInto,
                  trace::Query query, std::pair<float, float> radii) {
    std::array<std::vector<trace::TraceRay>, 2> rays;
    std::array<std::vector<float>, 2> hits;
    stages.read = [&](std::size_t place) {
        rays[place].resize(exactBatchRays);
        rays[place].resize(readInto(rays[place]));
        return rays[place].size();
    };
    stages.start = [](std::size_t, std::size_t) {};
    stages.finish = [&](std::size_t place) -> std::span<const float> {
        hits[place] = truth::traceByReference(query, {radii.first, radii.second}, rays[place]);
        return hits[place];
    };
    runBatches(stages);
}

ExitCode runTrace(const TraceCommand& command) {
    const auto radii = options::parsePair(command.torus);
    if (!radii) {
        throw Error(
            ExitCode::Usage,
            fmt::format("--torus takes the major and the minor radius as R,r, not \"{}\"", command.torus));
    }
    const auto [majorRadius, minorRadius] = *radii;
    if (!(majorRadius >= 0.0F) || !(minorRadius > 0.0F)) {
        throw Error(ExitCode::Usage,
                    fmt::format("--torus needs R >= 0 and r > 0, not \"{}\"", command.torus));
    }
    options::requireTorusInRange("--torus", {majorRadius, minorRadius}, command.torus);
    const trace::Query query = command.all   ? trace::Query::All
                               : command.any ? trace::Query::Any
                                             : trace::Query::Nearest;
    const bool exact = options::isReference(command.method, command.device);
    const trace::ShaderSource shaders =
        exact ? trace::ShaderSource() : options::shadersOf(command.method, command.device);
    options::refuseToOverwrite("--output", command.hits, command.rays);
    RayReader reader(command.rays, formatOf(command.rays));
    HitWriter writer(command.hits, formatOf(command.hits), query);
    options::Progress progress("tracing");
    BatchStages stages;
    const auto readInto = [&](std::span<trace::TraceRay> room) {
        progress.show(reader.done());
        return reader.read(room);
    };
    stages.write = [&](std::span<const float> hits) { writer.write(hits); };
    if (exact) {
        traceExactly(stages, readInto, query, *radii);
    } else {
        options::withDevice(command.device, [&](gpu::Context& context) {
            const std::size_t batch = std::min(batchRays, trace::Tracer::maxCapacity(context, query));
            trace::Tracer tracer(context, query, batch, shaders, 2);
            stages.read = [&](std::size_t place) { return readInto(tracer.rays(place)); };
            stages.start = [&](std::size_t place, std::size_t count) {
                tracer.start(place, {majorRadius, minorRadius}, count);
            };
            stages.finish = [&](std::size_t place) { return tracer.finish(place); };
            runBatches(stages);
        });
    }
    writer.commit();
    return ExitCode::Ok;
}

}  // namespace

void addTraceCommand(CLI::App& app, Action& action) {
    const auto command = std::make_shared<TraceCommand>();
    CLI::App* sub = app.add_subcommand("trace", "Trace a file of rays against one torus");
    sub->add_option("rays", command->rays, "The rays")->required()->option_text("RAYS REQUIRED");
    sub->add_option("-o,--output", command->hits, "The hits, in the order of the rays")
        ->required()
        ->option_text("HITS REQUIRED");
    sub->add_option("--torus", command->torus, "Major and minor radius")
        ->required()
        ->option_text("R,r REQUIRED");
    CLI::Option* all = sub->add_flag("--all", command->all, "All hits of each ray, not only the nearest");
    sub->add_flag("--any", command->any, "Only whether there is a hit")->excludes(all);
    options::addMethodOrReferenceOption(*sub, command->method);
    options::addDeviceOptions(*sub, command->device);
    sub->footer(traceFooter);
    sub->callback([command, &action] { action = [command] { return runTrace(*command); }; });
}

}  // namespace raytorus::cli
