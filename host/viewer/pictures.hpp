// SPDX-License-Identifier: MIT
// The pictures of both sides of the wipe, drawn again when something has changed: small while it moves, whole
// and then with more samples when it rests.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "render/live_picture.hpp"
#include "viewer/resolution.hpp"
#include "viewer/state.hpp"

namespace raytorus::viewer {

/// Tells shaders apart.
struct ShaderVersion {
    std::size_t method = 0;
    int version = 0;
    bool steps = false;

    bool operator==(const ShaderVersion&) const = default;
};

/// Everything that pictures depend on; equal wishes give equal pictures.
struct Wish {
    scene::Scene scene;  ///< as it is at the time shown
    std::array<trace::ShaderSource, 2> shaders;
    std::array<ShaderVersion, 2> shaderVersions{};  ///< of `shaders`
    std::array<render::Route, 2> routes{};
    bool right = false;  ///< the right side is wanted, too
    bool aovs = false;   ///< the geometric pictures are wanted at once
    int samplesPerSide = 1;
    bool still = false;  ///< nothing is going to move: whole pictures at once

    [[nodiscard]] bool samePicture(const Wish& other) const;
};

class Pictures {
public:
    Pictures(gpu::Context& context, VkExtent2D size);

    /// The window has another size now.
    void resize(VkExtent2D size);

    /// Takes up a wish, and begins to draw where the pictures are not what it asks for. `now`: seconds of a
    /// clock that goes on. Throws Error{Shader} if the driver refuses a shader; what is shown stays.
    void update(const Wish& wish, double now);

    /// Draws for about so long. True: the pictures that are shown are others than before.
    bool draw(double seconds);

    /// What showing a moving picture takes.
    void learnShowing(double seconds) { resolution.learnShowing(seconds); }

    /// Nothing is left to be drawn.
    [[nodiscard]] bool settled() const;
    /// How good the pictures are that are shown; nothing: none are complete.
    [[nodiscard]] std::optional<Quality> shown() const { return complete; }
    [[nodiscard]] bool drawing() const { return inWork.has_value(); }

    /// The part of the images that is the picture.
    [[nodiscard]] VkExtent2D extent() const { return shownExtent; }
    [[nodiscard]] VkExtent2D size() const { return windowSize; }
    [[nodiscard]] int samples() const { return shownSamples; }
    /// What the picture shows, which may be older than the last wish.
    [[nodiscard]] const scene::Scene& scene() const { return wanted.scene; }

    [[nodiscard]] render::LivePicture& side(std::size_t index) { return *live[index]; }
    [[nodiscard]] bool hasRight() const { return wanted.right; }
    /// Of the left side's last drawing.
    [[nodiscard]] const render::LiveTimes& times() const { return live[0]->times(); }

    /// How long after the last change the whole picture is begun.
    static constexpr double restSeconds = 0.15;

private:
    void begin(Quality quality);
    void setShaders(const Wish& wish);
    [[nodiscard]] std::optional<Quality> next(double now) const;

    gpu::Context* context;
    VkExtent2D windowSize;
    std::array<std::unique_ptr<render::LivePicture>, 2> live;
    std::array<std::optional<scene::Scene>, 2> drawnScene;  // whose tori are on the device
    std::array<std::optional<ShaderVersion>, 2> versions;
    std::array<render::Route, 2> routes{};
    Wish wanted;
    bool hasWish = false;
    double lastChange = -1e9;
    Resolution resolution;
    std::optional<Quality> inWork;
    std::array<bool, 2> ready{};
    VkExtent2D workExtent{};
    int workSamples = 1;
    std::optional<Quality> complete;
    VkExtent2D shownExtent{};
    int shownSamples = 1;
};

}  // namespace raytorus::viewer
