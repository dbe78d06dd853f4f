// SPDX-License-Identifier: MIT
#include "bench/measure.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace raytorus::bench {
namespace {

// Enough that a stream of them leaves every cache.
constexpr std::size_t streamCopies = 16;

constexpr std::uint32_t mostLayers = 4096;

}  // namespace

Measurer::Measurer(gpu::Context& deviceContext, std::vector<TimedMethod> chosen,
                   const MeasureOptions& measureOptions)
    : context(&deviceContext),
      methods(std::move(chosen)),
      options(measureOptions),
      kernel(deviceContext, measureOptions.side) {}

std::vector<CellResult> Measurer::measure(const Workload& workload, std::span<const trace::Query> queries,
                                          const std::function<void(double)>& progress) {
    const reference::Torus torus = workload.torus();
    kernel.forgetPipelines();  // so that no method has bad luck in every workload
    const RayView view = aimedView(kernel, workload, options.seed);
    const std::vector<trace::TraceRay> rays = kernel.rays(workload.pattern, view);
    ReferenceHits expected(torus, rays);
    std::optional<Stream> stream;
    if (workload.mode == Mode::Streamed) {
        const std::size_t room = trace::Tracer::maxCapacity(*context, trace::Query::All) / kernel.rayCount();
        stream.emplace(*context, torus, rays, std::clamp<std::size_t>(room, 1, streamCopies));
    }
    std::vector<CellResult> results;
    for (const trace::Query query : queries) {
        results.push_back(
            measureQuery(workload, query, view, expected, stream ? &*stream : nullptr, [&](double part) {
                if (progress) {
                    progress((static_cast<double>(results.size()) + part) /
                             static_cast<double>(queries.size()));
                }
            }));
    }
    return results;
}

std::uint32_t Measurer::layersFor(double secondsOfOne) const {
    if (options.layers > 0) {
        return options.layers;
    }
    const double wanted = std::ceil(options.leastSeconds / std::max(secondsOfOne, 1e-9));
    return static_cast<std::uint32_t>(std::clamp(wanted, 1.0, double{mostLayers}));
}

CellResult Measurer::measureQuery(const Workload& workload, trace::Query query, const RayView& view,
                                  ReferenceHits& expected, Stream* stream,
                                  const std::function<void(double)>& progress) {
    CellResult cell{workload, query, expected.hitPart(), kernel.rayCount(), {}};
    std::vector<std::function<Shot()>> contestants;
    for (const TimedMethod& method : methods) {
        MethodResult result;
        result.name = method.name;
        std::vector<float> answers;
        if (stream != nullptr) {
            stream->time(method, query);
            answers = stream->answers(query);
            result.layers = static_cast<std::uint32_t>(stream->rayCount() / kernel.rayCount());
            contestants.emplace_back([&method, query, stream] { return stream->time(method, query); });
        } else {
            answers = kernel.answers(method, query, workload.pattern, view);
            const auto time = [this, &method, query, &workload, &view](std::uint32_t layers) {
                return kernel.time(method, query, workload.pattern, view, layers);
            };
            // In the first run the driver compiles.
            result.checksumHeld = time(1).checksum == checksumOf(answers);
            result.layers = layersFor(time(1).seconds);
            contestants.emplace_back([time, layers = result.layers] { return time(layers); });
        }
        if (method.name != emptyName) {
            result.correctness = expected.judge(query, answers);
        }
        cell.methods.push_back(result);
        progress(0.5 * static_cast<double>(cell.methods.size()) / static_cast<double>(methods.size()));
    }
    const std::vector<Series> series = takeTurns(contestants, options.rounds);
    const auto indexOf = [this](const char* name) {
        return static_cast<std::size_t>(std::ranges::find(methods, name, &TimedMethod::name) -
                                        methods.begin());
    };
    // Streamed, what the rays and answers cost is the point.
    const Series* empty = stream != nullptr ? nullptr : &series[indexOf(emptyName)];
    for (std::size_t i = 0; i < series.size(); ++i) {
        cell.methods[i].times = timesOf(series[i], series[indexOf(ourName)], empty);
        cell.methods[i].checksumHeld = cell.methods[i].checksumHeld && series[i].checksumHeld;
    }
    progress(1.0);
    return cell;
}

}  // namespace raytorus::bench
