// SPDX-License-Identifier: MIT
// raytorus golden: the golden pictures of a folder listed, checked and renewed.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <iterator>
#include <map>
#include <memory>
#include <new>
#include <span>

#include "cli/command.hpp"
#include "core/console.hpp"
#include "core/output_file.hpp"
#include "golden/file_group.hpp"
#include "golden/golden_check.hpp"
#include "golden/golden_folder.hpp"
#include "golden/golden_options.hpp"
#include "golden/golden_renew.hpp"
#include "methods/methods.hpp"
#include "options/device_options.hpp"
#include "options/numbers.hpp"
#include "options/progress.hpp"

namespace raytorus::cli {
namespace {

constexpr const char* goldenFooter =
    R"(A golden is the truth: a picture of the scene by the 113-bit reference, which knows for each pixel how far a correct
shader may be off, and where rounding may change what is hit (docs/golden.md).

Examples:
  raytorus golden list
  raytorus golden check
  raytorus golden check ring_half horn --report out/report
  raytorus golden check --tolerance-factor 8
  raytorus golden renew ring_half --reason "the camera stands closer")";

struct GoldenCommand {
    std::string folder = golden::CheckOptions().folder;
    std::vector<std::string> names;
    std::string report;
    std::string reason;
    float toleranceFactor = golden::CheckOptions().toleranceFactor;
    bool all = false;
    options::DeviceOptions device;

    // Without --report: what is read there is not to be overwritten by a part of it.
    [[nodiscard]] golden::CheckOptions repeated() const {
        return {folder, device.context, device.shaderFolder, toleranceFactor};
    }
};

std::vector<golden::Case> chosenCases(const golden::Set& set, const std::vector<std::string>& names) {
    if (names.empty()) {
        return set.cases();
    }
    std::vector<golden::Case> chosen;
    for (const std::string& name : names) {
        if (std::ranges::find(chosen, name, &golden::Case::name) == chosen.end()) {
            chosen.push_back(set.find(name));
        }
    }
    return chosen;
}

ExitCode runList(const GoldenCommand& command) {
    const golden::Set set(command.folder);
    for (const golden::Case& row : set.cases()) {
        print("{:<24}{}\n", row.name, row.catches);
    }
    return ExitCode::Ok;
}

// One picture of a case: by the library, or by another method.
struct Drawing {
    golden::Case row;
    std::string label;
    render::Route route = render::Route::Fragment;
    const Method* method = nullptr;  // null: the library
    int allowedPixels = 0;
};

std::vector<Drawing> drawingsOf(const std::vector<golden::Case>& rows) {
    std::vector<Drawing> drawings;
    for (const golden::Case& row : rows) {
        for (const render::RouteInfo& info : render::routes) {
            drawings.push_back({row, row.name + "_" + info.name, info.route, nullptr, 0});
        }
        for (const auto& [name, allowed] : row.methods) {
            drawings.push_back(
                {row, row.name + "_" + name, render::Route::Fragment, findMethod(name), allowed});
        }
    }
    return drawings;
}

class Checking {
public:
    Checking(const golden::Set& goldens, const GoldenCommand& command)
        : set(&goldens), shaders(command.device.shaders()), options(command.repeated()) {}

    void addAll(gpu::Context& context, std::span<const Drawing> drawings) {
        options::Progress progress("checking");
        std::map<const Method*, render::PipelineStore> pipelines;
        // The pipelines take most of the time: they are made several at once, while pictures are drawn.
        for (const Drawing& drawing : drawings) {
            golden::prepare(context, *set, drawing.row, drawing.route, shadersOf(drawing),
                            pipelines[drawing.method]);
        }
        for (const Drawing& drawing : drawings) {
            add(context, drawing, pipelines);
            progress.show(static_cast<double>(cases.size()) / static_cast<double>(drawings.size()));
        }
    }

    /// The folder as a whole. In the report it is a case of its own, with all that is wrong with it.
    void addFolder(const std::vector<std::string>& faults) {
        for (const std::string& fault : faults) {
            print("{}\n", fault);
        }
        if (!faults.empty()) {
            exitCode = golden::worse(exitCode, ExitCode::File);
            folder.push_back(golden::unchecked(set->folder().string(), ExitCode::File,
                                               fmt::format("{}", fmt::join(faults, "; ")))
                                 .report);
        }
    }

    /// What is wrong with the folder, what was judged, and what was to be and was not.
    [[nodiscard]] std::vector<report::ReportCase> reported(std::span<const Drawing> drawings) const {
        std::vector<report::ReportCase> all = folder;
        all.insert(all.end(), cases.begin(), cases.end());
        std::vector<std::string> labels;
        std::ranges::transform(drawings, std::back_inserter(labels), &Drawing::label);
        std::ranges::move(report::skippedCases(labels, cases), std::back_inserter(all));
        return all;
    }

