// SPDX-License-Identifier: MIT
#include "verify/verify_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/error.hpp"
#include "core/parse_number.hpp"
#include "core/shell_quote.hpp"
#include "options/method_option.hpp"
#include "options/numbers.hpp"
#include "options/option_text.hpp"
#include "options/program.hpp"
#include "trace/device_words.hpp"

namespace raytorus::verify {
namespace {

constexpr const char* footer =
    R"(A group of rays is of one class, one shape of torus and one distance of the origins. All groups are run unless some are
chosen.
Errors of positions are in R + r, those of t in ulp of t (of (R + r) / 16 if t is shorter than that).

Exit codes: 0 every threshold is held, 2 a threshold is exceeded (each is named), others as of raytorus. Thresholds are
what the library promises: of other methods the table alone is printed.

Examples:
  raytorus-verify
  raytorus-verify --class camera,grazing --radius 0.001 --rows distance --rays 1000000
  raytorus-verify --seed 942361370 --json results.json
  raytorus-verify --method closed-form-naive --class camera --rows distance
  raytorus-verify --replay "0x1p+0 0x1p-2  -0x1p+1 0x0p+0 0x0p+0 0x0p+0  0x1p+0 0x0p+0 0x0p+0 inf")";

std::string classNames() {
    std::string names;
    for (const reference::RayClass rayClass : reference::allRayClasses) {
        names += fmt::format("{}{}", names.empty() ? "" : " ", reference::nameOf(rayClass));
    }
    return names;
}

reference::RayClass parseClass(const std::string& name) {
    for (const reference::RayClass rayClass : reference::allRayClasses) {
        if (name == reference::nameOf(rayClass)) {
            return rayClass;
        }
    }
    throw Error(ExitCode::Usage,
                fmt::format("--class: there is no class \"{}\" (there are {})", name, classNames()));
}

Rows parseRows(const std::string& name) {
    for (const auto& [word, rows] :
         {std::pair("class", Rows::Class), std::pair("radius", Rows::Radius),
          std::pair("distance", Rows::Distance), std::pair("group", Rows::Group)}) {
        if (name == word) {
            return rows;
        }
    }
    throw Error(ExitCode::Usage, fmt::format("--rows is class, radius, distance or group, not \"{}\"", name));
}

std::uint64_t parseSeed(const std::string& text) {
    const std::optional<std::uint64_t> seed = parseNumber<std::uint64_t>(text);
    if (!seed) {
        throw Error(ExitCode::Usage,
                    fmt::format("--seed is a whole number below 2^64, or today, not \"{}\"", text));
    }
    return *seed;
}

}  // namespace

std::uint64_t seedOfToday() {
    const std::chrono::year_month_day today{
        std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now())};
    return static_cast<std::uint64_t>(static_cast<int>(today.year())) * 10000U +
           static_cast<unsigned>(today.month()) * 100U + static_cast<unsigned>(today.day());
}

std::string VerifyOptions::command() const {
    const std::string who = method == methods().front().name ? "" : shellOption("--method", method);
    return programName + who + trace::deviceWords(device.context, device.shaderFolder);
}

std::optional<VerifyOptions> parseOptions(const std::vector<std::string>& arguments) {
    VerifyOptions options;
    std::vector<std::string> classes;
    std::string seed;
    std::string rows;
    std::string replay;
    CLI::App app("Draws fresh rays, asks the shaders, and holds every answer to a 113-bit reference.",
                 programName);
    app.set_version_flag("--version", fmt::format("{} {}", programName, version()));
    app.footer(footer);
    app.add_option("--class", classes, "Classes of rays: " + classNames())
        ->delimiter(',')
        ->option_text("NAME,...");
    app.add_option("--radius", options.groups.radii, "Minor radii; the major radius is 1")
        ->delimiter(',')
        ->check(options::decimalNumber(1e-7, 1e4))
        ->option_text("r,...");
    app.add_option("--distance", options.groups.distances, "Distances of the origins from the centre, in R")
        ->delimiter(',')
        ->check(options::decimalNumber(1.0, 1e12))
        ->option_text("D,...");
    app.add_option("--rays", options.rays, "Rays a group")
        ->check(options::wholeNumber(1, std::uint64_t{1} << 40U))
        ->option_text("N [20000]");
    app.add_option("--seed", seed, "A whole number, for the same rays again; today: the date")
        ->option_text("N [today]");
    app.add_option("--rows", rows, "What the table keeps apart: class, radius, distance or group (both)")
        ->option_text("KEY [radius]");
    options::addMethodOption(app, options.method);
    app.add_option("--json", options.json, "Everything, histograms and worst rays too, into a file")
        ->option_text("FILE");
    app.add_option("--replay", replay,
                   "Judge one ray, as failures print it: R r, origin, tMin, direction, tMax")
        ->option_text("\"10 NUMBERS\"");
    app.add_option("--threads", options.threads, "Threads of the reference")
        ->check(options::wholeNumber(1, 1024))
        ->option_text("N [all]");
    options.device.program = programName;
    options::addDeviceOptions(app, options.device);
    if (!options::parse(app, arguments)) {
        return std::nullopt;
    }
    for (const std::string& name : classes) {
        options.groups.classes.push_back(parseClass(name));
    }
    options.shaders = options::shadersOf(options.method, options.device);
    options.rows = rows.empty() ? Rows::Radius : parseRows(rows);
    options.seedOfTheDay = seed.empty() || seed == "today";
    options.seed = options.seedOfTheDay ? seedOfToday() : parseSeed(seed);
    if (!replay.empty()) {
        options.replay = options::replayOption(replay);
    }
    return options;
}

}  // namespace raytorus::verify
