// SPDX-License-Identifier: MIT
#include "verify/verifier.hpp"

#include <algorithm>
#include <mutex>
#include <thread>
#include <vector>

#include "core/in_parallel.hpp"

namespace raytorus::verify {
namespace {

constexpr std::size_t blockRays = std::size_t{1} << 16U;

}  // namespace

Verifier::Verifier(gpu::Context& context, const trace::ShaderSource& shaders, unsigned wantedThreads)
    : threads(wantedThreads > 0 ? wantedThreads : std::max(1U, std::thread::hardware_concurrency())),
      queries(context, blockRays, shaders) {}

Statistics Verifier::judgeBlock(const RayGroup& group, const std::vector<reference::Ray>& rays,
                                const std::vector<judge::Answers>& answers) const {
    const reference::Torus torus = group.torus();
    const double endMargin = judge::clearEndMargin(torus);
    Statistics total;
    std::mutex mutex;
    inParallel(threads, rays.size(), [&](std::size_t from, std::size_t to) {
        Statistics part;
        for (std::size_t i = from; i < to; ++i) {
            const reference::Ray& ray = rays[i];
            judge::ExactHits exact =
                group.needsPreciseHits() ? judge::preciseHits(torus, ray) : judge::quickHits(torus, ray);
            if (!judge::isClear(exact, group.tangentMargin(), endMargin)) {
                ++part.rays;
                ++part.unclear;
                continue;
            }
            judge::Judgement judgement = judge::judge(torus, ray, exact, answers[i]);
            if (judgement.fault != judge::Fault::None) {  // it must stand before the arbiter
                exact = judge::arbiterHits(torus, ray);
                judgement = judge::judge(torus, ray, exact, answers[i]);
            }
            part.add(torus, ray, exact.count > 0, judgement);
        }
        const std::scoped_lock lock(mutex);
        total.merge(part);
    });
    return total;
}

Statistics Verifier::verify(const RayGroup& group, std::uint64_t seed, std::uint64_t count,
                            const std::function<void(std::uint64_t)>& progress) {
    Statistics total;
    std::vector<reference::Ray> rays;
    for (std::uint64_t first = 0; first < count; first += rays.size()) {
        rays.resize(static_cast<std::size_t>(std::min<std::uint64_t>(blockRays, count - first)));
        inParallel(threads, rays.size(), [&](std::size_t from, std::size_t to) {
            for (std::size_t i = from; i < to; ++i) {
                rays[i] = group.ray(seed, first + i);
            }
        });
        total.merge(judgeBlock(group, rays, queries.answer(group.torus(), rays)));
        if (progress) {
            progress(first + rays.size());
        }
    }
    return total;
}

Verifier::Replay Verifier::replay(const reference::Torus& torus, const reference::Ray& ray) {
    Replay replay;
    replay.exact = reference::intersect(torus, ray);
    replay.answers = queries.answer(torus, {ray}).front();
    replay.judgement = judge::judge(torus, ray, judge::arbiterHits(torus, ray), replay.answers);
    return replay;
}

}  // namespace raytorus::verify
