// SPDX-License-Identifier: MIT
#include "judge/judge.hpp"

#include <cmath>
#include <cstring>
#include <limits>

#include "reference/double_double.hpp"
#include "reference/intersect.hpp"
#include "reference/promise.hpp"

namespace raytorus::judge {
namespace {

using reference::BasicIntersections;
using reference::BasicRay;
using reference::BasicTorus;
using reference::DoubleDouble;
using reference::Vec3;

template <class Real>
ExactHits rounded(const BasicIntersections<Real>& exact) {
    ExactHits hits;
    hits.count = exact.count;
    hits.startsInside = exact.startsInside;
    hits.clearance = exact.clearance;
    hits.startClearance = exact.startClearance;
    hits.stopClearance = exact.stopClearance;
    for (std::size_t i = 0; i < exact.hits.size(); ++i) {
        hits.hits[i] = {reference::toDouble(exact.hits[i].t),
                        reference::convert<double>(exact.hits[i].position), exact.hits[i].entering};
    }
    return hits;
}

double length(const Vec3<double>& v) {
    return std::sqrt(reference::dot(v, v));
}

Vec3<double> widened(const float (&v)[3]) {
    return {double{v[0]}, double{v[1]}, double{v[2]}};
}

bool isFiniteHit(float t, const float (&position)[3]) {
    return std::isfinite(t) && std::isfinite(position[0]) && std::isfinite(position[1]) &&
           std::isfinite(position[2]);
}

Fault verdictFault(const ExactHits& exact, const Answers& answers) {
    const trace::NearestHit& nearest = answers.nearest;
    const trace::AllHits& all = answers.all;
    const bool hit = exact.count > 0;
    const bool found = nearest.hit != 0.0F;
    const int count = static_cast<int>(all.count);
    bool finite = !found || isFiniteHit(nearest.t, nearest.position);
    bool ascending = true;
    for (int k = 0; k < count; ++k) {
        finite = finite && isFiniteHit(all.t[k], all.position[k]);
        ascending = ascending && (k == 0 || all.t[k - 1] <= all.t[k]);
    }
    if (!finite) {
        return Fault::NonFinite;
    }
    const bool touches = reference::differByTouches(exact.clearance, exact.count, count);
    if (found != hit && !touches) {
        return hit ? Fault::Missed : Fault::FalseHit;
    }
    if (count != exact.count && !touches) {
        return Fault::WrongCount;
    }
    if (!ascending) {
        return Fault::Order;
    }
    return agree(answers) ? Fault::None : Fault::Disagreement;
}

}  // namespace

ExactHits arbiterHits(const reference::Torus& torus, const reference::Ray& ray) {
    return rounded(reference::intersect(torus, ray));
}

ExactHits preciseHits(const reference::Torus& torus, const reference::Ray& ray) {
    return rounded(
        reference::intersectAs<DoubleDouble>(BasicTorus<DoubleDouble>(torus), BasicRay<DoubleDouble>(ray)));
}

ExactHits quickHits(const reference::Torus& torus, const reference::Ray& ray) {
    return reference::intersectAs<DoubleDouble, double>(BasicTorus<DoubleDouble>(torus),
                                                        BasicRay<DoubleDouble>(ray));
}

bool agree(const Answers& answers) {
    const trace::NearestHit& nearest = answers.nearest;
    const trace::AllHits& all = answers.all;
    const bool found = nearest.hit != 0.0F;
    const bool first = std::memcmp(&nearest.t, &all.t[0], sizeof(nearest.t)) == 0 &&
                       std::memcmp(nearest.position, all.position[0], sizeof(nearest.position)) == 0;
    return found == (all.count > 0.0F) && found == (answers.any != 0.0F) && (first || !found);
}

const char* nameOf(Fault fault) {
    switch (fault) {
        case Fault::None:
            return "right";
        case Fault::NonFinite:
            return "non-finite";
        case Fault::Missed:
            return "missed";
        case Fault::FalseHit:
            return "false";
        case Fault::WrongCount:
            return "count";
        case Fault::Order:
            return "order";
        case Fault::Disagreement:
            return "disagree";
        case Fault::Gross:
            return "gross";
    }
    return "?";
}

double ulpOf(float t, double size) {
    const float magnitude = std::max(std::abs(t), static_cast<float>(std::ldexp(size, -4)));
    // The largest float has no next one.
    return magnitude < std::numeric_limits<float>::max()
               ? double{std::nextafter(magnitude, INFINITY)} - double{magnitude}
               : std::ldexp(1.0, 104);
}

Judgement judge(const reference::Torus& torus, const reference::Ray& ray, const ExactHits& exact,
                const Answers& answers) {
    Judgement judgement;
    judgement.fault = verdictFault(exact, answers);
    const int count = static_cast<int>(answers.all.count);
    if (count != exact.count) {
        return judgement;
    }
    const double r{torus.minorRadius};
    const double size = double{torus.majorRadius} + r;
    const double rayLength = length(widened(ray.direction));
    const BasicTorus<double> exactTorus{double{torus.majorRadius}, r};
    for (int k = 0; k < count; ++k) {
        const auto& hit = exact.hits[static_cast<std::size_t>(k)];
        const Vec3<double> position = widened(answers.all.position[k]);
        const Vec3<double> off{position[0] - hit.position[0], position[1] - hit.position[1],
                               position[2] - hit.position[2]};
        HitErrors& errors = judgement.errors[static_cast<std::size_t>(judgement.hitCount++)];
        errors.position = length(off) / size;
        const float t = answers.all.t[k];
        errors.t = std::abs(hit.t - double{t}) / ulpOf(t, size / rayLength);
        errors.surface = std::abs(reference::tubeDistance(exactTorus, position)) / size;
        if (judgement.fault == Fault::None && !(errors.position * size <= grossError(torus))) {
            judgement.fault = Fault::Gross;
        }
    }
    return judgement;
}

}  // namespace raytorus::judge