    ExitCode exitCode = ExitCode::Ok;
    std::vector<report::ReportCase> cases;
    std::int64_t marginal = 0, flips = 0, failures = 0;

private:
    [[nodiscard]] const trace::ShaderSource& shadersOf(const Drawing& drawing) const {
        return drawing.method != nullptr ? drawing.method->shaders : shaders;
    }

    // pipelines: of each method, kept from one drawing to the next.
    void add(gpu::Context& context, const Drawing& drawing,
             std::map<const Method*, render::PipelineStore>& pipelines) {
        const auto start = std::chrono::steady_clock::now();
        golden::Checked checked = judged(context, drawing, pipelines[drawing.method]);
        report::ReportCase& report = checked.report;
        report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        report.catches = drawing.row.catches;
        report.explainCommand = options.explainCommand(set->scene(drawing.row));
        report.rerunCommand = options.checkCommand(drawing.row);
        report.renewCommand = options.renewCommand(drawing.row);
        count(checked);
        cases.push_back(std::move(checked.report));
    }

    // What is wrong with one case keeps none of the others from being judged.
    [[nodiscard]] golden::Checked judged(gpu::Context& context, const Drawing& drawing,
                                         render::PipelineStore& pipelines) const {
        try {
            const image::Image actual =
                golden::draw(context, *set, drawing.row, drawing.route, shadersOf(drawing), &pipelines);
            golden::Checked checked = golden::check(*set, drawing.row, drawing.label, actual,
                                                    drawing.allowedPixels, options.toleranceFactor);
            if (checked.report.passed && context.info().type == "CPU" && drawing.method == nullptr) {
                requireBits(checked, drawing, actual);
            }
            return checked;
        } catch (const Error& error) {
            if (!golden::isOfOneCase(error.exitCode)) {
                throw;
            }
            return golden::unchecked(drawing.label, error.exitCode, error.what());
        } catch (const std::bad_alloc&) {
            return golden::unchecked(drawing.label, ExitCode::OutOfMemory, "out of memory");
        }
    }

    void requireBits(golden::Checked& checked, const Drawing& drawing, const image::Image& actual) const {
        const auto fail = [&checked](ExitCode code, const char* verdict, const std::string& sentence) {
            checked.exitCode = code;
            checked.report.passed = false;
            checked.report.verdict = verdict;
            checked.report.sentence = sentence;
        };
        try {
            if (const std::string fault = golden::bitsFault(*set, drawing.row, actual); !fault.empty()) {
                fail(ExitCode::ComparisonFailed, "other bits",
                     fmt::format("{}; if that is as it should be: {}", fault, options.bitsCommand()));
            }
        } catch (const Error& error) {
            fail(error.exitCode, "error", error.what());
        }
    }

    void count(const golden::Checked& checked) {
        if (!checked.report.passed) {
            ++failures;
            exitCode = golden::worse(exitCode, checked.exitCode);
            print("{}: {}\n", checked.report.name, checked.report.sentence);
        }
        if (checked.report.comparison) {
            for (const compare::MarginalPixels& margin : checked.report.comparison->margins) {
                marginal += margin.count;
                flips += margin.flips;
            }
        }
    }

