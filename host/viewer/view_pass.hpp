// SPDX-License-Identifier: MIT
// From pictures to what the window shows of them: view.comp and the images around it.
#pragma once

#include "gpu/device_image.hpp"
#include "gpu/pipeline.hpp"
#include "render/live_picture.hpp"
#include "viewer/analysis.hpp"
#include "viewer/view_io.h"

namespace raytorus::viewer {

class ViewPass {
public:
    explicit ViewPass(gpu::Context& context);

    /// Uploads what is known about the picture. Its size is that of the picture.
    void setAnalysis(const AnalysisPixels& pixels);

    /// Makes shown() from the pictures. `right` may be null. Their images are in VK_IMAGE_LAYOUT_GENERAL.
    void draw(const render::LivePicture& left, const render::LivePicture* right,
              const view_io::ViewPush& push);

    /// In VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL; its upper left extent() is what is to be seen, as displayed
    /// unless push.linear was 1.
    [[nodiscard]] const gpu::DeviceImage& shown() const { return output; }
    [[nodiscard]] VkExtent2D extent() const { return shownExtent; }

    /// The same on the host: R, G, B as displayed, in [0, 1].
    [[nodiscard]] image::Image readBack();

private:
    void need(VkExtent2D extent);

    gpu::Context* context;
    gpu::Pipeline pipeline;
    gpu::DeviceImage output;
    gpu::DeviceImage analysis;
    VkExtent2D shownExtent{};
    bool shownLinear = false;
};

}  // namespace raytorus::viewer
