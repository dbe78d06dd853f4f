// SPDX-License-Identifier: MIT
#include "verify/verifier.hpp"

#include <algorithm>
#include <cstring>
#include <mutex>
#include <span>
#include <thread>
#include <vector>

#include "verify/trace_ray.hpp"

namespace raytorus::verify {
namespace {

constexpr std::size_t blockRays = std::size_t{1} << 16U;

// work(from, to) for as many parts of 0 ... count - 1 as there are threads, at the same time.
void inParallel(unsigned threads, std::size_t count,
                const std::function<void(std::size_t, std::size_t)>& work) {
    std::vector<std::jthread> running;
    for (unsigned i = 0; i < threads; ++i) {
        running.emplace_back(work, count * i / threads, count * (i + 1) / threads);
    }
}

// Whether a ray has one right answer; of a grazing one its ends alone decide, being nearly tangent is its
// point.
bool isClear(const Cell& cell, const Truth& truth, double endMargin) {
    return truth.clearance >= (cell.isGrazing() ? cell.margin : clearMargin) &&
           truth.endClearance() >= endMargin;
}

}  // namespace

struct Verifier::Block {
    std::span<const render::TraceRay> rays;
    std::span<const float> nearest;
    std::span<const float> all;
    std::span<const float> any;
};

Verifier::Verifier(gpu::Context& context, const render::ShaderSource& shaders, unsigned wantedThreads)
    : threads(wantedThreads > 0 ? wantedThreads : std::max(1U, std::thread::hardware_concurrency())),
      nearest(context, render::Query::Nearest, blockRays, shaders),
      all(context, render::Query::All, blockRays, shaders),
      any(context, render::Query::Any, blockRays, shaders) {}

Statistics Verifier::judgeBlock(const Cell& cell, const Block& block) const {
    const reference::Torus torus{1.0F, cell.minorRadius};
    const double endMargin = clearEndMargin(torus);
    Statistics total;
    std::mutex mutex;
    inParallel(threads, block.rays.size(), [&](std::size_t from, std::size_t to) {
        Statistics part;
        for (std::size_t i = from; i < to; ++i) {
            const reference::Ray ray = asReferenceRay(block.rays[i]);
            render::NearestHit nearestHit;
            render::AllHits allHits;
            std::memcpy(&nearestHit, &block.nearest[i * render::hitFloats(render::Query::Nearest)],
                        sizeof(nearestHit));
            std::memcpy(&allHits, &block.all[i * render::hitFloats(render::Query::All)], sizeof(allHits));
            Truth truth = cell.isGrazing() ? preciseTruth(torus, ray) : quickTruth(torus, ray);
            if (!isClear(cell, truth, endMargin)) {
                ++part.rays;
                ++part.unclear;
                continue;
            }
            const Answers answers{&nearestHit, &allHits, block.any[i]};
            Judgement judgement = judge(torus, ray, truth, answers);
            if (judgement.fault != Fault::None) {  // it must stand before the arbiter
                truth = arbiterTruth(torus, ray);
                judgement = judge(torus, ray, truth, answers);
            }
            part.add(torus, ray, truth.count > 0, judgement);
        }
        const std::scoped_lock lock(mutex);
        total.merge(part);
    });
    return total;
}

Statistics Verifier::verify(const Cell& cell, std::uint64_t seed, std::uint64_t count,
                            const std::function<void(std::uint64_t)>& progress) {
    Statistics total;
    std::vector<render::TraceRay> rays;
    for (std::uint64_t first = 0; first < count; first += rays.size()) {
        rays.resize(static_cast<std::size_t>(std::min<std::uint64_t>(blockRays, count - first)));
        inParallel(threads, rays.size(), [&](std::size_t from, std::size_t to) {
            for (std::size_t i = from; i < to; ++i) {
                rays[i] = asTraceRay(cell.ray(seed, first + i));
            }
        });
        const Block block{rays, nearest.trace(1.0F, cell.minorRadius, rays),
                          all.trace(1.0F, cell.minorRadius, rays), any.trace(1.0F, cell.minorRadius, rays)};
        total.merge(judgeBlock(cell, block));
        if (progress) {
            progress(first + rays.size());
        }
    }
    return total;
}

Verifier::Replay Verifier::replay(const reference::Torus& torus, const reference::Ray& ray) {
    const std::vector<render::TraceRay> rays{asTraceRay(ray)};
    Replay replay;
    replay.truth = reference::intersect(torus, ray);
    std::memcpy(&replay.nearest, nearest.trace(torus.majorRadius, torus.minorRadius, rays).data(),
                sizeof(replay.nearest));
    std::memcpy(&replay.all, all.trace(torus.majorRadius, torus.minorRadius, rays).data(),
                sizeof(replay.all));
    replay.any = any.trace(torus.majorRadius, torus.minorRadius, rays)[0];
    replay.judgement =
        judge(torus, ray, arbiterTruth(torus, ray), {&replay.nearest, &replay.all, replay.any});
    return replay;
}

}  // namespace raytorus::verify
