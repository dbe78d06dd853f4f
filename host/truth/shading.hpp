// SPDX-License-Identifier: MIT
// The colour of a point of a surface, in any number type: hemisphere ambient, and for each light that reaches
// it Lambert and the microfacet model of Walter et al. (EGSR 2007), with the GGX distribution, Schlick's
// Fresnel term and Karis' rational masking (SIGGRAPH 2013).
#pragma once

#include <bitset>

#include "truth/surface.hpp"

namespace raytorus::truth {

/// Which lights reach a point.
using LightMask = std::bitset<scene::maxLights>;

/// What a ray sees that hits nothing; also the ambient light a normal receives: from bottom at -z to top at
/// +z.
template <class Real>
Vec3<Real> hemisphere(const scene_io::vec4& bottom, const scene_io::vec4& top, const Real& z) {
    const Real height = Real(0.5) + Real(0.5) * z;
    return exactly<Real>(bottom) + height * (exactly<Real>(top) - exactly<Real>(bottom));
}

/// Whether the checker shows its other colour there. A field is [i, i + 1) / count.
template <class Real>
bool onOtherField(const scene_io::SceneMaterial& material, const std::array<Real, 2>& uv) {
    const double u = std::floor(toDouble(uv[0] * exactly<Real>(material.checkerCounts.x)));
    const double v = std::floor(toDouble(uv[1] * exactly<Real>(material.checkerCounts.y)));
    return material.checkerCounts.x > 0.0F && std::fmod(u + v, 2.0) == 1.0;
}

/// The surface as it is lit: its normal is turned towards the eye, since seen from within it is lit from
/// within.
template <class Real>
Vec3<Real> normalTowards(const Vec3<Real>& toEye, const Vec3<Real>& outward) {
    return toDouble(dot(outward, toEye)) < 0.0 ? -outward : outward;
}

/// Where shadow rays start: off the surface by a thousandth of the tube, or by some roundings of the position
/// if that is more. The factors are the floats of the definition.
template <class Real>
Vec3<Real> shadowStart(const scene_io::SceneTorus& torus, const Vec3<Real>& position,
                       const Vec3<Real>& normal) {
    Real size = exactly<Real>(torus.radii.x);
    for (const Real& component : position) {
        const Real magnitude = toDouble(component) < 0.0 ? -component : component;
        size = toDouble(magnitude) > toDouble(size) ? magnitude : size;
    }
    const Real ofTube = exactly<Real>(1.0e-3F) * exactly<Real>(torus.radii.y);
    const Real ofPosition = exactly<Real>(4.0e-6F) * size;
    const Real lift = toDouble(ofTube) > toDouble(ofPosition) ? ofTube : ofPosition;
    return position + lift * normal;
}

inline bool isPointLight(const scene_io::SceneLight& light) {
    return light.vector.w > 0.5F;
}

/// The way from there to a light: to a point light the whole way, else a unit vector.
template <class Real>
Vec3<Real> pathTo(const scene_io::SceneLight& light, const Vec3<Real>& start) {
    const Vec3<Real> vector = exactly<Real>(light.vector);
    return isPointLight(light) ? vector - start : vector;
}

/// The part of a light's radiance that goes to the eye, times pi: a white surface that faces the light
/// shows 1.
template <class Real>
Vec3<Real> reflected(const scene_io::SceneMaterial& material, const Vec3<Real>& diffuse,
                     const Vec3<Real>& normal, const Vec3<Real>& toEye, const Vec3<Real>& toLight) {
    const Real one(1.0);
    const Vec3<Real> halfway = unit(toLight + toEye);
    const Real cosLight = atLeast(dot(normal, toLight), 0.0);
    const Real cosEye = atLeast(dot(normal, toEye), double{1.0e-4F});
    const Real cosHalf = atLeast(dot(normal, halfway), 0.0);
    const Real cosDifference = atLeast(dot(toEye, halfway), 0.0);

    const Real roughness = exactly<Real>(material.diffuse.w);
    const Real alpha = roughness * roughness;
    const Real alpha2 = alpha * alpha;
    const Real spread = cosHalf * cosHalf * (alpha2 - one) + one;
    const Real distribution = alpha2 / (spread * spread);
    const Real k = Real(0.5) * alpha;
    const auto shadowing = [&](const Real& cosine) { return cosine * (one - k) + k; };
    const Real masking = Real(0.25) / (shadowing(cosLight) * shadowing(cosEye));
    const Real past = one - cosDifference;
    const Real past2 = past * past;
    const Vec3<Real> f0 = exactly<Real>(material.specular);
    const Vec3<Real> fresnel = f0 + (past2 * past2 * past) * (uniform<Real>(1.0) - f0);
    return cosLight * (diffuse + (distribution * masking) * fresnel);
}

/// The colour of a point that these lights reach. A light behind the surface adds nothing either way.
template <class Real>
Vec3<Real> shaded(const SceneData& scene, const scene_io::SceneTorus& torus, const SurfacePoint<Real>& point,
                  const Vec3<Real>& toEye, bool otherField, LightMask reaching) {
    const scene_io::SceneFrame& frame = scene.frame;
    const auto& material = scene.materials[static_cast<std::size_t>(torus.names.y)];
    const Vec3<Real> diffuse = exactly<Real>(otherField ? material.checkerDiffuse : material.diffuse);
    const Vec3<Real> normal = normalTowards(toEye, point.outward);
    const Vec3<Real> start = shadowStart(torus, point.position, normal);
    Vec3<Real> color = hemisphere(frame.ambientGround, frame.ambientSky, normal[2]) *
                       (diffuse + Real(0.5) * exactly<Real>(material.specular));
    for (int i = 0; i < scene.lights; ++i) {
        if (!reaching[static_cast<std::size_t>(i)]) {
            continue;
        }
        const scene_io::SceneLight& light = frame.lights[i];
        const Vec3<Real> path = pathTo(light, start);
        const Real distance2 = dot(path, path);
        const Real falloff = isPointLight(light) ? Real(1.0) / distance2 : Real(1.0);
        color = color + (falloff * exactly<Real>(light.color)) *
                            reflected(material, diffuse, normal, toEye, unit(path));
    }
    return color;
}

}  // namespace raytorus::truth
