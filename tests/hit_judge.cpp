// SPDX-License-Identifier: MIT
#include "hit_judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "device_fixture.hpp"
#include "hit_match.hpp"
#include "reference/torus_reference.hpp"

namespace raytorus::test {
namespace {

constexpr std::size_t shownFaults = 5;

template <typename Row>
std::vector<Row> traceRows(render::Tracer& tracer, const reference::Torus& torus,
                           const std::vector<render::TraceRay>& rays) {
    const std::span<const float> values = tracer.trace(torus.majorRadius, torus.minorRadius, rays);
    std::vector<Row> rows(rays.size());
    std::memcpy(rows.data(), values.data(), values.size_bytes());
    return rows;
}

double length(const reference::QuadVec3& v) {
    return std::sqrt(reference::toDouble(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]));
}

double distanceBetween(const reference::QuadVec3& exact, const float (&actual)[3]) {
    return length({exact[0] - actual[0], exact[1] - actual[1], exact[2] - actual[2]});
}

// See tBound. `size` is R + r in lengths of the direction.
double ulpsBetween(reference::Quad exact, float actual, double size) {
    const float magnitude = std::max(std::abs(actual), static_cast<float>(std::ldexp(size, -4)));
    const double ulp = static_cast<double>(std::nextafter(magnitude, INFINITY) - magnitude);
    return std::abs(reference::toDouble(exact - actual)) / ulp;
}

// The verdicts of one ray; empty if they are right.
std::string faultOf(const reference::Intersections& truth, const render::NearestHit& nearest,
                    const render::AllHits& all, float any) {
    const bool hit = truth.count > 0;
    if ((nearest.hit != 0.0F) != hit) {
        return hit ? "missed" : "false hit";
    }
    if (static_cast<int>(all.count) != truth.count) {
        return fmt::format("{} hits instead of {}", all.count, truth.count);
    }
    if ((any != 0.0F) != hit) {
        return fmt::format("torusOccluded says {}", any);
    }
    if (hit && (std::memcmp(&nearest.t, &all.t[0], sizeof(float)) != 0 ||
                std::memcmp(nearest.position, all.position[0], sizeof(nearest.position)) != 0)) {
        return "the nearest hit is not the first of all";
    }
    return {};
}

}  // namespace

struct HitJudge::Answers {
    std::vector<render::NearestHit> nearest;
    std::vector<render::AllHits> all;
    std::vector<float> any;
};

HitJudge::HitJudge(std::size_t capacity)
    : nearest(device(), render::Query::Nearest, capacity),
      all(device(), render::Query::All, capacity),
      any(device(), render::Query::Any, capacity) {}

HitJudge::Answers HitJudge::ask(const reference::Torus& torus, const std::vector<reference::Ray>& rays) {
    static_assert(sizeof(reference::Ray) == sizeof(render::TraceRay));
    std::vector<render::TraceRay> input(rays.size());
    std::memcpy(input.data(), rays.data(), rays.size() * sizeof(reference::Ray));
    return {traceRows<render::NearestHit>(nearest, torus, input),
            traceRows<render::AllHits>(all, torus, input), traceRows<float>(any, torus, input)};
}

namespace {

void addFault(Judgement& judgement, const std::string& what, const std::string& name, std::size_t index,
              const reference::Torus& torus, const reference::Ray& ray) {
    if (!what.empty() && ++judgement.faultCount <= shownFaults) {
        judgement.faults.push_back(
            fmt::format("{}, ray {}: {}\n  {}", name, index, what, reference::hexFloats(torus, ray)));
    }
}

// The first of a ray's hits that is not where it must be; empty if none is. Notes how far off each is.
std::string misplaced(const reference::Torus& torus, const reference::Ray& ray,
                      const reference::Intersections& truth, const render::AllHits& all,
                      Judgement& judgement) {
    const double size = static_cast<double>(torus.majorRadius) + static_cast<double>(torus.minorRadius);
    const double rayLength = length(reference::toQuad(ray.direction));
    for (int k = 0; k < truth.count; ++k) {
        const auto& exact = truth.hits[static_cast<std::size_t>(k)];
        const float(&position)[3] = all.position[k];
        const double error = distanceBetween(exact.position, position) / size;
        const double tError = ulpsBetween(exact.t, all.t[k], size / rayLength);
        const double surface =
            std::abs(reference::toDouble(reference::distance(torus, reference::toQuad(position))));
        judgement.offSurface = std::max(judgement.offSurface, surface / size);
        judgement.positionError = std::max(judgement.positionError, error);
        judgement.tError = std::max(judgement.tError, tError);
        if (!(error <= positionBound)) {
            return fmt::format("position {} is off by {:.3g} (R + r)", k, error);
        }
        if (!(tError <= tBound)) {
            return fmt::format("t {} is off by {:.3g} ulp", k, tError);
        }
    }
    return {};
}

}  // namespace

Judgement HitJudge::judge(const reference::Torus& torus, const std::vector<reference::Ray>& rays,
                          const std::string& name) {
    const Answers answers = ask(torus, rays);
    const double endMargin = clearEndMargin(static_cast<double>(torus.minorRadius));
    Judgement judgement;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const reference::Intersections truth = reference::intersect(torus, rays[i]);
        if (truth.clearance < clearMargin || truth.endClearance() < endMargin) {
            ++judgement.unclear;
            continue;
        }
        ++judgement.judged;
        judgement.hits += truth.count > 0 ? 1 : 0;
        std::string fault = faultOf(truth, answers.nearest[i], answers.all[i], answers.any[i]);
        if (fault.empty()) {
            fault = misplaced(torus, rays[i], truth, answers.all[i], judgement);
        }
        addFault(judgement, fault, name, i, torus, rays[i]);
    }
    return judgement;
}

Judgement HitJudge::judgeVerdicts(const reference::Torus& torus, const std::vector<reference::Ray>& rays,
                                  const std::string& name) {
    const Answers answers = ask(torus, rays);
    const double endMargin = clearEndMargin(static_cast<double>(torus.minorRadius));
    Judgement judgement;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const reference::Intersections truth = reference::intersect(torus, rays[i]);
        if (truth.endClearance() < endMargin) {
            ++judgement.unclear;
            continue;
        }
        ++judgement.judged;
        judgement.hits += truth.count > 0 ? 1 : 0;
        addFault(judgement, faultOf(truth, answers.nearest[i], answers.all[i], answers.any[i]), name, i,
                 torus, rays[i]);
    }
    return judgement;
}

std::vector<std::string> HitJudge::mismatches(const reference::Torus& torus,
                                              const std::vector<reference::Ray>& rays) {
    const Answers answers = ask(torus, rays);
    std::vector<std::string> faults(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const std::string fault =
            mismatch(torus, rays[i], {answers.nearest[i], answers.all[i], answers.any[i]});
        faults[i] = fault.empty() ? "" : fault + "\n  " + reference::hexFloats(torus, rays[i]);
    }
    return faults;
}

}  // namespace raytorus::test
