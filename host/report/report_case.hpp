// SPDX-License-Identifier: MIT
// One case of a report as HTML.
#pragma once

#include <string>

#include "report/report.hpp"

namespace raytorus::report {

/// The case's verdict in a word.
[[nodiscard]] std::string verdictOf(const ReportCase& reported);

/// All of a case: a line to find it by, and what opens below.
[[nodiscard]] std::string caseHtml(const ReportCase& reported, bool open);

/// The table of channels, and what is counted over all of them.
[[nodiscard]] std::string numbersHtml(const compare::Comparison& comparison);

/// Bars of differenceHistogram(). Of a case that was compared.
[[nodiscard]] std::string histogramHtml(const ReportCase& reported);

/// The values of one pixel, a row for each channel that differs. Of a case that was compared.
[[nodiscard]] std::string pixelHtml(const ReportCase& reported, compare::Pixel pixel);

}  // namespace raytorus::report
