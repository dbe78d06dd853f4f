// SPDX-License-Identifier: MIT
// What the include promises whatever it is given, of both tiers as C++. No output is written before the call.
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <vector>

#include "stage_rays.hpp"
#include "support/contract_checks.hpp"

namespace raytorus::test {
namespace {

using trace::Query;

template <class Answer>
void append(std::vector<float>& floats, const Answer& answer) {
    std::array<float, sizeof(Answer) / sizeof(float)> own{};
    std::memcpy(own.data(), &answer, sizeof(Answer));
    floats.insert(floats.end(), own.begin(), own.end());
}

AnswerRays answersOf(const Tier& tier) {
    return [&tier](Query query, const reference::Torus& torus, const std::vector<trace::TraceRay>& rays) {
        std::vector<float> answers;
        for (const trace::TraceRay& ray : rays) {
            switch (query) {
                case Query::Nearest:
                    append(answers, tier.nearest(torus.majorRadius, torus.minorRadius, ray));
                    break;
                case Query::All:
                    append(answers, tier.all(torus.majorRadius, torus.minorRadius, ray));
                    break;
                case Query::Any:
                    answers.push_back(tier.any(torus.majorRadius, torus.minorRadius, ray) ? 1.0F : 0.0F);
                    break;
            }
        }
        return answers;
    };
}

class TierContract : public OfBothTiers {};

TEST_P(TierContract, IsKept) {
    for (const ContractCheck& check : contractChecks()) {
        EXPECT_EQ(check.fault(answersOf(tier())), "") << check.name;
    }
}

INSTANTIATE_TEST_SUITE_P(Tier, TierContract, testing::Values(&exactTier(), &fastTier()), nameOfTier);

}  // namespace
}  // namespace raytorus::test
