// SPDX-License-Identifier: MIT
// The polynomial identities of the derivation, proved: two polynomials of degree n_i in the i-th variable
// that agree on a grid of n_i + 1 values of each are the same (Alon, "Combinatorial Nullstellensatz",
// Combinatorics, Probability and Computing 8, 1999, lemma 2.1). Everything is an integer, and none overflows:
// nothing is rounded, nothing is sampled.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>

#include "closed_form_cxx.hpp"

namespace raytorus {
namespace {

using Int = std::int64_t;
using Cxx = test::ClosedFormCxx<Int>;

// A ray (a, b, c) + t (x, y, z) and a torus.
struct Point {
    Int a, b, c, x, y, z, t, r, w;
};

// Every polynomial of the derivation has degree 4 or less in each of a, b, c, x, y, z and t, and r and w
// occur in their squares alone, to the second power of these: five values of the seven, three of the two, 703
// 125 points. The squares 0, 1 and 4 are three values. Numbers stay below 1e6. Where the degree in x, y and z
// is 8, these go to `widest` = 4.
template <class Check>
void onTheGrid(const Check& check, Int widest) {
    const std::array<Int, 9> first{-2, -2, -2, -widest, -widest, -widest, -2, 0, 0};
    const std::array<Int, 9> last{2, 2, 2, widest, widest, widest, 2, 2, 2};
    std::array<Int, 9> at = first;
    for (;;) {
        if (!check(Point{at[0], at[1], at[2], at[3], at[4], at[5], at[6], at[7], at[8]})) {
            return;
        }
        std::size_t k = 0;
        for (; k < at.size() && at[k] == last[k]; ++k) {
            at[k] = first[k];
        }
        if (k == at.size()) {
            return;
        }
        ++at[k];
    }
}

// Whether the two agree on the whole grid.
template <class F, class G>
bool identical(const F& f, const G& g, Int widest = 2) {
    bool same = true;
    Int points = 0;
    onTheGrid(
        [&](const Point& p) {
            ++points;
            return same = f(p) == g(p);
        },
        widest);
    const Int values = 2 * widest + 1;
    return same && points == 625 * values * values * values * 9;
}

Int sq(Int x) {
    return x * x;
}
Int cube(Int x) {
    return x * x * x;
}
Int pow4(Int x) {
    return x * x * x * x;
}

// (math.md, eq. 4), with R for the one r that the derivation this project started from prints as R.
Int substituted(const Point& p, Int R) {
    const Int X = p.a + p.x * p.t;
    const Int Y = p.b + p.y * p.t;
    const Int Z = p.c + p.z * p.t;
    return sq(X * X + Y * Y + Z * Z + R * R - p.w * p.w) - 4 * p.r * p.r * (X * X + Y * Y);
}

Int ray(const Point& p) {
    return substituted(p, p.r);
}

// (math.md, eq. 5), term by term.
Int expanded(const Point& p) {
    const auto& [a, b, c, x, y, z, t, r, w] = p;
    const Int a2 = a * a, b2 = b * b, c2 = c * c, x2 = x * x, y2 = y * y, z2 = z * z, t2 = t * t, r2 = r * r,
              w2 = w * w;
    const Int t3 = t2 * t, t4 = t2 * t2;
    return a2 * a2 + 4 * a2 * a * t * x + 2 * a2 * b2 + 4 * a2 * b * t * y + 2 * a2 * c2 +
           4 * a2 * c * t * z - 2 * a2 * r2 + 6 * a2 * t2 * x2 + 2 * a2 * t2 * y2 + 2 * a2 * t2 * z2 -
           2 * a2 * w2 + 4 * a * b2 * t * x + 8 * a * b * t2 * x * y + 4 * a * c2 * t * x +
           8 * a * c * t2 * x * z - 4 * a * r2 * t * x + 4 * a * t3 * x2 * x + 4 * a * t3 * x * y2 +
           4 * a * t3 * x * z2 - 4 * a * t * w2 * x + b2 * b2 + 4 * b2 * b * t * y + 2 * b2 * c2 +
           4 * b2 * c * t * z - 2 * b2 * r2 + 2 * b2 * t2 * x2 + 6 * b2 * t2 * y2 + 2 * b2 * t2 * z2 -
           2 * b2 * w2 + 4 * b * c2 * t * y + 8 * b * c * t2 * y * z - 4 * b * r2 * t * y +
           4 * b * t3 * x2 * y + 4 * b * t3 * y2 * y + 4 * b * t3 * y * z2 - 4 * b * t * w2 * y + c2 * c2 +
           4 * c2 * c * t * z + 2 * c2 * r2 + 2 * c2 * t2 * x2 + 2 * c2 * t2 * y2 + 6 * c2 * t2 * z2 -
           2 * c2 * w2 + 4 * c * r2 * t * z + 4 * c * t3 * x2 * z + 4 * c * t3 * y2 * z +
           4 * c * t3 * z2 * z - 4 * c * t * w2 * z + r2 * r2 - 2 * r2 * t2 * x2 - 2 * r2 * t2 * y2 +
           2 * r2 * t2 * z2 - 2 * r2 * w2 + t4 * x2 * x2 + 2 * t4 * x2 * y2 + 2 * t4 * x2 * z2 +
           t4 * y2 * y2 + 2 * t4 * y2 * z2 + t4 * z2 * z2 - 2 * t2 * w2 * x2 - 2 * t2 * w2 * y2 -
           2 * t2 * w2 * z2 + w2 * w2;
}

using Coefficients = std::array<Int, 5>;

Int inT(const Coefficients& k, Int t) {
    return k[0] + t * (k[1] + t * (k[2] + t * (k[3] + t * k[4])));
}

// (math.md, eq. 6).
Coefficients collected(const Point& p) {
    const auto& [a, b, c, x, y, z, t, r, w] = p;
    const Int a2 = a * a, b2 = b * b, c2 = c * c, x2 = x * x, y2 = y * y, z2 = z * z, r2 = r * r, w2 = w * w;
    return {pow4(a) + 2 * a2 * b2 + pow4(b) + 2 * a2 * c2 + 2 * b2 * c2 + pow4(c) - 2 * a2 * r2 -
                2 * b2 * r2 + 2 * c2 * r2 + pow4(r) - 2 * a2 * w2 - 2 * b2 * w2 - 2 * c2 * w2 - 2 * r2 * w2 +
                pow4(w),
            4 * cube(a) * x + 4 * a * b2 * x + 4 * a * c2 * x - 4 * a * r2 * x - 4 * a * w2 * x +
                4 * a2 * b * y + 4 * cube(b) * y + 4 * b * c2 * y - 4 * b * r2 * y - 4 * b * w2 * y +
                4 * a2 * c * z + 4 * b2 * c * z + 4 * cube(c) * z + 4 * c * r2 * z - 4 * c * w2 * z,
            6 * a2 * x2 + 2 * b2 * x2 + 2 * c2 * x2 - 2 * r2 * x2 - 2 * w2 * x2 + 8 * a * b * x * y +
                2 * a2 * y2 + 6 * b2 * y2 + 2 * c2 * y2 - 2 * r2 * y2 - 2 * w2 * y2 + 8 * a * c * x * z +
                8 * b * c * y * z + 2 * a2 * z2 + 2 * b2 * z2 + 6 * c2 * z2 + 2 * r2 * z2 - 2 * w2 * z2,
            4 * a * cube(x) + 4 * b * x2 * y + 4 * a * x * y2 + 4 * b * cube(y) + 4 * c * x2 * z +
                4 * c * y2 * z + 4 * a * x * z2 + 4 * b * y * z2 + 4 * c * cube(z),
            pow4(x) + 2 * x2 * y2 + pow4(y) + 2 * x2 * z2 + 2 * y2 * z2 + pow4(z)};
}

// (math.md, eq. 7).
Coefficients simplified(const Point& p) {
    const auto& [a, b, c, x, y, z, t, r, w] = p;
    const Int a2 = a * a, b2 = b * b, c2 = c * c, x2 = x * x, y2 = y * y, z2 = z * z, r2 = r * r, w2 = w * w;
    const Int o2 = a2 + b2 + c2, d2 = x2 + y2 + z2;
    return {collected(p)[0], 4 * ((o2 - r2 - w2) * (a * x + b * y) + c * (o2 + r2 - w2) * z),
            2 * ((c2 - r2 - w2) * (x2 + y2) + 4 * b * c * y * z + (3 * c2 + r2 - w2) * z2 +
                 4 * a * x * (b * y + c * z) + a2 * (3 * x2 + y2 + z2) + b2 * (x2 + 3 * y2 + z2)),
            4 * (a * x + b * y + c * z) * d2, sq(d2)};
}

TEST(Identities, TheImplicitEquationIsTheTubeTimesTheInnerSheet) {
    // Degree 4 in rho, R and z and w: five values of each.
    for (Int rho = 0; rho < 5; ++rho)
        for (Int R = 0; R < 5; ++R)
            for (Int z = 0; z < 5; ++z)
                for (Int w = 0; w < 5; ++w) {
                    const Int tube = sq(R - rho) + z * z - w * w;  // (math.md, eq. 1)
                    const Int inner = sq(R + rho) + z * z - w * w;
                    const Int s = rho * rho + z * z + R * R - w * w;
                    EXPECT_EQ(s - 2 * R * rho, tube);                        // (math.md, eq. 2)
                    EXPECT_EQ(s * s - 4 * R * R * rho * rho, tube * inner);  // (math.md, eq. 3)
                }
}

TEST(Identities, TheLongExpansionIsTheSubstitutedRay) {
    EXPECT_TRUE(identical(expanded, ray));
}

TEST(Identities, TheCollectedFormIsTheSubstitutedRay) {
    EXPECT_TRUE(identical([](const Point& p) { return inT(collected(p), p.t); }, ray));
}

TEST(Identities, TheSimplifiedFormIsTheCollectedOne) {
    EXPECT_TRUE(identical(simplified, collected));
}

// The library's own lines, as integers.
TEST(Identities, TorusQuarticCoefficientsAreTheSimplifiedForm) {
    const auto library = [](const Point& p) {
        return Cxx::quarticCoefficients(p.r, p.w, {p.a, p.b, p.c}, {p.x, p.y, p.z});
    };
    EXPECT_TRUE(identical(library, simplified));
}

// beta as 15 terms is beta as a product: degree 4 in each of a, b, c and w, in squares. With rho^2 = a^2 +
// b^2 the product is a difference of two squares.
TEST(Identities, TheSumForBetaIsTheProduct) {
    for (Int a = 0; a < 3; ++a)
        for (Int b = 0; b < 3; ++b)
            for (Int c = 0; c < 3; ++c)
                for (Int w = 0; w < 3; ++w) {
                    Cxx::Ray reduced;
                    reduced.origin = {a, b, c};
                    reduced.tubeRadius = w;
                    const Int rho2 = a * a + b * b;
                    EXPECT_EQ(Cxx::betaSum(reduced), sq(rho2 + c * c + 1 - w * w) - 4 * rho2);
                    // The form that precedes the substitutions.
                    EXPECT_EQ(Cxx::betaSum(reduced), pow4(a) + 2 * a * a * (b * b + c * c - w * w - 1) +
                                                         pow4(b) + 2 * b * b * (c * c - w * w - 1) +
                                                         sq(c * c - w * w + 1));
                }
}

// (math.md, eq. 28) times |d|^8, which leaves no fraction: u, k, b and e of the ray as the march has them.
Int marched(const Point& p) {
    const Int dd = sq(p.x) + sq(p.y) + sq(p.z);
    const Int od = p.a * p.x + p.b * p.y + p.c * p.z;
    const Int oo = sq(p.a) + sq(p.b) + sq(p.c);
    const Int u = dd * p.t + od;                                // |d|^2 u
    const Int k = oo * dd - sq(od) - (sq(p.r) + sq(p.w)) * dd;  // |d|^4 k
    const Int b0 = 2 * p.r * (p.c * dd - od * p.z);             // |d|^4 b_0
    const Int b1 = 2 * p.r * p.z;                               // |d|^2 b_1
    return sq(sq(u) + k) + sq(b0 + b1 * u) - sq(2 * p.r * p.w * dd);
}

TEST(Identities, TheMarchIsTheSubstitutedRay) {
    const auto timesLength4 = [](const Point& p) { return ray(p) * sq(sq(p.x) + sq(p.y) + sq(p.z)); };
    EXPECT_TRUE(identical(marched, timesLength4, 4));
}

// The march's quartic of some line, and what it knows of it at u.
struct March {
    Int k, b0, b1, edge2;

