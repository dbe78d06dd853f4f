// SPDX-License-Identifier: MIT
#include "truth/sample.hpp"

#include "reference/intersect.hpp"

namespace raytorus::truth {
namespace {

// Whether the line certainly misses the sphere round the torus: an intersection in many bits costs a thousand
// times as much. Doubles lose some 1e-15 of the origin's distance, the rows of the rotation 1e-7 of the size.
template <class Real>
bool passesBy(const Ray<Real>& local, double radius) {
    const Vec3<double> origin = toDoubles(local.origin);
    const Vec3<double> direction = toDoubles(local.direction);
    const double toFoot = -dot(origin, direction) / dot(direction, direction);
    const double nearest = length(origin + toFoot * direction);
    return nearest > radius * (1.0 + 1e-6) + 1e-14 * length(origin);
}

template <class Real>
reference::BasicTorus<Real> exactShape(const scene_io::SceneTorus& torus) {
    return {exactly<Real>(torus.radii.x), exactly<Real>(torus.radii.y)};
}

// The crossings of a ray with all tori. t counts in lengths of the direction, from 0.
template <class Real>
struct Crossings {
    int torus = -1;  // that is hit first, or -1
    Real t{};
    Vec3<Real> position{};  // of that hit, in its torus' frame
    int count = 0;          // of surfaces
};

template <class Real>
Crossings<Real> crossings(const SceneData& scene, const Ray<Real>& ray, double tMax) {
    Crossings<Real> found;
    for (std::size_t i = 0; i < scene.tori.size(); ++i) {
        const scene_io::SceneTorus& torus = scene.tori[i];
        const Ray<Real> local = toTorus(torus, ray);
        if (passesBy(local, outerRadius(torus))) {
            continue;
        }
        const reference::BasicRay<Real> whole(local.origin, Real(0.0), local.direction, Real(tMax));
        const auto hits = reference::intersectAs<Real>(exactShape<Real>(torus), whole);
        found.count += hits.count;
        if (hits.count > 0 && (found.torus < 0 || hits.hits[0].t < found.t)) {
            found.torus = static_cast<int>(i);
            found.t = hits.hits[0].t;
            found.position = hits.hits[0].position;
        }
    }
    return found;
}

}  // namespace

reference::BasicIntersections<double> quickCrossings(const scene_io::SceneTorus& torus,
                                                     const Ray<DoubleDouble>& local) {
    const reference::BasicRay<DoubleDouble> whole(local.origin, DoubleDouble(0.0), local.direction,
                                                  DoubleDouble(farthest));
    return reference::intersectAs<DoubleDouble, double>(exactShape<DoubleDouble>(torus), whole);
}

template <class Real, class Surface>
Sample<Surface> traceSample(const SceneData& scene, const Ray<Real>& ray) {
    const Crossings<Real> hit = crossings(scene, ray, farthest);
    Sample<Surface> sample;
    sample.torus = hit.torus;
    sample.count = hit.count;
    const Vec3<Surface> direction = reference::convert<Surface>(ray.direction);
    if (hit.torus < 0) {
        sample.color = hemisphere(scene.frame.backgroundBottom, scene.frame.backgroundTop, direction[2]);
        return sample;
    }
    const scene_io::SceneTorus& torus = scene.tori[static_cast<std::size_t>(hit.torus)];
    sample.t = reference::convert<Surface>(hit.t);
    sample.point = surfacePoint(torus, reference::convert<Surface>(hit.position));
    sample.otherField =
        onOtherField(scene.materials[static_cast<std::size_t>(torus.names.y)], sample.point.uv);
    const Vec3<Surface> toEye = -direction;
    const Vec3<Surface> normal = normalTowards(toEye, sample.point.outward);
    const Vec3<Surface> start = shadowStart(torus, sample.point.position, normal);
    for (int i = 0; i < scene.lights; ++i) {
        const scene_io::SceneLight& light = scene.frame.lights[i];
        const Vec3<Surface> path = pathTo(light, start);
        const bool facing = dot(normal, path) > Surface(0.0);
        const Ray<Real> shadow{reference::convert<Real>(start), reference::convert<Real>(path)};
        sample.reaching[static_cast<std::size_t>(i)] =
            !facing || crossings(scene, shadow, isPointLight(light) ? 1.0 : farthest).count == 0;
    }
    sample.color = shaded(scene, torus, sample.point, toEye, sample.otherField, sample.reaching);
    return sample;
}

template Sample<Quad> traceSample(const SceneData&, const Ray<Quad>&);
template Sample<double> traceSample(const SceneData&, const Ray<DoubleDouble>&);

}  // namespace raytorus::truth
