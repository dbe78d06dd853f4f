// SPDX-License-Identifier: MIT
#include "truth/sample.hpp"

#include "truth/crossings.hpp"

namespace raytorus::truth {
namespace {

// The crossings of a ray of the world with all tori.
template <class Real>
Crossings<Real> crossingsOf(const SceneData& scene, const SceneRay<Real>& ray, double tMax) {
    return crossings<Real>(
        scene, [&ray](const scene_io::SceneTorus& torus) { return toTorus(torus, ray); }, tMax);
}

}  // namespace

reference::BasicIntersections<double> quickCrossings(const scene_io::SceneTorus& torus,
                                                     const SceneRay<DoubleDouble>& local) {
    const reference::BasicRay<DoubleDouble> whole(local.origin, DoubleDouble(0.0), local.direction,
                                                  DoubleDouble(farthest));
    return reference::intersectAs<DoubleDouble, double>(reference::BasicTorus<DoubleDouble>(shapeOf(torus)),
                                                        whole);
}

template <class Real, class Surface>
Sample<Surface> traceSample(const SceneData& scene, const SceneRay<Real>& ray) {
    const Crossings<Real> hit = crossingsOf(scene, ray, farthest);
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
        const SceneRay<Real> shadow{reference::convert<Real>(start), reference::convert<Real>(path)};
        sample.reaching[static_cast<std::size_t>(i)] =
            !facing || crossingsOf(scene, shadow, isPointLight(light) ? 1.0 : farthest).count == 0;
    }
    sample.color = shaded(scene, torus, sample.point, toEye, sample.otherField, sample.reaching);
    return sample;
}

template Sample<Quad> traceSample(const SceneData&, const SceneRay<Quad>&);
template Sample<double> traceSample(const SceneData&, const SceneRay<DoubleDouble>&);

}  // namespace raytorus::truth
