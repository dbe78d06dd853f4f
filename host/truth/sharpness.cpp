// SPDX-License-Identifier: MIT
#include "truth/sharpness.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "truth/clearance.hpp"
#include "truth/verdicts.hpp"

namespace raytorus::truth {
namespace {

// Displaced rays lie on a circle round the exact one. What happens between them, and that no quantity is
// quite linear, is in the factor: beside a tangent one displacement away, a hit moves by up to 1.4 times what
// they show.
constexpr int displacedRays = 8;
constexpr double spreadFactor = 2.0;

double largestOf(const Vec3<double>& v) {
    return std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
}

// What a ray sees at the hit that the truth has, or a change of it.
struct Sight {
    double t = 0.0;
    Vec3<double> hit{};  // in the torus' frame
    SurfacePoint<double> point{};
    Vec3<double> color{};
    std::array<Clearance, scene::maxLights> shadows{};  // of the lights that the surface faces
};

// How much of a view changes.
struct Spread {
    double t = 0.0, position = 0.0, normal = 0.0, u = 0.0, v = 0.0, color = 0.0;
    std::array<double, scene::maxLights> shadows{};

    void include(const Sight& exact, const Sight& displaced) {
        const auto grow = [](double& most, double change) { most = std::max(most, std::abs(change)); };
        grow(t, displaced.t - exact.t);
        grow(position, length(displaced.point.position - exact.point.position));
        grow(normal, length(displaced.point.outward - exact.point.outward));
        grow(u, turnsBetween(displaced.point.uv[0], exact.point.uv[0]));
        grow(v, turnsBetween(displaced.point.uv[1], exact.point.uv[1]));
        grow(color, largestOf(displaced.color - exact.color));
        for (std::size_t i = 0; i < shadows.size(); ++i) {
            grow(shadows[i], displaced.shadows[i].length - exact.shadows[i].length);
        }
    }
};

// For all components of a value: what the displaced rays show, what float32 loses after the hit, and half an
// ulp, since the truth is stored in float32 too.
template <std::size_t count>
double toleranceOf(double change, const std::array<Rounded, count>& components) {
    double most = 0.0;
    for (const Rounded& component : components) {
        most = std::max(most, component.error + floatRounding * std::abs(component.value));
    }
    return spreadFactor * change + most;
}

// A sample that hits something.
class HitSharpness {
public:
    HitSharpness(const SceneData& data, const Seen& truth, const SceneRay<DoubleDouble>& exact,
                 const CameraBounds& bounds)
        : scene(data),
          seen(truth),
          torus(data.tori[static_cast<std::size_t>(truth.torus)]),
          ray(exact),
          toEye(-toDoubles(exact.direction)),
          camera(bounds) {}

    // A ray that does not cross the surface here as the exact one does leaves every verdict in doubt, and the
    // tolerances to the others.
    Sharpness judge(VerdictMargins verdicts) const {
        const std::optional<Sight> exact = see(ray, std::nullopt);
        if (!exact) {
            return {};
        }
        const bool entering = dot(exact->point.outward, toEye) > 0.0;
        Spread spread;
        for (const Vec3<double>& shift : displacements()) {
            const std::optional<Sight> displaced =
                see({ray.origin + fromDoubles<DoubleDouble>(shift), ray.direction}, entering);
            if (displaced) {
                spread.include(*exact, *displaced);
            } else {
                verdicts = {0.0, 0.0};
            }
        }
        return withRounding(*exact, spread, verdicts);
    }

private:
    std::optional<Sight> see(const SceneRay<DoubleDouble>& line, std::optional<bool> entering) const {
        const auto hits = quickCrossings(torus, toTorus(torus, line));
        const reference::BasicHit<double>* nearest = nullptr;
        for (int i = 0; i < hits.count; ++i) {
            const auto& hit = hits.hits[static_cast<std::size_t>(i)];
            const bool nearer =
                nearest == nullptr || std::abs(hit.t - seen.t) < std::abs(nearest->t - seen.t);
            nearest = nearer && hit.entering == entering.value_or(hit.entering) ? &hit : nearest;
        }
        if (nearest == nullptr) {
            return std::nullopt;
        }
        Sight view;
        view.t = nearest->t;
        view.hit = nearest->position;
        view.point = surfacePoint(torus, view.hit);
        view.color = shaded(scene, torus, view.point, toEye, seen.otherField, seen.reaching);
        const Vec3<double> normal = normalTowards(toEye, view.point.outward);
        const Vec3<double> start = shadowStart(torus, view.point.position, normal);
        for (int i = 0; i < scene.lights; ++i) {
            const scene_io::SceneLight& light = scene.frame.lights[i];
            const Vec3<double> path = pathTo(light, start);
            if (dot(normal, path) > 0.0) {
                view.shadows[static_cast<std::size_t>(i)] =
                    leastClearance(scene, {fromDoubles<DoubleDouble>(start), fromDoubles<DoubleDouble>(path)},
                                   isPointLight(light) ? 1.0 : farthest);
            }
        }
        return view;
    }

    // As far across the ray as a shader's may be off where it hits, in all directions.
    [[nodiscard]] std::array<Vec3<double>, displacedRays> displacements() const {
        const double by = cameraDisplacement(torus, ray, camera).at(seen.t);
        Vec3<double> other{};
        other[std::abs(toEye[0]) < 0.5 ? 0 : 1] = 1.0;
        const Vec3<double> first = unit(other - dot(other, toEye) * toEye);
        const Vec3<double> second{toEye[1] * first[2] - toEye[2] * first[1],
                                  toEye[2] * first[0] - toEye[0] * first[2],
                                  toEye[0] * first[1] - toEye[1] * first[0]};
        std::array<Vec3<double>, displacedRays> all;
        for (std::size_t i = 0; i < all.size(); ++i) {
            const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / displacedRays;
            all[i] = (by * std::cos(angle)) * first + (by * std::sin(angle)) * second;
        }
        return all;
    }

