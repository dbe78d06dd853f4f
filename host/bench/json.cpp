// SPDX-License-Identifier: MIT
#include "bench/json.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/json_text.hpp"
#include "core/strict_json.hpp"

namespace raytorus::bench {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr const char* formatName = "raytorus-bench";
constexpr int formatVersion = 1;

// To four digits: the rest is noise.
double rounded(double value) {
    return std::stod(fmt::format("{:.4g}", value));
}

ordered_json machineJson(const Machine& machine) {
    ordered_json out;
    out["device"] = machine.device;
    out["driver"] = machine.driver;
    out["deviceType"] = machine.deviceType;
    out["vulkan"] = machine.vulkan;
    out["processor"] = machine.processor;
    out["processors"] = machine.processors;
    out["lavapipeThreads"] = machine.lavapipeThreads;
    out["clock"] = machine.clock;
    return out;
}

ordered_json methodJson(const MethodResult& method) {
    const Times& times = method.times;
    ordered_json out;
    out["min"] = rounded(times.minimum);
    out["median"] = rounded(times.median);
    out["net"] = rounded(times.netMinimum);
    out["ratio"] = rounded(times.ratio);
    out["quartiles"] = {rounded(times.lowerQuartile), rounded(times.middleRatio),
                        rounded(times.upperQuartile)};
    out["judged"] = method.correctness.judged;
    out["wrong"] = method.correctness.wrong;
    out["gross"] = method.correctness.gross;
    out["p99"] = rounded(method.correctness.positionP99);
    out["layers"] = method.layers;
    out["checksumHeld"] = method.checksumHeld;
    return out;
}

std::string cellText(const CellResult& cell) {
    std::string text = fmt::format(
        " {{\"workload\": \"{}\", \"query\": \"{}\", \"hitPart\": {:g}, \"rays\": {}, "
        "\"methods\": {{",
        cell.workload.name(), nameOf(cell.query), rounded(cell.hitPart), cell.rays);
    const char* separator = "\n";
    for (const MethodResult& method : cell.methods) {
        text += fmt::format("{}  \"{}\": {}", separator, method.name, dumpJson(methodJson(method), -1));
        separator = ",\n";
    }
    return text + "\n }}";
}

ReferenceTable parseReference(const std::filesystem::path& path, const json& table) {
    ReferenceTable reference;
    reference.file = path.string();
    const json& machine = table.at("machine");
    reference.device = machine.at("device").get<std::string>();
    reference.driver = machine.at("driver").get<std::string>();
    reference.lavapipeThreads = machine.at("lavapipeThreads").get<std::string>();
    for (const json& cell : table.at("cells")) {
        for (const auto& [name, method] : cell.at("methods").items()) {
            const json& quartiles = method.at("quartiles");
            reference.rows.push_back(
                {cell.at("workload").get<std::string>(), cell.at("query").get<std::string>(), name,
                 method.at("ratio").get<double>(), quartiles.at(0).get<double>(),
                 quartiles.at(2).get<double>(),
                 method.at("wrong").get<std::size_t>() + method.at("gross").get<std::size_t>(),
                 cell.at("rays").get<std::size_t>()});
        }
    }
    return reference;
}

Error refusal(const std::filesystem::path& path, const std::string& reason) {
    return {ExitCode::File, fmt::format("{}: {}", path.string(), reason)};
}

}  // namespace

std::string runJson(const BenchRun& run) {
    std::string text = fmt::format(
        "{{\"format\": \"{}\", \"version\": {},\n\"machine\": {},\n\"seed\": {}, \"rounds\": {}, "
        "\"cells\": [",
        formatName, formatVersion, dumpJson(machineJson(run.machine), -1), run.seed, run.rounds);
    const char* separator = "\n";
    for (const CellResult& cell : run.cells) {
        text += separator + cellText(cell);
        separator = ",\n";
    }
    return text + "\n]}\n";
}

ReferenceTable readReference(const std::filesystem::path& path) {
    const std::string text = readTextFile(path);
    json table;
    try {
        table = parseStrictJson(text, path.string());
    } catch (const Error& error) {
        throw Error(ExitCode::File, error.what());  // not of a scene
    }
    if (!table.is_object() || table.value("format", json()) != formatName) {
        throw refusal(path, "this is no table that raytorus-bench --json has written");
    }
    if (table.value("version", json()) != formatVersion) {
        throw refusal(path, fmt::format("this table has version {} of the format, and {} is wanted",
                                        table.value("version", json()).dump(), formatVersion));
    }
    try {
        return parseReference(path, table);
    } catch (const json::exception&) {
        throw refusal(path, "this table of raytorus-bench is incomplete");
    }
}

}  // namespace raytorus::bench
