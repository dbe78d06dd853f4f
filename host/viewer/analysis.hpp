// SPDX-License-Identifier: MIT
// What the reference says of a picture, worked out in the background, tile by tile from the middle outwards.
//
// The reference meets each torus with the very ray that the shader gives to the library: in the torus' frame,
// in float32. So what is seen is the intersection's own error, and what the shader does to the hit afterwards
// to place it in the world. The unit is a rounding of the numbers that the position is made of:
// 2^-24 (R + r + the largest coordinate of the torus' centre).
#pragma once

#include <atomic>
#include <mutex>
#include <thread>
#include <vector>

#include "image/image.hpp"
#include "scene/scene.hpp"
#include "truth/scene_data.hpp"

namespace raytorus::viewer {

/// Four floats a pixel, as view.comp reads them: see ANALYSIS_... in view_io.h.
struct AnalysisPixels {
    int width = 0;
    int height = 0;
    std::vector<float> values;
};

/// What is known about a pixel, to be shown.
struct PixelAnalysis {
    int state = 0;               ///< ANALYSIS_...
    double fromSurface = 0.0;    ///< in units; negative inside
    double fromReference = 0.0;  ///< in units
};

/// Judges pixels of a picture that has the channels of render().
class PixelJudge {
public:
    PixelJudge(const scene::Scene& scene, int width, int height);

    [[nodiscard]] PixelAnalysis judge(const image::Image& picture, int x, int y) const;

private:
    truth::SceneData data;
};

class Analysis {
public:
    Analysis() = default;
    Analysis(const Analysis&) = delete;
    Analysis& operator=(const Analysis&) = delete;
    ~Analysis() { stop(); }

    /// Begins with a picture that has the channels of render(), and drops the one before.
    void start(const scene::Scene& scene, image::Image picture);
    void stop();

    struct Progress {
        double part = 0.0;  ///< of the pixels, 1: all are known
        long long wrong = 0;
        double largest = 0.0;  ///< distance from the reference's hit, in units
    };

    /// Copies what is known by now, if that is more than at the last call.
    bool take(AnalysisPixels& pixels, Progress& progress);

private:
    void work(const PixelJudge& judge, const image::Image& picture);

    std::mutex mutex;
    AnalysisPixels known;
    Progress now;
    bool news = false;
    std::atomic<bool> stopping = false;
    std::thread worker;
};

}  // namespace raytorus::viewer
