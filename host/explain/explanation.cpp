// SPDX-License-Identifier: MIT
#include "explain/explanation.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "explain/number_text.hpp"

namespace raytorus::explain {
namespace {

template <class Actual>
Quad distance(const Vec3<Quad>& exact, const Vec3<Actual>& actual) {
    Vec3<Quad> off{};
    for (std::size_t i = 0; i < 3; ++i) {
        off[i] = exact[i] - Quad(actual[i]);
    }
    return reference::squareRoot(reference::dot(off, off));
}

Quad lengthOf(const reference::Ray& ray) {
    const Vec3<Quad> direction = reference::toQuad(ray.direction);
    return reference::squareRoot(reference::dot(direction, direction));
}

double size(const reference::Torus& torus) {
    return double{torus.majorRadius} + double{torus.minorRadius};
}

}  // namespace

double sizeInT(const reference::Torus& torus, const reference::Ray& ray) {
    return size(torus) / reference::toDouble(lengthOf(ray));
}

double tError(const Explanation& e, const TrueRoot& root, float t) {
    const double shortest = std::ldexp(sizeInT(e.torus, e.ray), -4);
    const double magnitude = std::max(std::abs(reference::toDouble(root.t)), shortest);
    return reference::toDouble(reference::magnitude(root.t - Quad(t))) / floatUlp(magnitude);
}

double positionError(const Explanation& e, const TrueRoot& root, const Vec3<float>& position) {
    return reference::toDouble(distance(root.position, position)) / size(e.torus);
}

double positionError(const Explanation& e, const TrueRoot& root, float t) {
    return reference::toDouble(reference::magnitude(root.t - Quad(t)) * lengthOf(e.ray)) / size(e.torus);
}

double normalError(const TrueRoot& root, const ShaderHit& hit) {
    return reference::toDouble(distance(root.normal, hit.normal));
}

double uvError(const TrueRoot& root, const ShaderHit& hit) {
    double largest = 0.0;
    for (std::size_t i = 0; i < 2; ++i) {
        const double off = std::abs(reference::toDouble(root.uv[i] - Quad(hit.uv[i])));
        largest = std::max(largest, std::min(off, 1.0 - off));  // 0 and 1 are one place
    }
    return largest;
}

bool isInvented(const Explanation& e, std::size_t hit) {
    return std::none_of(e.roots.begin(), e.roots.end(),
                        [hit](const TrueRoot& root) { return root.hit == hit; });
}

bool isInventedByClosedForm(const Explanation& e, std::size_t found) {
    return std::none_of(e.roots.begin(), e.roots.end(),
                        [found](const TrueRoot& root) { return root.closedForm == found; });
}

const char* shapeOf(const reference::Torus& torus) {
    if (torus.majorRadius == 0.0F) {
        return "sphere";
    }
    if (torus.minorRadius == torus.majorRadius) {
        return "horn";
    }
    return torus.minorRadius < torus.majorRadius ? "ring" : "spindle";
}

const char* describe(RootCase rootCase) {
    switch (rootCase) {
        case RootCase::Biquadratic:
            return "cz or S is 0: a quadratic in t^2 (23)";
        case RootCase::FourOrNone:
            return "epsilon < 0: four real roots or none (21)";
        case RootCase::Two:
            return "epsilon > 0: two real roots (18)";
        case RootCase::Multiple:
            return "epsilon = 0: a double root (18)";
        case RootCase::Triple:
            return "zeta = 0: a triple root (18)";
        case RootCase::None:
            break;
    }
    return "no reduced quartic";
}

std::vector<std::size_t> matched(const std::vector<Quad>& shorter, const std::vector<Quad>& longer) {
    std::vector<std::size_t> best;
    Quad bestSum = 0;
    // Every choice of as many entries, as bits.
    for (unsigned chosen = 0; chosen < 1U << longer.size(); ++chosen) {
        if (static_cast<std::size_t>(std::popcount(chosen)) != shorter.size()) {
            continue;
        }
        std::vector<std::size_t> places;
        Quad sum = 0;
        for (std::size_t i = 0; i < longer.size(); ++i) {
            if ((chosen >> i & 1U) != 0U) {
                sum += reference::magnitude(shorter[places.size()] - longer[i]);
                places.push_back(i);
            }
        }
        if (best.empty() || sum < bestSum) {
            best = places;
            bestSum = sum;
        }
    }
    return best;
}

}  // namespace raytorus::explain
