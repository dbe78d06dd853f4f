// SPDX-License-Identifier: MIT
// From a pixel to its values: camera ray, shading and the geometric pictures. Both routes call scenePixel and nothing
// else, and every step is `precise`, so they agree bit for bit. Only + - * / sqrt: no driver's pow or normalize.
#ifndef SHADE_GLSL
#define SHADE_GLSL

#include "scene.glsl"

layout(constant_id = SCENE_CONSTANT_AOVS) const bool sceneAovs = false;
layout(constant_id = SCENE_CONSTANT_SIDE) const int sceneSide = 1;
layout(constant_id = SCENE_CONSTANT_LIGHTS) const int sceneLights = 1;

// What a pixel consists of, in the order of the colour attachments and of the bindings from SCENE_BINDING_COLOR on.
struct ScenePixel {
    vec4 color;     // linear RGB, averaged over the samples; A = 1
    vec4 position;  // xyz: hit in world space, w: t. The ray through the middle of the pixel, as all that follows
    vec4 normal;    // xyz: unit, outward; w: number of surfaces the whole ray crosses
    vec4 surface;   // xy: uv, z: index of the torus in the scene or -1, w: RAY_STEPS
};

#define SCENE_T_MAX 3.0e38

vec3 sceneUnit(vec3 v) {
    precise float length2 = v.x * v.x + v.y * v.y + v.z * v.z;
    precise vec3 unit = v / sqrt(length2);
    return unit;
}

float sceneDot(vec3 a, vec3 b) {
    precise float sum = a.x * b.x + a.y * b.y + a.z * b.z;
    return sum;
}

// The ray through a point of the picture: pixels from the upper left corner.
SceneRay sceneCameraRay(vec2 pixel) {
    precise float x = 2.0 * pixel.x / frame.size.x - 1.0;
    precise float y = 1.0 - 2.0 * pixel.y / frame.size.y;
    precise vec3 direction = frame.cameraForward.xyz + x * frame.cameraRight.xyz + y * frame.cameraUp.xyz;
    return sceneMakeRay(frame.cameraPosition.xyz, sceneUnit(direction));
}

vec3 sceneBackground(vec3 direction) {
    precise float height = 0.5 + 0.5 * direction.z;
    precise vec3 color = frame.backgroundBottom.rgb + height * (frame.backgroundTop.rgb - frame.backgroundBottom.rgb);
    return color;
}

vec3 sceneDiffuse(SceneMaterial material, vec2 uv) {
    precise float u = floor(uv.x * material.checkerCounts.x);
    precise float v = floor(uv.y * material.checkerCounts.y);
    precise float parity = u + v - 2.0 * floor(0.5 * (u + v));
    bool other = material.checkerCounts.x > 0.0 && parity > 0.5;
    return other ? material.checkerDiffuse.rgb : material.diffuse.rgb;
}

// Diffuse and glossy reflectance times the cosine and pi, so that a white surface which faces a light of radiance 1
// shows 1: Lambert, and the microfacet model of Walter et al. (EGSR 2007)
// with the GGX distribution, Schlick's Fresnel term, and Karis' rational fit to Smith's masking (SIGGRAPH 2013).
vec3 sceneReflect(vec3 diffuse, vec3 specular, float roughness, vec3 normal, vec3 toEye, vec3 toLight) {
    precise float nl = max(sceneDot(normal, toLight), 0.0);
    precise float nv = max(sceneDot(normal, toEye), 1.0e-4);
    vec3 halfway = sceneUnit(toLight + toEye);
    precise float nh = max(sceneDot(normal, halfway), 0.0);
    precise float vh = max(sceneDot(toEye, halfway), 0.0);
    precise float a = roughness * roughness;
    precise float a2 = a * a;
    precise float bend = (nh * a2 - nh) * nh + 1.0;
    precise float facets = a2 / (bend * bend);
    precise float k = 0.5 * a;
    precise float masking = 0.25 / ((nl * (1.0 - k) + k) * (nv * (1.0 - k) + k));
    precise float away = 1.0 - vh;
    precise float away2 = away * away;
    precise vec3 fresnel = specular + (vec3(1.0) - specular) * (away2 * away2 * away);
    precise vec3 value = nl * (diffuse + fresnel * (facets * masking));
    return value;
}

