// SPDX-License-Identifier: MIT
// Cases as they come up in a real run, without a renderer: rings seen from above, by their formula, against a
// truth that knows its own tolerances, with one fault of each kind planted.
#pragma once

#include <string>
#include <vector>

#include "report/report.hpp"

namespace raytorus::test {

/// A ring of 48 x 32 pixels with every channel of a rendering. `hue` gives its colour, `turn` its checker,
/// both from 0 to 1.
image::Image sampleRing(double minorRadius, double hue, double turn = 0.0);

/// The same as a truth: marginal beside the outlines, with a tolerance of some ulp.
image::Image sampleTruth(double minorRadius, double hue, double turn = 0.0);

/// One case of each kind: differing in several ways, missing, of another size, with a NaN, skipped; and
/// passing ones.
std::vector<report::ReportCase> sampleCases();

/// What stands above them.
report::ReportHeading sampleHeading();

}  // namespace raytorus::test
