// SPDX-License-Identifier: MIT
// Faults of the camera, of the shading, and of what a pixel is said to consist of.
#include "mutate/mutation.hpp"

namespace raytorus::mutate {
namespace {

constexpr const char* shade = "shade.glsl";

constexpr Mutation rows[] = {
    {"camera-upside-down", shade, "1.0 - 2.0 * pixel.y / frame.size.y", "2.0 * pixel.y / frame.size.y - 1.0",
     "pixels are counted from the upper left corner, as in Vulkan, not from the lower one"},
    {"camera-mirrored", shade, "2.0 * pixel.x / frame.size.x - 1.0", "1.0 - 2.0 * pixel.x / frame.size.x",
     "left and right swapped"},
    {"camera-aspect", shade, "2.0 * pixel.y / frame.size.y", "2.0 * pixel.y / frame.size.x",
     "height divided by the width"},
    {"camera-direction-not-unit", shade, "frame.cameraPosition.xyz, sceneUnit(direction)",
     "frame.cameraPosition.xyz, direction", "t is a distance only along a unit direction"},
    {"color-at-pixel-corner", shade,
     "(vec2(float(i % sceneSide), float(i / sceneSide)) + 0.5) / float(sceneSide)",
     "vec2(float(i % sceneSide), float(i / sceneSide)) / float(sceneSide)",
     "samples at the corners of their grid, not in the middle"},
    {"aovs-at-pixel-corner", shade, "sceneCameraRay(vec2(pixel) + 0.5)", "sceneCameraRay(vec2(pixel))",
     "half a pixel forgotten"},
    {"aovs-of-first-sample", shade, "sceneCameraRay(vec2(pixel) + 0.5)",
     "sceneCameraRay(vec2(pixel) + 0.5 / float(sceneSide))", "the first sample taken for the pixel's middle"},
    {"mean-over-one-side", shade, "sum / float(sceneSide * sceneSide)", "sum / float(sceneSide)",
     "n samples counted where there are n * n"},
    {"one-row-of-samples", shade, "i < sceneSide * sceneSide", "i < sceneSide", "the grid's first row alone"},
    {"alpha-zero", shade, "vec4(mean, 1.0)", "vec4(mean, 0.0)", "a picture that is transparent"},
    {"nan-in-one-pixel", shade, "vec4(mean, 1.0)",
     "vec4(pixel == uvec2(7u, 5u) ? vec3(uintBitsToFloat(0x7fc00000u)) : mean, 1.0)",
     "one pixel is not a number"},
    {"infinity-in-one-pixel", shade, "vec4(position, hit.t)",
     "vec4(position, pixel.x == 24u && pixel.y >= 14u ? uintBitsToFloat(0x7f800000u) : hit.t)",
     "a distance is infinite where there is a hit"},

    {"background-flipped", shade, "0.5 + 0.5 * direction.z", "0.5 - 0.5 * direction.z",
     "sky below the ground"},
    {"background-y-up", shade, "0.5 + 0.5 * direction.z", "0.5 + 0.5 * direction.y", "up is z here, not y"},
    {"checker-parity", shade, "parity > 0.5", "parity < 0.5", "even fields for odd ones"},
    {"checker-counts-swapped", shade, "uv.x * material.checkerCounts.x", "uv.x * material.checkerCounts.y",
     "fields round the tube counted round the axis"},
    {"checker-shifted", shade, "floor(uv.x * material.checkerCounts.x)",
     "floor(uv.x * material.checkerCounts.x + 0.5)", "rounded instead of truncated"},
    {"material-of-the-first", shade, "sceneMaterial(torus.names.y)", "sceneMaterial(0)",
     "every torus has the first material"},

    {"roughness-not-squared", shade, "roughness * roughness", "roughness",
     "the model's width is the square of what users call roughness"},
    {"facets-not-squared", shade, "a2 / (bend * bend)", "a2 / bend", "GGX has the square of the bend"},
    {"fresnel-fourth-power", shade, "away2 * away2 * away", "away2 * away2", "Schlick's power is five"},
    {"fresnel-by-normal", shade, "1.0 - vh", "1.0 - nv", "the angle to the surface, not to the facet"},
    {"masking-wide", shade, "0.5 * a;", "0.5 * roughness;", "another fit's parameter"},
    {"halfway-not-unit", shade, "sceneUnit(toLight + toEye)", "0.5 * (toLight + toEye)",
     "a mean of unit vectors is none"},
    {"specular-ignored", shade, "nl * (diffuse + fresnel * (facets * masking))", "nl * diffuse",
     "the glossy part forgotten"},

    {"inside-lit-from-outside", shade, "sceneDot(outward, toEye) < 0.0 ? -outward : outward", "outward",
     "seen from within, the surface is lit from within"},
    {"normal-towards-viewer", shade, "vec4(sceneFromTorus(torus, torusNormal(shape, hit.position)), 0.0)",
     "vec4(faceforward(sceneFromTorus(torus, torusNormal(shape, hit.position)), ray.direction, "
     "sceneFromTorus(torus, torusNormal(shape, hit.position))), 0.0)",
     "the picture of normals is outward, whoever looks"},
    {"normal-in-torus-frame", shade, "vec4(sceneFromTorus(torus, torusNormal(shape, hit.position)), 0.0)",
     "vec4(torusNormal(shape, hit.position), 0.0)", "not turned into the world"},
    {"normal-rotation-transposed", shade, "sceneFromTorus(torus, torusNormal(shape, hit.position))",
     "sceneToTorus(torus, torusNormal(shape, hit.position))", "turned the wrong way", Shows::InPictures, 2},
    {"position-not-moved", shade,
     "precise vec3 position = sceneFromTorus(torus, hit.position) + sceneOriginOf(torus)",
     "precise vec3 position = sceneFromTorus(torus, hit.position)", "the torus' place forgotten"},
    {"position-along-the-ray", shade,
     "precise vec3 position = sceneFromTorus(torus, hit.position) + sceneOriginOf(torus)",
     "precise vec3 position = ray.origin + hit.t * ray.direction",
     "from far away t has not the digits: the library's position does"},
    {"uv-swapped", shade, "vec4(torusUv(shape, hit.position), float",
     "vec4(torusUv(shape, hit.position).yx, float", "u and v swapped in the picture"},
    {"id-of-the-leaf", shade, "float(torus.names.x)", "float(hit.torus)",
     "the hierarchy's order instead of the scene's"},
    {"count-of-the-nearest", shade, "result.normal.w = float(sceneCount(ray, 0.0, SCENE_T_MAX))",
     "result.normal.w = hit.torus >= 0 ? float(sceneCount(ray, 0.0, hit.t)) : 0.0",
     "surfaces counted up to the nearest hit"},
    {"count-behind-the-camera", shade, "sceneCount(ray, 0.0,", "sceneCount(ray, -SCENE_T_MAX,",
     "the whole line instead of the ray"},

    {"ambient-without-normal", shade, "0.5 + 0.5 * normal.z", "0.5", "the same from all sides"},
    {"ambient-flipped", shade, "0.5 + 0.5 * normal.z", "0.5 - 0.5 * normal.z", "sky and ground swapped"},
    {"ambient-without-specular", shade, "(diffuse + 0.5 * material.specular.rgb)", "diffuse",
     "metals are black in the shade"},
    {"first-light-only", shade, "i < sceneLights", "i < min(sceneLights, 1)", "a loop that ends at once"},
    {"every-light-the-first", shade, "frame.lights[i]", "frame.lights[0]", "an index that does not move"},
    {"falloff-missing", shade, "1.0 / distance2 : 1.0", "1.0 : 1.0", "point lights as strong as far away"},
    {"falloff-linear", shade, "1.0 / distance2 : 1.0", "1.0 / sqrt(distance2) : 1.0",
     "distance for its square"},
    {"point-light-as-direction", shade, "light.vector.xyz - light.vector.w * start", "light.vector.xyz",
     "a position taken for a direction"},
    {"shadows-missing", shade,
     "facing && !sceneOccluded(sceneMakeRay(start, path), 0.0, light.vector.w > 0.5 ? 1.0 : SCENE_T_MAX)",
     "facing", "nothing is in anything's way"},
    {"shadow-beyond-the-light", shade, "light.vector.w > 0.5 ? 1.0 : SCENE_T_MAX", "SCENE_T_MAX",
     "what is behind a point light throws a shadow"},
    {"lift-missing", shade, "position + lift * normal", "position", "surfaces shade themselves"},
    {"lift-a-hundredfold", shade, "max(1.0e-3 * torus.radii.y", "max(1.0e-1 * torus.radii.y",
     "shadow rays leave far off the surface"},
    {"lift-outward", shade, "position + lift * normal", "position + lift * outward",
     "shadow rays of an inside leave outside"},
};

}  // namespace

std::span<const Mutation> shadingMutations() {
    return rows;
}

}  // namespace raytorus::mutate
