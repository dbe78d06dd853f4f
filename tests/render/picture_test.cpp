// SPDX-License-Identifier: MIT
// What a picture's channels promise each other, in goldens of every placement and distance.
#include <gtest/gtest.h>

#include "render/renderer.hpp"
#include "scene/scene_json.hpp"
#include "support/device_fixture.hpp"
#include "support/picture_checks.hpp"

namespace raytorus::test {
namespace {

class Picture : public DeviceTest, public testing::WithParamInterface<const char*> {};

TEST_P(Picture, HasItsPositionsOnTheTori) {
    const scene::Scene scene = scene::readScene(std::filesystem::path(RAYTORUS_SOURCE_DIR) / "golden" /
                                                "scenes" / (std::string(GetParam()) + ".json"));
    for (const render::Route route : {render::Route::Fragment, render::Route::Compute}) {
        render::RenderOptions options;
        options.route = route;
        const image::Image picture = render::render(device(), scene, options).picture;
        EXPECT_EQ(offTheTori(picture, scene), "");
    }
}

INSTANTIATE_TEST_SUITE_P(Goldens, Picture,
                         testing::Values("ring_half", "thin_001", "spindle", "far_1000", "far_1e5", "turned",
                                         "scaled", "moved", "tiny", "huge", "links"),
                         [](const auto& row) { return std::string(row.param); });

}  // namespace
}  // namespace raytorus::test
