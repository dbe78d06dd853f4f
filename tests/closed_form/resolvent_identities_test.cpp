// SPDX-License-Identifier: MIT
// The second half of the derivation, from the reduced quartic to its roots, in exact fractions.
//
// Where numbers are bound to each other (a unit direction, a point perpendicular to it), they are rational
// functions of free ones. Two such functions that differ, of degree d once their denominators are multiplied
// out, agree at a random point of a set of n values in each variable with a chance of at most d / n
// (Schwartz, "Fast probabilistic algorithms for verification of polynomial identities", JACM 27, 1980). Here
// d <= 40 and n = 2^62, at 20 points: 2^-1130. Identities in the roots are proved on grids, as in
// identities_test.cpp.
#include <gtest/gtest.h>

#include <cstdint>

#include "closed_form_cxx.hpp"
#include "reference/random.hpp"
#include "support/fresh_seed.hpp"

namespace raytorus {
namespace {

using test::Fraction;
using test::Triple;
using Cxx = test::ClosedFormCxx<Fraction>;

constexpr std::uint64_t points = 20;

class Free {
public:
    explicit Free(std::uint64_t point) : random(test::freshSeed(), 7, point) {}

    /// One of 2^62 values in (-1, 1): numerators are odd, so it is not 0.
    Fraction operator()() {
        const auto odd = static_cast<std::int64_t>(random.next() >> 1U) | 1;
        const Fraction size = Fraction(odd) / (Fraction(std::int64_t{1} << 62U) * 2);
        return random.below(2) == 0 ? size : -size;
    }

private:
    reference::Random random;
};

struct Angle {
    Fraction cosine, sine;

