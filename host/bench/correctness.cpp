// SPDX-License-Identifier: MIT
#include "bench/correctness.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <thread>

#include "core/in_parallel.hpp"
#include "judge/histogram.hpp"
#include "trace/trace_ray.hpp"

namespace raytorus::bench {
namespace {

using trace::Query;

// Aiming looks at some 4096 rays: 0.7 % of hits more or less.
constexpr std::size_t aimingRays = 4096;

struct Judged {
    bool wrong = false;
    double off = 0.0;  ///< the largest error of a position, in R + r; 0 if wrong or if there is none
};

double distanceBetween(std::span<const float> position, const reference::Vec3<double>& exact) {
    return std::hypot(double{position[0]} - exact[0], double{position[1]} - exact[1],
                      double{position[2]} - exact[2]);
}

Judged judgeNearest(const judge::ExactHits& exact, std::span<const float> answer) {
    const bool hit = answer[0] != 0.0F;
    if (hit != (exact.count > 0) || (hit && !std::isfinite(answer[1]))) {
        return {true, 0.0};
    }
    return {false, hit ? distanceBetween(answer.subspan(2, 3), exact.hits[0].position) : 0.0};
}

Judged judgeAll(const judge::ExactHits& exact, std::span<const float> answer) {
    if (answer[0] != static_cast<float>(exact.count)) {
        return {true, 0.0};
    }
    Judged judged;
    for (std::size_t k = 0; k < static_cast<std::size_t>(exact.count); ++k) {
        const bool ascending = k == 0 || answer[k] <= answer[1 + k];
        judged.wrong = judged.wrong || !ascending || !std::isfinite(answer[1 + k]);
        const double off = distanceBetween(answer.subspan(5 + 3 * k, 3), exact.hits[k].position);
        // A NaN is larger than anything, and stays.
        judged.off = off <= judged.off || std::isnan(judged.off) ? judged.off : off;
    }
    return judged;
}

Judged judgeOne(Query query, const judge::ExactHits& exact, std::span<const float> answer) {
    if (query == Query::Any) {
        return {(answer[0] != 0.0F) != (exact.count > 0), 0.0};
    }
    return query == Query::Nearest ? judgeNearest(exact, answer) : judgeAll(exact, answer);
}

bool isGross(const reference::Torus& torus, const Judged& judged) {
    return !(judged.off <= reference::grossError(torus));
}

}  // namespace

ReferenceHits::ReferenceHits(const reference::Torus& wantedTorus, std::vector<trace::TraceRay> wantedRays,
                             unsigned wantedThreads)
    : torus(wantedTorus),
      rays(std::move(wantedRays)),
      threads(wantedThreads > 0 ? wantedThreads : std::max(1U, std::thread::hardware_concurrency())),
      entries(rays.size()) {
    const double endMargin = judge::clearEndMargin(torus);
    inParallel(threads, rays.size(), [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i) {
            entries[i].exact = judge::quickHits(torus, trace::asReferenceRay(rays[i]));
            entries[i].clear = judge::isClear(entries[i].exact, judge::clearMargin, endMargin);
        }
    });
}

double ReferenceHits::hitPart() const {
    const auto hits =
        std::ranges::count_if(entries, [](const Entry& entry) { return entry.exact.count > 0; });
    return static_cast<double>(hits) / static_cast<double>(entries.size());
}

Correctness ReferenceHits::judge(Query query, std::span<const float> answers) {
    const std::size_t floats = answerFloats(query);
    const double size = double{torus.majorRadius} + double{torus.minorRadius};
    Correctness total;
    judge::Histogram errors;
    std::mutex mutex;
    inParallel(threads, entries.size(), [&](std::size_t from, std::size_t to) {
        Correctness part;
        judge::Histogram partErrors;
        for (std::size_t i = from; i < to; ++i) {
            Entry& entry = entries[i];
            if (!entry.clear) {
                continue;
            }
            const std::span<const float> answer = answers.subspan(i * floats, floats);
            Judged judged = judgeOne(query, entry.exact, answer);
            if (!entry.precise && (judged.wrong || isGross(torus, judged))) {
                entry.exact = judge::preciseHits(torus, trace::asReferenceRay(rays[i]));
                entry.precise = true;
                judged = judgeOne(query, entry.exact, answer);
            }
            ++part.judged;
            part.wrong += judged.wrong ? 1U : 0U;
            part.gross += !judged.wrong && isGross(torus, judged) ? 1U : 0U;
            if (!judged.wrong && entry.exact.count > 0 && query != Query::Any) {
                partErrors.add(judged.off / size);
            }
        }
        const std::scoped_lock lock(mutex);
        total.judged += part.judged;
        total.wrong += part.wrong;
        total.gross += part.gross;
        errors.merge(partErrors);
    });
    total.positionP99 = errors.quantile(0.99);
    return total;
}

RayView aimedView(Kernel& kernel, const Workload& workload, std::uint64_t seed) {
    // An odd stride, so that every column of the picture is looked at.
    const std::size_t stride = kernel.rayCount() / aimingRays | 1U;
    return aim(workload, kernel.pixels(), seed, [&](const RayView& tried) {
        return hitPartOf(workload.torus(), kernel.rays(workload.pattern, tried), stride);
    });
}

double hitPartOf(const reference::Torus& torus, std::span<const trace::TraceRay> rays, std::size_t stride) {
    const std::size_t looked = (rays.size() + stride - 1) / stride;
    std::atomic<std::size_t> hits = 0;
    const unsigned threads = std::max(1U, std::thread::hardware_concurrency());
    inParallel(threads, looked, [&](std::size_t from, std::size_t to) {
        std::size_t some = 0;
        for (std::size_t i = from; i < to; ++i) {
            some += judge::quickHits(torus, trace::asReferenceRay(rays[i * stride])).count > 0 ? 1U : 0U;
        }
        hits += some;
    });
    return static_cast<double>(hits) / static_cast<double>(looked);
}

}  // namespace raytorus::bench
