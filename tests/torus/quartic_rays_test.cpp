// SPDX-License-Identifier: MIT
// The quartics on which solvers are compared, as rays.
//
// Scaled and shifted so that its cubic term is gone, a quartic is t^4 + p t^2 + q t + s. A line with its foot
// at height c, at the distance D from the centre, with direction z (both of unit length) along the axis,
// meets a torus where
//
//     p = 2 S - 4 R^2 (1 - z^2),   q = 8 R^2 c z,   s = S^2 - 4 R^2 (D^2 - c^2),   S = D^2 + R^2 - r^2.
//
// Any p, q, s can be had: choose x = 4 R^2 (1 - z^2) no smaller than the largest root of the resolvent cubic
// x^3 + 2 p x^2 + (p^2 - 4 s) x - q^2, which is what makes |c| short enough for a line, and no smaller than
// -p, which puts all roots on the outer sheet; then 1 - z^2 so small that r is real. So none of the published
// tables has to be left out. Each ray here was searched for among those, and rounded to float32, where the
// tightest clusters merge: what the rounded ray meets is for the reference to say.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <ostream>
#include <vector>

#include "hit_judge.hpp"
#include "support/device_fixture.hpp"

namespace raytorus {
namespace {

using reference::Quad;

struct Root {
    double real, imaginary;
};

/// x^4 + a x^3 + b x^2 + c x + d
struct Quartic {
    Quad a, b, c, d;
    std::vector<double> realRoots;  ///< as published
};

Quartic fromCoefficients(Quad a, Quad b, Quad c, Quad d) {
    return {a, b, c, d, {}};
}

// Real, or conjugate: the first with the second and the third with the fourth.
Quartic fromRoots(Root first, Root second, Root third, Root fourth) {
    const auto sum = [](Root u, Root v) { return Quad(u.real) + Quad(v.real); };
    const auto product = [](Root u, Root v) {
        return Quad(u.real) * Quad(v.real) - Quad(u.imaginary) * Quad(v.imaginary);
    };
    const Quad s = sum(first, second), m = product(first, second);
    const Quad t = sum(third, fourth), n = product(third, fourth);
    Quartic quartic{-s - t, m + n + s * t, -m * t - n * s, m * n, {}};
    for (const Root& root : {first, second, third, fourth}) {
        if (root.imaginary == 0.0) {
            quartic.realRoots.push_back(root.real);
        }
    }
    return quartic;
}

/// y^4 + p y^2 + q y + s with the largest of |p|^(1/2), |q|^(1/3), |s|^(1/4) scaled to 1, and what y is of x.
struct Depressed {
    double p, q, s;
    Quad shift, scale;  ///< x = shift + scale y
};

Depressed scaled(Quad p, Quad q, Quad s, Quad shift, Quad scaleOfZeros) {
    // The three are within the range of double by the fourth root of the largest Quad.
    const Quad largest = std::max({sqrtq(fabsq(p)), cbrtq(fabsq(q)), sqrtq(sqrtq(fabsq(s)))});
    const Quad k = largest > 0 ? largest : scaleOfZeros;
    return {reference::toDouble(p / (k * k)), reference::toDouble(q / (k * k * k)),
            reference::toDouble(s / (k * k * k * k)), shift, k};
}

Depressed depressed(const Quartic& f) {
    const Quad a = f.a, aa = a * a;
    return scaled(f.b - 3 * aa / 8, f.c - a * f.b / 2 + aa * a / 8,
                  f.d - a * f.c / 4 + aa * f.b / 16 - 3 * aa * aa / 256, -a / 4, 1);
}

Depressed depressed(const reference::TorusAndRay& given) {
    const reference::QuadVec3 o = reference::toQuad(given.ray.origin),
                              d = reference::toQuad(given.ray.direction);
    const Quad R = given.torus.majorRadius, r = given.torus.minorRadius;
    const Quad dd = reference::dot(d, d), foot = -reference::dot(o, d) / dd;
    const reference::QuadVec3 p{o[0] + foot * d[0], o[1] + foot * d[1], o[2] + foot * d[2]};
    const Quad D2 = reference::dot(p, p), S = D2 + R * R - r * r, length = sqrtq(dd);
    Depressed result =
        scaled(2 * S - 4 * R * R * (d[0] * d[0] + d[1] * d[1]) / dd, 8 * R * R * p[2] * d[2] / length,
               S * S - 4 * R * R * (D2 - p[2] * p[2]), foot, R + r);
    result.scale /= length;
    return result;
}

struct QuarticRay {
    const char* name;
    Quartic quartic;
    const char* ray;  ///< torus and ray, hexFloats
    int apart;        ///< how many real roots of the quartic are so far apart that rounding cannot merge them
    std::vector<double> publishedRoots =
        {};  ///< of a quartic given by coefficients: those that are published
};

void PrintTo(const QuarticRay& row, std::ostream* out) {
    *out << row.name;
}

// 0x1p-24 for each of ten numbers, of which the shift to the foot of a ray some torus' sizes away costs the
// most.
constexpr double coefficientError = 1e-7;

class QuarticRays : public test::DeviceTest, public testing::WithParamInterface<QuarticRay> {
protected:
    static void SetUpTestSuite() { judge = std::make_unique<test::HitJudge>(1); }
    static void TearDownTestSuite() { judge.reset(); }

