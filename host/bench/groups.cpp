// SPDX-License-Identifier: MIT
#include "bench/groups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <cstring>
#include <nlohmann/json.hpp>

#include "bench/correctness.hpp"
#include "bench/groups_io.h"
#include "bench/isa.hpp"
#include "bench/kernel.hpp"
#include "core/error.hpp"
#include "core/json_text.hpp"
#include "gpu/buffer.hpp"
#include "gpu/commands.hpp"
#include "gpu/pipeline.hpp"
#include "gpu/shader_module.hpp"
#include "raytorus_bench_groups.hpp"
#include "reference/rays.hpp"
#include "trace_io.h"

namespace raytorus::bench {
namespace {

constexpr float radii[] = {0.05F, 0.1F, 0.25F, 0.5F, 0.9F, 1.0F, 1.5F};
constexpr double cameraDistance = 3.0;

/// Sets an environment variable for as long as it lives.
class Environment {
public:
    Environment(const char* variable, const char* value) : name(variable) {
        if (const char* const had = std::getenv(name)) {
            before = had;
        }
        value != nullptr ? setenv(name, value, 1) : unsetenv(name);
    }
    ~Environment() { before ? setenv(name, before->c_str(), 1) : unsetenv(name); }
    Environment(const Environment&) = delete;
    Environment& operator=(const Environment&) = delete;

private:
    const char* name;
    std::optional<std::string> before;
};

std::vector<trace::TraceRay> raysOfClass(reference::RayClass rayClass, const reference::Torus& torus,
                                         std::uint64_t seed, std::size_t count) {
    reference::RayParameters parameters;
    parameters.torus = torus;
    parameters.seed = seed;
    std::vector<trace::TraceRay> rays;
    for (const reference::Ray& ray : reference::generateRays(rayClass, parameters, count)) {
        rays.push_back(std::bit_cast<trace::TraceRay>(ray));
    }
    return rays;
}

std::vector<trace::TraceRay> benchRays(Kernel& kernel, Pattern pattern, float minorRadius,
                                       std::uint64_t seed) {
    const Workload workload{Mode::Made, pattern, minorRadius, cameraDistance,
                            pattern == Pattern::Tiles ? 30 : 50};
    return kernel.rays(pattern, aimedView(kernel, workload, seed));
}

/// count_passes.comp on a device.
class PathTracer {
public:
    PathTracer(gpu::Context& deviceContext, std::size_t rayCount)
        : context(&deviceContext),
          count(rayCount),
          rays(deviceContext, rayCount * sizeof(trace::TraceRay), gpu::BufferUse::Storage),
          paths(deviceContext, rayCount * sizeof(RayPath), gpu::BufferUse::ReadBack) {
        gpu::PipelineLayoutInfo info;
        info.bindings = {{TRACE_BINDING_RAYS, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER},
                         {TRACE_BINDING_HITS, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER}};
        info.pushConstantBytes = 2 * sizeof(float);
        const gpu::ShaderModule shader(deviceContext, bench_groups::find("count_passes.comp"),
                                       "count_passes.comp");
        pipeline = gpu::makeComputePipeline(deviceContext, shader, info);
        pipeline->bind(TRACE_BINDING_RAYS, rays);
        pipeline->bind(TRACE_BINDING_HITS, paths);
    }

