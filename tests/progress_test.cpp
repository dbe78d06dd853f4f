// SPDX-License-Identifier: MIT
// The progress bar: on a terminal after half a second, and never in a file or a pipe.
#include "cli/progress.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>

namespace raytorus::cli {
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

std::string readWhatIsThere(int file) {
    fcntl(file, F_SETFL, O_NONBLOCK);
    std::array<char, 4096> buffer{};
    const ssize_t count = read(file, buffer.data(), buffer.size());
    return {buffer.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0))};
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
    const std::string text = readWhatIsThere(terminal.master);
    EXPECT_NE(text.find("working [################................]  50 %"), std::string::npos) << text;
    EXPECT_TRUE(text.ends_with("\r\033[K")) << text;
}

TEST(Progress, DrawsNothingIntoAPipe) {
    std::array<int, 2> ends{};
    ASSERT_EQ(pipe(ends.data()), 0);
    showHalfDone(ends[1]);
    EXPECT_EQ(readWhatIsThere(ends[0]), "");
    close(ends[0]);
    close(ends[1]);
}

}  // namespace
}  // namespace raytorus::cli
