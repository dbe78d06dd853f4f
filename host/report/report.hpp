// SPDX-License-Identifier: MIT
// A page that shows comparisons of images: one HTML file, nothing beside it, nothing from a network. And the
// same for programs: report.json and junit.xml.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "compare/compare.hpp"
#include "image/image.hpp"

namespace raytorus::report {

/// One comparison, or the reason why there was none (a file that is missing, for instance).
struct ReportCase {
    std::string name;
    bool passed = false;
    std::string sentence;
    std::string
        verdict;  ///< in a word, "missing" for instance; empty: that of the comparison, or passed, or failed
    std::optional<compare::Comparison> comparison;  ///< gives the verdict and the numbers
    std::optional<image::Image> expected;
    std::optional<image::Image> actual;

    // For whoever reads the page. What is empty is not shown. Commands are shown as they are given: quoted
    // for a shell.
    std::string catches;         ///< what the case is there to catch
    std::string explainCommand;  ///< tells all about one pixel, which the last "{x},{y}" in it becomes
    std::string rerunCommand;    ///< makes and compares this case again
    std::string renewCommand;    ///< makes what came out what is expected
    double seconds = 0.0;        ///< how long it took; 0: not known
};

/// What stands above the cases: a title, and facts that belong to all of them, such as the device, by name.
struct ReportHeading {
    std::string title = "Image comparison";
    std::vector<std::pair<std::string, std::string>> facts;
};

/// The case of a comparison that was made.
[[nodiscard]] ReportCase reportCase(std::string name, image::Image expected, image::Image actual,
                                    compare::Comparison comparison);

/// The failed case "skipped" for each of the names that no case has: what did not run has not passed.
[[nodiscard]] std::vector<ReportCase> skippedCases(std::span<const std::string> names,
                                                   std::span<const ReportCase> cases);

/// How bad a case is: its largest difference in limits. Infinite for a failed one that was not compared.
[[nodiscard]] double badness(const ReportCase& reported);

/// The pixel to look at first: the first that is not finite, or else where the worst channel is furthest off,
/// or else the first flip. None where nothing differs.
[[nodiscard]] std::optional<compare::Pixel> worstPixel(const ReportCase& reported);

/// The page: failed cases first, then by badness, otherwise in the given order. The same cases give the same
/// text.
[[nodiscard]] std::string reportHtml(std::span<const ReportCase> cases, const ReportHeading& heading = {});

/// Counts and every case in the given order as one JSON object, with what jsonText() gives of its comparison.
[[nodiscard]] std::string reportJson(std::span<const ReportCase> cases, const ReportHeading& heading = {});

/// The cases as one suite in JUnit's XML. A case that was not compared, skipped ones included, is an error;
/// none is "skipped", which CI would let pass.
[[nodiscard]] std::string reportJunit(std::span<const ReportCase> cases, const ReportHeading& heading = {});

/// Writes the page, in one step like writeImage().
void writeReport(const std::filesystem::path& path, std::span<const ReportCase> cases);

/// Makes the folder of a report, if need be. Throws Error{File} if what writeReportFolder() writes could not
/// be written there: better said before a long work than after it.
void prepareReportFolder(const std::filesystem::path& folder);

/// Writes index.html, report.json and junit.xml into the folder, which is made if need be.
void writeReportFolder(const std::filesystem::path& folder, std::span<const ReportCase> cases,
                       const ReportHeading& heading = {});

}  // namespace raytorus::report