    // What the arithmetic after the hit may lose: the same formulas in Rounded, from a position that is off
    // by as much as the library's may be.
    Sharpness withRounding(const Sight& exact, const Spread& spread, const VerdictMargins& verdicts) const {
        Vec3<Rounded> hit = fromDoubles<Rounded>(exact.hit);
        for (Rounded& component : hit) {
            component.error = positionBound * outerRadius(torus);
        }
        const SurfacePoint<Rounded> point = surfacePoint(torus, hit);
        Vec3<Rounded> eye = fromDoubles<Rounded>(toEye);
        for (Rounded& component : eye) {
            component.error = camera.turned + camera.stretched * std::abs(component.value);
        }
        const Vec3<Rounded> color = shaded(scene, torus, point, eye, seen.otherField, seen.reaching);
        const double margin = std::min(
            {verdicts.nearest, checkerMargin(point, spread), shadowMargin(exact, spread, point, eye)});
        using One = std::array<Rounded, 1>;
        const Displacement frame = frameDisplacement(torus, ray);
        // t counts in lengths of the direction and from the origin as they come out in the torus' frame; then
        // it is rounded once, as a number of at least a sixteenth of the torus' size.
        const double t = exact.t * camera.stretched + frame.at(exact.t) +
                         floatRounding * std::max(exact.t, outerRadius(torus) / 16.0);
        return {verdicts.nearest,
                verdicts.count,
                margin,
                toleranceOf(spread.color, color),
                toleranceOf(spread.t, One{Rounded(exact.t, t)}),
                toleranceOf(spread.position, point.position),
                toleranceOf(spread.normal, point.outward),
                std::max(toleranceOf(spread.u, One{point.uv[0]}), toleranceOf(spread.v, One{point.uv[1]}))};
    }

    // How far from the nearest edge of the checker's fields.
    [[nodiscard]] double checkerMargin(const SurfacePoint<Rounded>& point, const Spread& spread) const {
        const auto& material = scene.materials[static_cast<std::size_t>(torus.names.y)];
        if (!(material.checkerCounts.x > 0.0F)) {
            return std::numeric_limits<double>::infinity();
        }
        const auto margin = [](const Rounded& coordinate, float count, double change) {
            const Rounded field = coordinate * exactly<Rounded>(count);
            const double off = field.error + spreadFactor * change * static_cast<double>(count);
            return std::abs(field.value - std::round(field.value)) / off;
        };
        return std::min(margin(point.uv[0], material.checkerCounts.x, spread.u),
                        margin(point.uv[1], material.checkerCounts.y, spread.v));
    }

    // How far from the edge of a shadow. The rays' clearance changes with the hit, which the displaced rays
    // show, and by what float32 does to the shadow ray itself.
    [[nodiscard]] double shadowMargin(const Sight& exact, const Spread& spread,
                                      const SurfacePoint<Rounded>& point, const Vec3<Rounded>& eye) const {
        const Vec3<Rounded> start = shadowStart(torus, point.position, normalTowards(eye, point.outward));
        double margin = std::numeric_limits<double>::infinity();
        for (int i = 0; i < scene.lights; ++i) {
            const Clearance& clearance = exact.shadows[static_cast<std::size_t>(i)];
            if (clearance.torus < 0) {
                continue;
            }
            const scene_io::SceneLight& light = scene.frame.lights[i];
            const auto& blocker = scene.tori[static_cast<std::size_t>(clearance.torus)];
            const SceneRay<Rounded> shadow{start, pathTo(light, start)};
            const double reach = length(toDoubles(start) - originOf<double>(blocker)) + outerRadius(blocker);
            const double t = isPointLight(light) ? 1.0 : reach;
            const double moved = displacementAt(blocker, shadow).at(t) + positionBound * outerRadius(blocker);
            const double off = spreadFactor * spread.shadows[static_cast<std::size_t>(i)] +
                               std::max(moved, libraryEnd(blocker));
            margin = std::min(margin, std::abs(clearance.length) / off);
        }
        return margin;
    }

    const SceneData& scene;
    const Seen& seen;
    const scene_io::SceneTorus& torus;
    const SceneRay<DoubleDouble>& ray;
    Vec3<double> toEye;
    CameraBounds camera;
};

Sharpness ofBackground(const SceneData& scene, const SceneRay<DoubleDouble>& ray, const CameraBounds& camera,
                       const VerdictMargins& verdicts) {
    const double z = toDouble(ray.direction[2]);
    const Rounded rounded(z, camera.turned + camera.stretched * std::abs(z));
    const Vec3<Rounded> color = hemisphere(scene.frame.backgroundBottom, scene.frame.backgroundTop, rounded);
    return {verdicts.nearest, verdicts.count, verdicts.nearest, toleranceOf(0.0, color), 0.0, 0.0, 0.0, 0.0};
}

}  // namespace

Sharpness sharpnessOf(const SceneData& scene, const PicturePoint<Rounded>& at,
                      const SceneRay<DoubleDouble>& ray, const Seen& seen) {
    const CameraBounds camera = cameraBounds(scene.frame, at);
    const VerdictMargins verdicts = verdictMargins(scene, ray, camera, seen.torus, seen.t);
    if (seen.torus < 0) {
        return ofBackground(scene, ray, camera, verdicts);
    }
    return HitSharpness(scene, seen, ray, camera).judge(verdicts);
}

}  // namespace raytorus::truth
