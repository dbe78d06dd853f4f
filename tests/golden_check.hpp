// SPDX-License-Identifier: MIT
// A golden case, checked: every way in which it can fail is a sentence of the result, and none is passed
// over.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "golden_cases.hpp"
#include "image/report.hpp"
#include "render/renderer.hpp"

namespace raytorus::test {

/// The picture of a case, all channels, as it is rendered now.
image::Image renderGolden(gpu::Context& context, const GoldenCase& row, render::Route route);

image::CompareRules goldenRules(const GoldenCase& row, const gpu::DeviceInfo& device);

/// Compares a picture with `<folder>/<name>.exr`. A golden that is missing, unreadable, of another size or
/// not finite fails, with a sentence that says so and how to renew it.
image::ReportCase checkGolden(const std::filesystem::path& folder, const GoldenCase& row,
                              const std::string& label, const image::Image& actual,
                              const image::CompareRules& rules);

/// What is wrong with the folder itself, a sentence each: files that no row of the table accounts for.
std::vector<std::string> strayGoldens(const std::filesystem::path& folder);

/// Leaves expected.exr, actual.exr, difference.png and report.html in `folder`, as far as they exist.
void leaveEvidence(const std::filesystem::path& folder, const image::ReportCase& result);

}  // namespace raytorus::test
