// SPDX-License-Identifier: MIT
// Work in a process of its own: what it tells arrives, and no end of it is missed or waits for another's.
#include "compile/bounded_child.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <filesystem>
#include <list>
#include <stdexcept>
#include <thread>
#include <vector>

#include "support/scratch_folder.hpp"

namespace raytorus::compile {
namespace {

using namespace std::chrono_literals;

struct Ended {
    std::string reason;
    std::vector<std::string> heard;
};

Ended run(const std::function<void(const Tell&)>& work, ChildLimits limits = {}) {
    Ended ended;
    ended.reason = runInChild(
        work, [&](std::string_view message) { ended.heard.emplace_back(message); }, limits);
    return ended;
}

std::ptrdiff_t openFiles() {
    const std::filesystem::directory_iterator files("/proc/self/fd");
    return std::distance(begin(files), end(files));
}

// A test of what a child is leaves neither a child nor a descriptor behind.
class BoundedChild : public testing::Test {
protected:
    BoundedChild() : filesBefore(openFiles()) {}
    ~BoundedChild() override {
        EXPECT_EQ(openFiles(), filesBefore);
        EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1) << "a child is left";
        EXPECT_EQ(errno, ECHILD);
    }

    std::ptrdiff_t filesBefore;
};

// Memory that is used, so that it counts.
[[noreturn]] void takeMemory() {
    std::list<std::string> taken;
    for (;;) {
        taken.emplace_back(1 << 20, 'x');
    }
}

[[noreturn]] void waitForever() {
    for (;;) {
        pause();
    }
}

TEST_F(BoundedChild, TellsAllThatItHasToTell) {
    const std::string large(10'000'000, 'l');
    const Ended ended = run([&](const Tell& tell) {
        tell("first");
        tell(std::string_view("\0second\n", 8));
        tell(large);
    });
    EXPECT_EQ(ended.reason, "");
    ASSERT_EQ(ended.heard.size(), 3U);
    EXPECT_EQ(ended.heard[0], "first");
    EXPECT_EQ(ended.heard[1], std::string("\0second\n", 8));
    EXPECT_TRUE(ended.heard[2] == large);
}

TEST_F(BoundedChild, ChangesNothingHere) {
    int number = 1;
    EXPECT_EQ(run([&](const Tell&) { number = 2; }).reason, "");
    EXPECT_EQ(number, 1);
}

TEST_F(BoundedChild, IsHeldToItsMemory) {
    const std::vector<char> before(300 << 20, 'x');  // what was there does not count
    const Ended ended = run(
        [](const Tell& tell) {
            tell("told");
            takeMemory();
        },
        {.memoryBytes = 100 << 20});
    EXPECT_EQ(ended.reason, "takes more than 100 MiB of memory");
    EXPECT_EQ(ended.heard, std::vector<std::string>{"told"});
    EXPECT_EQ(
        run([](const Tell&) { const std::vector<char> some(50 << 20, 'x'); }, {.memoryBytes = 100 << 20})
            .reason,
        "");
}

TEST_F(BoundedChild, IsHeldToItsTime) {
    const auto began = std::chrono::steady_clock::now();
    const Ended ended = run(
        [](const Tell& tell) {
            tell("told");
            waitForever();
        },
        {.time = 200ms});
    EXPECT_EQ(ended.reason, "takes longer than 0.2 s");
    EXPECT_EQ(ended.heard, std::vector<std::string>{"told"});
    EXPECT_GE(std::chrono::steady_clock::now() - began, 200ms);
    EXPECT_LT(std::chrono::steady_clock::now() - began, 10s);
}

TEST_F(BoundedChild, ThatCrashesOrIsKilledSaysSo) {
    for (const auto& [signal, name] : {std::pair(SIGSEGV, "was ended by signal 11 (Segmentation fault)"),
                                       {SIGABRT, "was ended by signal 6 (Aborted)"},
                                       {SIGKILL, "was ended by signal 9 (Killed)"}}) {
        const Ended ended = run([signal = signal](const Tell& tell) {
            tell("told");
            raise(signal);
        });
        EXPECT_EQ(ended.reason, name);
        EXPECT_EQ(ended.heard, std::vector<std::string>{"told"});
    }
    EXPECT_EQ(run([](const Tell&) { _exit(3); }).reason, "ended with 3");
    EXPECT_EQ(run([](const Tell&) { _exit(0); }).reason, "ended with 0") << "before it had done its work";
}

std::atomic<int> handled = 0;

// The program removes what it has half written at a signal. That is not the child's to do.
TEST_F(BoundedChild, HasNoHandlersOfThisProgram) {
    const auto before = signal(SIGTERM, [](int) {
        ++handled;
        _exit(7);
    });
    EXPECT_EQ(run([](const Tell&) {
                  raise(SIGTERM);
                  waitForever();
              }).reason,
              "was ended by signal 15 (Terminated)");
    signal(SIGTERM, before);
    EXPECT_EQ(handled, 0);
}

// A program that is started by one that ignores its children does so, too.
TEST_F(BoundedChild, WhereChildrenAreIgnored) {
    const auto before = signal(SIGCHLD, SIG_IGN);
    EXPECT_EQ(run([](const Tell& tell) { tell("told"); }).reason, "");
    EXPECT_EQ(run([](const Tell&) { raise(SIGKILL); }).reason, "ended too early");
    signal(SIGCHLD, before);
}

TEST_F(BoundedChild, SignalsHereDoNotDisturb) {
    struct sigaction count {};  // without SA_RESTART: what waits is interrupted
    struct sigaction before {};
    count.sa_handler = [](int) { ++handled; };
    sigaction(SIGUSR1, &count, &before);
    std::atomic<bool> over = false;
    const pthread_t here = pthread_self();
    std::thread sender([&] {
        while (!over) {
            pthread_kill(here, SIGUSR1);
            std::this_thread::sleep_for(100us);
        }
    });
    const Ended ended = run([](const Tell& tell) {
        for (int i = 0; i < 100; ++i) {
            tell(std::string(1000, 'x'));
            usleep(1000);
        }
    });
    over = true;
    sender.join();
    sigaction(SIGUSR1, &before, nullptr);
    EXPECT_EQ(ended.reason, "");
    EXPECT_EQ(ended.heard, std::vector<std::string>(100, std::string(1000, 'x')));
    EXPECT_GT(handled, 0);
}

TEST_F(BoundedChild, IsEndedWhereNobodyListens) {
    const auto work = [](const Tell& tell) {
        tell("told");
        waitForever();
    };
    const auto began = std::chrono::steady_clock::now();
    EXPECT_THROW(
        static_cast<void>(runInChild(work, [](std::string_view) { throw std::runtime_error("enough"); }, {})),
        std::runtime_error);
    EXPECT_LT(std::chrono::steady_clock::now() - began, 10s);
}

// The sanitizer's allocator does not outlive a fork beside threads that use it.
#ifndef __SANITIZE_ADDRESS__
TEST_F(BoundedChild, ManyAtOnceDoNotWaitForOneAnother) {
    const auto began = std::chrono::steady_clock::now();
    std::vector<std::thread> threads;
    std::atomic<int> right = 0;
    for (int i = 0; i < 8; ++i) {
        threads.emplace_back([&right, i] {
            const bool waits = i % 2 == 0;
            const Ended ended = run(
                [&](const Tell& tell) {
                    tell(std::string(200'000, static_cast<char>('a' + i)));
                    if (waits) {
                        waitForever();
                    }
                },
                {.time = 2s});
            const bool late = std::string(ended.reason) == "takes longer than 2 s";
            right += late == waits && ended.heard.size() == 1 && ended.heard[0].size() == 200'000 ? 1 : 0;
        });
    }
    std::ranges::for_each(threads, [](std::thread& thread) { thread.join(); });
    EXPECT_EQ(right, 8);
    EXPECT_LT(std::chrono::steady_clock::now() - began, 7s) << "four that wait for one another take 8 s";
}
#endif

// A program in the middle of a compilation is killed: no child of it goes on.
TEST_F(BoundedChild, EndsWithItsProgram) {
    const auto folder = test::scratchFolder();
    const auto file = folder / "child";
    for (const int how : {SIGKILL, SIGTERM, SIGINT}) {
        std::filesystem::remove(file);
        const pid_t program = fork();
        if (program == 0) {
            signal(how, SIG_DFL);
            static_cast<void>(run([&](const Tell&) {
                test::writeText(folder / "part", std::to_string(getpid()));
                std::filesystem::rename(folder / "part", file);
                waitForever();
            }));
            _exit(0);
        }
        for (int i = 0; i < 1000 && !std::filesystem::exists(file); ++i) {
            std::this_thread::sleep_for(10ms);
        }
        const pid_t child = std::stoi(test::fileText(file));
        EXPECT_EQ(kill(child, 0), 0);
        kill(program, how);
        EXPECT_EQ(waitpid(program, nullptr, 0), program);
        // It has no parent any more; who inherits it may take a while to bury it.
        const auto alive = [child] {
            const std::string path = "/proc/" + std::to_string(child) + "/stat";
            if (kill(child, 0) != 0 || !std::filesystem::exists(path)) {
                return false;
            }
            const std::string stat = test::fileText(path);
            return stat.find(") Z ") == std::string::npos && !stat.empty();
        };
        for (int i = 0; i < 300 && alive(); ++i) {
            std::this_thread::sleep_for(10ms);
        }
        EXPECT_FALSE(alive()) << how;
    }
}

}  // namespace
}  // namespace raytorus::compile
