// SPDX-License-Identifier: MIT
#include "window_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace raytorus::test {
namespace {

// Through env, which sets the variables and then becomes the program.
std::vector<std::string> commandOf(const std::filesystem::path& program,
                                   const std::vector<std::string>& arguments,
                                   const Environment& environment) {
    std::vector<std::string> command = {"/usr/bin/env"};
    for (const auto& [name, value] : environment) {
        command.push_back(name + "=" + value);
    }
    command.push_back(program.string());
    command.insert(command.end(), arguments.begin(), arguments.end());
    return command;
}

// Between fork and exec: system calls only.
[[noreturn]] void become(char* const* command, const char* folder, const char* errors, int output,
                         pid_t parent) {
    const int errorOutput = open(errors, O_WRONLY | O_CREAT | O_TRUNC, 0644);
    const int input = open("/dev/null", O_RDONLY);
    const bool ready = prctl(PR_SET_PDEATHSIG, SIGKILL) == 0 && getppid() == parent && errorOutput >= 0 &&
                       dup2(input, STDIN_FILENO) >= 0 && dup2(output, STDOUT_FILENO) >= 0 &&
                       dup2(errorOutput, STDERR_FILENO) >= 0 && (*folder == '\0' || chdir(folder) == 0);
    if (ready) {
        execv(command[0], command);
    }
    _exit(127);
}

}  // namespace

LiveProcess::LiveProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                         const ProgramSettings& settings, std::filesystem::path errors)
    : errorFile(std::move(errors)) {
    std::vector<std::string> command = commandOf(program, arguments, settings.environment);
    std::vector<char*> pointers;
    for (std::string& word : command) {
        pointers.push_back(word.data());
    }
    pointers.push_back(nullptr);
    const std::string folder = settings.folder.string();
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) {
        throw std::system_error(errno, std::generic_category(), "pipe2");
    }
    const pid_t parent = getpid();
    child = fork();
    if (child == 0) {
        become(pointers.data(), folder.c_str(), errorFile.c_str(), ends[1], parent);
    }
    close(ends[1]);
    output = ends[0];
    if (child < 0) {
        close(output);
        throw std::system_error(errno, std::generic_category(), "fork");
    }
}

LiveProcess::~LiveProcess() {
    kill();
    close(output);
}

void LiveProcess::kill() noexcept {
    if (child > 0) {
        ::kill(child, SIGKILL);
        while (waitpid(child, nullptr, 0) < 0 && errno == EINTR) {
        }
        child = -1;
    }
}

std::optional<std::string> LiveProcess::readLine(Clock::time_point deadline) {
    for (;;) {
        if (const std::size_t end = unread.find('\n'); end != std::string::npos) {
            std::string line = unread.substr(0, end);
            unread.erase(0, end + 1);
            return line;
        }
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now());
        if (left.count() <= 0) {
            throw std::runtime_error("the program printed no line in time");
        }
        pollfd file{output, POLLIN, 0};
        if (poll(&file, 1, static_cast<int>(left.count())) <= 0) {
            continue;
        }
        std::array<char, 65536> buffer{};
        const ssize_t count = read(output, buffer.data(), buffer.size());
        if (count == 0) {
            return std::nullopt;
        }
        unread.append(buffer.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    }
}

int LiveProcess::wait() {
    // The pid is the child's until waitpid() has taken it, so a file for it is sure to be of this process.
    pollfd ended{static_cast<int>(syscall(SYS_pidfd_open, child, 0)), POLLIN, 0};
    const auto milliseconds = std::chrono::duration_cast<std::chrono::milliseconds>(patience).count();
    const int found = poll(&ended, 1, static_cast<int>(milliseconds));
    close(ended.fd);
    if (found <= 0) {
        kill();
        throw std::runtime_error("the program did not end in time, and was killed");
    }
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    child = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

std::string LiveProcess::errorText() const {
    std::ifstream file(errorFile, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

}  // namespace raytorus::test
