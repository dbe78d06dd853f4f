// SPDX-License-Identifier: MIT
// The machine code of every method for an AMD GPU, counted by Mesa's radv, which compiles for a GPU that is
// not there: one ray in, one answer out (one_ray.comp).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bench/timed_method.hpp"
#include "gpu/context.hpp"
#include "trace/tracer.hpp"

namespace raytorus::bench {

struct IsaRow {
    std::string method;
    trace::Query query = trace::Query::Nearest;
    std::vector<std::pair<std::string, std::uint64_t>> statistics;  ///< by the driver's names
    double compileMs =
        0.0;  ///< milliseconds in which the driver makes the pipeline, the fastest of some times

    /// Nothing if the driver does not count it.
    [[nodiscard]] std::optional<std::uint64_t> of(std::string_view statistic) const;
};

/// From now on Vulkan knows one device: radv's, which only compiles, for `family` ("navi21"). Call it before
/// the first use of Vulkan. Where VK_DRIVER_FILES is set it stays as it is. Throws Error{NoDevice} if radv is
/// not installed.
void chooseNullDevice(const std::string& family);

/// Compiles each method and query. Throws Error{NoDevice} if the device counts nothing.
std::vector<IsaRow> countInstructions(gpu::Context& context, std::span<const TimedMethod> methods,
                                      std::span<const trace::Query> queries);

/// The instructions of a shader with the bindings of one_ray.comp and one specialization constant.
std::uint64_t countInstructions(gpu::Context& context, std::span<const std::uint32_t> words,
                                const std::string& name, std::uint32_t constant);

std::string isaText(std::span<const IsaRow> rows);

/// {"format": "raytorus-bench-isa", "version": 1, "device": ..., "driver": ..., "rows": [{"method": ...,
/// "query": ..., "compileMs": 1.5, "Instructions": 1, ...}, ...]}
std::string isaJson(const gpu::DeviceInfo& device, std::span<const IsaRow> rows);

}  // namespace raytorus::bench
