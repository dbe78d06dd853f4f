// SPDX-License-Identifier: MIT
// What float32 makes of the closed form, printed and held: how often the number of roots is wrong, how far
// off they are.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <vector>

#include "closed_form_cxx.hpp"
#include "closed_form_reference.hpp"
#include "reference/rays.hpp"

namespace raytorus {
namespace {

using reference::Quad;
using reference::RayClass;
using test::Triple;
using Float = test::ClosedFormCxx<float>;
using Exact = test::ClosedFormCxx<Quad>;

// 2^-24, half an ulp of 1.
constexpr double u = 0x1p-24;

// A line whose distance to the tube has an extremum at delta r from the surface takes the quartic to 8 w^2
// delta there (math.md, eq. 2: 2 w^2 delta of the one factor, 4 of the other), and each of the few dozen
// roundings of numbers about 1 moves it by u: beyond 8 u / w^2 the number of roots has to be right. Seen:
// wrong up to 2.3 u / w^2.
constexpr double tangentBand = 8;

// Half the digits: near a double root, and where the inner root vanishes, S is the square root of what the
// roundings of y and alpha leave, which at 256 u would be 16 sqrt(u). Seen: 4.5 sqrt(u), once in 400 000
// rays.
const double worstError = 16 * std::sqrt(u);

struct Errors {
    std::size_t rays = 0;
    std::size_t wrongCounts = 0;
    double widest = 0;  ///< the largest clearance of a ray with the wrong number of roots, in u / w^2
    std::vector<double> errors;  ///< of each ray with roots, and the right number of them, in R

    double at(double part) {
        if (errors.empty()) {
            return 0;
        }
        const auto k = static_cast<std::size_t>(part * static_cast<double>(errors.size() - 1));
        std::nth_element(errors.begin(), errors.begin() + static_cast<std::ptrdiff_t>(k), errors.end());
        return errors[k];
    }
};

void addErrors(const reference::RayParameters& parameters, const reference::Ray& ray, Errors& result) {
    const double w{parameters.torus.minorRadius};
    const Triple<Quad> origin = test::quads(ray.origin);
    const Triple<Quad> direction = test::quads(ray.direction);
    Float::Ray reduced;
    Exact::Ray exact;
    if (!Float::reduceRay(1, parameters.torus.minorRadius, std::to_array(ray.origin),
                          std::to_array(ray.direction), reduced) ||
        !Exact::reduceRay(1, parameters.torus.minorRadius, origin, direction, exact)) {
        return;
    }
    ++result.rays;
    const std::vector<Quad> truth = test::allRoots(parameters.torus, origin, direction);
    const test::QuarticRoots<float> roots = Float::reducedRoots(Float::axialQuartic(reduced));
    if (static_cast<std::size_t>(roots.count) != truth.size()) {
        ++result.wrongCounts;
        const double clearance = intersect(parameters.torus, ray).clearance;
        result.widest = std::max(result.widest, clearance * w * w / u);
    } else if (!truth.empty()) {
        // The reduced t: that the t of a far ray has to be one float is not the closed form's doing.
        std::vector<Quad> t;
        for (const float root : std::span(roots.roots).first(truth.size())) {
            t.push_back(exact.shift + exact.scale * Quad(root));
        }
        result.errors.push_back(test::difference(truth, t, exact.scale).values);
    }
}

// Not fresh: what float32 makes of the formula has no bound, and about one ray in ten million is wrong for
// another reason.
constexpr std::uint64_t fixedSeed = 23;

class ClosedFormFloat : public testing::TestWithParam<RayClass> {};

TEST_P(ClosedFormFloat, LosesHalfItsDigitsAndPairsNearATangentNoMore) {
    std::size_t withRoots = 0;
    for (const float minorRadius : {0.01F, 0.25F, 0.9F}) {
        Errors found;
        for (const double distance : {3.0, 100.0}) {
            const reference::RayParameters parameters{{1.0F, minorRadius}, distance, 1e-4, fixedSeed};
            for (const reference::Ray& ray : generateRays(GetParam(), parameters, 2000)) {
                addErrors(parameters, ray, found);
            }
        }
        fmt::print(
            "{}, r = {}: {} rays, {} wrong counts, up to {:.2g} u / w^2 from a tangent; t off by {:.1e} "
            "(half), {:.1e} (99 %), {:.1e} (all)\n",
            nameOf(GetParam()), minorRadius, found.rays, found.wrongCounts, found.widest, found.at(0.5),
            found.at(0.99), found.at(1));
        // Few lines through the axis meet a thin tube.
        EXPECT_GT(found.rays, 3000U);
        withRoots += found.errors.size();
        EXPECT_LE(found.widest, tangentBand);
        EXPECT_LE(found.at(1), worstError);
    }
    EXPECT_GT(withRoots, 1000U);
}

// These tori have neither horns' tips nor dimples.
INSTANTIATE_TEST_SUITE_P(Classes, ClosedFormFloat, testing::ValuesIn([] {
                             std::vector<RayClass> classes(std::begin(reference::allRayClasses),
                                                           std::end(reference::allRayClasses));
                             std::erase(classes, RayClass::dimpleCone);
                             std::erase(classes, RayClass::hornTip);
                             return classes;
                         }()),
                         [](const auto& row) { return std::string(nameOf(row.param)); });

// Why beta is evaluated as a product: on the surface of a thin tube it is 0, and the sum is what 15 roundings
// leave.
TEST(ClosedFormBeta, TheProductKeepsTheDigitsThatTheSumLoses) {
    const Float::Ray ray{{1.0078125F, 0, 0}, {0, 1, 0}, 0.00781251F, 0, 1};
    const Exact::Ray same{{Quad(1.0078125F), 0, 0}, {0, 1, 0}, Quad(0.00781251F), 0, 1};
    const Quad exact = Exact::betaProduct(same);
    const auto relative = [&](float beta) {
        return std::abs(static_cast<double>((Quad(beta) - exact) / exact));
    };
    EXPECT_LE(std::abs(static_cast<double>((Exact::betaSum(same) - exact) / exact)), 1e-20);
    EXPECT_LE(relative(Float::betaProduct(ray)), 1e-6);  // a few u
    EXPECT_GE(relative(Float::betaSum(ray)), 0.5);
}

}  // namespace
}  // namespace raytorus
