// SPDX-License-Identifier: MIT
// A program that runs while a test talks to it: what it prints is read line by line.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

#include "support/run_program.hpp"

namespace raytorus::test {

class LiveProcess {
public:
    /// How long a test waits for what has to come. Long, since machines are slow at times and nothing is
    /// measured by it.
    static constexpr std::chrono::seconds patience{90};

    /// Starts it in `settings.folder`. Its standard error goes to the file `errors`. It is killed when the
    /// process of the tests dies, whichever way. Throws std::system_error.
    LiveProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                const ProgramSettings& settings, std::filesystem::path errors);
    LiveProcess(const LiveProcess&) = delete;
    LiveProcess& operator=(const LiveProcess&) = delete;
    /// Kills it if it still runs.
    ~LiveProcess();

    using Clock = std::chrono::steady_clock;

    /// The next line of its standard output; nothing when it has closed it. Throws std::runtime_error if
    /// there is none by then.
    std::optional<std::string> readLine(Clock::time_point deadline = Clock::now() + patience);

    /// Its exit code, or minus the signal's number. Throws std::runtime_error, and kills it, if it does not
    /// end.
    int wait();

    /// What it has said on standard error by now.
    [[nodiscard]] std::string errorText() const;

private:
    void kill() noexcept;

    std::filesystem::path errorFile;
    pid_t child = -1;
    int output = -1;
    std::string unread;
};

}  // namespace raytorus::test
