// SPDX-License-Identifier: MIT
// The ray generators: one function a class. They compute in double and round to float at the very end; where
// a class promises an exact property (through the axis, zeros), the numbers have so few bits that nothing
// rounds.
#include "reference/rays.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "reference/random.hpp"

namespace raytorus::reference {

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

struct Scene {
    double R, r, D;
    double margin;
};

Ray makeRay(const DoubleVec3& origin, const DoubleVec3& direction, float tMin = 0, float tMax = infinity) {
    const auto f = [](double x) { return static_cast<float>(x); };
    return {{f(origin[0]), f(origin[1]), f(origin[2])},
            tMin,
            {f(direction[0]), f(direction[1]), f(direction[2])},
            tMax};
}

struct SurfacePoint {
    DoubleVec3 position, normal, alongU, alongV;
};

// A point of the outer sheet at `depth` r from the tube's centre circle: depth 1 is the surface. Not within
// 0.05 r of the axis, where a step along the normal may cross to the sheet's other side; cusps belong to
// throughAxis.
SurfacePoint tubePoint(Random& random, const Scene& scene, double depth) {
    const DoubleVec2 u = random.onCircle();
    DoubleVec2 v = random.onCircle();
    while (scene.R + scene.r * depth * v[0] < 0.05 * scene.r * depth)
        v = random.onCircle();
    const double rho = scene.R + scene.r * depth * v[0];
    return {{rho * u[0], rho * u[1], scene.r * depth * v[1]},
            {v[0] * u[0], v[0] * u[1], v[1]},
            {-u[1], u[0], 0},
            {-v[1] * u[0], -v[1] * u[1], v[0]}};
}

// A number of 12 bits in +-[1/2, 1): products of two are exact floats.
double shortNumber(Random& random) {
    return random.sign() * static_cast<double>(2048 + random.below(2048)) / 4096;
}

// The power of two next below `x`, so that a product with it stays exact.
double powerOfTwoBelow(double x) {
    return std::ldexp(1.0, std::ilogb(x));
}

Ray camera(Random& random, const Scene& scene, int branch) {
    const DoubleVec3 origin = scene.D * random.onSphere();
    const DoubleVec3 target =
        branch == 1 ? tubePoint(random, scene, 1).position : (scene.R + scene.r) * random.inBall();
    return makeRay(origin, unit(target - origin), 0,
                   branch == 2 ? std::numeric_limits<float>::max() : infinity);
}

Ray inside(Random& random, const Scene& scene, int branch) {
    const SurfacePoint p = tubePoint(random, scene, 0.999 * std::sqrt(random.uniform()));
    const DoubleVec3 direction = random.onSphere();
    return makeRay(p.position, branch == 0 ? direction : unit(random.sign() * p.alongU + 0.05 * direction));
}

Ray hole(Random& random, const Scene& scene, int branch) {
    const bool open = scene.r < scene.R;
    // Without a hole: above the cusp (or the horn point), by so much that 0.01 R beside the axis is outside.
    const double cusp = open ? 0 : std::sqrt((scene.r - scene.R) * (scene.r + scene.R));
    const double radius = open ? 0.99 * (scene.R - scene.r) : 0.01 * scene.R;
    const double z = cusp + scene.r * (open ? random.uniform(0, 1) : random.uniform(0.3, 1));
    const DoubleVec2 disc = random.inDisc();
    return makeRay({radius * disc[0], radius * disc[1], branch == 0 ? z : -z}, random.onSphere());
}

Ray equatorial(Random& random, const Scene& scene, int branch) {
    const DoubleVec2 from = random.onCircle(), start = random.inDisc(), target = random.inDisc();
    const double reach = scene.R + scene.r;
    const DoubleVec3 origin = branch == 0 ? DoubleVec3{scene.D * from[0], scene.D * from[1], 0}
                                          : DoubleVec3{reach * start[0], reach * start[1], 0};
    const DoubleVec3 towards{1.1 * reach * target[0], 1.1 * reach * target[1], 0};
    DoubleVec3 direction = unit(towards - origin);
    direction[2] = 0 * random.sign();
    return makeRay({origin[0], origin[1], 0 * random.sign()}, direction);
}

Ray axisParallel(Random& random, const Scene& scene, int branch) {
    const double up = branch == 0 || (branch == 2 && random.below(2) == 0) ? -1.0 : 1.0;
    const DoubleVec2 disc = random.inDisc();
    const double reach = branch == 2 ? 0 : 1.05 * (scene.R + scene.r);
    return makeRay({reach * disc[0], reach * disc[1], -up * scene.D},
                   {0 * random.sign(), 0 * random.sign(), up});
}

// x and y of origin and direction are in the ratio of two short numbers: the line meets the axis.
Ray throughAxis(Random& random, const Scene& scene, int branch) {
    const double x = shortNumber(random), y = shortNumber(random);
    const double far = branch == 0 ? powerOfTwoBelow(scene.D) * -std::abs(shortNumber(random)) * 2
                                   : -scene.D * random.uniform(0.9, 1.1);
    const double above = (scene.R + scene.r) * random.uniform(-1, 1);  // where the line meets the axis
    const double slope = random.uniform(-1, 1);
    return makeRay({far * x, far * y, above + far * slope}, {x, y, slope});
}

Ray throughCentre(Random& random, const Scene& scene, int branch) {
    const DoubleVec3 direction{shortNumber(random), shortNumber(random), shortNumber(random)};
    const double far = branch == 0 ? powerOfTwoBelow(scene.D) * -std::abs(shortNumber(random)) * 2
                                   : -scene.D * random.uniform(0.9, 1.1);
    return makeRay(far * direction, direction);
}

// Reflection, refraction and shadow rays; above and below are 1e-4 r, a tenth of tMin.
Ray leaving(Random& random, const Scene& scene, int branch) {
    const double offsets[3] = {0, 1e-4, -1e-4};
    const SurfacePoint p = tubePoint(random, scene, 1);
    DoubleVec3 direction = random.onSphere();
    const double cosine =
        direction[0] * p.normal[0] + direction[1] * p.normal[1] + direction[2] * p.normal[2];
    if ((cosine < 0) != (branch == 2)) direction = -1.0 * direction;
    return makeRay(p.position + (offsets[branch] * scene.r) * p.normal, direction,
                   static_cast<float>(1e-3 * scene.r));
}

Ray axisAligned(Random& random, const Scene& scene, int branch) {
    const std::size_t axis = static_cast<std::size_t>(branch % 3);
    const double reach = scene.R + scene.r;
    const DoubleVec3 inBall = random.inBall();
    DoubleVec3 direction{0 * random.sign(), 0 * random.sign(), 0 * random.sign()};
    if (branch < 3) {
        DoubleVec3 origin = reach * inBall;
        direction[axis] = random.sign();
        origin[axis] = -direction[axis] * scene.D;
        return makeRay(origin, direction);
    }
    const DoubleVec2 inPlane = random.onCircle();
    direction[(axis + 1) % 3] = inPlane[0];
    direction[(axis + 2) % 3] = inPlane[1];
    DoubleVec3 origin = reach * inBall - scene.D * direction;
    if (random.below(2) == 0) origin[axis] = 0 * random.sign();
    return makeRay(origin, direction);
}

Ray nonUnit(Random& random, const Scene& scene, int branch) {
    const DoubleVec3 origin = scene.D * random.onSphere();
    const DoubleVec3 target = (scene.R + scene.r) * random.inBall();
    const int exponent = random.below(59);  // 2^60 = 1.15e18
    const double length = random.uniform(1, 2) * std::ldexp(1.0, branch == 0 ? -1 - exponent : exponent);
    return makeRay(origin, length * unit(target - origin));
}

Ray grazing(Random& random, const Scene& scene, int branch) {
    const SurfacePoint p = tubePoint(random, scene, 1);
    const DoubleVec2 turn = random.onCircle();
    const DoubleVec3 direction = turn[0] * p.alongU + turn[1] * p.alongV;
    const double offset = (branch == 0 ? 1 : -1) * scene.margin * scene.r;
    return makeRay(p.position + offset * p.normal - scene.D * direction, direction);
}

Ray segment(Random& random, const Scene& scene, int branch) {
    const double reach = scene.R + scene.r;
    Ray ray = camera(random, scene, 1);
    const double low = branch == 1 ? 0 : branch == 2 ? scene.D : random.uniform(scene.D - reach, scene.D);
    const double high = branch == 1   ? scene.D - reach
                        : branch == 2 ? 2 * scene.D
                                      : scene.D + reach * random.uniform();
    ray.tMin = static_cast<float>(low);
    ray.tMax = static_cast<float>(high);
    return ray;
}

// 2^-bits to 1, by about as many in each octave.
double smallNumber(Random& random, int bits) {
    return std::ldexp(random.uniform(0.5, 1), -random.below(bits));
}

// The contact is fourfold where the line is a tangent of the top circle in its plane; turned out of both by a
// little.
Ray topCircle(Random& random, const Scene& scene, int branch) {
    const DoubleVec2 u = random.onCircle();
    const double top = random.sign();
    const DoubleVec3 point{scene.R * u[0], scene.R * u[1], top * scene.r};
    const DoubleVec3 outwards{u[0], u[1], 0}, alongU{-u[1], u[0], 0}, up{0, 0, top};
    const double aside = random.sign() * smallNumber(random, 20),
                 slope = random.sign() * smallNumber(random, 27);
    const DoubleVec3 direction = unit(alongU + aside * outwards + slope * up);
    const double offset = (branch == 0 ? 1 : -1) * scene.margin * scene.r;
    return makeRay(point + offset * up - scene.D * direction, direction);
}

// Within a tenth of r of the dimple's tip. A torus without a dimple has its centre there.
Ray dimpleCone(Random& random, const Scene& scene, int branch) {
    const DoubleVec2 u = random.onCircle();
    const double rho = 0.1 * scene.r * smallNumber(random, 13), top = random.sign();
    const double q = rho - scene.R;
    const double z = scene.r > scene.R ? top * std::sqrt((scene.r - q) * (scene.r + q)) : 0;
    const DoubleVec3 point{rho * u[0], rho * u[1], z};
    const DoubleVec3 normal = unit({q * u[0], q * u[1], z}), alongU{-u[1], u[0], 0};
    const DoubleVec3 alongV = unit({-z * u[0], -z * u[1], q});
    const double aside = random.sign() * smallNumber(random, 20);
    const DoubleVec3 direction = unit(random.sign() * alongV + aside * alongU);
    const double offset = (branch == 0 ? 1 : -1) * scene.margin * scene.r;
    return makeRay(point + offset * normal - scene.D * direction, direction);
}

// Near its tip a horn is rho = z^2 / (2 R): what passes the tip at a distance d passes the surface at some
// d^2 / (2 R).
Ray hornTip(Random& random, const Scene& scene, int branch) {
    const double aside = smallNumber(random, 13);
    const DoubleVec3 across = random.onSphere();
    const DoubleVec3 direction =
        branch == 0 ? across : unit({aside * across[0], aside * across[1], random.sign()});
    const double offset = 0.2 * scene.r * smallNumber(random, 13);
    return makeRay(offset * random.onSphere() - scene.D * direction, direction);
}

struct Generator {
    RayClass rayClass;
    const char* name;
    int branches;
    Ray (*make)(Random&, const Scene&, int);
};

constexpr Generator generators[] = {
    {RayClass::camera, "camera", 3, camera},
    {RayClass::inside, "inside", 2, inside},
    {RayClass::hole, "hole", 2, hole},
    {RayClass::equatorial, "equatorial", 2, equatorial},
    {RayClass::axisParallel, "axisParallel", 3, axisParallel},
    {RayClass::throughAxis, "throughAxis", 2, throughAxis},
    {RayClass::throughCentre, "throughCentre", 2, throughCentre},
    {RayClass::leaving, "leaving", 3, leaving},
    {RayClass::axisAligned, "axisAligned", 6, axisAligned},
    {RayClass::nonUnit, "nonUnit", 2, nonUnit},
    {RayClass::grazing, "grazing", 2, grazing},
    {RayClass::segment, "segment", 3, segment},
    {RayClass::topCircle, "topCircle", 2, topCircle},
    {RayClass::dimpleCone, "dimpleCone", 2, dimpleCone},
    {RayClass::hornTip, "hornTip", 2, hornTip},
};

const Generator& generatorOf(RayClass rayClass) {
    return generators[static_cast<std::size_t>(rayClass)];
}

}  // namespace

