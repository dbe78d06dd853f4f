// SPDX-License-Identifier: MIT
// What the include promises whatever it is given, and that its surface functions are the reference's, through
// the real SPIR-V.
#include <gtest/gtest.h>

#include <array>
#include <optional>

#include "support/contract_checks.hpp"
#include "support/device_fixture.hpp"
#include "support/surface_checks.hpp"

namespace raytorus::test {
namespace {

// A tracer a query, kept: each makes a pipeline, which takes some drivers a third of a second.
class Contract : public DeviceTest {
protected:
    AnswerRays answer = [this](trace::Query query, const reference::Torus& torus,
                               const std::vector<trace::TraceRay>& rays) {
        std::optional<trace::Tracer>& tracer = tracers.at(static_cast<std::size_t>(query));
        if (!tracer) {
            tracer.emplace(device(), query, contractRays);
        }
        const std::span<const float> values = tracer->trace(torus, rays);
        return std::vector<float>(values.begin(), values.end());
    };

private:
    std::array<std::optional<trace::Tracer>, 3> tracers;
};

TEST_F(Contract, IsKept) {
    for (const ContractCheck& check : contractChecks()) {
        EXPECT_EQ(check.fault(answer), "") << check.name;
    }
}

using Surface = DeviceTest;

TEST_F(Surface, IsTheReferences) {
    SurfaceProbe probe(device());
    const AskSurface ask = [&probe](const std::vector<SurfacePoint>& points) { return probe.ask(points); };
    for (const SurfaceCheck& check : surfaceChecks()) {
        EXPECT_EQ(check.fault(ask), "") << check.name;
    }
}

}  // namespace
}  // namespace raytorus::test
