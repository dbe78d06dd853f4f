// SPDX-License-Identifier: MIT
// The scene as the shaders read it, float32, and what its numbers mean: exactly, in any number type.
#pragma once

#include <vector>

#include "reference/torus_reference.hpp"
#include "scene/scene.hpp"
#include "truth/vectors.hpp"

namespace raytorus::truth {

struct SceneData {
    scene_io::SceneFrame frame;
    int lights = 0;
    std::vector<scene_io::SceneTorus> tori;  ///< in the order of the scene
    std::vector<scene_io::SceneMaterial> materials;
};

SceneData makeSceneData(const scene::Scene& scene, int width, int height);

/// Where rays end that do not end at a light, as the definition has it.
inline constexpr double farthest = double{3.0e38F};

template <class Real>
struct SceneRay {
    Vec3<Real> origin, direction;
};

inline reference::Torus shapeOf(const scene_io::SceneTorus& torus) {
    return {torus.radii.x, torus.radii.y};
}
inline double outerRadius(const scene_io::SceneTorus& torus) {
    return static_cast<double>(torus.radii.x) + static_cast<double>(torus.radii.y);
}

/// A vector of the world in the torus' frame. The rows are orthogonal only as far as float32 goes, and the
/// picture is that of the rows as they are.
template <class Real>
Vec3<Real> toTorus(const scene_io::SceneTorus& torus, const Vec3<Real>& v) {
    return {dot(exactly<Real>(torus.row0), v), dot(exactly<Real>(torus.row1), v),
            dot(exactly<Real>(torus.row2), v)};
}
/// And back, by the transposed.
template <class Real>
Vec3<Real> fromTorus(const scene_io::SceneTorus& torus, const Vec3<Real>& v) {
    return v[0] * exactly<Real>(torus.row0) + v[1] * exactly<Real>(torus.row1) +
           v[2] * exactly<Real>(torus.row2);
}
template <class Real>
Vec3<Real> originOf(const scene_io::SceneTorus& torus) {
    return {exactly<Real>(torus.row0.w), exactly<Real>(torus.row1.w), exactly<Real>(torus.row2.w)};
}

template <class Real>
SceneRay<Real> toTorus(const scene_io::SceneTorus& torus, const SceneRay<Real>& ray) {
    return {toTorus(torus, ray.origin - originOf<Real>(torus)), toTorus(torus, ray.direction)};
}

/// A point of the picture, in pixels from its upper left corner.
template <class Real>
struct PicturePoint {
    Real x, y;
};

/// The middle of field (i, j) of a grid of side x side fields in a pixel.
template <class Real>
PicturePoint<Real> samplePoint(int pixelX, int pixelY, int i, int j, int side) {
    return {Real(pixelX) + Real(i + 0.5) / Real(side), Real(pixelY) + Real(j + 0.5) / Real(side)};
}

/// Where the camera looks at that point; not of unit length.
template <class Real>
Vec3<Real> lookAt(const scene_io::SceneFrame& frame, const PicturePoint<Real>& point) {
    const Real x = Real(2.0) * point.x / exactly<Real>(frame.size.x) - Real(1.0);
    const Real y = Real(1.0) - Real(2.0) * point.y / exactly<Real>(frame.size.y);
    return exactly<Real>(frame.cameraForward) + x * exactly<Real>(frame.cameraRight) +
           y * exactly<Real>(frame.cameraUp);
}

template <class Real>
SceneRay<Real> cameraRay(const scene_io::SceneFrame& frame, const PicturePoint<Real>& point) {
    return {exactly<Real>(frame.cameraPosition), unit(lookAt(frame, point))};
}

}  // namespace raytorus::truth
