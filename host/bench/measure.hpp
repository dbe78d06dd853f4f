// SPDX-License-Identifier: MIT
// A workload, verified and timed.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "bench/kernel.hpp"
#include "bench/result.hpp"
#include "bench/stream.hpp"

namespace raytorus::bench {

struct MeasureOptions {
    std::uint32_t side = 4;      ///< of the picture, in blocks of 64 x 64 rays
    unsigned rounds = 15;        ///< timed runs of each method
    double leastSeconds = 2e-3;  ///< that a run is to take; else it answers the rays again and again
    std::uint32_t layers = 0;    ///< how often a run answers the rays; 0: as leastSeconds wants
    std::uint64_t seed = 0;
};

class Measurer {
public:
    Measurer(gpu::Context& context, std::vector<TimedMethod> methods, const MeasureOptions& options);

    /// Aims the workload's rays, holds every method's answers to the exact hits, then times them. `progress`
    /// hears the part that is done, 0 to 1, of this workload.
    std::vector<CellResult> measure(const Workload& workload, std::span<const trace::Query> queries,
                                    const std::function<void(double)>& progress = {});

private:
    CellResult measureQuery(const Workload& workload, trace::Query query, const RayView& view,
                            ReferenceHits& expected, Stream* stream,
                            const std::function<void(double)>& progress);
    [[nodiscard]] std::uint32_t layersFor(double secondsOfOne) const;

    gpu::Context* context;
    std::vector<TimedMethod> methods;
    MeasureOptions options;
    Kernel kernel;
};

}  // namespace raytorus::bench
