// SPDX-License-Identifier: MIT
#include "hit_match.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "judge/judge.hpp"
#include "reference/torus_reference.hpp"
#include "special_floats.hpp"

namespace raytorus::test {
namespace {

using judge::Answers;
using reference::Hit;
using reference::Quad;

constexpr Quad largestFloat = std::numeric_limits<float>::max();

double absolute(Quad x) {
    return std::abs(reference::toDouble(x));
}

double length(const reference::QuadVec3& v) {
    return std::sqrt(reference::toDouble(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]));
}

bool haveSameBits(float a, float b) {
    return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

// The hits of the whole line, and which of them the ray must have, may have, or cannot have.
struct ExpectedHits {
    int count = 0;
    std::array<Hit, 4> hits;
    unsigned must = 0;  // a bit a hit
    unsigned may = 0;
    bool touches = false;  // somewhere: then the hits are not to be relied on
    bool odd = false;      // starts and ends on different sides
    bool endsOnSurface = false;
};

struct Line {
    reference::Torus torus;
    reference::Ray ray;
    double size;       // R + r
    double rayLength;  // of the direction

    reference::QuadVec3 at(Quad t) const {
        reference::QuadVec3 point = reference::toQuad(ray.origin);
        for (std::size_t i = 0; i < 3; ++i) {
            point[i] += t * Quad(ray.direction[i]);
        }
        return point;
    }
    bool inside(float t) const { return std::isfinite(t) && reference::distance(torus, at(Quad(t))) < 0; }
    double distanceAt(Quad t) const { return absolute(reference::distance(torus, at(t))); }
};

// The hit nearest to an end of the ray may go either way if the end lies on the surface.
void loosenEnd(ExpectedHits& expected, const Line& line, Quad end) {
    const double r{line.torus.minorRadius};
    const double margin = judge::clearEndMargin(line.torus) * r;
    if (expected.count == 0 || !(absolute(end) <= absolute(largestFloat)) ||
        !(line.distanceAt(end) < margin)) {
        return;
    }
    int nearest = 0;
    for (int k = 1; k < expected.count; ++k) {
        const auto i = static_cast<std::size_t>(k), j = static_cast<std::size_t>(nearest);
        nearest = absolute(expected.hits[i].t - end) < absolute(expected.hits[j].t - end) ? k : nearest;
    }
    expected.endsOnSurface = true;
    expected.may |= 1U << nearest;
}

ExpectedHits expectedOf(const Line& line) {
    reference::Ray whole = line.ray;
    whole.tMin = -infinity;
    whole.tMax = infinity;
    const reference::Intersections found = reference::intersect(line.torus, whole);
    ExpectedHits expected;
    expected.count = line.ray.tMin <= line.ray.tMax ? found.count : 0;
    expected.hits = found.hits;
    const double r{line.torus.minorRadius};
    expected.odd = line.inside(line.ray.tMin) != line.inside(line.ray.tMax);
    expected.touches = found.clearance * r <= tangentMargin * line.size;
    for (int k = 0; k < expected.count; ++k) {
        const Quad t = expected.hits[static_cast<std::size_t>(k)].t;
        // A t that no float holds is no hit.
        if (t >= Quad(line.ray.tMin) && t <= Quad(line.ray.tMax) && t >= -largestFloat && t <= largestFloat) {
            expected.must |= 1U << k;
        }
    }
    loosenEnd(expected, line, Quad(line.ray.tMin));
    loosenEnd(expected, line, Quad(line.ray.tMax));
    return expected;
}

// One hit against the exact one. Where a pair touches, rounding decides the place along the line (a depth of
// 2^-38 (R + r) is 2^-19 long, and 2^-10 where line and surface meet as closely as they can): then the hit is
// held to the surface and to its own t instead.
std::string misplaced(const Line& line, const Hit* exact, const float (&position)[3], float t) {
    const reference::QuadVec3 at = reference::toQuad(position);
    const double offSurface = absolute(reference::distance(line.torus, at)) / line.size;
    if (!(offSurface <= judge::positionBound)) {
        return fmt::format("a position is {:.3g} (R + r) off the surface", offSurface);
    }
    const double ulp = judge::ulpOf(t, line.size / line.rayLength);
    const reference::QuadVec3 there = exact == nullptr ? line.at(Quad(t)) : exact->position;
    const double error = length({there[0] - at[0], there[1] - at[1], there[2] - at[2]}) / line.size;
    const double tRounding = exact == nullptr ? judge::tBound * ulp * line.rayLength / line.size : 0.0;
    if (!(error <= judge::positionBound + tRounding)) {
        return fmt::format("a position is off by {:.3g} (R + r)", error);
    }
    // A hit that rounding puts beyond an end is the one at the end.
    const Quad exactT =
        exact == nullptr ? Quad(t) : std::clamp(exact->t, Quad(line.ray.tMin), Quad(line.ray.tMax));
    const double tError = absolute(exactT - Quad(t)) / ulp;
    if (!(tError <= judge::tBound)) {
        return fmt::format("a t is off by {:.3g} ulp", tError);
    }
    return {};
}

// The answer that holds the hits of `taken`; empty if it does.
std::string differs(const Line& line, const ExpectedHits& expected, unsigned taken,
                    const trace::AllHits& all) {
    int index = 0;
    for (int k = 0; k < expected.count; ++k) {
        if ((taken >> k & 1U) != 0) {
            const std::string fault = misplaced(line, &expected.hits[static_cast<std::size_t>(k)],
                                                all.position[index], all.t[index]);
            if (!fault.empty()) {
                return fmt::format("hit {}: {}", index, fault);
            }
            ++index;
        }
    }
    return {};
}

// Where the line touches, rounding decides about pairs, the reference's own too: every hit must be one, and
// their number even from outside and odd from inside.
std::string touchingFault(const Line& line, const ExpectedHits& expected, const trace::AllHits& all) {
    const int count = static_cast<int>(all.count);
    for (int k = 0; k < count; ++k) {
        const std::string fault = misplaced(line, nullptr, all.position[k], all.t[k]);
        if (!fault.empty()) {
            return fmt::format("hit {}: {}", k, fault);
        }
    }
    const bool odd = count % 2 != 0;
    return expected.endsOnSurface || odd == expected.odd ? ""
                                                         : fmt::format("{} hits where a line touches", count);
}

std::string disagreement(const Line& line, const ExpectedHits& expected, const Answers& answers) {
    const trace::NearestHit& nearest = answers.nearest;
    const trace::AllHits& all = answers.all;
    if (!expected.endsOnSurface) {
        return judge::agree(answers)
                   ? std::string()
                   : fmt::format("{} hits, the first at t {:a}; nearest {} at t {:a}; any {}", all.count,
                                 all.t[0], nearest.hit, nearest.t, answers.any);
    }
    // Each function decides for itself about a hit at an end.
    const unsigned sure = expected.touches ? 0 : expected.must & ~expected.may;
    if (sure != 0 && (nearest.hit == 0.0F || answers.any == 0.0F)) {
        return fmt::format("a hit within the ray is missed: nearest {}, any {}", nearest.hit, answers.any);
    }
    if (nearest.hit == 0.0F) {
        return {};
    }
    std::string fault = "the nearest hit is none";
    for (int k = 0; k < expected.count && !fault.empty(); ++k) {
        if (((expected.must | expected.may) >> k & 1U) != 0) {
            const std::string here =
                misplaced(line, expected.touches ? nullptr : &expected.hits[static_cast<std::size_t>(k)],
                          nearest.position, nearest.t);
            fault = here.empty() ? "" : "nearest: " + here;
        }
        if ((sure >> k & 1U) != 0) {
            break;
        }
    }
    return fault;
}

}  // namespace

std::string malformed(const reference::Ray& ray, const Answers& answers) {
    const trace::AllHits& all = answers.all;
    const int count = static_cast<int>(all.count);
    if (static_cast<float>(count) != all.count || count < 0 || count > 4) {
        return fmt::format("{} hits", all.count);
    }
    for (int k = 0; k < 4; ++k) {
        bool fine = k < count ? all.t[k] >= ray.tMin && all.t[k] <= ray.tMax && std::isfinite(all.t[k])
                              : haveSameBits(all.t[k], ray.tMax);
        for (const float x : all.position[k]) {
            fine = fine && (k < count ? std::isfinite(x) : haveSameBits(x, 0.0F));
        }
        if (!fine || (k > 0 && !(all.t[k] >= all.t[k - 1]))) {
            return fmt::format("entry {} of {} holds what it must not: t = {}", k, count, all.t[k]);
        }
    }
    const trace::NearestHit& nearest = answers.nearest;
    bool fine = nearest.hit != 0.0F
                    ? nearest.t >= ray.tMin && nearest.t <= ray.tMax && std::isfinite(nearest.t)
                    : haveSameBits(nearest.t, ray.tMax);
    for (int i = 0; i < 3; ++i) {
        fine = fine &&
               (nearest.hit != 0.0F ? std::isfinite(nearest.position[i]) && std::isfinite(nearest.normal[i])
                                    : haveSameBits(nearest.position[i], 0.0F));
    }
    return fine ? "" : fmt::format("the nearest hit holds what it must not: t = {}", nearest.t);
}

std::string mismatch(const reference::Torus& torus, const reference::Ray& ray, const Answers& answers) {
    std::string fault = malformed(ray, answers);
    if (!fault.empty()) {
        return fault;
    }
    const Line line{torus, ray, double{torus.majorRadius} + double{torus.minorRadius},
                    length(reference::toQuad(ray.direction))};
    const ExpectedHits expected = expectedOf(line);
    fault = disagreement(line, expected, answers);
    if (!fault.empty()) {
        return fault;
    }
    if (expected.touches) {
        return touchingFault(line, expected, answers.all);
    }
    const int count = static_cast<int>(answers.all.count);
    fault = fmt::format("{} hits instead of {}", count, std::popcount(expected.must));
    for (unsigned taken = 0; taken < 1U << expected.count; ++taken) {
        // What the ray must have and may have differ by the hits at its ends.
        const bool allowed =
            (taken & ~(expected.must | expected.may)) == 0 && (expected.must & ~(taken | expected.may)) == 0;
        if (allowed && std::popcount(taken) == count) {
            fault = differs(line, expected, taken, answers.all);
            if (fault.empty()) {
                return {};
            }
        }
    }
    return fault;
}

}  // namespace raytorus::test
