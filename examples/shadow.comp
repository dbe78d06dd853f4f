#version 460
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// A torus that stands anywhere, with its own shadow on it. Placement is the caller's: rays go into the torus' frame by
// the inverse of its matrix, t stays the same, hits and normals come back by the matrix. (A matrix that scales
// differently along its axes would need its inverse transpose for the normal, as always.)
#include "torus.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 0, rgba32f) uniform writeonly image2D picture;
layout(push_constant) uniform Placement { mat4 torusToWorld; mat4 worldToTorus; };

const vec3 eye = vec3(0.0, -5.0, 0.0);
const vec3 light = vec3(3.0, -4.0, 5.0);

vec3 place(mat4 m, vec3 point) { return (m * vec4(point, 1.0)).xyz; }
vec3 turn(mat4 m, vec3 direction) { return (m * vec4(direction, 0.0)).xyz; }

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(picture);
    if (at.x >= size.x || at.y >= size.y) {
        return;
    }
    vec2 p = (2.0 * vec2(at) + 1.0 - vec2(size)) / float(size.y);
    vec3 direction = vec3(p.x, 2.0, -p.y);

    Torus torus = Torus(1.0, 0.4);
    TorusHit hit;
    float shade = 0.0;
    if (torusIntersect(torus, place(worldToTorus, eye), 0.0, turn(worldToTorus, direction), 1.0e30, hit)) {
        vec3 normal = normalize(turn(torusToWorld, torusNormal(torus, hit.position)));
        vec3 position = place(torusToWorld, hit.position);
        // From a little off the surface to the light, which is at t = 1.
        vec3 start = position + 1.0e-4 * normal;
        vec3 toLight = light - start;
        bool dark = torusOccluded(torus, place(worldToTorus, start), 0.0, turn(worldToTorus, toLight), 1.0);
        shade = dark ? 0.0 : max(dot(normal, normalize(toLight)), 0.0);
        shade = 0.1 + 0.9 * shade;
    }
    imageStore(picture, at, vec4(vec3(shade), 1.0));
}
