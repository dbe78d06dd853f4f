// SPDX-License-Identifier: MIT
#include "options/option_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <system_error>

#include "core/console.hpp"
#include "core/error.hpp"
#include "core/torus_range.hpp"
#include "options/numbers.hpp"
#include "scene/scene.hpp"

namespace raytorus::options {

namespace {

// By what is there, or, where nothing is there yet, by name.
bool isSameFile(const std::string& one, const std::string& other) {
    namespace fs = std::filesystem;
    std::error_code none;
    return !one.empty() && !other.empty() &&
           (fs::equivalent(one, other, none) ||
            fs::weakly_canonical(fs::absolute(one), none) == fs::weakly_canonical(fs::absolute(other), none));
}

}  // namespace

void refuseToOverwrite(const char* option, const std::string& output, const std::string& input) {
    if (isSameFile(output, input)) {
        throw Error(ExitCode::Usage, fmt::format("{} would overwrite \"{}\", which is read", option, input));
    }
}

void refuseSameFile(const char* option, const std::string& output, const char* other,
                    const std::string& otherOutput) {
    if (isSameFile(output, otherOutput)) {
        throw Error(ExitCode::Usage,
                    fmt::format("{} and {} name the same file, \"{}\"", option, other, output));
    }
}

std::pair<int, int> sizeOption(const std::string& text) {
    const auto size = parseSize(text);
    if (!size) {
        throw Error(ExitCode::Usage, fmt::format("--size takes WIDTHxHEIGHT, each from 1 to {}, not \"{}\"",
                                                 scene::maxImageSize, text));
    }
    return *size;
}

render::Route routeOption(const std::string& text) {
    std::string names;
    for (const render::RouteInfo& info : render::routes) {
        if (text == info.name) {
            return info.route;
        }
        names += fmt::format("{}{}", names.empty() ? "" : " or ", info.name);
    }
    throw Error(ExitCode::Usage, fmt::format("--route takes {}, not \"{}\"", names, text));
}

int samplesOption(const std::string& text, int mostPerSide) {
    const auto side = parseSquare(text);
    if (!side || *side > mostPerSide) {
        throw Error(
            ExitCode::Usage,
            fmt::format("--spp takes a square number of samples, 1, 4, 9, ... {}, for a regular grid, not "
                        "\"{}\"",
                        mostPerSide * mostPerSide, text));
    }
    return *side;
}

void requireTorusInRange(const char* option, const reference::Torus& torus, const std::string& text) {
    const auto [R, r] = torus;
    if (R >= 0.0F && r > 0.0F && std::isfinite(R) && std::isfinite(r) && !isTorusInRange(R, r)) {
        throw Error(ExitCode::Usage, fmt::format("{} needs R + r from {:g} to {:g}, not \"{}\"", option,
                                                 smallestTorus, largestTorus, excerpt(text)));
    }
}

reference::TorusAndRay replayOption(const std::string& text) {
    const auto replay = reference::parseHexFloats(text);
    if (!replay) {
        throw Error(
            ExitCode::Usage,
            fmt::format("--replay takes ten numbers: R r, origin, tMin, direction, tMax; not \"{}\"", text));
    }
    requireTorusInRange("--replay", replay->torus, text);
    return *replay;
}

}  // namespace raytorus::options
