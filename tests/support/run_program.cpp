// SPDX-License-Identifier: MIT
#include "run_program.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <string_view>
#include <system_error>
#include <utility>

extern char** environ;

namespace raytorus::test {
namespace {

void require(int problem, const char* call) {
    if (problem != 0) {
        throw std::system_error(problem, std::generic_category(), call);
    }
}

// Both ends close by themselves, and neither is seen by the program but where we put it.
class Pipe {
public:
    Pipe() { require(pipe2(ends.data(), O_CLOEXEC) == 0 ? 0 : errno, "pipe2"); }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    ~Pipe() {
        close(ends[0]);
        closeWriteEnd();
    }

    [[nodiscard]] int readEnd() const { return ends[0]; }
    [[nodiscard]] int writeEnd() const { return ends[1]; }
    void closeWriteEnd() {
        if (ends[1] >= 0) {
            close(std::exchange(ends[1], -1));
        }
    }

private:
    std::array<int, 2> ends{};
};

std::vector<std::string> environmentWith(const Environment& changes) {
    std::vector<std::string> variables;
    for (char** variable = environ; *variable != nullptr; ++variable) {
        const std::string_view text(*variable);
        if (!changes.contains(std::string(text.substr(0, text.find('='))))) {
            variables.emplace_back(text);
        }
    }
    for (const auto& [name, value] : changes) {
        variables.push_back(name + "=" + value);
    }
    return variables;
}

// As exec wants them; the texts must outlive the result.
std::vector<char*> pointersTo(std::vector<std::string>& texts) {
    std::vector<char*> pointers;
    for (std::string& text : texts) {
        pointers.push_back(text.data());
    }
    pointers.push_back(nullptr);
    return pointers;
}

pid_t spawn(std::vector<std::string> command, const ProgramSettings& settings, const Pipe& out,
            const Pipe& err) {
    std::vector<std::string> variables = environmentWith(settings.environment);
    const std::vector<char*> arguments = pointersTo(command);
    const std::vector<char*> environment = pointersTo(variables);
    posix_spawn_file_actions_t actions;
    require(posix_spawn_file_actions_init(&actions), "posix_spawn_file_actions_init");
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, out.writeEnd(), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, err.writeEnd(), STDERR_FILENO);
    if (!settings.folder.empty()) {
        posix_spawn_file_actions_addchdir_np(&actions, settings.folder.c_str());
    }
    pid_t child = 0;
    const int problem =
        posix_spawn(&child, command.front().c_str(), &actions, nullptr, arguments.data(), environment.data());
    posix_spawn_file_actions_destroy(&actions);
    require(problem, "posix_spawn");
    return child;
}

// Appends what is there to read. False at the end.
bool readSome(int file, std::string& text) {
    std::array<char, 65536> buffer{};
    const ssize_t count = read(file, buffer.data(), buffer.size());
    text.append(buffer.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    return count > 0 || (count < 0 && errno == EINTR);
}

// Reads both until the program closes them, which it does by ending. False if the time is over first.
bool readUntil(std::chrono::steady_clock::time_point deadline, const Pipe& out, const Pipe& err,
               ProgramResult& result) {
    std::array<pollfd, 2> files = {pollfd{out.readEnd(), POLLIN, 0}, pollfd{err.readEnd(), POLLIN, 0}};
    const std::array<std::string*, 2> texts = {&result.out, &result.err};
    while (files[0].fd >= 0 || files[1].fd >= 0) {
        const auto left =
            std::chrono::ceil<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now());
        if (left.count() <= 0) {
            return false;
        }
        poll(files.data(), files.size(), static_cast<int>(left.count()));
        for (std::size_t i = 0; i < files.size(); ++i) {
            if (files[i].revents != 0 && !readSome(files[i].fd, *texts[i])) {
                files[i].fd = -1;  // poll() passes over it
            }
            files[i].revents = 0;
        }
    }
    return true;
}

}  // namespace

ProgramResult runProgram(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                         const ProgramSettings& settings) {
    std::vector<std::string> command = {program.string()};
    command.insert(command.end(), arguments.begin(), arguments.end());
    Pipe out;
    Pipe err;
    const auto deadline = std::chrono::steady_clock::now() + settings.timeLimit;
    const pid_t child = spawn(std::move(command), settings, out, err);
    out.closeWriteEnd();
    err.closeWriteEnd();
    ProgramResult result;
    if (!readUntil(deadline, out, err, result)) {
        kill(child, SIGKILL);
        result.err += "\n(killed: it did not end in time)";
    }
    int status = 0;
    rusage usage{};
    while (wait4(child, &status, 0, &usage) < 0 && errno == EINTR) {
    }
    result.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    result.peakMemory = static_cast<std::size_t>(usage.ru_maxrss) * 1024;
    return result;
}

void PrintTo(const ProgramResult& result, std::ostream* stream) {
    *stream << "exit code " << result.exitCode << "\nstandard output: " << result.out
            << "\nstandard error: " << result.err;
}

}  // namespace raytorus::test