    Int a(Int u) const { return u * u + k; }
    Int b(Int u) const { return b0 + b1 * u; }
    Int f(Int u) const { return sq(a(u)) + sq(b(u)) - edge2; }
    Int h(Int u) const { return 2 * u * a(u) + b1 * b(u); }
    Int c(Int u) const { return 2 * a(u) + b1 * b1; }
    // f + 2 h x + (c + squared) x^2: a parabola in x.
    Int parabola(Int u, Int x, Int squared) const { return f(u) + (2 * h(u) + (c(u) + squared) * x) * x; }
};

// Every line and torus of a grid. Of degree 2 in k, b_0 and b_1, linear in e^2.
template <class Check>
void forMarches(const Check& check) {
    for (Int k = -4; k <= 2; ++k)
        for (Int b0 = -2; b0 <= 2; ++b0)
            for (Int b1 = -2; b1 <= 2; ++b1)
                for (Int edge2 = 0; edge2 <= 9; edge2 += 3) {
                    check(March{k, b0, b1, edge2});
                }
}

// (math.md, eq. 29): degree 4 in u and x.
TEST(Identities, AStepOfTheMarchIsExact) {
    forMarches([](const March& march) {
        for (Int u = -2; u <= 2; ++u)
            for (Int x = -2; x <= 2; ++x) {
                ASSERT_EQ(march.f(u + x), march.parabola(u, x, 0) + sq(2 * u * x + x * x));
            }
    });
}

// (math.md, eq. 30), with m and M found as the march finds them. Integers are as good as fractions: u, x and
// b_1 times n, k and b_0 times n^2 and e^2 times n^4 are the same line, drawn larger.
TEST(Identities, TheParabolasBoundTheMarch) {
    int crossings = 0;
    forMarches([&](const March& march) {
        for (Int u = -4; u <= 3; ++u)
            for (Int reach = 1; reach <= 9; ++reach) {
                const Int twoU = 2 * u, ahead = twoU + reach;
                const Int least = sq(twoU > 0 ? twoU : std::min<Int>(ahead, 0));
                const Int largest = sq(std::max(std::abs(twoU), std::abs(ahead)));
                Int m = sq(twoU), M = m;
                bool crossed = false;
                for (Int x = 0; x <= reach; ++x) {
                    m = std::min(m, sq(twoU + x));
                    M = std::max(M, sq(twoU + x));
                    const Int f = march.f(u + x);
                    const Int below = march.parabola(u, x, least), above = march.parabola(u, x, largest);
                    ASSERT_LE(below, f);
                    ASSERT_GE(above, f);
                    // Whoever has crossed is past a root of the parabola of the side where the step began.
                    const Int side = march.f(u) > 0 ? 1 : -1;
                    if (march.f(u) != 0 && side * f <= 0) {
                        ASSERT_LE(side * (side > 0 ? below : above), 0);
                        crossed = true;
                    }
                }
                // Both are reached, so no parabola with the same value and slope is closer.
                ASSERT_EQ(least, m);
                ASSERT_EQ(largest, M);
                crossings += crossed ? 1 : 0;
            }
    });
    EXPECT_GT(crossings, 10000);
}

// The errors of print, each shown to be one. A second radius R, where the first is meant:
TEST(IdentitiesErrata, TheRPrintedInTheSubstitutedRayIsR) {
    EXPECT_FALSE(identical([](const Point& p) { return substituted(p, p.r + 1); }, expanded));
    const Point p{3, 0, 0, 1, 0, 0, 1, 2, 1};
    EXPECT_EQ(substituted(p, 2), 105);  // (16 + 4 - 1)^2 - 4 * 4 * 16, that is 19^2 - 16^2
    EXPECT_EQ(expanded(p), 105);
    EXPECT_EQ(substituted(p, 1), 0);  // (16 + 1 - 1)^2 - 16^2: the ray would be on the surface
}

}  // namespace
}  // namespace raytorus
