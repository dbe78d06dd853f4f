// SPDX-License-Identifier: MIT
// A scene's picture that stays on the device and is drawn again and again, for looking at it while it
// changes. The same drawing as render()'s: equal scenes, routes, sizes and samples give equal bits.
#pragma once

#include <memory>
#include <optional>

#include "image/image.hpp"
#include "render/picture_drawing.hpp"

namespace raytorus::render {

/// What a drawing of LivePicture makes.
struct LiveRequest {
    VkExtent2D extent{};     ///< at most the largest
    int samplesPerSide = 1;  ///< colour is the mean of a regular grid of n x n rays a pixel
    /// The geometric pictures too. They are kept while the colour alone is drawn again.
    bool aovs = true;
};

/// What the last complete drawing took, by the wall clock and by the device's own (0: it has none).
struct LiveTimes {
    double seconds = 0.0;
    double deviceSeconds = 0.0;
    bool compiled = false;  ///< by a pipeline used for the first time: the driver compiled within these
};

class LivePicture {
public:
    /// The images have the size `largest`, so that smaller pictures need no new ones.
    LivePicture(gpu::Context& context, VkExtent2D largest);

    /// Drops what was drawn.
    void resize(VkExtent2D largest);

    /// Which shaders draw, by which route. Makes the pipeline that `scene` needs at once, and changes nothing
    /// if that throws.
    void setShaders(const scene::Scene& scene, const trace::ShaderSource& shaders, Route route);

    /// Starts a drawing and ends the one that is in the making. `sameTori`: tori and materials are those of
    /// the drawing before.
    void begin(const scene::Scene& scene, const LiveRequest& request, bool sameTori);

    /// Draws for about so long. True: the drawing is complete, and images() are ready to be read by a compute
    /// shader.
    bool draw(double seconds);

    [[nodiscard]] bool drawing() const { return current.has_value(); }
    [[nodiscard]] const LiveTimes& times() const { return lastTimes; }

    /// The pictures as in PictureTargets, in VK_IMAGE_LAYOUT_GENERAL while nothing is being drawn. The colour
    /// is the one drawn last, with or without the others.
    [[nodiscard]] const gpu::DeviceImage& image(std::size_t index) const;

    /// The upper left of the images, with all channels; while nothing is being drawn.
    [[nodiscard]] image::Image readBack(VkExtent2D extent);

private:
    struct Images {
        Images(gpu::Context& context, VkExtent2D extent);
        PictureTargets all;
        PictureTargets color;
    };

    [[nodiscard]] const PictureTargets& targetsOf(const LiveRequest& request) const;
    void abandon();
    image::Image readBack(const PictureTargets& targets, VkExtent2D extent);

    gpu::Context* context;
    std::unique_ptr<Images> images;
    trace::ShaderSource shaders;
    Route route = Route::Fragment;
    PipelineStore pipelines;
    std::unique_ptr<SceneBuffers> buffers;
    std::optional<PictureDrawing> current;
    LiveRequest request;
    std::uint32_t bandRows = 0;
    bool untried = true;      // the shaders have not drawn yet
    bool colorAlone = false;  // the colour of `color` is newer than that of `all`
    LiveTimes drawTimes;
    LiveTimes lastTimes;
};

}  // namespace raytorus::render
