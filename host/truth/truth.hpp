// SPDX-License-Identifier: MIT
// The picture that a scene has: what shaders/shade.glsl and scene.glsl define, computed in 113 bits by the
// reference, from the float32 data that the shaders read. docs/golden.md tells what it is for.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "image/image.hpp"
#include "scene/scene.hpp"

namespace raytorus::truth {

enum class Precision {
    Bits113,  ///< the arbiter
    Bits104,  ///< double-double, and doubles after the hit: other code, to question the arbiter with
};

struct TruthOptions {
    int samplesPerSide = 1;  ///< colour is the mean of a regular grid of n x n rays a pixel
    bool aovs = true;        ///< t, position, normal, uv, count and id too, as `raytorus render` writes them
    bool sharpness = false;  ///< the channels margin, margin.*, and tolerance.* too
    Precision precision = Precision::Bits113;
    unsigned threads = 0;                  ///< 0: one a processor; the picture is the same
    std::function<void(double)> progress;  ///< called with the part done, in (0, 1], never twice at once
};

/// Margins and tolerances are powers of two, which compress well: margins rounded down and at most this.
inline constexpr float largestMargin = 0x1p20F;

/// Throws Error{ExitCode::OutOfMemory} for a picture that is too large.
image::Image renderTruth(const scene::Scene& scene, int width, int height, const TruthOptions& options);

/// A value for which the two precisions give different floats.
struct Disagreement {
    int x = 0, y = 0;
    std::string channel;
    float arbiter = 0.0F, other = 0.0F;
};

/// Where the reference disagrees with itself: values that differ between the precisions by more than 2^-22 of
/// the larger, or 1e-9 where that is more. Doubles after the hit are right to some 1e-12, so only roundings
/// to another float may differ, and a value that differs by more is wrong in one of them.
std::vector<Disagreement> disagreements(const scene::Scene& scene, int width, int height,
                                        const TruthOptions& options);

}  // namespace raytorus::truth
