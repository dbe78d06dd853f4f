// SPDX-License-Identifier: MIT
#include "explain/exact.hpp"

#include <algorithm>
#include <limits>

#include "reference/intersect.hpp"

namespace raytorus::explain {
namespace {

using reference::magnitude;
using reference::squareRoot;

Quad square(Quad x) {
    return x * x;
}

// Equation 7, term by term.
std::array<Quad, 5> coefficientsOf(Quad R, Quad r, const Vec3<Quad>& origin, const Vec3<Quad>& direction) {
    const auto& [a, b, c] = origin;
    const auto& [x, y, z] = direction;
    const Quad R2 = R * R, r2 = r * r;
    const Quad o2 = reference::dot(origin, origin), d2 = reference::dot(direction, direction);
    const Quad c0 = square(o2 + R2 - r2) - 4 * R2 * (a * a + b * b);
    const Quad c1 = 4 * ((o2 - R2 - r2) * (a * x + b * y) + (o2 + R2 - r2) * c * z);
    const Quad c2 = 2 * ((c * c - R2 - r2) * (x * x + y * y) + 4 * b * c * y * z +
                         (3 * c * c + R2 - r2) * z * z + 4 * a * x * (b * y + c * z) +
                         a * a * (3 * x * x + y * y + z * z) + b * b * (x * x + 3 * y * y + z * z));
    const Quad c3 = 4 * reference::dot(origin, direction) * d2;
    return {c0, c1, c2, c3, d2 * d2};
}

// Equation 8. Lengths and the direction are scaled by powers of two first, so that the far end of a ray costs
// no digits; see reference/intersect.hpp.
void reduce(const reference::Torus& torus, const reference::Ray& ray, Steps<Quad>& steps) {
    const int length = reference::exponentOf(Quad(std::max(torus.majorRadius, torus.minorRadius)));
    Vec3<Quad> origin = reference::toQuad(ray.origin), direction = reference::toQuad(ray.direction);
    const int speed = reference::exponentOf(squareRoot(reference::dot(direction, direction)));
    for (std::size_t i = 0; i < 3; ++i) {
        origin[i] = reference::timesPowerOfTwo(origin[i], -length);
        direction[i] = reference::timesPowerOfTwo(direction[i], -speed);
    }
    const reference::ScaledLine<Quad> line = reference::shiftedToFoot(origin, direction);
    const Quad d2 = reference::dot(direction, direction), d = squareRoot(d2);
    const Quad rest = -reference::dot(line.point, direction) / d2;
    const Quad R = reference::timesPowerOfTwo(Quad(torus.majorRadius), -length);
    const Vec3<Quad> foot = line.at(rest);
    for (std::size_t i = 0; i < 3; ++i) {
        steps.origin[i] = foot[i] / R;
        steps.direction[i] = direction[i] / d;
    }
    steps.tubeRadius = Quad(torus.minorRadius) / Quad(torus.majorRadius);
    steps.shift = reference::timesPowerOfTwo(line.shift + rest, length - speed);
    steps.scale = reference::timesPowerOfTwo(R / d, length - speed);
}

// Equations 9 to 13.
void formQuartic(Steps<Quad>& steps) {
    const auto& [a, b, c] = steps.origin;
    const auto& [x, y, z] = steps.direction;
    const Quad w = steps.tubeRadius, w2 = w * w;
    const Quad o2 = reference::dot(steps.origin, steps.origin);
    const Quad rho = squareRoot(a * a + b * b);
    steps.alpha = o2 - w2 + 2 * z * z - 1;
    steps.cz = c * z;
    steps.beta = ((rho - 1 - w) * (rho - 1 + w) + c * c) * ((rho + 1 - w) * (rho + 1 + w) + c * c);
    steps.alphaRadial = o2 - w2 - 2 * x * x - 2 * y * y + 1;
    steps.czRadial = -(a * x + b * y);
    const Quad a2 = a * a, b2 = b * b, c2 = c * c;
    steps.betaSum = a2 * a2 + 2 * a2 * b2 + 2 * a2 * c2 - 2 * a2 * w2 - 2 * a2 + b2 * b2 + c2 * c2 + w2 * w2 -
                    2 * b2 + 2 * b2 * c2 + 2 * c2 - 2 * b2 * w2 - 2 * c2 * w2 - 2 * w2 + 1;
}

// 113 bits less what the dozen roundings on the way to a number cost: nearer to 0 its sign is not known.
const Quad doubtful = reference::timesPowerOfTwo(Quad(1), -100);

// Equations 14 to 21.
void solveResolvent(Steps<Quad>& steps) {
    const Quad alpha = steps.alpha, beta = steps.beta, cz = steps.cz;
    const Quad gamma = 16 * alpha * alpha * alpha - 144 * alpha * beta + 1728 * cz * cz;
    const Quad delta = 4 * alpha * alpha + 12 * beta;
    const Quad gamma2 = gamma * gamma, delta3 = 4 * delta * delta * delta;
    steps.gamma = gamma;
    steps.delta = delta;
    steps.epsilon = gamma2 - delta3;
    if (magnitude(steps.epsilon) <= doubtful * (gamma2 + magnitude(delta3))) {
        steps.epsilon = 0;
    }
    if (steps.epsilon < 0) {
        const Quad cosine = gamma / (2 * delta * squareRoot(delta));
        steps.y = 2 * squareRoot(delta) * cosq(acosq(cosine) / 3) / 3;
        steps.rootCase = RootCase::FourOrNone;
    } else {
        const Quad root = squareRoot(steps.epsilon);
        const Quad zeta = cbrtq((gamma < 0 ? gamma - root : gamma + root) / 2);
        steps.zeta = zeta;
        steps.y = zeta != 0 ? zeta / 3 + delta / (3 * zeta) : 0;
        const RootCase withZeta = steps.epsilon > 0 ? RootCase::Two : RootCase::Multiple;
        steps.rootCase = zeta != 0 ? withZeta : RootCase::Triple;
    }
    const Quad inner = steps.y - 4 * alpha / 3;
    const bool vanishes = inner <= doubtful * (magnitude(steps.y) + magnitude(alpha));
    steps.S = vanishes ? 0 : squareRoot(inner);
    if (cz == 0 || vanishes) {
        steps.rootCase = RootCase::Biquadratic;
    }
}

// The inner sheet lies where s = |p|^2 + R^2 - r^2 <= 0, and at both ends of that range the quartic is not
// positive.
reference::RootList<Quad> innerRoots(const Steps<Quad>& steps) {
    reference::RootList<Quad> found;
    const Quad w = steps.tubeRadius;
    const Quad reach2 = (w - 1) * (w + 1) - reference::dot(steps.origin, steps.origin);
    if (reach2 > 0) {
        const Quad reach = squareRoot(reach2);
        const reference::Quartic<Quad> q{steps.beta, 8 * steps.cz, 2 * steps.alpha, 0, 1};
        reference::addRootsBetween<Quad>(q, -reach, true, reach, true, found);
    }
    return found;
}

RootPlace placeOf(Quad t, const reference::Ray& ray) {
    if (t < Quad(ray.tMin)) {
        return RootPlace::Before;
    }
    return t <= Quad(ray.tMax) ? RootPlace::Within : RootPlace::Beyond;
}

}  // namespace

Steps<Quad> exactSteps(const reference::Torus& torus, const reference::Ray& ray) {
    Steps<Quad> steps;
    steps.coefficients = coefficientsOf(Quad(torus.majorRadius), Quad(torus.minorRadius),
                                        reference::toQuad(ray.origin), reference::toQuad(ray.direction));
    steps.reduced = torus.majorRadius > 0.0F;
    if (steps.reduced) {
        reduce(torus, ray, steps);
        formQuartic(steps);
        solveResolvent(steps);
    }
    return steps;
}

std::vector<TrueRoot> trueRoots(const reference::Torus& torus, const reference::Ray& ray,
                                const Steps<Quad>& steps) {
    reference::Ray line = ray;
    line.tMin = -std::numeric_limits<float>::infinity();
    line.tMax = std::numeric_limits<float>::infinity();
    const reference::Intersections outer = reference::intersect(torus, line);
    std::vector<TrueRoot> roots;
    for (int i = 0; i < outer.count; ++i) {
        const reference::Hit& hit = outer.hits[static_cast<std::size_t>(i)];
        TrueRoot root;
        root.t = hit.t;
        root.position = hit.position;
        root.entering = hit.entering;
        roots.push_back(root);
    }
    reference::RootList<Quad> inner = innerRoots(steps);
    // A horn's inner sheet is the centre alone: a line through it has four real roots, those there among
    // them.
    const bool meetsTip =
        steps.reduced && steps.tubeRadius == 1 && reference::dot(steps.origin, steps.origin) == 0;
    for (int i = outer.count; meetsTip && i < 4; ++i) {
        inner.add(0, false);
    }
    for (int i = 0; i < inner.count; ++i) {
        const Quad u = inner.roots[static_cast<std::size_t>(i)].value;
        TrueRoot root;
        root.t = steps.shift + steps.scale * u;
        for (std::size_t k = 0; k < 3; ++k) {
            root.position[k] = Quad(torus.majorRadius) * (steps.origin[k] + u * steps.direction[k]);
        }
        root.sheet = Sheet::Inner;
        roots.push_back(root);
    }
    for (TrueRoot& root : roots) {
        root.place = placeOf(root.t, ray);
        root.normal = reference::normal(torus, root.position);
        root.uv = reference::uv(torus, root.position);
    }
    std::sort(roots.begin(), roots.end(), [](const TrueRoot& a, const TrueRoot& b) { return a.t < b.t; });
    return roots;
}

}  // namespace raytorus::explain
