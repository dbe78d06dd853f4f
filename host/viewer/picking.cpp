// SPDX-License-Identifier: MIT
#include "viewer/picking.hpp"

#include <fmt/format.h>

#include "explain/explain.hpp"
#include "explain/pixel.hpp"
#include "explain/text.hpp"
#include "reference/rays.hpp"

namespace raytorus::viewer {
namespace {

// A row for a table of rays whose hits are known, as C++ reads it: hexadecimal floats lose nothing.
std::string testCaseOf(const explain::PixelRay& found, const explain::Explanation& explanation) {
    const reference::Ray& ray = found.ray;
    std::string hits;
    for (const explain::TrueRoot& root : explanation.roots) {
        if (root.isHit()) {
            hits += fmt::format("{}{:a}", hits.empty() ? "" : ", ", reference::toDouble(root.t));
        }
    }
    return fmt::format(
        "{{\"pixel_{}_{}\", {:a}F, {:a}F, {{{{{:a}F, {:a}F, {:a}F}}, {:a}F, {{{:a}F, {:a}F, {:a}F}}, "
        "infinity}}, {{{}}}, ulps}},",
        found.x, found.y, found.torus.majorRadius, found.torus.minorRadius, ray.origin[0], ray.origin[1],
        ray.origin[2], ray.tMin, ray.direction[0], ray.direction[1], ray.direction[2], hits);
}

}  // namespace

Pick pickPixel(gpu::Context& context, const scene::Scene& scene, VkExtent2D extent, int x, int y,
               const trace::ShaderSource& shaders, const std::string& deviceWords) {
    const explain::PixelRay found =
        explain::pixelRay(scene, static_cast<int>(extent.width), static_cast<int>(extent.height), x, y);
    const explain::Explanation explanation = explain::explain(context, found.torus, found.ray, shaders);
    Pick pick;
    pick.x = x;
    pick.y = y;
    pick.text = fmt::format("pixel ({}, {}) of {} x {}: {}\n\n{}", x, y, extent.width, extent.height,
                            found.sentence, explain::textOf(explanation));
    pick.command = fmt::format("raytorus explain{} --replay \"{}\"", deviceWords,
                               reference::hexFloats(found.torus, found.ray));
    pick.testCase = testCaseOf(found, explanation);
    return pick;
}

}  // namespace raytorus::viewer
