// SPDX-License-Identifier: MIT
// What a group of lanes pays: a GPU runs 32 or 64 rays at a time, and each of them waits for the slowest.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gpu/context.hpp"
#include "trace/tracer.hpp"

namespace raytorus::bench {

/// What the library does for one ray, as count_passes.comp tells it.
struct RayPath {
    std::uint32_t steps;
    std::uint32_t stepsOfPasses;   ///< of the first passes, some bits each
    std::uint32_t refiningPasses;  ///< a bit a pass
    std::uint32_t hitsAndRefinements;

    [[nodiscard]] std::uint32_t hits() const;
    [[nodiscard]] std::uint32_t refinements() const;
    [[nodiscard]] std::uint32_t stepsOf(int pass) const;
};

/// Instructions of the library's parts, and of the closed form that everybody pastes.
struct PartCosts {
    double ends = 0.0;  ///< reduction, clip and start, and what makes a hit of a crossing
    double step = 0.0;
    double refinement = 0.0;
    double closedForm = 0.0;
};

inline constexpr std::array<std::size_t, 3> groupSizes = {8, 32, 64};

struct GroupRow {
    std::string rays;  ///< "tiles", "scattered", "second", "inside"
    float minorRadius = 0.25F;
    std::size_t count = 0;
    double hitPart = 0.0;
    double steps = 0.0;               ///< of a ray that takes any
    std::array<double, 3> slowest{};  ///< mean of the most steps of 8, 32 and 64 rays
    double refiningRays = 0.0;        ///< part of the rays that refine but for the last step of a hit ...
    double refiningGroups = 0.0;      ///< ... and of the groups of 64 with such a ray
    std::array<double, 3>
        instructions{};  ///< issued for 8, 32 and 64 rays; 0 where nothing is known of the parts
};

/// The row of rays of which these are the paths, in the order of their lanes.
GroupRow groupRow(std::span<const RayPath> paths, const std::optional<PartCosts>& costs);

/// Instructions that a group issues: its ends, the steps of its slowest ray in each pass, and a refinement in
/// each pass in which one of its rays has one.
double groupInstructions(std::span<const RayPath> group, const PartCosts& costs);

/// By Mesa's radv, which compiles for a GPU that is not there; nothing if radv is not installed.
std::optional<PartCosts> countParts(const std::string& family);

struct GroupOptions {
    std::uint64_t seed = 1;
    std::uint32_t side = 4;  ///< of the picture, in blocks of 64 x 64 rays
};

/// Nearest hits of tiles, scattered rays, rays that leave the surface and rays that start inside, for each r
/// / R.
std::vector<GroupRow> measureGroups(gpu::Context& context, const GroupOptions& options,
                                    const std::optional<PartCosts>& costs,
                                    const std::function<void(double)>& progress);

std::string groupsText(std::span<const GroupRow> rows, const std::optional<PartCosts>& costs);

/// {"format": "raytorus-bench-groups", "version": 1, "device": ..., "driver": ..., "seed": ..., "parts":
/// {...}, "rows":
/// [{"rays": "tiles", "minorRadius": 0.25, ...}, ...]}
std::string groupsJson(const gpu::DeviceInfo& device, std::uint64_t seed, std::span<const GroupRow> rows,
                       const std::optional<PartCosts>& costs);

}  // namespace raytorus::bench
