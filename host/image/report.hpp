// SPDX-License-Identifier: MIT
// A page that shows comparisons of images: one HTML file, nothing beside it, nothing from a network.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "image/compare.hpp"
#include "image/image.hpp"

namespace raytorus::image {

/// One comparison, or the reason why there was none (a file that is missing, for instance).
struct ReportCase {
    std::string name;
    bool passed = false;
    std::string sentence;
    std::optional<Comparison> comparison;  ///< gives the verdict and the numbers
    std::optional<Image> expected;
    std::optional<Image> actual;
};

/// The case of a comparison that was made.
[[nodiscard]] ReportCase reportCase(std::string name, Image expected, Image actual, Comparison comparison);

/// The page: failed cases first, otherwise in the given order. The same cases give the same text.
[[nodiscard]] std::string reportHtml(std::span<const ReportCase> cases);

/// Writes the page, in one step like writeImage().
void writeReport(const std::filesystem::path& path, std::span<const ReportCase> cases);

/// Text with the characters that mean something in HTML written as entities.
[[nodiscard]] std::string escapeHtml(std::string_view text);

}  // namespace raytorus::image
