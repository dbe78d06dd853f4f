// SPDX-License-Identifier: MIT
// Submissions after the first one compile nothing. Some versions of lavapipe put uniforms on which a branch
// or a loop depends into the code as constants, and do that, compiler and all, for each submission: 50 ms for
// what takes 1.
#include <gtest/gtest.h>

#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "render/picture_drawing.hpp"
#include "scene/scene_json.hpp"
#include "support/device_fixture.hpp"
#include "trace/tracer.hpp"

namespace raytorus::test {
namespace {

class OnceCompiled : public DeviceTest {};

// Bytes of this process that are code but of no file, as a driver for the CPU compiles it. Linux tells. They
// may become fewer at any time: a driver gives back what it has compiled with.
std::size_t compiledBytes() {
    std::ifstream maps("/proc/self/maps");
    std::size_t bytes = 0;
    for (std::string line; std::getline(maps, line);) {
        std::istringstream words(line);
        std::string range;
        std::string rights;
        std::string offset;
        std::string device;
        unsigned long long file = 0;
        words >> range >> rights >> offset >> device >> file;
        if (rights.find('x') != std::string::npos && file == 0) {
            const std::size_t dash = range.find('-');
            bytes += std::stoull(range.substr(dash + 1), nullptr, 16) - std::stoull(range, nullptr, 16);
        }
    }
    EXPECT_GT(bytes, 0U) << "not even the kernel's own page";
    return bytes;
}

// One torus: its radii are uniforms at a fixed place.
TEST_F(OnceCompiled, Pictures) {
    const scene::Scene scene =
        scene::readScene(std::filesystem::path(RAYTORUS_SOURCE_DIR) / "scenes" / "ring.json");
    for (const render::Route route : {render::Route::Fragment, render::Route::Compute}) {
        constexpr VkExtent2D extent{32, 16};
        const render::SceneBuffers buffers(device(), scene, extent.width, extent.height);
        const render::PictureTargets targets(device(), extent, true);
        render::PipelineStore pipelines;
        render::PictureDrawing drawing(device(), pipelines, scene, buffers, targets, extent, {route, 1, {}});
        const auto drawRow = [&] {
            drawing.setBandRows(1);
            drawing.drawBand(1.0);
        };
        drawRow();
        const std::size_t first = compiledBytes();
        while (!drawing.complete()) {
            drawRow();
        }
        EXPECT_LE(compiledBytes(), first)
            << (route == render::Route::Fragment ? "fragment" : "compute") << " route";
    }
}

// The radii are push constants.
TEST_F(OnceCompiled, Traces) {
    for (const trace::Query query : {trace::Query::Nearest, trace::Query::All, trace::Query::Any}) {
        trace::Tracer tracer(device(), query, 1);
        const std::vector<trace::TraceRay> rays = {
            {{3.0F, 0.0F, 0.0F}, 0.0F, {-1.0F, 0.0F, 0.0F}, std::numeric_limits<float>::infinity()}};
        tracer.trace({1.0F, 0.25F}, rays);
        const std::size_t first = compiledBytes();
        for (int i = 1; i < 16; ++i) {
            EXPECT_GE(tracer.trace({1.0F, 0.25F}, rays).front(), 1.0F);
        }
        EXPECT_LE(compiledBytes(), first) << "query " << static_cast<int>(query);
    }
}

}  // namespace
}  // namespace raytorus::test
