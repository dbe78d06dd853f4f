// SPDX-License-Identifier: MIT
#include "verify/replay_text.hpp"

#include <fmt/format.h>

namespace raytorus::verify {
namespace {

std::string vectorText(const float (&v)[3]) {
    return fmt::format("({:.9g}, {:.9g}, {:.9g})", v[0], v[1], v[2]);
}

std::string hitText(const reference::Hit& hit) {
    const auto position = reference::toDouble(hit.position);
    return fmt::format("t {:.17g} at ({:.17g}, {:.17g}, {:.17g}), {}", reference::toDouble(hit.t),
                       position[0], position[1], position[2], hit.entering ? "entering" : "leaving");
}

}  // namespace

std::string replayText(const reference::Torus& torus, const reference::Ray& ray,
                       const Verifier::Replay& replay) {
    std::string text = fmt::format(
        "torus R {:.9g}, r {:.9g}\nray   from {}, direction {}, t from {:.9g} to {:.9g}\n", torus.majorRadius,
        torus.minorRadius, vectorText(ray.origin), vectorText(ray.direction), ray.tMin, ray.tMax);
    text += fmt::format(
        "nearest to a tangent: {:.3g} r; ends of the ray from the surface: {:.3g} r and {:.3g} r\n",
        replay.exact.clearance, replay.exact.startClearance, replay.exact.stopClearance);
    text += fmt::format("truth: {} hit(s)\n", replay.exact.count);
    for (int k = 0; k < replay.exact.count; ++k) {
        text += fmt::format("  {}\n", hitText(replay.exact.hits[static_cast<std::size_t>(k)]));
    }
    const judge::Answers& answers = replay.answers;
    const int count = static_cast<int>(answers.all.count);
    text += fmt::format("torusIntersectAll: {} hit(s)\n", count);
    for (int k = 0; k < count && k < 4; ++k) {
        text += fmt::format("  t {:.9g} at {}", answers.all.t[k], vectorText(answers.all.position[k]));
        if (k < replay.judgement.hitCount) {
            const judge::HitErrors& errors = replay.judgement.errors[static_cast<std::size_t>(k)];
            text += fmt::format("; off by {:.3g} (R + r), {:.3g} ulp of t; {:.3g} (R + r) from the surface",
                                errors.position, errors.t, errors.surface);
        }
        text += "\n";
    }
    text += answers.nearest.hit != 0.0F ? fmt::format("torusIntersect: t {:.9g} at {}\n", answers.nearest.t,
                                                      vectorText(answers.nearest.position))
                                        : "torusIntersect: no hit\n";
    text += fmt::format("torusOccluded: {}\n", answers.any != 0.0F ? "yes" : "no");
    text += fmt::format("verdict: {}\n", judge::nameOf(replay.judgement.fault));
    return text;
}

}  // namespace raytorus::verify
