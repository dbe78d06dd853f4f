// SPDX-License-Identifier: MIT
// A golden case, drawn and checked: every way in which it can fail is a sentence of the result, and none is
// passed over.
#pragma once

#include <string>

#include "core/error.hpp"
#include "golden/golden_set.hpp"
#include "gpu/context.hpp"
#include "render/renderer.hpp"
#include "report/report.hpp"

namespace raytorus::golden {

/// Lets the pipeline that draw() will want be made ahead, by another thread. A scene that cannot be read is
/// passed over: draw() says so when its turn comes.
void prepare(const gpu::Context& context, const Set& set, const Case& row, render::Route route,
             const trace::ShaderSource& shaders, render::PipelineStore& pipelines);

/// Throws the first fault that keeps the cases from being drawn and judged: of a scene, the manifest, a
/// truth, a sidecar.
void requireSound(const Set& set);

/// The picture of a case, all channels, as it is drawn now.
image::Image draw(gpu::Context& context, const Set& set, const Case& row, render::Route route,
                  const trace::ShaderSource& shaders = {}, render::PipelineStore* pipelines = nullptr);

struct Checked {
    report::ReportCase report;
    ExitCode exitCode = ExitCode::Ok;  ///< of the first gate that did not open
};

/// Holds a picture to the truth: manifest and sidecar first, then size and channels, non-finite values, what
/// is exact, and every value within the tolerance of its pixel.
/// label: of the picture, "ring_half_compute". allowedPixels: that may be off by more. toleranceFactor: for a
/// device that rounds so many times as loosely, by which each tolerance grows and each margin shrinks.
Checked check(const Set& set, const Case& row, const std::string& label, const image::Image& actual,
              int allowedPixels = 0, float toleranceFactor = 1.0f);

/// A picture that could not be drawn or compared: an error, not a difference.
Checked unchecked(const std::string& label, ExitCode code, const std::string& sentence);

/// Whether an error is about one case, and others can still be judged: not where the device is gone, for
/// instance.
bool isOfOneCase(ExitCode code);

/// The code that says most of two: what kept a comparison from being made goes before what came out of one.
/// docs/golden.md has the order.
ExitCode worse(ExitCode one, ExitCode other);

/// Why the bits are not those that are recorded; empty if they are. Throws Error{File} as readBits().
std::string bitsFault(const Set& set, const Case& row, const image::Image& actual);

}  // namespace raytorus::golden
