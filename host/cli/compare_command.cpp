// SPDX-License-Identifier: MIT
// raytorus compare: two image files, a table of numbers, and an exit code.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "cli/command.hpp"
#include "compare/compare.hpp"
#include "compare/comparison_text.hpp"
#include "compare/difference.hpp"
#include "core/console.hpp"
#include "core/parse_number.hpp"
#include "image/image_io.hpp"
#include "image/manifest.hpp"
#include "report/report.hpp"

namespace raytorus::cli {

namespace {

struct CompareOptions {
    std::string expected;
    std::string actual;
    compare::CompareRules rules;
    std::string manifestPath;
    std::string differencePath;
    std::string reportFolder;
    bool json = false;
};

// The whole text as a number that is finite and not negative: std::stod would take "nan" and "1e-3x".
template <typename Number>
Number notNegative(const std::string& text, std::string_view what) {
    const std::optional<Number> value = parseNumber<Number>(text);
    if (!value || !(*value >= 0 && *value <= std::numeric_limits<Number>::max())) {
        throw CLI::ValidationError(fmt::format("{} that is not negative, not \"{}\"", what, text));
    }
    return *value;
}

double parseTolerance(const std::string& text) {
    return notNegative<double>(text, "A tolerance is a number");
}

std::int64_t parseCount(const std::string& text) {
    return notNegative<std::int64_t>(text, "A count of pixels is a whole number");
}

// "1e-4", or "4ulp".
compare::CompareRule parseRule(std::string text) {
    constexpr std::string_view unit = "ulp";
    compare::CompareRule rule;
    if (text.ends_with(unit)) {
        text.resize(text.size() - unit.size());
        rule.ulps = notNegative<std::int64_t>(text, "A tolerance in ulps is a whole number");
    } else {
        rule.tolerance = parseTolerance(text);
    }
    return rule;
}

// "NAME=TOLERANCE". Split at the last '=': channel names may have one.
void addChannelRule(compare::CompareRules& rules, const std::string& text) {
    const std::size_t equals = text.rfind('=');
    if (equals == std::string::npos || equals == 0) {
        throw CLI::ValidationError(
            fmt::format("--channel takes NAME=TOLERANCE, for example Z=1e-4 or Z=4ulp, not \"{}\"", text));
    }
    const std::string name = text.substr(0, equals);
    if (!rules.channelRules.try_emplace(name, parseRule(text.substr(equals + 1))).second) {
        throw CLI::ValidationError(fmt::format("--channel gives the tolerance of {} twice", name));
    }
}

// A slip in the order of the names must not cost a golden image.
void refuseToOverwriteInput(const CompareOptions& options) {
    std::error_code ignored;
    for (const std::string& input : {options.expected, options.actual}) {
        if (std::filesystem::equivalent(input, options.differencePath, ignored)) {
            throw Error(
                ExitCode::Usage,
                fmt::format("--difference would overwrite \"{}\", one of the images compared", input));
        }
    }
}

// Before anything is read from the picture itself: what a wrong file holds does not matter.
void requireListed(const CompareOptions& options) {
    if (options.manifestPath.empty()) {
        return;
    }
    const image::Manifest manifest = image::readManifest(options.manifestPath);
    if (const std::string fault = image::manifestFault(manifest, options.expected); !fault.empty()) {
        throw Error(ExitCode::File, fmt::format("{} ({})", fault, options.manifestPath));
    }
}

void writeReport(const CompareOptions& options, const image::Image& expected, const image::Image& actual,
                 const compare::Comparison& comparison) {
    const std::string name = std::filesystem::path(options.actual).stem().string();
    const report::ReportHeading heading = {"raytorus compare",
                                           {{"expected", options.expected}, {"actual", options.actual}}};
    report::writeReportFolder(options.reportFolder,
                              std::vector{report::reportCase(name, expected, actual, comparison)}, heading);
}

void printComparison(const CompareOptions& options, const compare::Comparison& comparison) {
    if (options.json) {
        print("{}\n", compare::jsonText(comparison));
    } else {
        print("{}{}\n", compare::numbersTable(comparison), comparison.sentence);
    }
}

ExitCode runCompare(const CompareOptions& options) {
    refuseToOverwriteInput(options);
    requireListed(options);
    const image::ImageFile expectedFile(options.expected);
    const image::ImageFile actualFile(options.actual);
    // Pictures that are not alike need not be decoded, and may be huge. A report shows them.
    const auto unlike = compare::compareShapes(expectedFile.header(), actualFile.header(), options.rules);
    if (unlike && options.reportFolder.empty()) {
        printComparison(options, *unlike);
        return unlike->exitCode();
    }
    const image::Image expected = expectedFile.read();
    const image::Image actual = actualFile.read();
    const compare::Comparison comparison = compare::compare(expected, actual, options.rules);
    printComparison(options, comparison);
    if (!options.differencePath.empty() && comparison.verdict != compare::Verdict::SizeDiffers) {
        image::writeImage(options.differencePath, compare::differenceImage(expected, actual, options.rules));
    }
    if (!options.reportFolder.empty()) {
        writeReport(options, expected, actual, comparison);
    }
    return comparison.exitCode();
}

constexpr const char* compareFooter =
    R"(A value agrees when it is off by no more than --tolerance, or by no more than --relative times the
expected value, or by no more than --ulp times its last place. A pixel agrees when all its channels do. NaN and
infinity never agree, in either image.

A truth is an expected image that has channels "margin..." and "tolerance..." besides. It gives each pixel its own
tolerance, is exact in id, count and A, and knows where rounding may flip a pixel: flips are counted apart.

Examples:
  raytorus compare golden/ring.exr out/ring.exr
  raytorus compare expected.exr actual.exr --tolerance 1e-5 --channel Z=1e-4 --allow 8 --window-limit 3
  raytorus compare expected.exr actual.exr --relative 1e-6 --difference difference.png
  raytorus compare expected.png actual.png --tolerance 0.004 --json
  raytorus compare golden/ring.exr out/ring.exr --manifest golden/manifest.json --channel t=4ulp --report out/report

Exit codes: 0 the images agree, 2 they differ, 3 size or channels differ, 4 a file cannot be read or written or
is not the one in the manifest, 5 the command line is wrong, 12 an image holds NaN or infinity.)";

}  // namespace

