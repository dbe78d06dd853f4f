// SPDX-License-Identifier: MIT
#include "special_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "special_floats.hpp"

namespace raytorus::test {
namespace {

using reference::Ray;
using reference::Torus;

// `x` moved by a number of floats.
float stepped(float x, int steps) {
    for (; steps != 0; steps += steps < 0 ? 1 : -1) {
        x = std::nextafter(x, steps < 0 ? -infinity : infinity);
    }
    return x;
}

// The ray itself, and with each number of its origin and direction moved by up to 4 floats.
std::vector<Ray> withNeighbours(const Ray& ray) {
    std::vector<Ray> rays{ray};
    for (int i = 0; i < 6; ++i) {
        for (const int steps : {-4, -2, -1, 1, 2, 4}) {
            Ray moved = ray;
            float& number = i < 3 ? moved.origin[i] : moved.direction[i - 3];
            // Beside zero the next floats are denormal: there, the steps of a number near 1.
            number = number == 0.0F ? static_cast<float>(steps) * 0x1p-24F : stepped(number, steps);
            rays.push_back(moved);
        }
    }
    return rays;
}

void addLines(std::vector<SpecialLines>& lines, const Torus& torus, const std::vector<Ray>& rays) {
    std::vector<Ray> all;
    for (const Ray& ray : rays) {
        const std::vector<Ray> some = withNeighbours(ray);
        all.insert(all.end(), some.begin(), some.end());
    }
    lines.push_back({torus, all});
}

Ray along(const std::array<float, 3>& origin, const std::array<float, 3>& direction) {
    return {{origin[0], origin[1], origin[2]}, 0, {direction[0], direction[1], direction[2]}, infinity};
}

}  // namespace

std::vector<SpecialLines> touchTheEquators() {
    std::vector<SpecialLines> lines;
    for (const float minorRadius : {0x1p-10F, 0.0625F, 0.25F, 0.875F, 1.0F, 1.5F}) {
        const Torus torus{1, minorRadius};
        const float outer = 1 + minorRadius;
        const float inner = 1 - minorRadius;
        addLines(lines, torus,
                 {along({outer, -5, 0}, {0, 1, 0}), along({-2, outer, 0}, {1, 0, 0}),
                  along({outer, 0, 3}, {0, 0, -1}), along({outer, -4, -4}, {0, 1, 1}),
                  along({inner, -5, 0}, {0, 1, 0}), along({-2, inner, 0}, {1, 0, 0}),
                  along({inner, 0, 3}, {0, 0, -1}), along({inner, -4, -4}, {0, 1, 1})});
    }
    return lines;
}

// Along y at height r the line touches the top circle; at x = 1 it lies in its tangent: a fourfold root. Of a
// thinner tube the hits beside that one are known to some 1e-5 (R + r) only.
std::vector<SpecialLines> touchTheTopCircle() {
    std::vector<SpecialLines> lines;
    for (const float minorRadius : {0.03125F, 0.0625F, 0.25F, 0.875F, 1.0F, 1.5F}) {
        const Torus torus{1, minorRadius};
        std::vector<Ray> rays;
        for (const float x : {0.0F, 0.25F, 0.9375F, 1.0F, 1.0625F}) {
            rays.push_back(along({x, -5, minorRadius}, {0, 1, 0}));
            rays.push_back(along({x, 3, -minorRadius}, {0, -2, 0}));
        }
        rays.push_back(along({-3, -4, minorRadius}, {0.75F, 1, 0}));
        addLines(lines, torus, rays);
    }
    return lines;
}

// With R = 5, r = 3 the plane z = 3 x / 4 cuts the torus in two circles of radius 5 around (0, +-3, 0): lines
// in it meet each in two points, or touch one at y = +-8 or y = +-2 (the equators), and the one through the
// centre touches the torus from inside the hole in both points where the circles cross.
std::vector<SpecialLines> runInVillarceausPlanes() {
    std::vector<SpecialLines> lines;
    const Torus torus{5, 3};
    std::vector<Ray> rays;
    for (const float y : {0.0F, 2.0F, -2.0F, 8.0F, -8.0F, 1.0F, 4.0F, -7.5F}) {
        rays.push_back(along({-16, y, -12}, {4, 0, 3}));
        rays.push_back(along({16, y, -12}, {-4, 0, 3}));  // the other plane
    }
    for (const float x : {0.0F, 0.5F, 4.0F, 3.75F}) {
        rays.push_back(along({x, -20, 0.75F * x}, {0, 1, 0}));  // x = 4: touches both circles
    }
    rays.push_back(along({-16, -5, -12}, {4, 1, 3}));
    rays.push_back(along({-8, 9, -6}, {4, -3, 3}));
    addLines(lines, torus, rays);
    // Villarceau's planes of other tori are no exact numbers; the reference says what the rounded ones are.
    for (const float minorRadius : {0x1p-8F, 0.25F, 0.9375F}) {
        const float slope = minorRadius / std::sqrt(1 - minorRadius * minorRadius);
        addLines(lines, {1, minorRadius},
                 {along({-3, 0, -3 * slope}, {1, 0, slope}), along({0, -3, 3 * slope}, {0, 1, -slope}),
                  along({-3, 1 - minorRadius, -3 * slope}, {1, 0, slope})});
    }
    return lines;
}

std::vector<SpecialLines> runAlongTheAxisOrBesideIt() {
    std::vector<SpecialLines> lines;
    for (const float minorRadius : {0x1p-10F, 0.25F, 1.0F, 1.25F, 4.0F}) {
        std::vector<Ray> rays;
        for (const float x : {0.0F, -0.0F, 1e-38F, 1e-30F, 1e-12F, 1.6e-11F, 1e-7F, 1e-4F}) {
            rays.push_back(along({x, -0.0F, 5}, {0, -0.0F, -1}));
            rays.push_back(along({0, x, -5}, {-0.0F, 0, 3}));
        }
        addLines(lines, {1, minorRadius}, rays);
    }
    return lines;
}

std::vector<SpecialLines> meetTheTipOfAHorn() {
    std::vector<SpecialLines> lines;
    std::vector<Ray> rays;
    for (const float offset : {0.0F, 1e-30F, 1e-12F, 1e-7F, 1e-5F, 1e-3F}) {
        rays.push_back(along({5, 0, offset}, {-1, 0, 0}));
        rays.push_back(along({5, offset, 0}, {-1, 0, 0}));
        rays.push_back(along({3, offset, 3}, {-1, 0, -1}));
        rays.push_back(along({-3, 3, std::min(offset, 1e-5F) - 1}, {0.75F, -0.75F, 0.25F}));
        rays.push_back(along({0.5F + offset, 0, 4}, {-0.125F, 0, -1}));
        rays.push_back(along({offset, 0, 0}, {0.5F, 0.5F, 0.0625F}));  // starts at the tip
    }
    // Through the centre, where only the rounding of the surface is left to follow.
    rays.push_back(
        along({0x1.3b951p+2F, 0x1.0c737p+2F, -0x1.2b98ep+2F}, {-0x1.decp-1F, -0x1.974p-1F, 0x1.c68p-1F}));
    addLines(lines, {1, 1}, rays);
    return lines;
}

// r = 5/4, R = 3/4: the tips of the dimples are at z = +-1. Lines along the cone that the sheet makes there
// are not asked: their hits are known to some 1e-5 (R + r) only.
std::vector<SpecialLines> meetTheDimplesOfASpindle() {
    std::vector<SpecialLines> lines;
    std::vector<Ray> rays;
    for (const float offset : {0.0F, 1e-7F, -1e-7F, 1e-4F, -1e-4F}) {
        rays.push_back(along({4, offset, 5}, {-1, 0, -1}));              // steeply into the tip
        rays.push_back(along({5, 0, 1 + offset}, {-1, 0, 0}));           // level through the tip
        rays.push_back(along({offset, 0, 5}, {0, 0, -1}));               // along the axis
        rays.push_back(along({5, offset, 1.125F}, {-1, 0, 0}));          // across the dimple
        rays.push_back(along({5, 0.125F, 1.25F + offset}, {-1, 0, 0}));  // touches the top circle
        rays.push_back(along({0, offset, 1.0625F}, {0.5F, 0, 0.125F}));  // from within the dimple
        for (const float slope : {0.001F, 0.01F, 0.1F, 0.34F}) {
            rays.push_back(along({3 * slope, offset, 4}, {-slope, 0, -1}));  // at many angles into the tip
        }
    }
    addLines(lines, {0.75F, 1.25F}, rays);
    return lines;
}

// From a point 1e-15 above a horn's tip the hits are at 5e-31 and 2; from 1e8 away they all have one t.
std::vector<SpecialLines> haveHitsManyDecadesApartOrInOneFloat() {
    std::vector<SpecialLines> lines;
    addLines(lines, {1, 1}, {along({0, 0, 1e-15F}, {1, 0, 0}), along({0, 0, -1e-15F}, {0.5F, 0.25F, 0})});
    for (const float minorRadius : {0x1p-10F, 0.25F, 1.5F}) {
        addLines(lines, {1, minorRadius},
                 {along({-1e8F, 0, 0}, {1, 0, 0}), along({0, 0, -1e8F}, {0, 0, 1e-8F}),
                  along({-0x1p26F, -0x1p26F, 0}, {1, 1, 0})});
    }
    return lines;
}

// An end within what the march can be off by, but farther from the surface than what leaves it open: just
// before and just behind the crossings of a tube, and in a dimple above its tip, between the spindle's top
// and its surface.
std::vector<SpecialLines> endBesideACrossing() {
    std::vector<SpecialLines> lines;
    const auto upTo = [](Ray ray, float tMax) {
        ray.tMax = tMax;
        return ray;
    };
    for (const float minorRadius : {0x1p-10F, 0x1p-7F, 0.25F}) {
        std::vector<Ray> rays;
        for (const float slack : {-6e-6F, -2e-6F, 2e-6F, 6e-6F}) {
            const float outer = 1 + minorRadius;
            rays.push_back(upTo(along({outer + 2, 0, 0}, {-1, 0, 0}), 2 + slack));
            rays.push_back(upTo(along({0, outer + 1, -0.5F}, {0, -2, 1}), 0.5F + 0.5F * slack));
            rays.push_back(upTo(along({0, 0, 0}, {-1, 0, 0}), outer + slack));
        }
        addLines(lines, {1, minorRadius}, rays);
    }
    std::vector<Ray> rays;
    for (const float z : {1.0625F, 1.125F, 1.1875F}) {
        rays.push_back(upTo(along({0.015625F, 0, 5}, {0, 0, -1}), 5 - z));
        rays.push_back(upTo(along({0, -3, -3 - z}, {0, 1, 1}), 3));
    }
    addLines(lines, {0.75F, 1.25F}, rays);
    return lines;
}

// Within 5e-5 r of a tangent: two dips with a maximum between them that float32 cannot tell from a root, and
// dips and gaps that it cannot tell from none. Without neighbours: of those nearer to the tangent no answer
// is promised.
std::vector<SpecialLines> runAlongThinTubes() {
    std::vector<Ray> rays;
    for (const float x : {0x1.4a7088p-1F, 0x1.4a7089p-1F, 0x1.4a708ap-1F, 0x1.4a7086p-1F, 0x1.4a7084p-1F}) {
        rays.push_back(
            along({x, 0x1.8aa742p+1F, -0x1.ddbdd8p-8F}, {-0x1.0284b4p-1F, -0x1.b9f07p-1F, 0x1.693412p-9F}));
    }
    rays.push_back(along({0x1.8cfae2p+5F, 0x1.5b3d6ep+6F, -0x1.193072p-2F},
                         {-0x1.0284b4p-1F, -0x1.b9f07p-1F, 0x1.693412p-9F}));
    rays.push_back(along({0x1.6d05aap+1F, 0x1.10736ep+1F, 0x1.8e98fcp+0F},
                         {-0x1.67e168p-1F, -0x1.f25f9cp-2F, -0x1.09960ep-1F}));
    rays.push_back(along({0x1.cfee7p+0F, -0x1.eec824p+0F, -0x1.12e528p+1F},
                         {-0x1.3ff0bap-1F, 0x1.3eb8b8p-2F, 0x1.6e966p-1F}));
    rays.push_back(along({-0x1.556b5ap-1F, 0x1.ecfae4p+1F, -0x1.3a8ee2p-1F},
                         {0x1.9a061ap-4F, -0x1.f28e5p-1F, 0x1.a2be64p-3F}));
    // From nearly as far as an origin stays where it is, with the foot's rounding; and four hits from far
    // away.
    rays.push_back(along({-0x1.4b9beap+2F, 0x1.fa6a48p-1F, 0x1.0cdcep+2F},
                         {0x1.68ccecp-1F, -0x1.d35e0ap-4F, -0x1.668b56p-1F}));
    rays.push_back(along({-0x1.c85954p+0F, -0x1.fba8aap+1F, -0x1.620bc2p+1F},
                         {0x1.99808cp-2F, 0x1.958e1cp-1F, 0x1.d83648p-2F}));
    rays.push_back(along({-0x1.1710a2p+5F, -0x1.76d104p+6F, 0x1.8fc9cap+0F},
                         {0x1.6ec718p-2F, 0x1.ddf682p-1F, -0x1.ffda18p-7F}));
    // Past a place that comes within 2e-6 r of the surface, on to a crossing.
    const std::vector<Ray> pastNearMisses = {along({0x1.afc35ap+2F, 0x1.dae8ccp+2F, 0x1.eb6f36p-1F},
                                                   {-0x1.7a63f4p-1F, -0x1.5569aap-1F, -0x1.8814c6p-4F}),
                                             along({-0x1.cea5ccp+2F, -0x1.ba1c5ap+2F, 0x1.0f8b58p-3F},
                                                   {0x1.4d0cdap-1F, 0x1.84cdd2p-1F, -0x1.d1fd5cp-7F})};
    // Through a tube as thin as the march goes on from a crossing: the way out is still to come.
    const std::vector<Ray> throughHairs = {along({0x1.4d0a6p-2F, 0x1.ca7b56p-1F, 0x1.2899f2p+0F},
                                                 {0x1.af20e2p-2F, -0x1.186098p-1F, -0x1.7238fp-1F}),
                                           along({-0x1.c7714ap-2F, -0x1.953b62p-3F, 0x1.6b3752p+0F},
                                                 {-0x1.05027cp-2F, 0x1.b83e0cp-2F, -0x1.bb7672p-1F}),
                                           along({0x1.f24e3ap-1F, 0x1.3c234cp-2F, 0x1.194e0ep+0F},
                                                 {-0x1.d68908p-6F, -0x1.076456p-1F, -0x1.b6cedap-1F})};
    return {{{1, 0x1.0624dep-10F}, rays},
            {{1, 0x1.47ae14p-7F}, pastNearMisses},
            {{1, 0x1.0c6f7ap-20F}, throughHairs}};
}

// Nearest to the axis G has no third derivative: a parabola that is good to third order may be long there.
// The start is within rounding of the surface, so that the refinement begins there.
std::vector<SpecialLines> leaveThinTubesWhereTheyAreNearestToTheAxis() {
    std::vector<SpecialLines> lines;
    Ray leaving = along({0x1.f09788p-1F, 0x1.f58de8p-3F, 0x1.ebb4aep-11F},
                        {-0x1.bd4604p-3F, 0x1.b8df28p-1F, -0x1.d6ad7cp-2F});
    leaving.tMin = 0x1.0c6f7ap-20F;
    addLines(lines, {1, 0.001F}, {leaving});
    for (const float minorRadius : {0.001F, 0.002F, 0.004F}) {
        std::vector<Ray> rays;
        for (const float rise : {0.5F, 0.25F, 0.125F}) {
            Ray ray = along({1, 0, minorRadius}, {0, 1, -rise});
            ray.tMin = 0.002F * minorRadius;
            rays.push_back(ray);
        }
        addLines(lines, {1, minorRadius}, rays);
    }
    return lines;
}

// Crossings whose sine goes from 1/256 to 1/8, seen from as far as their refinement begins at the origin
// (ray.glsl, TORUS_FAR): there a rounding counts the more, the flatter the crossing is.
std::vector<SpecialLines> crossAtSmallAngles() {
    constexpr int count = 2000;
    std::vector<SpecialLines> lines;
    for (const float minorRadius : {0.01F, 0.25F, 0.9F}) {
        std::vector<Ray> rays;
        for (int i = 0; i < count; ++i) {
            // Multiples of the reciprocals of the plastic and of the golden ratio fill a square and a circle
            // evenly.
            const double aroundAxis = 2 * std::numbers::pi * std::fmod(0.7548776662466927 * i, 1.0);
            const double aroundTube = 2 * std::numbers::pi * std::fmod(0.5698402909980532 * i, 1.0);
            const double turn = 2 * std::numbers::pi * std::fmod(0.6180339887498949 * i, 1.0);
            const double sine = std::exp2(-8 + 5 * static_cast<double>(i) / count);
            const double cu = std::cos(aroundAxis), su = std::sin(aroundAxis);
            const double cv = std::cos(aroundTube), sv = std::sin(aroundTube);
            const double rho = 1 + double{minorRadius} * cv;
            const std::array point = {rho * cu, rho * su, double{minorRadius} * sv};
            const std::array normal = {cv * cu, cv * su, sv};
            const std::array alongRing = {-su, cu, 0.0};
            const std::array alongTube = {-sv * cu, -sv * su, cv};
            std::array<float, 3> origin{};
            std::array<float, 3> direction{};
            for (std::size_t k = 0; k < 3; ++k) {
                const double d =
                    -sine * normal[k] + std::sqrt(1 - sine * sine) *
                                            (std::cos(turn) * alongRing[k] + std::sin(turn) * alongTube[k]);
                direction[k] = static_cast<float>(d);
                origin[k] = static_cast<float>(point[k] - 6.5 * d);
            }
            rays.push_back(along(origin, direction));
        }
        lines.push_back({{1, minorRadius}, rays});
    }
    return lines;
}

std::span<const SpecialLinesOf> allSpecialLines() {
    static constexpr std::array all = {
        SpecialLinesOf{"lines that touch the equators", touchTheEquators},
        SpecialLinesOf{"lines that touch the top circle", touchTheTopCircle},
        SpecialLinesOf{"lines that run in villarceaus planes", runInVillarceausPlanes},
        SpecialLinesOf{"lines that run along the axis or beside it", runAlongTheAxisOrBesideIt},
        SpecialLinesOf{"lines that meet the tip of a horn", meetTheTipOfAHorn},
        SpecialLinesOf{"lines that meet the dimples of a spindle", meetTheDimplesOfASpindle},
        SpecialLinesOf{"lines that have hits many decades apart or in one float",
                       haveHitsManyDecadesApartOrInOneFloat},
        SpecialLinesOf{"lines that end beside a crossing", endBesideACrossing},
        SpecialLinesOf{"lines that run along thin tubes", runAlongThinTubes},
        SpecialLinesOf{"lines that cross at small angles", crossAtSmallAngles},
        SpecialLinesOf{"lines that leave thin tubes where they are nearest to the axis",
                       leaveThinTubesWhereTheyAreNearestToTheAxis},
    };
    return all;
}

}  // namespace raytorus::test
