// SPDX-License-Identifier: MIT
#include "hit_judge.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "reference/torus_reference.hpp"
#include "support/device_fixture.hpp"
#include "support/hit_match.hpp"

namespace raytorus::test {
namespace {

constexpr std::size_t shownFaults = 5;

void addFault(HitTally& judgement, const std::string& what, const std::string& name, std::size_t index,
              const reference::Torus& torus, const reference::Ray& ray) {
    if (!what.empty() && ++judgement.faultCount <= shownFaults) {
        judgement.faults.push_back(
            fmt::format("{}, ray {}: {}\n  {}", name, index, what, reference::hexFloats(torus, ray)));
    }
}

// What is wrong with the answers to a ray, for people; empty if nothing is.
std::string faultOf(const judge::Judgement& judged, const judge::ExactHits& truth,
                    const trace::AllHits& all) {
    if (judged.fault == judge::Fault::WrongCount) {
        return fmt::format("{} hits instead of {}", all.count, truth.count);
    }
    return judged.fault == judge::Fault::None ? std::string() : judge::nameOf(judged.fault);
}

// The first of a ray's hits that is not where it must be; empty if none is. Notes how far off each is.
std::string misplaced(const judge::Judgement& judged, HitTally& judgement) {
    for (int k = 0; k < judged.hitCount; ++k) {
        const judge::HitErrors& errors = judged.errors[static_cast<std::size_t>(k)];
        judgement.offSurface = std::max(judgement.offSurface, errors.surface);
        judgement.positionError = std::max(judgement.positionError, errors.position);
        judgement.tError = std::max(judgement.tError, errors.t);
        if (!(errors.position <= judge::positionBound)) {
            return fmt::format("position {} is off by {:.3g} (R + r)", k, errors.position);
        }
        if (!(errors.t <= judge::tBound)) {
            return fmt::format("t {} is off by {:.3g} ulp", k, errors.t);
        }
    }
    return {};
}

}  // namespace

HitJudge::HitJudge(std::size_t capacity) : queries(device(), capacity) {}

HitTally HitJudge::judgeAll(const reference::Torus& torus, const std::vector<reference::Ray>& rays,
                            const std::string& name, bool clearOnly) {
    const std::vector<judge::Answers> answers = queries.answer(torus, rays);
    const double endMargin = judge::clearEndMargin(torus);
    HitTally judgement;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const judge::ExactHits truth = judge::arbiterHits(torus, rays[i]);
        if (!judge::isClear(truth, clearOnly ? judge::clearMargin : 0.0, endMargin)) {
            ++judgement.unclear;
            continue;
        }
        ++judgement.judged;
        judgement.hits += truth.count > 0 ? 1 : 0;
        const judge::Judgement judged = judge::judge(torus, rays[i], truth, answers[i]);
        std::string fault;
        if (clearOnly || judged.fault != judge::Fault::Gross) {
            fault = faultOf(judged, truth, answers[i].all);
        }
        if (clearOnly && fault.empty()) {
            fault = misplaced(judged, judgement);
        }
        addFault(judgement, fault, name, i, torus, rays[i]);
    }
    return judgement;
}

HitTally HitJudge::judge(const reference::Torus& torus, const std::vector<reference::Ray>& rays,
                         const std::string& name) {
    return judgeAll(torus, rays, name, true);
}

HitTally HitJudge::judgeVerdicts(const reference::Torus& torus, const std::vector<reference::Ray>& rays,
                                 const std::string& name) {
    return judgeAll(torus, rays, name, false);
}

std::vector<std::string> HitJudge::mismatches(const reference::Torus& torus,
                                              const std::vector<reference::Ray>& rays) {
    const std::vector<judge::Answers> answers = queries.answer(torus, rays);
    std::vector<std::string> faults(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const std::string fault = mismatch(torus, rays[i], answers[i]);
        faults[i] = fault.empty() ? "" : fault + "\n  " + reference::hexFloats(torus, rays[i]);
    }
    return faults;
}

}  // namespace raytorus::test
