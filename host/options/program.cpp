// SPDX-License-Identifier: MIT
#include "options/program.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <system_error>

#include "core/console.hpp"
#include "core/output_file.hpp"
#include "core/suggestion.hpp"

namespace raytorus::options {
namespace {

// What has several lines, as a shader's errors, goes on indented: a file's name cannot have a line that looks
// like one of ours.
ExitCode fail(std::string_view name, ExitCode code, std::string_view message) {
    std::string text;
    for (const char c : message) {
        text += text.ends_with('\n') && c != ' ' ? "  " : "";
        text += c;
    }
    writeError(fmt::format("{}: {}\n", name, text));
    return code;
}

// What is opened next would get the number of a standard stream that the caller has closed, and what is said
// would go there. From this nothing can be read, and to it nothing written.
void holdStandardStreams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (fcntl(stream, F_GETFD) < 0) {
            static_cast<void>(open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY));
        }
    }
}

}  // namespace

ExitCode runProgram(std::string_view name, const std::function<ExitCode()>& work) {
    holdStandardStreams();
    cleanUpOnSignals();
    try {
        const ExitCode code = work();
        flushOutput();
        return code;
    } catch (const Error& error) {
        return fail(name, error.exitCode, error.what());
    } catch (const std::bad_alloc&) {
        return fail(name, ExitCode::OutOfMemory, "out of memory");
    } catch (const std::system_error& error) {
        const bool threads = error.code() == std::errc::resource_unavailable_try_again;
        return threads ? fail(name, ExitCode::OutOfMemory, "the system allows no more threads")
                       : fail(name, ExitCode::Internal, fmt::format("internal error: {}", error.what()));
    } catch (const std::exception& error) {
        return fail(name, ExitCode::Internal, fmt::format("internal error: {}", error.what()));
    }
}

namespace {

// "there is no option --sise; did you mean --size?"
std::string unknownOption(const CLI::App& app, const std::string& word) {
    const std::string name = word.substr(0, word.find('='));
    std::vector<std::string> known;
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& longName : option->get_lnames()) {
            known.push_back("--" + longName);
        }
    }
    if (std::ranges::find(known, name) != known.end()) {
        return fmt::format("{} stands behind the command {}", name, app.get_name());
    }
    return fmt::format("there is no option {}{}", excerpt(name), suggestion(name, known));
}

const CLI::App& chosenCommand(const CLI::App& app) {
    const std::vector<CLI::App*> chosen = app.get_subcommands();
    return chosen.empty() ? app : chosenCommand(*chosen.back());
}

std::vector<std::string> commandsOf(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
        names.push_back(command->get_name());
    }
    return names;
}

}  // namespace

std::string missingCommand(const CLI::App& app) {
    const std::vector<std::string> names = commandsOf(chosenCommand(app));
    return names.empty() ? "" : fmt::format("a command is missing: {}", fmt::join(names, ", "));
}

std::string unexpected(const CLI::App& app, const std::vector<std::string>& arguments) {
    std::vector<std::string> unknown = app.remaining(true);
    std::erase(unknown, "--");
    if (unknown.empty()) {
        return "";
    }
    const CLI::App& command = chosenCommand(app);
    const std::string& first = unknown.front();
    const auto end = std::ranges::find(arguments, "--");
    const bool isName = std::find(arguments.begin(), end, first) == end;
    if (!isName && first.starts_with('-')) {
        return unknownOption(command, first);
    }
    const std::vector<std::string> commands = commandsOf(command);
    if (!isName && !commands.empty()) {
        return fmt::format("there is no command \"{}\"{}", excerpt(first), suggestion(first, commands));
    }
    return fmt::format("\"{}\" is one argument too many", excerpt(first));
}

void refuseEmptyWords(const CLI::App& app) {
    for (const CLI::Option* option : app.get_options()) {
        if (std::ranges::find(option->results(), "") != option->results().end()) {
            throw Error(ExitCode::Usage, fmt::format("{} is given, and is empty", option->get_name()));
        }
    }
    for (const CLI::App* command : app.get_subcommands()) {
        refuseEmptyWords(*command);
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
        const std::string unknown = unexpected(app, arguments);
        throw Error(ExitCode::Usage, fmt::format("{} (see {} --help)",
                                                 unknown.empty() ? error.what() : unknown, app.get_name()));
    }
    refuseEmptyWords(app);
    return true;
}

int exitStatus(ExitCode code) {
    if (code == ExitCode::DeviceLost) {
        std::fflush(nullptr);
        std::_Exit(static_cast<int>(code));
    }
    return static_cast<int>(code);
}

}  // namespace raytorus::options
