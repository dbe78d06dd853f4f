// SPDX-License-Identifier: MIT
#include "bench/isa.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "bench/kernel.hpp"
#include "core/error.hpp"
#include "core/json_text.hpp"
#include "gpu/result.hpp"
#include "trace_io.h"

namespace raytorus::bench {
namespace {

namespace fs = std::filesystem;

// Where the Vulkan loader looks for drivers that are installed.
constexpr const char* driverFolders[] = {"/usr/share/vulkan/icd.d", "/usr/local/share/vulkan/icd.d",
                                         "/etc/vulkan/icd.d", "/usr/local/etc/vulkan/icd.d"};

std::optional<fs::path> findRadv() {
    for (const char* folder : driverFolders) {
        std::error_code none;
        for (const fs::directory_entry& entry : fs::directory_iterator(folder, none)) {
            const std::string name = entry.path().filename().string();
            // On a 64-bit computer there may be one of 32 bits beside it.
            if (name.starts_with("radeon_icd") && !name.ends_with("i686.json")) {
                return entry.path();
            }
        }
    }
    return std::nullopt;
}

constexpr int timedCompilations = 5;

// radv ends the process where RADV_FORCE_FAMILY is no family that it knows, so another process tries.
bool driverAborts() {
    const pid_t child = fork();
    if (child == 0) {
        const int nowhere = open("/dev/null", O_WRONLY);
        dup2(nowhere, STDERR_FILENO);
        VkApplicationInfo application{VK_STRUCTURE_TYPE_APPLICATION_INFO};
        application.apiVersion = VK_API_VERSION_1_3;
        VkInstanceCreateInfo info{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
        info.pApplicationInfo = &application;
        VkInstance instance = VK_NULL_HANDLE;
        std::uint32_t count = 0;
        if (vkCreateInstance(&info, nullptr, &instance) == VK_SUCCESS) {
            vkEnumeratePhysicalDevices(instance, &count, nullptr);
        }
        _exit(0);
    }
    int status = 0;
    return child > 0 && waitpid(child, &status, 0) == child && WIFSIGNALED(status);
}

template <typename Function>
Function functionOf(VkDevice device, const char* name) {
    return reinterpret_cast<Function>(vkGetDeviceProcAddr(device, name));
}

std::uint64_t valueOf(const VkPipelineExecutableStatisticKHR& statistic) {
    switch (statistic.format) {
        case VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_BOOL32_KHR:
            return statistic.value.b32;
        case VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_FLOAT64_KHR:
            return static_cast<std::uint64_t>(statistic.value.f64);
        default:
            return statistic.value.u64;
    }
}

// The fastest of so many compilations.
IsaRow count(gpu::Context& context, std::span<const std::uint32_t> words, const std::string& name,
             std::uint32_t constant, int compilations = 1) {
    gpu::PipelineLayoutInfo info;
    info.bindings = {{TRACE_BINDING_RAYS, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER},
                     {TRACE_BINDING_HITS, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER}};
    info.pushConstantBytes = 2 * sizeof(float);
    info.specialization = {constant};
    info.flags = VK_PIPELINE_CREATE_CAPTURE_STATISTICS_BIT_KHR;
    const gpu::ShaderModule shader(context, words, name);
    IsaRow row;
    row.compileMs = std::numeric_limits<double>::infinity();
    gpu::Pipeline pipeline;
    for (int i = 0; i < compilations; ++i) {
        const auto start = std::chrono::steady_clock::now();
        pipeline = gpu::makeComputePipeline(context, shader, info);
        const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
        row.compileMs = std::min(row.compileMs, taken.count());
    }
    VkPipelineExecutableInfoKHR executable{VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_INFO_KHR};
    executable.pipeline = pipeline.get();
    const auto list = functionOf<PFN_vkGetPipelineExecutableStatisticsKHR>(
        context.device(), "vkGetPipelineExecutableStatisticsKHR");
    std::uint32_t number = 0;
    gpu::check(list(context.device(), &executable, &number, nullptr), "vkGetPipelineExecutableStatisticsKHR");
    std::vector<VkPipelineExecutableStatisticKHR> told(number,
                                                       {VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_STATISTIC_KHR});
    gpu::check(list(context.device(), &executable, &number, told.data()),
               "vkGetPipelineExecutableStatisticsKHR");
    for (const VkPipelineExecutableStatisticKHR& statistic : told) {
        row.statistics.emplace_back(statistic.name, valueOf(statistic));
    }
    return row;
}

IsaRow countOne(gpu::Context& context, const TimedMethod& method, trace::Query query) {
    IsaRow row = count(context, method.shaders.load("one_ray.comp"), "one_ray.comp of " + method.name,
                       queryConstant(query), timedCompilations);
    row.method = method.name;
    row.query = query;
    return row;
}

std::string cellOf(const IsaRow& row, std::string_view statistic) {
    const auto value = row.of(statistic);
    return value ? fmt::format("{}", *value) : "-";
}

std::uint64_t spillsOf(const IsaRow& row) {
    return row.of("Spilled VGPRs").value_or(0) + row.of("Spilled SGPRs").value_or(0);
}

std::string rowText(const IsaRow& row, const IsaRow& ours) {
    const auto mine = row.of("Instructions");
    const auto our = ours.of("Instructions");
    const double ratio =
        mine && our && *mine > 0 ? static_cast<double>(*our) / static_cast<double>(*mine) : 0.0;
    return fmt::format("  {:<21} {:>7} {:>7.2f} {:>6} {:>6} {:>7} {:>8} {:>9} {:>8} {:>8} {:>8} {:>8.1f}\n",
                       row.method, cellOf(row, "Instructions"), ratio, cellOf(row, "VGPRs"),
                       cellOf(row, "SGPRs"), spillsOf(row), cellOf(row, "Scratch size"),
                       cellOf(row, "Branches"), cellOf(row, "Latency"), cellOf(row, "Inverse Throughput"),
                       cellOf(row, "Code size"), row.compileMs);
}

const IsaRow* findRow(std::span<const IsaRow> rows, trace::Query query, const char* method) {
    const auto found = std::ranges::find_if(
        rows, [&](const IsaRow& row) { return row.query == query && row.method == method; });
    return found == rows.end() ? nullptr : &*found;
}

// How many times the tuned closed form's instructions may be ours, and how many registers we may use.
constexpr double instructionAim = 1.5;
constexpr std::uint64_t registerAim = 40;

std::string aimText(std::span<const IsaRow> rows) {
    const IsaRow* ours = findRow(rows, trace::Query::Nearest, ourName);
    const IsaRow* peer = findRow(rows, trace::Query::Nearest, "closed-form-common");
    if (ours == nullptr || peer == nullptr || peer->of("Instructions").value_or(0) == 0) {
        return "";
    }
    const double ratio = static_cast<double>(ours->of("Instructions").value_or(0)) /
                         static_cast<double>(*peer->of("Instructions"));
    const std::uint64_t registers = ours->of("VGPRs").value_or(0);
    const std::uint64_t memory = spillsOf(*ours) + ours->of("Scratch size").value_or(0);
    const auto verdict = [](bool held) { return held ? "held" : "not held"; };
    return fmt::format(
        "\naims for nearest: at most {:g} times the instructions of closed-form-common: {:.2f}, {}; at most "
        "{} "
        "VGPRs: {}, {}; nothing spilled, no scratch: {}\n",
        instructionAim, ratio, verdict(ratio <= instructionAim), registerAim, registers,
        verdict(registers <= registerAim), verdict(memory == 0));
}

}  // namespace

std::optional<std::uint64_t> IsaRow::of(std::string_view statistic) const {
    const auto found =
        std::ranges::find_if(statistics, [&](const auto& row) { return row.first == statistic; });
    return found == statistics.end() ? std::nullopt : std::optional(found->second);
}

void chooseNullDevice(const std::string& family) {
    setenv("RADV_FORCE_FAMILY", family.c_str(), 1);
    // Each compilation is timed: none comes from a cache.
    const char* debug = std::getenv("RADV_DEBUG");
    setenv("RADV_DEBUG", debug != nullptr ? fmt::format("{},nocache", debug).c_str() : "nocache", 1);
    if (std::getenv("VK_DRIVER_FILES") == nullptr && std::getenv("VK_ICD_FILENAMES") == nullptr) {
        const auto radv = findRadv();
        if (!radv) {
            throw Error(ExitCode::NoDevice,
                        "--isa needs Mesa's radv, and no radeon_icd*.json is installed (Debian: "
                        "mesa-vulkan-drivers); VK_DRIVER_FILES may name one");
        }
        setenv("VK_DRIVER_FILES", radv->c_str(), 1);
        setenv("VK_ICD_FILENAMES", radv->c_str(), 1);
    }
    if (driverAborts()) {
        throw Error(ExitCode::Usage, fmt::format("--family: radv knows no GPU called \"{}\"", family));
    }
}

std::vector<IsaRow> countInstructions(gpu::Context& context, std::span<const TimedMethod> methods,
                                      std::span<const trace::Query> queries) {
    if (!context.hasPipelineStatistics()) {
        throw Error(ExitCode::NoDevice,
                    fmt::format("--isa needs VK_KHR_pipeline_executable_properties, which "
                                "{} ({}) does not have",
                                context.info().name, context.info().driverInfo));
    }
    std::vector<IsaRow> rows;
    for (const trace::Query query : queries) {
        for (const TimedMethod& method : methods) {
            if (method.needs != Needs::Float64 || context.hasFloat64()) {
                rows.push_back(countOne(context, method, query));
            }
        }
    }
    return rows;
}

std::uint64_t countInstructions(gpu::Context& context, std::span<const std::uint32_t> words,
                                const std::string& name, std::uint32_t constant) {
    return count(context, words, name, constant).of("Instructions").value_or(0);
}

std::string isaText(std::span<const IsaRow> rows) {
    std::string text;
    for (const trace::Query query : allQueries) {
        const IsaRow* ours = findRow(rows, query, ourName);
        if (ours == nullptr) {
            continue;
        }
        text +=
            fmt::format("{}{}\n  {:<21} {:>7} {:>7} {:>6} {:>6} {:>7} {:>8} {:>9} {:>8} {:>8} {:>8} {:>8}\n",
                        text.empty() ? "" : "\n", nameOf(query), "method", "instr.", "ours/it", "VGPRs",
                        "SGPRs", "spilled", "scratch", "branches", "latency", "inv. tp", "bytes", "comp. ms");
        for (const IsaRow& row : rows) {
            text += row.query == query ? rowText(row, *ours) : "";
        }
    }
    return text + aimText(rows);
}

std::string isaJson(const gpu::DeviceInfo& device, std::span<const IsaRow> rows) {
    nlohmann::ordered_json out;
    out["format"] = "raytorus-bench-isa";
    out["version"] = 1;
    out["device"] = device.name;
    out["driver"] = device.driverName + " " + device.driverInfo;
    out["rows"] = nlohmann::ordered_json::array();
    for (const IsaRow& row : rows) {
        nlohmann::ordered_json one;
        one["method"] = row.method;
        one["query"] = nameOf(row.query);
        one["compileMs"] = row.compileMs;
        for (const auto& [name, value] : row.statistics) {
            one[name] = value;
        }
        out["rows"].push_back(one);
    }
    return dumpJson(out, 1) + "\n";
}

}  // namespace raytorus::bench
