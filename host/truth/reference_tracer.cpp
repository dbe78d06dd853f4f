// SPDX-License-Identifier: MIT
#include "truth/reference_tracer.hpp"

#include <algorithm>
#include <limits>
#include <thread>

#include "core/in_parallel.hpp"
#include "trace/trace_ray.hpp"

namespace raytorus::truth {
namespace {

// tMax, or 0 if that is no number: the library's contract.
float missT(const reference::Ray& ray) {
    return ray.tMax >= -std::numeric_limits<float>::max() ? ray.tMax : 0.0F;
}

void store(const reference::QuadVec3& from, std::span<float> to) {
    for (std::size_t i = 0; i < 3; ++i) {
        to[i] = static_cast<float>(from[i]);
    }
}

void answer(trace::Query query, const reference::Torus& torus, const reference::Ray& ray,
            std::span<float> row) {
    const reference::Intersections found = reference::intersect(torus, ray);
    std::ranges::fill(row, 0.0F);
    if (query == trace::Query::Any) {
        row[0] = found.count > 0 ? 1.0F : 0.0F;
        return;
    }
    if (query == trace::Query::All) {
        row[0] = static_cast<float>(found.count);
        for (std::size_t k = 0; k < 4; ++k) {
            const bool hit = static_cast<int>(k) < found.count;
            row[1 + k] = hit ? static_cast<float>(found.hits[k].t) : missT(ray);
            if (hit) {
                store(found.hits[k].position, row.subspan(5 + 3 * k, 3));
            }
        }
        return;
    }
    row[1] = missT(ray);
    if (found.count > 0) {
        row[0] = 1.0F;
        row[1] = static_cast<float>(found.hits[0].t);
        store(found.hits[0].position, row.subspan(2, 3));
        store(reference::normal(torus, found.hits[0].position), row.subspan(5, 3));
    }
}

}  // namespace

std::vector<float> traceByReference(trace::Query query, const reference::Torus& torus,
                                    std::span<const trace::TraceRay> rays) {
    const std::size_t floats = trace::hitFloats(query);
    std::vector<float> hits(rays.size() * floats);
    const auto answerSome = [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i) {
            answer(query, torus, trace::asReferenceRay(rays[i]), std::span(hits).subspan(i * floats, floats));
        }
    };
    inParallel(std::max(1U, std::thread::hardware_concurrency()), rays.size(), answerSome);
    return hits;
}

}  // namespace raytorus::truth