    const golden::Set* set;
    trace::ShaderSource shaders;
    golden::CheckOptions options;
    std::vector<report::ReportCase> folder;
};

ExitCode runCheck(const GoldenCommand& command) {
    const auto start = std::chrono::steady_clock::now();
    const golden::Set set(command.folder);
    const std::vector<golden::Case> rows = chosenCases(set, command.names);
    Checking checking(set, command);
    if (!command.report.empty()) {
        report::prepareReportFolder(command.report);
    }
    if (command.names.empty()) {
        checking.addFolder(golden::folderFaults(set));
    } else if (const std::string fault = golden::renewalFault(set); !fault.empty()) {
        checking.addFolder({fault});
    }
    report::ReportHeading heading{"Golden pictures", {{"raytorus", std::string(version())}}};
    if (command.toleranceFactor != 1.0F) {
        heading.facts.emplace_back("tolerance factor", fmt::format("{}", command.toleranceFactor));
    }
    const std::vector<Drawing> drawings = drawingsOf(rows);
    const auto report = [&](const char* fact, const std::string& text) {
        if (!command.report.empty()) {
            heading.facts.emplace_back(fact, text);
            report::writeReportFolder(command.report, checking.reported(drawings), heading);
        }
    };
    try {
        options::withDevice(command.device, [&](gpu::Context& context) {
            heading.facts.emplace_back("device", context.info().name);
            heading.facts.emplace_back("driver", context.info().driverInfo);
            checking.addAll(context, drawings);
        });
    } catch (const Error& error) {
        report("ended by", error.what());
        throw;
    }
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    report("seconds", fmt::format("{:.1f}", seconds));
    const std::string looser = command.toleranceFactor == 1.0F
                                   ? ""
                                   : fmt::format(" at {} times the rounding", command.toleranceFactor);
    print("{} of {} pictures of {} cases are right{}; {} of {} marginal pixels flip; {:.1f} s\n",
          static_cast<std::int64_t>(checking.cases.size()) - checking.failures, checking.cases.size(),
          rows.size(), looser, checking.flips, checking.marginal, seconds);
    return checking.exitCode;
}

ExitCode runRenew(const GoldenCommand& command) {
    golden::requireRenewal(command.reason);
    const golden::Set set(command.folder);
    if (command.names.empty() != command.all) {
        throw Error(ExitCode::Usage, "name the cases to renew, or all of them by --all");
    }
    const std::vector<golden::Case> rows = chosenCases(set, command.names);
    if (golden::recover(set)) {
        print("put back what a renewal that was ended in the middle had replaced\n");
    }
    std::vector<golden::Renewal> renewals;
    {
        options::Progress progress("rendering");
        renewals = golden::renew(set, rows, command.reason, [&](double done) { progress.show(done); });
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
        print("renewed {}: {} of {} pixels are marginal\n", set.truth(rows[i]).string(), renewals[i].marginal,
              renewals[i].pixels);
    }
    return ExitCode::Ok;
}

ExitCode runBits(const GoldenCommand& command) {
    golden::requireRenewal(command.reason);
    const golden::Set set(command.folder);
    golden::requireSound(set);
    requireWritable(set.bits());
    std::map<std::string, std::string> bits;
    options::withDevice(command.device, [&](gpu::Context& context) {
        if (context.info().type != "CPU") {
            throw Error(ExitCode::NoDevice,
                        fmt::format("{} promises no bits; a CPU does (--device)", context.info().name));
        }
        options::Progress progress("drawing");
        render::PipelineStore pipelines;
        const trace::ShaderSource shaders = command.device.shaders();
        for (const golden::Case& row : set.cases()) {
            const image::Image picture =
                golden::draw(context, set, row, render::Route::Fragment, shaders, &pipelines);
            const golden::Checked checked = golden::check(set, row, row.name, picture);
            if (!checked.report.passed) {
                throw Error(checked.exitCode, fmt::format("{}: {}", row.name, checked.report.sentence));
            }
            const image::Image again =
                golden::draw(context, set, row, render::Route::Compute, shaders, &pipelines);
            bits[row.name] = golden::pictureHash(picture);
            if (golden::pictureHash(again) != bits[row.name]) {
                throw Error(ExitCode::ComparisonFailed, fmt::format("{}: the two routes disagree", row.name));
            }
            progress.show(static_cast<double>(bits.size()) / static_cast<double>(set.cases().size()));
        }
    });
    golden::writeBits(set, bits, command.reason);
    print("wrote {}\n", set.bits().string());
    return ExitCode::Ok;
}

using Run = ExitCode (*)(const GoldenCommand&);

CLI::App& addSubcommand(CLI::App& golden, Action& action, const std::shared_ptr<GoldenCommand>& command,
                        const char* name, const char* description, Run run) {
    CLI::App& sub = *golden.add_subcommand(name, description);
    sub.add_option("--folder", command->folder, "The goldens")->option_text("DIR [golden]");
    sub.callback([command, &action, run] { action = [command, run] { return run(*command); }; });
    return sub;
}

}  // namespace

void addGoldenCommand(CLI::App& app, Action& action) {
    const auto command = std::make_shared<GoldenCommand>();
    CLI::App* golden = app.add_subcommand("golden", "Check pictures against their truths, or renew those");
    golden->require_subcommand(1);
    golden->footer(goldenFooter);
    addSubcommand(*golden, action, command, "list", "The cases, and what each is there to catch", runList);
    CLI::App& check = addSubcommand(*golden, action, command, "check",
                                    "Draw the cases by both routes and hold them to their truths", runCheck);
    check.add_option("cases", command->names, "Cases instead of all")->option_text("CASE...");
    check.add_option("--report", command->report, "Write a page with the pictures here")->option_text("DIR");
    check
        .add_option("--tolerance-factor", command->toleranceFactor,
                    "Each tolerance times F, 1 to 1000, for a device that rounds so loosely")
        ->check(options::decimalNumber(1.0, 1000.0))
        ->option_text("F [1]");
    options::addDeviceOptions(check, command->device);
    CLI::App& renew = addSubcommand(*golden, action, command, "renew",
                                    "Make the truths of the named cases anew, by the reference", runRenew);
    renew.add_option("cases", command->names, "The cases")->option_text("CASE...");
    renew.add_flag("--all", command->all, "All of them");
    renew.add_option("--reason", command->reason, "Why; kept beside the truth")
        ->required()
        ->option_text("TEXT REQUIRED");
    CLI::App& bits = addSubcommand(
        *golden, action, command, "bits",
        "Record the bits that CPU drivers draw, after the shaders were to change them", runBits);
    bits.add_option("--reason", command->reason, "Why; kept beside them")
        ->required()
        ->option_text("TEXT REQUIRED");
    options::addDeviceOptions(bits, command->device);
}

}  // namespace raytorus::cli
