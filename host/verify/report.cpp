// SPDX-License-Identifier: MIT
#include "verify/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/json_text.hpp"

namespace raytorus::verify {
namespace {

using nlohmann::ordered_json;

std::string rowName(const RayGroup& group, Rows rows) {
    std::string name = fmt::format("{:<20}", group.className());
    if (rows == Rows::Radius || rows == Rows::Group) {
        name += fmt::format(" {:>6g}", group.minorRadius);
    }
    if (rows == Rows::Distance || rows == Rows::Group) {
        name += group.distance > 0.0 ? fmt::format(" {:>7g}", group.distance) : fmt::format(" {:>7}", "-");
    }
    return name;
}

std::string heading(Rows rows) {
    std::string name = fmt::format("{:<20}", "class");
    if (rows == Rows::Radius || rows == Rows::Group) {
        name += fmt::format(" {:>6}", "r/R");
    }
    if (rows == Rows::Distance || rows == Rows::Group) {
        name += fmt::format(" {:>7}", "D/R");
    }
    return name +
           fmt::format(
               " {:>10} {:>5} {:>6} {:>6} {:>6} {:>6} {:>6} {:>6} | {:>7} {:>7} {:>7} | {:>5} {:>5} {:>6}\n",
               "judged", "hit %", "missed", "false", "count", "order", "disagr", "gross", "p50", "p99", "max",
               "p50", "p99", "max");
}

std::string rowText(const std::string& name, const Statistics& statistics) {
    const judge::Histogram& position = statistics.position.histogram;
    const judge::Histogram& t = statistics.t.histogram;
    const auto judged = static_cast<double>(statistics.judged());
    const double hitPart = judged > 0.0 ? 100.0 * static_cast<double>(statistics.hitting) / judged : 0.0;
    return name +
           fmt::format(
               " {:>10} {:>5.1f} {:>6} {:>6} {:>6} {:>6} {:>6} {:>6} | {:>7.1e} {:>7.1e} {:>7.1e} | "
               "{:>5.2g} {:>5.2g} {:>6.3g}\n",
               statistics.judged(), hitPart, statistics.faultsOf(judge::Fault::Missed),
               statistics.faultsOf(judge::Fault::FalseHit), statistics.faultsOf(judge::Fault::WrongCount),
               statistics.faultsOf(judge::Fault::Order),
               statistics.faultsOf(judge::Fault::Disagreement) + statistics.faultsOf(judge::Fault::NonFinite),
               statistics.faultsOf(judge::Fault::Gross), position.quantile(0.5), position.quantile(0.99),
               position.max(), t.quantile(0.5), t.quantile(0.99), t.max());
}

ordered_json errorsJson(const Errors& errors) {
    const judge::Histogram& histogram = errors.histogram;
    ordered_json json;
    json["count"] = histogram.count();
    for (const auto& [name, part] :
         {std::pair("p50", 0.5), std::pair("p99", 0.99), std::pair("p99.99", 0.9999)}) {
        json[name] = histogram.quantile(part);
    }
    json["max"] = histogram.max();
    if (histogram.count() > 0) {
        json["worst"] = reference::hexFloats(errors.worstTorus, errors.worstRay);
    }
    json["histogram"] = ordered_json::array();  // [upper end, count]
    for (const judge::Histogram::Bin& bin : histogram.bins()) {
        json["histogram"].push_back({bin.upperEnd, bin.count});
    }
    return json;
}

ordered_json groupJson(const RayGroupResult& result, const std::string& command) {
    const auto& [group, statistics] = result;
    ordered_json json;
    json["class"] = reference::nameOf(group.rayClass);
    json["majorRadius"] = 1;
    json["minorRadius"] = group.minorRadius;
    json["distance"] = group.distance > 0.0 ? ordered_json(group.distance) : ordered_json(nullptr);
    if (group.passesByMargin()) {
        json["margin"] = {group.margin, group.marginTo};
    }
    json["rays"] = statistics.rays;
    json["judged"] = statistics.judged();
    json["hitting"] = statistics.hitting;
    for (std::size_t i = 1; i < judge::faultKinds; ++i) {
        json["faults"][judge::nameOf(static_cast<judge::Fault>(i))] = statistics.faults[i];
    }
    json["position"] = errorsJson(statistics.position);  // in R + r
    json["t"] = errorsJson(statistics.t);                // in ulp
    json["surface"] = errorsJson(statistics.surface);    // in R + r
    json["examples"] = ordered_json::array();
    for (const Example& example : statistics.examples) {
        json["examples"].push_back({{"fault", judge::nameOf(example.fault)},
                                    {"ray", reference::hexFloats(example.torus, example.ray)},
                                    {"replay", replayCommand(command, example.torus, example.ray)}});
    }
    return json;
}

std::string vectorText(const float (&v)[3]) {
    return fmt::format("({:.9g}, {:.9g}, {:.9g})", v[0], v[1], v[2]);
}

std::string hitText(const reference::Hit& hit) {
    const auto position = reference::toDouble(hit.position);
    return fmt::format("t {:.17g} at ({:.17g}, {:.17g}, {:.17g}), {}", reference::toDouble(hit.t),
                       position[0], position[1], position[2], hit.entering ? "entering" : "leaving");
}

}  // namespace

std::string replayCommand(const std::string& command, const reference::Torus& torus,
                          const reference::Ray& ray) {
    return fmt::format("{} --replay \"{}\"", command, reference::hexFloats(torus, ray));
}

std::string tableText(std::span<const RayGroupResult> results, Rows rows) {
    std::vector<std::pair<std::string, Statistics>> table;
    for (const RayGroupResult& result : results) {
        const std::string name = rowName(result.group, rows);
        auto row =
            std::find_if(table.begin(), table.end(), [&](const auto& other) { return other.first == name; });
        if (row == table.end()) {
            row = table.insert(row, {name, Statistics()});
        }
        row->second.merge(result.statistics);
    }
    std::string text = heading(rows);
    for (const auto& [name, statistics] : table) {
        text += rowText(name, statistics);
    }
    return text;
}

std::string resultsJson(const Run& run, std::span<const RayGroupResult> results,
                        std::span<const std::string> exceeded) {
    ordered_json json;
    json["version"] = version();
    json["method"] = run.method;
    json["device"] = run.device;
    json["driver"] = run.driver;
    json["seed"] = run.seed;
    json["raysPerGroup"] = run.raysPerGroup;
    json["seconds"] = run.seconds;
    json["units"] = {
        {"position", "R + r"}, {"surface", "R + r"}, {"t", "ulp of t, or of (R + r) / 16 if longer"}};
    json["thresholdsExceeded"] = exceeded;
    json["groups"] = ordered_json::array();
    for (const RayGroupResult& result : results) {
        json["groups"].push_back(groupJson(result, run.command));
    }
    return dumpJson(json, 1) + "\n";
}

std::string replayText(const reference::Torus& torus, const reference::Ray& ray,
                       const Verifier::Replay& replay) {
    std::string text = fmt::format(
        "torus R {:.9g}, r {:.9g}\nray   from {}, direction {}, t from {:.9g} to {:.9g}\n", torus.majorRadius,
        torus.minorRadius, vectorText(ray.origin), vectorText(ray.direction), ray.tMin, ray.tMax);
    text += fmt::format(
        "nearest to a tangent: {:.3g} r; ends of the ray from the surface: {:.3g} r and {:.3g} r\n",
        replay.exact.clearance, replay.exact.startClearance, replay.exact.stopClearance);
    text += fmt::format("truth: {} hit(s)\n", replay.exact.count);
    for (int k = 0; k < replay.exact.count; ++k) {
        text += fmt::format("  {}\n", hitText(replay.exact.hits[static_cast<std::size_t>(k)]));
    }
    const judge::Answers& answers = replay.answers;
    const int count = static_cast<int>(answers.all.count);
    text += fmt::format("torusIntersectAll: {} hit(s)\n", count);
    for (int k = 0; k < count && k < 4; ++k) {
        text += fmt::format("  t {:.9g} at {}", answers.all.t[k], vectorText(answers.all.position[k]));
        if (k < replay.judgement.hitCount) {
            const judge::HitErrors& errors = replay.judgement.errors[static_cast<std::size_t>(k)];
            text += fmt::format("; off by {:.3g} (R + r), {:.3g} ulp of t; {:.3g} (R + r) from the surface",
                                errors.position, errors.t, errors.surface);
        }
        text += "\n";
    }
    text += answers.nearest.hit != 0.0F ? fmt::format("torusIntersect: t {:.9g} at {}\n", answers.nearest.t,
                                                      vectorText(answers.nearest.position))
                                        : "torusIntersect: no hit\n";
    text += fmt::format("torusOccluded: {}\n", answers.any != 0.0F ? "yes" : "no");
    text += fmt::format("verdict: {}\n", judge::nameOf(replay.judgement.fault));
    return text;
}

}  // namespace raytorus::verify