    std::vector<RayPath> trace(const reference::Torus& torus, std::span<const trace::TraceRay> asked) {
        std::memcpy(rays.data(), asked.data(), asked.size_bytes());
        context->submit([&](VkCommandBuffer commands) {
            pipeline->use(commands, std::as_bytes(std::span(&torus, 1)));
            vkCmdDispatch(commands, static_cast<std::uint32_t>(count / TRACE_GROUP_SIZE), 1, 1);
            gpu::bufferBarrier(commands, paths, gpu::shaderWrite, gpu::hostRead);
        });
        const std::span<const RayPath> told = paths.as<const RayPath>().first(count);
        return {told.begin(), told.end()};
    }

private:
    gpu::Context* context;
    std::size_t count;
    gpu::Buffer rays;
    gpu::Buffer paths;
    std::optional<gpu::Pipeline> pipeline;
};

}  // namespace

std::uint32_t RayPath::hits() const {
    return hitsAndRefinements & ((1U << GROUPS_REFINEMENTS_SHIFT) - 1U);
}

std::uint32_t RayPath::refinements() const {
    return hitsAndRefinements >> GROUPS_REFINEMENTS_SHIFT;
}

std::uint32_t RayPath::stepsOf(int pass) const {
    return stepsOfPasses >> (GROUPS_BITS_OF_A_PASS * pass) & ((1U << GROUPS_BITS_OF_A_PASS) - 1U);
}

double groupInstructions(std::span<const RayPath> group, const PartCosts& costs) {
    double steps = 0.0;
    std::uint32_t stepsKnown = 0;
    for (int pass = 0; pass < GROUPS_PASSES; ++pass) {
        std::uint32_t most = 0;
        for (const RayPath& path : group) {
            most = std::max(most, path.stepsOf(pass));
        }
        steps += most;
        stepsKnown += most;
    }
    // Of later passes the steps are known together.
    std::uint32_t mostSteps = 0;
    std::uint32_t refiningPasses = 0;
    for (const RayPath& path : group) {
        mostSteps = std::max(mostSteps, path.steps);
        refiningPasses |= path.refiningPasses;
    }
    steps += mostSteps > stepsKnown ? mostSteps - stepsKnown : 0;
    return costs.ends + steps * costs.step + std::popcount(refiningPasses) * costs.refinement;
}

GroupRow groupRow(std::span<const RayPath> paths, const std::optional<PartCosts>& costs) {
    GroupRow row;
    row.count = paths.size();
    std::size_t hitting = 0;
    std::size_t marching = 0;
    std::size_t refining = 0;
    double steps = 0.0;
    const auto refinesMore = [](const RayPath& path) { return path.refinements() > path.hits(); };
    for (const RayPath& path : paths) {
        hitting += path.hits() > 0 ? 1U : 0U;
        marching += path.steps > 0 ? 1U : 0U;
        steps += path.steps;
        refining += refinesMore(path) ? 1U : 0U;
    }
    const auto all = static_cast<double>(paths.size());
    row.hitPart = static_cast<double>(hitting) / all;
    row.steps = marching > 0 ? steps / static_cast<double>(marching) : 0.0;
    row.refiningRays = static_cast<double>(refining) / all;
    for (std::size_t k = 0; k < groupSizes.size(); ++k) {
        const std::size_t size = groupSizes[k];
        const std::size_t groups = paths.size() / size;
        std::size_t refiningGroups = 0;
        for (std::size_t g = 0; g < groups; ++g) {
            const std::span<const RayPath> group = paths.subspan(g * size, size);
            row.slowest[k] += std::ranges::max(group, {}, &RayPath::steps).steps;
            row.instructions[k] += costs ? groupInstructions(group, *costs) : 0.0;
            refiningGroups += std::ranges::any_of(group, refinesMore) ? 1U : 0U;
        }
        row.slowest[k] /= static_cast<double>(groups);
        row.instructions[k] /= static_cast<double>(groups);
        row.refiningGroups = static_cast<double>(refiningGroups) / static_cast<double>(groups);
    }
    return row;
}

std::optional<PartCosts> countParts(const std::string& family) {
    // As radv is asked for here alone, whatever driver the user has named for the rest.
    const Environment driver("VK_DRIVER_FILES", nullptr);
    const Environment icd("VK_ICD_FILENAMES", nullptr);
    const Environment forced("RADV_FORCE_FAMILY", nullptr);
    try {
        chooseNullDevice(family);
        gpu::ContextOptions compiling;
        compiling.pipelineStatistics = true;
        compiling.compileOnly = true;
        gpu::Context context(compiling, nullptr);
        const auto count = [&](std::uint32_t which) {
            return static_cast<double>(
                countInstructions(context, bench_groups::find("part.comp"), "part.comp", which));
        };
        const double none = count(GROUPS_PART_NONE);
        const auto part = [&](std::uint32_t which) { return count(which) - none; };
        const std::vector<std::string> names{"closed-form-common"};
        const std::vector<TimedMethod> methods = chooseMethods(names);
        const std::vector<IsaRow> rows =
            countInstructions(context, methods, std::array{trace::Query::Nearest});
        return PartCosts{part(GROUPS_PART_ENDS), part(GROUPS_PART_STEP), part(GROUPS_PART_REFINEMENT),
                         static_cast<double>(rows.back().of("Instructions").value_or(0))};
    } catch (const Error& error) {
        if (error.exitCode == ExitCode::NoDevice) {
            return std::nullopt;
        }
        throw;
    }
}

std::vector<GroupRow> measureGroups(gpu::Context& context, const GroupOptions& options,
                                    const std::optional<PartCosts>& costs,
                                    const std::function<void(double)>& progress) {
    Kernel kernel(context, options.side);
    PathTracer tracer(context, kernel.rayCount());
    std::vector<GroupRow> rows;
    const auto add = [&](const char* name, float minorRadius, std::span<const trace::TraceRay> rays) {
        GroupRow row = groupRow(tracer.trace({1.0F, minorRadius}, rays), costs);
        row.rays = name;
        row.minorRadius = minorRadius;
        rows.push_back(row);
        progress(static_cast<double>(rows.size()) / (4.0 * std::size(radii)));
    };
    for (const float r : radii) {
        const reference::Torus torus{1.0F, r};
        add("tiles", r, benchRays(kernel, Pattern::Tiles, r, options.seed));
        add("scattered", r, benchRays(kernel, Pattern::Scattered, r, options.seed));
        add("second", r, raysOfClass(reference::RayClass::leaving, torus, options.seed, kernel.rayCount()));
        add("inside", r, raysOfClass(reference::RayClass::inside, torus, options.seed, kernel.rayCount()));
    }
    return rows;
}

std::string groupsText(std::span<const GroupRow> rows, const std::optional<PartCosts>& costs) {
    std::string text = fmt::format("  {:<10} {:>5} {:>6} {:>6} {:>6} {:>6} {:>6} {:>8} {:>9}", "rays", "r/R",
                                   "hit %", "steps", "of 8", "of 32", "of 64", "refine %", "groups %");
    text += costs ? fmt::format(" {:>8} {:>8} {:>8}\n", "instr 32", "instr 64", "64/form") : "\n";
    for (const GroupRow& row : rows) {
        text += fmt::format("  {:<10} {:>5g} {:>6.1f} {:>6.2f} {:>6.2f} {:>6.2f} {:>6.2f} {:>8.3f} {:>9.2f}",
                            row.rays, row.minorRadius, 100 * row.hitPart, row.steps, row.slowest[0],
                            row.slowest[1], row.slowest[2], 100 * row.refiningRays, 100 * row.refiningGroups);
        text += costs ? fmt::format(" {:>8.0f} {:>8.0f} {:>8.2f}\n", row.instructions[1], row.instructions[2],
                                    row.instructions[2] / costs->closedForm)
                      : "\n";
    }
    if (costs) {
        text += fmt::format(
            "\ninstructions by radv: ends {:.0f}, a step {:.0f}, a refinement {:.0f}; closed-form-common "
            "{:.0f}\n",
            costs->ends, costs->step, costs->refinement, costs->closedForm);
    } else {
        text +=
            "\nno instructions: they need Mesa's radv (Debian: mesa-vulkan-drivers) and a --family that it "
            "knows\n";
    }
    return text;
}

std::string groupsJson(const gpu::DeviceInfo& device, std::uint64_t seed, std::span<const GroupRow> rows,
                       const std::optional<PartCosts>& costs) {
    nlohmann::ordered_json out;
    out["format"] = "raytorus-bench-groups";
    out["version"] = 1;
    out["device"] = device.name;
    out["driver"] = device.driverName + " " + device.driverInfo;
    out["seed"] = seed;
    if (costs) {
        out["parts"] = {{"ends", costs->ends},
                        {"step", costs->step},
                        {"refinement", costs->refinement},
                        {"closedFormCommon", costs->closedForm}};
    }
    out["rows"] = nlohmann::ordered_json::array();
    for (const GroupRow& row : rows) {
        nlohmann::ordered_json one{
            {"rays", row.rays},
            {"minorRadius", row.minorRadius},
            {"count", row.count},
            {"hitPart", row.hitPart},
            {"steps", row.steps},
            {"slowest", {{"8", row.slowest[0]}, {"32", row.slowest[1]}, {"64", row.slowest[2]}}},
            {"refiningRays", row.refiningRays},
            {"refiningGroupsOf64", row.refiningGroups}};
        if (costs) {
            one["instructions"] = {{"32", row.instructions[1]}, {"64", row.instructions[2]}};
        }
        out["rows"].push_back(one);
    }
    return dumpJson(out) + "\n";
}

}  // namespace raytorus::bench
