// SPDX-License-Identifier: MIT
#include "trace/pixel_ray.hpp"

#include <cmath>
#include <limits>

namespace raytorus::trace {
namespace {

// sceneToTorus() of shaders/scene.glsl.
void turn(const scene_io::SceneTorus& torus, const float (&v)[3], float (&to)[3]) {
    const scene_io::vec4* rows[] = {&torus.row0, &torus.row1, &torus.row2};
    for (int i = 0; i < 3; ++i) {
        to[i] = rows[i]->x * v[0] + rows[i]->y * v[1] + rows[i]->z * v[2];
    }
}

}  // namespace

// sceneCameraRay() of shaders/shade.glsl.
TraceRay cameraRay(const scene_io::SceneFrame& frame, int x, int y) {
    const float across = 2.0F * (static_cast<float>(x) + 0.5F) / frame.size.x - 1.0F;
    const float upwards = 1.0F - 2.0F * (static_cast<float>(y) + 0.5F) / frame.size.y;
    TraceRay ray{};
    for (int i = 0; i < 3; ++i) {
        ray.origin[i] = frame.cameraPosition[i];
        ray.direction[i] =
            frame.cameraForward[i] + across * frame.cameraRight[i] + upwards * frame.cameraUp[i];
    }
    const float(&d)[3] = ray.direction;
    const float length = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    for (float& component : ray.direction) {
        component /= length;
    }
    ray.tMax = std::numeric_limits<float>::infinity();
    return ray;
}

TraceRay rayInFrame(const scene_io::SceneTorus& torus, const TraceRay& ray) {
    const float fromCentre[3] = {ray.origin[0] - torus.row0.w, ray.origin[1] - torus.row1.w,
                                 ray.origin[2] - torus.row2.w};
    TraceRay local = ray;
    turn(torus, fromCentre, local.origin);
    turn(torus, ray.direction, local.direction);
    return local;
}

}  // namespace raytorus::trace