const char* nameOf(RayClass rayClass) {
    return generatorOf(rayClass).name;
}

int branchCount(RayClass rayClass) {
    return generatorOf(rayClass).branches;
}

double originDistance(const RayParameters& parameters) {
    const double R{parameters.torus.majorRadius}, r{parameters.torus.minorRadius};
    return std::max(parameters.distance * std::max(R, r), 1.25 * (R + r));
}

GeneratedRay generateRay(RayClass rayClass, const RayParameters& parameters, std::uint64_t index) {
    Random random(parameters.seed, static_cast<std::uint64_t>(rayClass), index);
    const Scene scene{double{parameters.torus.majorRadius}, double{parameters.torus.minorRadius},
                      originDistance(parameters), parameters.margin};
    const int branch = random.below(branchCount(rayClass));
    return {generatorOf(rayClass).make(random, scene, branch), branch};
}

std::string describeRay(RayClass rayClass, const RayParameters& parameters, std::uint64_t index) {
    const GeneratedRay generated = generateRay(rayClass, parameters, index);
    std::ostringstream text;
    text << nameOf(rayClass) << " branch " << generated.branch << " D " << parameters.distance << " margin "
         << parameters.margin << " seed " << parameters.seed << " index " << index << ": "
         << hexFloats(parameters.torus, generated.ray);
    return text.str();
}

std::vector<Ray> generateRays(RayClass rayClass, const RayParameters& parameters, std::uint64_t count) {
    std::vector<Ray> rays;
    rays.reserve(count);
    for (std::uint64_t index = 0; index < count; ++index) {
        rays.push_back(generateRay(rayClass, parameters, index).ray);
    }
    return rays;
}

}  // namespace raytorus::reference