void addCompareCommand(CLI::App& app, Action& action) {
    CLI::App* const command = app.add_subcommand("compare", "Compare two image files (.exr, .png)");
    const auto options = std::make_shared<CompareOptions>();
    compare::CompareRules& rules = options->rules;
    command->footer(compareFooter);
    // An option whose text goes to `store`, which throws CLI::ValidationError for what it does not like.
    const auto addOption = [command](const std::string& name, const char* type, const std::string& help,
                                     auto store) {
        return command->add_option_function<std::string>(name, std::move(store), help)->type_name(type);
    };
    command->add_option("EXPECTED", options->expected, "The image as it should be")
        ->required()
        ->type_name("FILE");
    command->add_option("ACTUAL", options->actual, "The image to judge")->required()->type_name("FILE");
    addOption("--tolerance", "X", "Allowed difference of a value (default 0)",
              [&rules](const std::string& text) { rules.defaultRule.tolerance = parseTolerance(text); });
    addOption(
        "--relative", "X", "Allowed difference relative to the expected value (default 0)",
        [&rules](const std::string& text) { rules.defaultRule.relativeTolerance = parseTolerance(text); });
    addOption("--ulp", "N", "Allowed difference in units in the last place of the expected value (default 0)",
              [&rules](const std::string& text) {
                  rules.defaultRule.ulps =
                      notNegative<std::int64_t>(text, "A tolerance in ulps is a whole number");
              });
    addOption("--allow", "N", "Pixels that may be over their tolerance (default 0)",
              [&rules](const std::string& text) { rules.allowedPixels = parseCount(text); });
    addOption("--channel", "NAME=TOL",
              "Tolerance of one channel instead of the general ones, as 1e-4 or 4ulp; may be repeated",
              [&rules](const std::string& text) { addChannelRule(rules, text); })
        ->trigger_on_parse();
    addOption(
        "--window-limit", "N",
        fmt::format("Pixels over their tolerance that may lie in one {0} x {0} square (default: any number)",
                    rules.windowSize),
        [&rules](const std::string& text) { rules.windowLimit = parseCount(text); });
    addOption("--allow-flips", "N",
              "Pixels that may flip where a truth says that rounding may flip them (default: all of those)",
              [&rules](const std::string& text) { rules.allowedFlips = parseCount(text); });
    command
        ->add_option("--manifest", options->manifestPath,
                     "Refuse an expected image that is not the one listed in this file, by its SHA-256")
        ->type_name("FILE.json");
    addOption("--difference", "FILE.png", "Write a picture of the differences here",
              [options = options.get()](const std::string& path) {
                  if (!image::hasImageExtension(path, image::Format::Png)) {
                      throw CLI::ValidationError(fmt::format(
                          "The name of the difference picture must end in .png, not \"{}\"", path));
                  }
                  options->differencePath = path;
              });
    command->add_option("--report", options->reportFolder, "Write index.html, report.json and junit.xml here")
        ->type_name("FOLDER");
    command->add_flag("--json", options->json, "Print the result as JSON");
    command->callback([options, &action] { action = [options] { return runCompare(*options); }; });
}

}  // namespace raytorus::cli
