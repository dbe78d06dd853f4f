// SPDX-License-Identifier: MIT
#include "cli/program.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <new>

namespace raytorus::cli {
namespace {

ExitCode fail(std::string_view name, ExitCode code, std::string_view message) {
    fmt::print(stderr, "{}: {}\n", name, message);
    return code;
}

}  // namespace

ExitCode runProgram(std::string_view name, const std::function<ExitCode()>& work) {
    try {
        return work();
    } catch (const Error& error) {
        return fail(name, error.exitCode, error.what());
    } catch (const std::bad_alloc&) {
        return fail(name, ExitCode::OutOfMemory, "out of memory");
    } catch (const std::exception& error) {
        return fail(name, ExitCode::Internal, fmt::format("internal error: {}", error.what()));
    }
}

bool parse(CLI::App& app, const std::vector<std::string>& arguments) {
    try {
        app.parse(std::vector<std::string>(arguments.rbegin(),
                                           arguments.rend()));  // CLI11 takes them from the back
    } catch (const CLI::Success& success) {
        app.exit(success);
        return false;
    } catch (const CLI::ParseError& error) {
        throw Error(ExitCode::Usage, fmt::format("{} (see {} --help)", error.what(), app.get_name()));
    }
    return true;
}

int exitStatus(ExitCode code) {
    if (code == ExitCode::DeviceLost) {
        std::fflush(nullptr);
        std::_Exit(static_cast<int>(code));
    }
    return static_cast<int>(code);
}

}  // namespace raytorus::cli
