// SPDX-License-Identifier: MIT
// A seeded stream of numbers, points and directions, identical on every platform: no std distribution, no
// sin.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

namespace raytorus::reference {

using DoubleVec3 = std::array<double, 3>;
using DoubleVec2 = std::array<double, 2>;

inline DoubleVec3 operator+(const DoubleVec3& a, const DoubleVec3& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline DoubleVec3 operator-(const DoubleVec3& a, const DoubleVec3& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline DoubleVec3 operator*(double s, const DoubleVec3& a) {
    return {s * a[0], s * a[1], s * a[2]};
}
inline DoubleVec3 unit(const DoubleVec3& a) {
    return (1 / std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2])) * a;
}

// SplitMix64: Steele, Lea, Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014.
class Random {
public:
    Random(std::uint64_t seed, std::uint64_t stream, std::uint64_t index) : state(seed) {
        state = next() + stream;
        state = next() + index;
    }

    std::uint64_t next() {
        state += 0x9E3779B97F4A7C15u;
        std::uint64_t z = state;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
        return z ^ (z >> 31);
    }
    int below(int count) {
        return static_cast<int>((next() >> 32) * static_cast<std::uint64_t>(count) >> 32);
    }
    double uniform() { return std::ldexp(static_cast<double>(next() >> 11), -53); }  // [0, 1)
    double uniform(double low, double high) { return low + (high - low) * uniform(); }
    double sign() { return below(2) == 0 ? 1.0 : -1.0; }

    // By rejection: the square root is the only function needed.
    DoubleVec3 inBall() {
        for (;;) {
            const DoubleVec3 p{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
            const double squared = p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
            if (squared <= 1 && squared > 1e-6) return p;  // away from 0, so that unit() is safe
        }
    }
    DoubleVec2 inDisc() {
        for (;;) {
            const DoubleVec2 p{uniform(-1, 1), uniform(-1, 1)};
            const double squared = p[0] * p[0] + p[1] * p[1];
            if (squared <= 1 && squared > 1e-6) return p;
        }
    }
    DoubleVec3 onSphere() { return unit(inBall()); }
    DoubleVec2 onCircle() {
        const DoubleVec2 p = inDisc();
        const double length = std::sqrt(p[0] * p[0] + p[1] * p[1]);
        return {p[0] / length, p[1] / length};
    }

private:
    std::uint64_t state;
};

}  // namespace raytorus::reference
