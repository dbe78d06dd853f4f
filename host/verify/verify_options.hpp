// SPDX-License-Identifier: MIT
// The command line of raytorus-verify.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "methods/methods.hpp"
#include "options/device_options.hpp"
#include "verify/report.hpp"

namespace raytorus::verify {

inline constexpr const char* programName = "raytorus-verify";

struct VerifyOptions {
    RayGroupChoice groups;
    std::uint64_t rays = 20000;  ///< a ray group
    std::uint64_t seed = 0;
    bool seedOfTheDay = true;
    Rows rows = Rows::Radius;
    std::string method = methods().front().name;
    trace::ShaderSource shaders;  ///< the method's
    std::string json;             ///< a file; empty: none
    std::optional<reference::TorusAndRay> replay;
    unsigned threads = 0;  ///< 0: as many as there are processors
    options::DeviceOptions device;

    /// This program, with the method and the device that were given.
    [[nodiscard]] std::string command() const;
};

/// Nothing if there is nothing to do: --help and --version have been answered. Throws Error{Usage}.
std::optional<VerifyOptions> parseOptions(const std::vector<std::string>& arguments);

/// 20260131: the date of today, UTC.
std::uint64_t seedOfToday();

}  // namespace raytorus::verify