    // Every angle but pi, by the tangent of its half.
    explicit Angle(const Fraction& t) : cosine((1 - t * t) / (1 + t * t)), sine(2 * t / (1 + t * t)) {}
};

// Every reduced ray but few: the point closest to the centre in polar coordinates, the direction in the plane
// perpendicular to it. rho is a fraction as well, which the product for beta needs.
Cxx::Ray reducedRay(Free& free) {
    const Fraction s = free() + 1;
    const Angle theta(free()), phi(free()), psi(free());
    Cxx::Ray ray;
    ray.origin = {s * phi.cosine * theta.cosine, s * phi.cosine * theta.sine, s * phi.sine};
    const Triple<Fraction> across{-theta.sine, theta.cosine, 0};
    const Triple<Fraction> up{-phi.sine * theta.cosine, -phi.sine * theta.sine, phi.cosine};
    for (std::size_t i = 0; i < 3; ++i) {
        ray.direction[i] = psi.cosine * across[i] + psi.sine * up[i];
    }
    ray.tubeRadius = free() + 1;
    return ray;
}

Fraction at(const test::ReducedQuartic<Fraction>& f, const Fraction& t) {
    return ((t * t + 2 * f.alpha) * t + 8 * f.cz) * t + f.beta;
}

TEST(Identities, BothReducedQuarticsAreTheSubstitutedRay) {
    for (std::uint64_t i = 0; i < points; ++i) {
        Free free(i);
        const Cxx::Ray ray = reducedRay(free);
        const Fraction t = free(), w2 = ray.tubeRadius * ray.tubeRadius;
        Triple<Fraction> p;
        for (std::size_t k = 0; k < 3; ++k) {
            p[k] = ray.origin[k] + t * ray.direction[k];
        }
        const Fraction rho2 = p[0] * p[0] + p[1] * p[1];
        const Fraction sum = rho2 + p[2] * p[2] + 1 - w2;
        const Fraction implicit = sum * sum - 4 * rho2;
        ASSERT_EQ(at(Cxx::axialQuartic(ray), t), implicit);
        ASSERT_EQ(at(Cxx::radialQuartic(ray), t), implicit);
        ASSERT_EQ(Cxx::betaSum(ray), Cxx::betaProduct(ray));
        ASSERT_EQ(Cxx::axialQuartic(ray).cz, Cxx::radialQuartic(ray).cz);
    }
}

// Any ray is a reduced one, scaled by R, its direction by a length, its origin moved along it (math.md, eq.
// 8).
TEST(Identities, ReducingARayScalesItsQuartic) {
    for (std::uint64_t i = 0; i < points; ++i) {
        Free free(100 + i);
        const Cxx::Ray ray = reducedRay(free);
        const Fraction R = free() + 1, length = free() + 1, shift = free(), t = free();
        Triple<Fraction> origin, direction;
        for (std::size_t k = 0; k < 3; ++k) {
            direction[k] = length * ray.direction[k];
            origin[k] = R * ray.origin[k] - shift * direction[k];
        }
        const std::array<Fraction, 5> c = Cxx::quarticCoefficients(R, R * ray.tubeRadius, origin, direction);
        const Fraction T = shift + R / length * t;
        const Fraction quartic = c[0] + T * (c[1] + T * (c[2] + T * (c[3] + T * c[4])));
        ASSERT_EQ(quartic, R * R * R * R * at(Cxx::axialQuartic(ray), t));
    }
}

Fraction gammaOf(const Fraction& alpha, const Fraction& cz, const Fraction& beta) {
    return 16 * alpha * alpha * alpha - 144 * beta * alpha + 1728 * cz * cz;
}

Fraction deltaOf(const Fraction& alpha, const Fraction& beta) {
    return 4 * alpha * alpha + 12 * beta;
}

Fraction sq(const Fraction& x) {
    return x * x;
}

// Vieta's relations: from any four roots with the sum 0. The highest power of one of them is the 12th, in
// gamma^2, in delta^3 and in the discriminant: 13 values of each of three.
TEST(Identities, TheResolventKnowsTheRoots) {
    for (int i = 0; i < 13; ++i)
        for (int j = 0; j < 13; ++j)
            for (int k = 0; k < 13; ++k) {
                const Fraction r1 = i, r2 = j, r3 = k, r4 = -(r1 + r2 + r3);
                // (t - r1)(t - r2)(t - r3)(t - r4) = t^4 + 2 alpha t^2 + 8 cz t + beta
                const Fraction alpha = (r1 * r2 + (r1 + r2) * (r3 + r4) + r3 * r4) / 2;
                const Fraction cz = -(r1 * r2 * (r3 + r4) + (r1 + r2) * r3 * r4) / 8;
                const Fraction beta = r1 * r2 * r3 * r4;
                const Fraction S = -(r1 + r2), m = S * S, y = m + 4 * alpha / 3;
                const Fraction gamma = gammaOf(alpha, cz, beta), delta = deltaOf(alpha, beta);
                // (math.md, eq. 14, 16)
                ASSERT_EQ(((m + 4 * alpha) * m + 4 * alpha * alpha - 4 * beta) * m, 64 * cz * cz);
                ASSERT_EQ(y * y * y - delta * y / 3 - gamma / 27, 0);
                // (math.md, eq. 17)
                ASSERT_EQ(gamma * gamma - 4 * delta * delta * delta,
                          -27 * sq((r1 - r2) * (r1 - r3) * (r1 - r4) * (r2 - r3) * (r2 - r4) * (r3 - r4)));
                // (math.md, eq. 20), times S: the discriminants of the two pairs.
                ASSERT_EQ(S * (-y - 8 * alpha / 3) + 16 * cz, S * sq(r1 - r2));
                ASSERT_EQ(S * (-y - 8 * alpha / 3) - 16 * cz, S * sq(r3 - r4));
                // (math.md, eq. 22), times S^2.
                ASSERT_EQ(sq(16 * cz), S * S * 4 * (sq(2 * alpha + S * S) - 4 * beta));
            }
}

// gamma is what makes a given zeta one: then sqrt(epsilon) is zeta^3 - (delta / zeta)^3, and no root is left
// to take.
TEST(Identities, ZetaSolvesTheCubic) {
    for (std::uint64_t i = 0; i < points; ++i) {
        Free free(200 + i);
        const Fraction zeta = free(), delta = free(), other = delta / zeta;
        const Fraction cube = zeta * zeta * zeta, otherCube = other * other * other;
        const Fraction gamma = cube + otherCube, root = cube - otherCube;
        ASSERT_EQ(gamma * gamma - 4 * delta * delta * delta, root * root);
        ASSERT_EQ(cube, (gamma + root) / 2);  // (math.md, eq. 18)
        const Fraction y = zeta / 3 + delta / (3 * zeta);
        ASSERT_EQ(y * y * y - delta * y / 3 - gamma / 27, 0);
        // (math.md, eq. 19): with k for the cube root of 2, any k will do, and k^3 = 2 makes it gamma +
        // sqrt(epsilon).
        const Fraction k = free(), unhalved = k * zeta;
        ASSERT_EQ(unhalved / (3 * k) + k * delta / (3 * unhalved), y);
        ASSERT_EQ(unhalved * unhalved * unhalved, k * k * k * (gamma + root) / 2);
    }
}

// epsilon < 0: degree 3 in the cosine, 6 in that of the sixth, and 3 in d, the square root of delta.
TEST(Identities, AThirdOfTheAngleSolvesTheCubic) {
    for (int i = 0; i < 7; ++i)
        for (int j = 0; j < 7; ++j) {
            const Fraction k = i, d = j;
            const Fraction c = 2 * k * k - 1;
            const Fraction x = 4 * c * c * c - 3 * c;  // cos(theta)
            const Fraction s = 4 * k * k * k - 3 * k;  // cos(theta / 2)
            ASSERT_EQ(x, 2 * s * s - 1);
            const Fraction gamma = 2 * d * d * d * x, y = 2 * d * c / 3;
            ASSERT_EQ(y * y * y - d * d * y / 3 - gamma / 27, 0);  // (math.md, eq. 21)
            ASSERT_EQ(2 * d * d * d * s * s, (gamma + 2 * d * d * d) / 2);
        }
}

// delta = 0 and gamma = 8, hence epsilon = 64: y = zeta / (3 cbrt(2)) has to have 27 y^3 = zeta^3 / 2 =
// gamma.
TEST(IdentitiesErrata, ZetaIsTheCubeRootOfTheSum) {
    const Fraction gamma = 8, rootOfEpsilon = 8, cubeRootOfGamma = 2;
    const Fraction mendedCube = gamma + rootOfEpsilon;
    EXPECT_EQ(mendedCube / 2, gamma);
    const Fraction printed = cubeRootOfGamma + rootOfEpsilon;
    EXPECT_EQ(printed * printed * printed / 2, 500);
    // Such quartics exist: alpha = -3, beta = -3 and 1728 cz^2 = 8 + 1728.
    const Fraction alpha = -3, beta = -3;
    EXPECT_EQ(deltaOf(alpha, beta), 0);
    EXPECT_EQ(gammaOf(alpha, 0, beta) + 1736, gamma);
}

}  // namespace
}  // namespace raytorus
