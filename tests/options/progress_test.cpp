// SPDX-License-Identifier: MIT
// The progress bar: on a terminal after half a second, and never in a file or a pipe.
#include "options/progress.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <thread>

namespace raytorus::options {
namespace {

// Standard error goes to a file of ours for as long as this lives.
class StandardErrorTo {
public:
    explicit StandardErrorTo(int file) : saved(dup(STDERR_FILENO)) {
        std::fflush(stderr);
        dup2(file, STDERR_FILENO);
    }
    StandardErrorTo(const StandardErrorTo&) = delete;
    StandardErrorTo& operator=(const StandardErrorTo&) = delete;
    ~StandardErrorTo() {
        std::fflush(stderr);
        dup2(saved, STDERR_FILENO);
        close(saved);
    }

private:
    int saved;
};

// What is in `file` before `end`. A terminal hands on what is written to it a moment later, so to ask what
// is there already may find a part of it. Nothing more comes after an end of file.
std::string readUntil(int file, std::string_view end) {
    std::string text;
    std::array<char, 4096> buffer{};
    while (end.empty() || !text.ends_with(end)) {
        const ssize_t count = read(file, buffer.data(), buffer.size());
        if (count <= 0) {
            return text;
        }
        text.append(buffer.data(), static_cast<std::size_t>(count));
    }
    return text.substr(0, text.size() - end.size());
}

// Half a second of work shows nothing yet. To sleep for longer asks nothing of the machine's speed.
void showHalfDone(int file) {
    const StandardErrorTo redirected(file);
    Progress progress("working");
    std::this_thread::sleep_for(std::chrono::milliseconds(600));
    progress.show(0.5);
}

struct Terminal {
    Terminal() {
        grantpt(master);
        unlockpt(master);
        slave = open(ptsname(master), O_RDWR | O_NOCTTY);
    }
    Terminal(const Terminal&) = delete;
    Terminal& operator=(const Terminal&) = delete;
    ~Terminal() {
        close(slave);
        close(master);
    }

    int master = posix_openpt(O_RDWR | O_NOCTTY);
    int slave = -1;
};

TEST(Progress, IsDrawnOnATerminalAndClearedAtTheEnd) {
    const Terminal terminal;
    ASSERT_GE(terminal.slave, 0);
    showHalfDone(terminal.slave);
    constexpr std::string_view last = "(no more)";
    ASSERT_EQ(write(terminal.slave, last.data(), last.size()), static_cast<ssize_t>(last.size()));
    const std::string text = readUntil(terminal.master, last);
    EXPECT_NE(text.find("working [################................]  50 %"), std::string::npos) << text;
    EXPECT_TRUE(text.ends_with("\r\033[K")) << text;
}

TEST(Progress, DrawsNothingIntoAPipe) {
    std::array<int, 2> ends{};
    ASSERT_EQ(pipe(ends.data()), 0);
    showHalfDone(ends[1]);
    close(ends[1]);
    EXPECT_EQ(readUntil(ends[0], ""), "");
    close(ends[0]);
}

}  // namespace
}  // namespace raytorus::options
