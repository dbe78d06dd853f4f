// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "cli/command.hpp"
#include "core/console.hpp"
#include "options/program.hpp"

namespace raytorus::cli {
namespace {

constexpr const char* programFooter = R"(Examples:
  raytorus render scenes/chain.json -o chain.png
  raytorus trace rays.csv -o hits.csv --torus 1,0.25
  raytorus compare golden.exr new.exr --tolerance 1e-5
  raytorus explain --torus 1,0.25 --origin 3,0,0 --direction -1,0,0.05
  raytorus golden check
  raytorus doctor

Exit codes:
   0  ok
   1  internal error
   2  comparison failed
   3  size or channels differ
   4  file missing, damaged or not writable
   5  wrong command line
   6  invalid scene
   7  shader refused
   8  no suitable device
   9  out of memory
  10  device lost or time-out
  11  validation message
  12  NaN or infinity in a picture)";

// What CLI11 says, but for what it says too little of: it finds a positional argument missing before it finds
// that what stands in its place is an option, or a command, which does not exist.
std::string usageProblem(const CLI::App& app, const CLI::ParseError& error,
                         const std::vector<std::string>& arguments) {
    const auto type = static_cast<CLI::ExitCodes>(error.get_exit_code());
    const bool incomplete = type == CLI::ExitCodes::RequiredError || type == CLI::ExitCodes::ExtrasError;
    const std::string unknown = incomplete ? options::unexpected(app, arguments) : "";
    if (!unknown.empty() && arguments.front() != "--") {
        return unknown;
    }
    const std::string missing = incomplete ? options::missingCommand(app) : "";
    return missing.empty() ? error.what() : missing;
}

// The command whose --help tells more.
std::string helpOf(const CLI::App& app) {
    const std::vector<CLI::App*> commands = app.get_subcommands();
    return fmt::format("raytorus {}--help", commands.empty() ? "" : commands.front()->get_name() + " ");
}

ExitCode parseAndRun(const std::vector<std::string>& arguments) {
    CLI::App app("Exact ray-torus intersection: render scenes, trace rays, compare pictures, explain a ray.",
                 "raytorus");
    app.set_version_flag("--version", fmt::format("raytorus {}", version()));
    app.require_subcommand(1);
    app.footer(programFooter);
    Action action;
    addRenderCommand(app, action);
    addTraceCommand(app, action);
    addCompareCommand(app, action);
    addExplainCommand(app, action);
    addGoldenCommand(app, action);
    addDoctorCommand(app, action);
    try {
        app.parse(std::vector<std::string>(arguments.rbegin(),
                                           arguments.rend()));  // CLI11 takes them from the back
    } catch (const CLI::Success& success) {                     // --help, --version
        app.exit(success);
        return ExitCode::Ok;
    } catch (const CLI::ParseError& error) {
        throw Error(ExitCode::Usage,
                    fmt::format("{} (see {})", usageProblem(app, error, arguments), helpOf(app)));
    }
    options::refuseEmptyWords(app);
    return action();
}

}  // namespace

ExitCode runCommandLine(const std::vector<std::string>& arguments) {
    return options::runProgram("raytorus", [&arguments] { return parseAndRun(arguments); });
}

}  // namespace raytorus::cli
