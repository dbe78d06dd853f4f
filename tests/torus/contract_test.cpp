// SPDX-License-Identifier: MIT
// What the include promises whatever it is given, through the real SPIR-V.
#include <gtest/gtest.h>

#include <array>
#include <optional>

#include "support/contract_checks.hpp"
#include "support/device_fixture.hpp"

namespace raytorus::test {
namespace {

// A tracer a query, kept: each makes a pipeline, which takes some drivers a third of a second.
class Contract : public DeviceTest {
protected:
    AnswerRays answer = [this](trace::Query query, float majorRadius, float minorRadius,
                               const std::vector<trace::TraceRay>& rays) {
        std::optional<trace::Tracer>& tracer = tracers.at(static_cast<std::size_t>(query));
        if (!tracer) {
            tracer.emplace(device(), query, contractRays);
        }
        const std::span<const float> values = tracer->trace(majorRadius, minorRadius, rays);
        return std::vector<float>(values.begin(), values.end());
    };

private:
    std::array<std::optional<trace::Tracer>, 3> tracers;
};

TEST_F(Contract, BadInputIsAMissWithEveryOutputWritten) {
    EXPECT_EQ(badInputFault(answer), "");
}

TEST_F(Contract, TMaxMayBeInfiniteAndANanInItIsAMiss) {
    EXPECT_EQ(infiniteEndFault(answer), "");
}

TEST_F(Contract, ScalingByPowersOfTwoChangesNoBit) {
    EXPECT_EQ(scalingFault(answer), "");
}

TEST_F(Contract, EntriesPastTheCountHoldTMax) {
    EXPECT_EQ(pastTheCountFault(answer), "");
}

TEST_F(Contract, NormalsOfHitsAreOutward) {
    EXPECT_EQ(hitNormalFault(answer), "");
}

}  // namespace
}  // namespace raytorus::test