    static std::unique_ptr<test::HitJudge> judge;
};

std::unique_ptr<test::HitJudge> QuarticRays::judge;

TEST_P(QuarticRays, AreThoseOfTheQuarticAndMetByAllThreeFunctions) {
    const QuarticRay& row = GetParam();
    const auto given = reference::parseHexFloats(row.ray);
    ASSERT_TRUE(given.has_value());
    const Depressed published = depressed(row.quartic), actual = depressed(*given);
    EXPECT_NEAR(actual.p, published.p, coefficientError);
    EXPECT_NEAR(actual.q, published.q, coefficientError);
    EXPECT_NEAR(actual.s, published.s, coefficientError);
    EXPECT_EQ(judge->mismatches(given->torus, {given->ray}), std::vector<std::string>{""});

    // The hits are the reference's, so the reference's are held to the published roots, where an error of the
    // coefficients moves them by less than to a third of the way to their neighbours.
    std::vector<double> roots = row.quartic.realRoots;
    roots.insert(roots.end(), row.publishedRoots.begin(), row.publishedRoots.end());
    const reference::Intersections truth = reference::intersect(given->torus, given->ray);
    int apart = 0;
    for (std::size_t i = 0; i < roots.size(); ++i) {
        const double y = reference::toDouble((Quad(roots[i]) - published.shift) / published.scale);
        const double slope = 4 * y * y * y + 2 * published.p * y + published.q;
        const double error = coefficientError * (y * y + std::abs(y) + 1) / std::abs(slope);
        double gap = 1.0;
        for (std::size_t k = 0; k < roots.size(); ++k) {
            if (k != i) {
                gap = std::min(
                    gap, std::abs(reference::toDouble((Quad(roots[k]) - Quad(roots[i])) / published.scale)));
            }
        }
        if (!(error < gap / 3)) {
            continue;
        }
        ++apart;
        double nearest = 1.0;
        for (int k = 0; k < truth.count; ++k) {
            const Quad t = truth.hits[static_cast<std::size_t>(k)].t;
            nearest = std::min(nearest, std::abs(reference::toDouble((t - actual.shift) / actual.scale) - y));
        }
        // 1e-9: some published roots have ten digits.
        EXPECT_LE(nearest, error + 1e-9) << "root " << roots[i];
    }
    EXPECT_EQ(apart, row.apart);
}

// Flocke, Algorithm 954, ACM Transactions on Mathematical Software 41(4), 2015. Orellana and De Michele,
// Algorithm 1010, the same journal 46(2), 2020; its numbers are taken from the authors' test program
// (accuracytest.cpp).
const QuarticRay quarticRays[] = {
    // Flocke's, as Algorithm 1010's test program has them (1 to 13): its 2, 3 and 11 are not quite those of
    // Algorithm 954's own test.
    {"decadesApart", fromRoots({1e9, 0}, {1e6, 0}, {1e3, 0}, {1, 0}),
     "0x1.2f697cp+0 0x1.430172p+0  0x1.28dae2p+1 0x1.0d2aeep+2 -0x1.4cd35ap+2 0x0p+0  -0x1.78878cp-2 "
     "-0x1.403496p-1 0x1.606046p-1 inf",
     1},
    {"closeTogether", fromRoots({2.003, 0}, {2.002, 0}, {2.001, 0}, {2, 0}),
     "0x1.106c3ap+0 0x1.9fd92cp-2  0x1.c5e0a8p+1 0x1.643722p+1 -0x1.32ddeep+0 0x0p+0  -0x1.a6e678p-1 "
     "-0x1.006a6ap-1 0x1.08f49cp-2 inf",
     4},
    {"hugeAndDecadesApart", fromRoots({1e53, 0}, {1e50, 0}, {1e49, 0}, {1e47, 0}),
     "0x1.50f9c6p-1 0x1.cb6f26p-1  0x1.94399cp-1 -0x1.a0b32p+2 -0x1.76df9cp+1 0x0p+0  -0x1.60a1c6p-4 "
     "0x1.e3cd38p-1 0x1.4356cap-2 inf",
     1},
    {"oneFarFromThree", fromRoots({1e14, 0}, {2, 0}, {1, 0}, {-1, 0}),
     "0x1.e88574p-1 0x1.023032p+0  0x1.694aa8p+2 0x1.290d0cp+1 -0x1.466c3ap+2 0x0p+0  -0x1.783c96p-1 "
     "-0x1.4d0e48p-2 0x1.30ba1p-1 inf",
     1},
    {"twoFarFromTwo", fromRoots({-2e7, 0}, {1e7, 0}, {1, 0}, {-1, 0}),
     "0x1.e608bap-1 0x1.eca286p-1  -0x1.f835a2p-1 0x1.ac33c6p+1 -0x1.ef5e64p+1 0x0p+0  0x1.7d3468p-3 "
     "-0x1.3ceb0ap-1 0x1.86ac06p-1 inf",
     2},
    {"smallComplexPair", fromRoots({1e7, 0}, {-1e6, 0}, {1, 1}, {1, -1}),
     "0x1.9b8cf2p-1 0x1.6e7af2p-1  0x1.b079aep+1 0x1.a1982ep+0 -0x1.161faap+2 0x0p+0  -0x1.308e5p-1 "
     "-0x1.42a18cp-2 0x1.7aa36ap-1 inf",
     2},
    {"closePairFarFromComplexPair", fromRoots({-7, 0}, {-4, 0}, {-1e6, 1e5}, {-1e6, -1e5}),
     "0x1.f05a48p-1 0x1.04ea26p-2  0x1.d97834p+0 0x1.1ffa54p+1 -0x1.e19a48p-1 0x0p+0  -0x1.1605f4p-1 "
     "-0x1.918c12p-1 0x1.334a88p-2 inf",
     0},
    {"complexPairInACluster", fromRoots({1e8, 0}, {11, 0}, {1e3, 1}, {1e3, -1}),
     "0x1.13d76ap+0 0x1.0e2776p+0  -0x1.03987ap+1 -0x1.36c86ap-2 -0x1.f55944p+1 0x0p+0  0x1.f25f0ap-2 "
     "0x1.cafceap-5 0x1.be5964p-1 inf",
     1},
    {"complexPairsDecadesApart", fromRoots({1e7, 1e6}, {1e7, -1e6}, {1, 2}, {1, -2}),
     "0x1.324094p+0 0x1.106366p-2  -0x1.be0cccp+1 -0x1.80c5ep-1 -0x1.e9291ap-1 0x0p+0  0x1.d1a824p-1 "
     "0x1.44713p-2 0x1.139f94p-2 inf",
     0},
    {"complexPairsCrossed", fromRoots({1e4, 3}, {1e4, -3}, {-7, 1e3}, {-7, -1e3}),
     "0x1.c33408p-1 0x1.6bfccep-3  -0x1.1d30dap+1 0x1.29c836p+1 -0x1.ac866ap-1 0x0p+0  0x1.670f32p-1 "
     "-0x1.574a28p-1 0x1.eff1dp-3 inf",
     0},
    {"complexPairsNearlyEqual", fromRoots({1.001, 4.998}, {1.001, -4.998}, {1, 5.001}, {1, -5.001}),
     "0x1.d8a086p-1 0x1.4340f4p-3  0x1.c44ab2p+0 0x1.ff94e8p-3 -0x1.f9b178p+0 0x0p+0  -0x1.27c5aep-1 "
     "-0x1.2f5d66p-2 0x1.856decp-1 inf",
     0},
    {"complexPairsAboveEachOther", fromRoots({1e3, 3}, {1e3, -3}, {1e3, 1}, {1e3, -1}),
     "0x1.1482eep+0 0x1.fe3ff4p-1  0x1.3ac46cp+2 0x1.324dd6p+1 -0x1.b24c66p+1 0x0p+0  -0x1.09f32ep-1 "
     "-0x1.483efep-1 0x1.214198p-1 inf",
     0},
    {"complexPairsFarFromReal", fromRoots({2, 1e4}, {2, -1e4}, {1, 1e3}, {1, -1e3}),
     "0x1.068e36p+0 0x1.43f262p-2  0x1.f7664ep-5 0x1.08ea34p+1 -0x1.6aad1cp+1 0x0p+0  -0x1.52aa1ap-2 "
     "-0x1.5b8e5p-2 0x1.c2db54p-1 inf",
     0},
    // Strobach's (14 to 18 there). The first is a line that touches the top circle, exactly.
    {"quadrupleRoot", fromRoots({1000, 0}, {1000, 0}, {1000, 0}, {1000, 0}),
     "0x1p+0 0x1p-2  0x1p+0 -0x1.4p+2 0x1p-2 0x0p+0  0x0p+0 0x1p+0 0x0p+0 inf", 0},
    {"tripleRoot", fromRoots({1000, 0}, {1000, 0}, {1000, 0}, {0x1p-48, 0}),
     "0x1.e05fcp-1 0x1.fd2b66p-1  -0x1.2d0eccp+2 0x1.a60eccp-1 -0x1.6c72cp+1 0x0p+0  0x1.9bc08p-1 "
     "-0x1.cc167ep-4 0x1.2ad364p-1 inf",
     1},
    {"complexPairsNearTheReal", fromRoots({1e16, 1e7}, {1e16, -1e7}, {1, 0.1}, {1, -0.1}),
     "0x1.183f14p+0 0x1.0bc39ep-2  -0x1.7d6fcp+0 -0x1.14f07cp+1 -0x1.b6b9fep-1 0x0p+0  0x1.40bbd4p-2 "
     "0x1.c9c07ep-1 0x1.47f618p-2 inf",
     0},
    {"growingGaps", fromRoots({10000, 0}, {10001, 0}, {10010, 0}, {10100, 0}),
     "0x1.25aac8p+0 0x1.1173cp+0  -0x1.06b57ap+1 -0x1.32bd9p-3 -0x1.d83998p+1 0x0p+0  0x1.04903ep-1 "
     "0x1.38129p-7 0x1.b8b63ap-1 inf",
     4},
    {"complexPairsNearTheReal2", fromRoots({4e5, 3e2}, {4e5, -3e2}, {3e4, 7e3}, {3e4, -7e3}),
     "0x1.265c88p+0 0x1.3339cep-2  -0x1.e5e0b8p+0 0x1.11be5cp+1 -0x1.ce8f06p-1 0x0p+0  0x1.e82ddcp-2 "
     "-0x1.a5cb3ap-1 0x1.3a088ap-2 inf",
     0},
    // Orellana's and De Michele's own (19 to 24 there).
    {"doubleRoot44Decades", fromRoots({1e44, 0}, {1e30, 0}, {1e30, 0}, {1, 0}),
     "0x1.f8a32cp-1 0x1.8e48f6p+0  -0x1.8886e8p+2 0x1.927904p+1 -0x1.ed7108p+1 0x0p+0  0x1.b1ad1ap-1 "
     "-0x1.9d356ap-2 0x1.624efcp-2 inf",
     1},
    {"doubleRoot14Decades", fromRoots({1e14, 0}, {1e7, 0}, {1e7, 0}, {1, 0}),
     "0x1.3307e8p+0 0x1.3ad7c4p+0  -0x1.6d2d84p+1 -0x1.89dd44p-2 -0x1.e74eacp+1 0x0p+0  0x1.4cb39ap-1 "
     "0x1.d48562p-4 0x1.80bd14p-1 inf",
     1},
    {"doubleRoot15Decades", fromRoots({1e15, 0}, {1e7, 0}, {1e7, 0}, {1, 0}),
     "0x1.2c10bap+0 0x1.09ccdep+0  0x1.f233aep+1 0x1.4c91ap+0 -0x1.a742ecp+1 0x0p+0  -0x1.8631f6p-1 "
     "-0x1.4a8f2p-2 0x1.1f5b8cp-1 inf",
     1},
    {"greaterThanTheRootOfTheLargestDouble", fromRoots({1e154, 0}, {1e152, 0}, {10, 0}, {1, 0}),
     "0x1.82e646p-1 0x1.ac2c4ap-1  0x1.8870fap-1 -0x1.cc9a86p+1 -0x1.45ad9ep+1 0x0p+0  -0x1.ccd0e2p-3 "
     "0x1.b42906p-1 0x1.e44c6cp-2 inf",
     2},
    {"vanishingResolvent", fromCoefficients(1, 1, 3.0 / 8.0, 1e-3),
     "0x1.1eea2p+0 0x1.93ed8cp+0  0x1.3227bp+0 0x1.eb741ep+1 -0x1.195eeap+2 0x0p+0  -0x1.ec2738p-2 "
     "-0x1.55c51ap-2 0x1.9f3276p-1 inf",
     0},
    {"factorsOfThirtyDecades", fromRoots({1, 0}, {1e-30, 0}, {1e30, 0}, {-1e30, 0}),
     "0x1.e3cb2ep-1 0x1.c5da82p-1  0x1.a372e8p+1 -0x1.26cb22p+1 -0x1.6ac9f4p+1 0x0p+0  -0x1.5261f2p-1 "
     "0x1.ea8ddcp-2 0x1.27c554p-1 inf",
     2},
    // Quartics of rays against tori that a solver got wrong: Celeritas, QuarticSolver.test.cc (2026). It
    // publishes
    // the positive roots.
    {"celeritasOnePositive",
     fromCoefficients(250.353530, -40111.798938, -6982487.888858, -174874197.079351),
     "0x1.1a599p+0 0x1.786a8cp-1  0x1.2174c8p-7 -0x1.40ef4cp+2 -0x1.012cdep+1 0x0p+0  0x1.dc99cp-5 "
     "0x1.da3302p-1 0x1.7d885ap-2 inf",
     1,
     {187.76045963}},
    {"celeritasTwoPositive",
     fromCoefficients(19.534611, -48660.891842, -476217.617178, 57126150.652217),
     "0x1.237f24p+0 0x1.c9b282p-1  0x1.2034f8p+2 0x1.37e566p+1 -0x1.ed5f9ep+1 0x0p+0  -0x1.6e04aap-1 "
     "-0x1.6ce154p-2 0x1.340aeap-1 inf",
     2,
     {30.11797881450676, 213.24217809742103}},
    {"celeritasTwoMorePositive",
     fromCoefficients(39.057127, -47753.699175, -940008.633992, 54384055.574769),
     "0x1.e53c42p-1 0x1.435ecep-1  -0x1.176fa4p+0 -0x1.d328c4p+1 -0x1.fc38fep-1 0x0p+0  0x1.cb33d6p-3 "
     "0x1.e1ebap-1 0x1.0297b8p-2 inf",
     2,
     {25.6335352, 207.19825152}},
    // Artefacts of a ray-traced torus: diagrams-solve, pull request 7 (2020).
    {"diagramsSolve", fromCoefficients(-240, 25449, -1325880, 26471900.25),
     "0x1.dca4e4p-1 0x1.90c02ep-2  0x1.9a7d06p+1 -0x1.e7fafp-1 -0x1.ae3a0ep+1 0x0p+0  -0x1.0f024p-1 "
     "0x1.b1b4e6p-2 0x1.786502p-1 inf",
     0},
    // A torus again, solved as four zeros: RpolyPlusPlus, issue 5 (2017). Six digits of each coefficient are
    // published; the first and the last of twelve.
    {"rpolyPlusPlusFirst", fromCoefficients(-198.995, 15006.6, -508127, 6.52025e6),
     "0x1.aaa6bap-1 0x1.89677ep-2  -0x1.a4d99cp+0 -0x1.9185f6p+2 -0x1.0f9476p+1 0x0p+0  -0x1.3c7eeep-2 "
     "0x1.cb8bfcp-1 0x1.41fbcp-2 inf",
     0},
    {"rpolyPlusPlusLast", fromCoefficients(-202.427, 15350.8, -516876, 6.52025e6),
     "0x1.6448aep-1 0x1.1219e6p-2  -0x1.9a86c6p+0 -0x1.94d1acp+1 -0x1.af1f34p+0 0x0p+0  0x1.c3b676p-2 "
     "0x1.9b0c5cp-1 0x1.9ab7bp-2 inf",
     0},
    // PolynomialRoots (E. Bertolazzi, quarticRootsFlocke, 2017), test 14.
    {"polynomialRoots14",
     fromCoefficients(-100000 / 714285.71428571432, 13479.924671428573 / 714285.71428571432,
                      -2.2737367544323206e-13 / 714285.71428571432, -22.526485131747265 / 714285.71428571432),
     "0x1.9bcd82p-1 0x1.8e1d88p-3  -0x1.ad0b3cp+0 0x1.988b14p+1 -0x1.b199f4p+0 0x0p+0  0x1.2692dap-1 "
     "-0x1.551fdap-1 0x1.e5d11ep-2 inf",
     0},
};

INSTANTIATE_TEST_SUITE_P(Published, QuarticRays, testing::ValuesIn(quarticRays),
                         [](const auto& row) { return std::string(row.param.name); });

}  // namespace
}  // namespace raytorus
