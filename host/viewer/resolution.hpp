// SPDX-License-Identifier: MIT
// Which size the picture has while something moves, and how it gets better at rest. Decisions only.
#pragma once

#include <vulkan/vulkan.h>

namespace raytorus::viewer {

/// What to draw next.
enum class Quality {
    Moving,   ///< one sample a pixel, as many pixels as there is time for
    Full,     ///< every pixel, one sample, all channels
    Refined,  ///< every pixel, all samples
};

class Resolution {
public:
    /// Seconds a drawing may take at most while something moves: half of what 30 frames a second leave.
    static constexpr double movingSeconds = 0.016;
    /// Seconds that drawing and showing a frame shall take together: 30 frames a second, and some room.
    static constexpr double frameSeconds = 0.028;
    /// A drawing has at least this long, however slowly it is shown.
    static constexpr double leastSeconds = 0.004;

    /// Learns from a drawing what a pixel costs.
    void learn(VkExtent2D extent, int samples, double seconds);

    /// Learns what a frame takes besides its drawing.
    void learnShowing(double seconds);

    /// The size for a moving picture in a window of this size: the same shape, each side a multiple of 8 or
    /// the full one, never below an eighth of it.
    [[nodiscard]] VkExtent2D movingExtent(VkExtent2D window) const;

private:
    double secondsPerPixel = 0.0;  // 0: not known yet
    double secondsPerDrawing = 0.001;
    double secondsToShow = frameSeconds - movingSeconds;
};

}  // namespace raytorus::viewer
