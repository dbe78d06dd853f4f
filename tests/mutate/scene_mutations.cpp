// SPDX-License-Identifier: MIT
// Faults of the way through the scene: hierarchy, placement, the loops over tori, and the two routes.
#include "mutate/mutation.hpp"

namespace raytorus::mutate {
namespace {

constexpr const char* scene = "scene.glsl";

constexpr Mutation rows[] = {
    {"rotation-transposed", scene, "sceneToTorus(torus, ray", "sceneFromTorus(torus, ray",
     "rays turned the wrong way", Shows::InPictures, 6},
    {"translation-ignored", scene, "ray.origin - sceneOriginOf(torus)", "ray.origin",
     "every torus stands at the origin", Shows::InPictures, 3},
    {"shadow-translation-added", scene,
     "ray.origin - sceneOriginOf(torus));\n        vec3 direction = sceneToTorus(torus, ray.direction);\n"
     "        occluded",
     "ray.origin + sceneOriginOf(torus));\n        vec3 direction = sceneToTorus(torus, ray.direction);\n"
     "        occluded",
     "a sign in one of three copies"},
    {"nearest-is-the-last", scene, "direction, nearest.t, hit", "direction, tMax, hit",
     "each torus overwrites what was nearer"},
    {"shadow-of-the-last", scene, "index >= 0 && !occluded", "index >= 0",
     "a later torus that is not in the way lifts the shadow"},
    {"count-of-the-last", scene, "count += RAY_INTERSECT_ALL", "count = RAY_INTERSECT_ALL",
     "surfaces of the last torus alone"},
    {"skip-one-further", scene, "int next = floatBitsToInt(current.minimum.w)",
     "int next = floatBitsToInt(current.minimum.w) + 1", "a node is jumped over"},
    {"last-node-lost", scene, "node < 2 * sceneTori - 1", "node < 2 * sceneTori - 2",
     "the number of nodes off by one"},
    {"box-too-tight", scene, "(node.maximum.xyz - ray.origin)", "(node.maximum.xyz - ray.origin - 0.02)",
     "boxes that end before the torus does"},
    {"box-of-the-inside-lost", scene, "leave + room >= tMin", "enter + room >= tMin",
     "a box that the ray starts in is missed"},
    {"box-near-the-start", scene, "min(leave, tMax) + room && leave",
     "min(leave, tMax) && leave > 1.0 && leave", "boxes that end soon after the start are culled"},
    {"large-scenes-first-torus", scene, "largeTori[index]", "largeTori[0]",
     "the storage that large scenes have is read at its start alone"},
    {"large-scenes-next-node", scene, "largeNodes[index]", "largeNodes[min(index + 1, 2 * sceneTori - 2)]",
     "an index off by one in the storage that large scenes have"},
    {"large-scenes-first-material", scene, "largeMaterials[index]", "largeMaterials[0]",
     "the first material for all in the storage that large scenes have"},

    {"fragment-next-pixel", "scene.frag", "uvec2(gl_FragCoord.xy)", "uvec2(gl_FragCoord.xy + 0.5)",
     "FragCoord is at the middle already"},
    {"fragment-uv-swapped", "scene.frag", "surface = pixel.surface", "surface = pixel.surface.yxzw",
     "one route differs"},
    {"compute-upside-down", "scene.comp", "imageStore(colorImage, ivec2(at),",
     "imageStore(colorImage, ivec2(at.x, endRow - 1u - at.y + firstRow),", "one route differs"},
    {"compute-normal-stale", "scene.comp", "imageStore(normalImage, ivec2(at), pixel.normal)",
     "imageStore(normalImage, ivec2(at), pixel.position)", "a line pasted and not changed"},
    {"compute-last-column", "scene.comp", "at.x >= width", "at.x + 1u >= width",
     "the last column is left out"},
    {"compute-first-band", "scene.comp", "+ uvec2(0u, firstRow)", "+ uvec2(0u, 0u)",
     "every band of rows is the first one"},
};

}  // namespace

std::span<const Mutation> sceneMutations() {
    return rows;
}

}  // namespace raytorus::mutate