vec3 sceneShade(SceneRay ray, SceneHit hit) {
    SceneTorus torus = sceneTorus(hit.torus);
    Torus shape = Torus(torus.radii.x, torus.radii.y);
    SceneMaterial material = sceneMaterial(torus.names.y);
    vec3 diffuse = sceneDiffuse(material, torusUv(shape, hit.position));
    vec3 position = sceneFromTorus(torus, hit.position) + sceneOriginOf(torus);
    vec3 outward = sceneFromTorus(torus, torusNormal(shape, hit.position));
    vec3 toEye = -ray.direction;
    // Seen from within, the surface is lit from within.
    vec3 normal = sceneDot(outward, toEye) < 0.0 ? -outward : outward;

    precise float height = 0.5 + 0.5 * normal.z;
    precise vec3 ambient = frame.ambientGround.rgb + height * (frame.ambientSky.rgb - frame.ambientGround.rgb);
    precise vec3 color = ambient * (diffuse + 0.5 * material.specular.rgb);
    // Shadow rays leave from a little off the surface: a thousandth of the tube, or some roundings of the position.
    precise float size = max(max(abs(position.x), abs(position.y)), abs(position.z));
    precise float lift = max(1.0e-3 * torus.radii.y, 4.0e-6 * max(size, torus.radii.x));
    precise vec3 start = position + lift * normal;
    for (int i = 0; i < sceneLights; ++i) {
        SceneLight light = frame.lights[i];
        precise vec3 path = light.vector.xyz - light.vector.w * start;
        precise float distance2 = sceneDot(path, path);
        precise vec3 toLight = path / sqrt(distance2);
        precise float falloff = light.vector.w > 0.5 ? 1.0 / distance2 : 1.0;
        bool facing = sceneDot(normal, toLight) > 0.0;
        // The path is as long as the way to a point light: t = 1 is at the light.
        if (facing && !sceneOccluded(sceneMakeRay(start, path), 0.0, light.vector.w > 0.5 ? 1.0 : SCENE_T_MAX)) {
            precise vec3 lit = light.color.rgb * falloff *
                               sceneReflect(diffuse, material.specular.rgb, material.diffuse.w, normal, toEye, toLight);
            color += lit;
        }
    }
    return color;
}

vec3 sceneColor(vec2 pixel) {
    SceneRay ray = sceneCameraRay(pixel);
    SceneHit hit = sceneIntersect(ray, 0.0, SCENE_T_MAX);
    vec3 color = sceneBackground(ray.direction);
    if (hit.torus >= 0) {
        color = sceneShade(ray, hit);
    }
    return color;
}

ScenePixel scenePixel(uvec2 pixel) {
    ScenePixel result = ScenePixel(vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0, 0.0, -1.0, 0.0));
    precise vec3 sum = vec3(0.0);
    for (int i = 0; i < sceneSide * sceneSide; ++i) {
        precise vec2 offset = (vec2(float(i % sceneSide), float(i / sceneSide)) + 0.5) / float(sceneSide);
        sum += sceneColor(vec2(pixel) + offset);
    }
    precise vec3 mean = sum / float(sceneSide * sceneSide);
    result.color = vec4(mean, 1.0);
    if (sceneAovs) {
        SceneRay ray = sceneCameraRay(vec2(pixel) + 0.5);
        RAY_STEPS_BEGIN
        SceneHit hit = sceneIntersect(ray, 0.0, SCENE_T_MAX);
        result.surface.w = RAY_STEPS;
        if (hit.torus >= 0) {
            SceneTorus torus = sceneTorus(hit.torus);
            Torus shape = Torus(torus.radii.x, torus.radii.y);
            precise vec3 position = sceneFromTorus(torus, hit.position) + sceneOriginOf(torus);
            result.position = vec4(position, hit.t);
            result.normal = vec4(sceneFromTorus(torus, torusNormal(shape, hit.position)), 0.0);
            result.surface = vec4(torusUv(shape, hit.position), float(torus.names.x), result.surface.w);
        }
        result.normal.w = float(sceneCount(ray, 0.0, SCENE_T_MAX));
    }
    return result;
}

#endif
