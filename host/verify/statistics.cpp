// SPDX-License-Identifier: MIT
#include "verify/statistics.hpp"

namespace raytorus::verify {

void Errors::add(double value, const reference::Torus& torus, const reference::Ray& ray) {
    const bool worst = histogram.count() == 0 || value > histogram.max();
    histogram.add(value);
    if (worst) {
        worstTorus = torus;
        worstRay = ray;
    }
}

void Errors::merge(const Errors& other) {
    if (other.histogram.count() > 0 && (histogram.count() == 0 || other.histogram.max() > histogram.max())) {
        worstTorus = other.worstTorus;
        worstRay = other.worstRay;
    }
    histogram.merge(other.histogram);
}

void Statistics::add(const reference::Torus& torus, const reference::Ray& ray, bool hits,
                     const judge::Judgement& judgement) {
    ++rays;
    hitting += hits ? 1U : 0U;
    ++faults[static_cast<std::size_t>(judgement.fault)];
    if (judgement.fault != judge::Fault::None && examples.size() < maxExamples) {
        examples.push_back({judgement.fault, torus, ray});
    }
    for (int k = 0; k < judgement.hitCount; ++k) {
        const judge::HitErrors& errors = judgement.errors[static_cast<std::size_t>(k)];
        position.add(errors.position, torus, ray);
        t.add(errors.t, torus, ray);
        surface.add(errors.surface, torus, ray);
    }
}

void Statistics::merge(const Statistics& other) {
    rays += other.rays;
    unclear += other.unclear;
    hitting += other.hitting;
    for (std::size_t i = 0; i < judge::faultKinds; ++i) {
        faults[i] += other.faults[i];
    }
    for (const Example& example : other.examples) {
        if (examples.size() < maxExamples) {
            examples.push_back(example);
        }
    }
    position.merge(other.position);
    t.merge(other.t);
    surface.merge(other.surface);
}

}  // namespace raytorus::verify
