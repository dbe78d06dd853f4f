// SPDX-License-Identifier: MIT
#include "compile/bounded_child.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <pthread.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <mutex>
#include <new>
#include <optional>
#include <span>

#include "core/descriptor.hpp"
#include "core/error.hpp"
#include "core/file.hpp"

namespace raytorus::compile {
namespace {

using Clock = std::chrono::steady_clock;

// How a child ends.
enum Ending : int { done = 0, tooMuchMemory = 61, tooLong = 62, noMemory = 63, unheard = 64 };

// Often enough that little more than the limit is ever taken: memory fills by some MB in a millisecond.
constexpr suseconds_t lookMicroseconds = 5000;

// The child's own, for its signal handler.
struct Watched {
    long mostKilobytes = 0;
    Clock::time_point end;
} watched;

long peakKilobytes() {
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    return used.ru_maxrss;
}

void look(int /*signal*/) {
    if (peakKilobytes() > watched.mostKilobytes) {
        _exit(tooMuchMemory);
    }
    if (Clock::now() > watched.end) {
        _exit(tooLong);
    }
}

// The child looks at itself, by a timer: so it is held to its limits even where its parent is stopped. Not by
// the system's own limits: that of address space is passed by the first step of a sanitizer, and none tells
// afterwards that it was the reason.
void watchOneself(const ChildLimits& limits) {
    watched.mostKilobytes = peakKilobytes() + static_cast<long>(limits.memoryBytes / 1024);
    watched.end = Clock::now() + limits.time;
    struct sigaction action {};
    action.sa_handler = look;
    action.sa_flags = SA_RESTART;
    sigaction(SIGALRM, &action, nullptr);
    const itimerval often{{0, lookMicroseconds}, {0, lookMicroseconds}};
    setitimer(ITIMER_REAL, &often, nullptr);
    std::set_new_handler([] { _exit(noMemory); });
}

// The handlers of this program remove its files and end it; a sanitizer's tell of the crash.
void forgetHandlers() {
    struct sigaction usual {};
    usual.sa_handler = SIG_DFL;
    for (int signal = 1; signal < NSIG; ++signal) {
        sigaction(signal, &usual, nullptr);
    }
}

// glslang calls itself once for each operand of a long expression, and an overflow of the stack cannot be
// caught. glslang 12.0 needs between 400 and 512 MiB for a sum that fills maxSourceBytes.
constexpr std::size_t stackBytes = std::size_t{1} << 30U;

void* runWork(void* work) {
    (*static_cast<const std::function<void()>*>(work))();
    return nullptr;
}

void runWithLargeStack(const std::function<void()>& work) {
    pthread_attr_t attributes;
    if (pthread_attr_init(&attributes) == 0) {
        pthread_t thread{};
        // pthread_create wants what it hands on without const; runWork puts the const back.
        void* argument = const_cast<std::function<void()>*>(&work);
        const bool started = pthread_attr_setstacksize(&attributes, stackBytes) == 0 &&
                             pthread_create(&thread, &attributes, runWork, argument) == 0;
        pthread_attr_destroy(&attributes);
        if (started) {
            pthread_join(thread, nullptr);
            return;
        }
    }
    work();
}

// Each message goes after its length. None stands at the end.
using Length = std::uint64_t;

[[noreturn]] void beChild(const std::function<void(const Tell&)>& work, int file, pid_t parent,
                          const ChildLimits& limits) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) {
        _exit(unheard);  // it ended before
    }
    prctl(PR_SET_DUMPABLE, 0);  // no core of all that the parent holds
    forgetHandlers();
    watchOneself(limits);
    sigset_t none;
    sigemptyset(&none);
    pthread_sigmask(SIG_SETMASK, &none, nullptr);
    const Tell tell = [file](std::string_view message) {
        const Length length = message.size();
        // Only if all was written, the child may say that it is done.
        if (!writeAll(file, std::as_bytes(std::span(&length, 1))) ||
            !writeAll(file, std::as_bytes(std::span(message)))) {
            _exit(unheard);
        }
    };
    runWithLargeStack([&] {
        work([&tell](std::string_view message) {
            if (!message.empty()) {
                tell(message);
            }
        });
    });
    tell({});
    _exit(done);
}

// All signals, so that none runs a handler of the parent in the child.
class BlockedSignals {
public:
    BlockedSignals() {
        sigset_t all;
        sigfillset(&all);
        pthread_sigmask(SIG_SETMASK, &all, &before);
    }
    BlockedSignals(const BlockedSignals&) = delete;
    BlockedSignals& operator=(const BlockedSignals&) = delete;
    ~BlockedSignals() { pthread_sigmask(SIG_SETMASK, &before, nullptr); }

private:
    sigset_t before{};
};

class Child {
public:
    Child(const std::function<void(const Tell&)>& work, const ChildLimits& limits) {
        // A child that inherits the writing end of another's pipe would keep it open.
        static std::mutex oneAtATime;
        const std::scoped_lock lock(oneAtATime);
        std::array<int, 2> ends{};
        if (pipe2(ends.data(), O_CLOEXEC) != 0) {
            refused(errno);
        }
        file = ends[0];
        const pid_t parent = getpid();
        int problem = 0;
        {
            const BlockedSignals blocked;
            process = fork();
            problem = errno;
            if (process == 0) {
                beChild(work, ends[1], parent, limits);
            }
        }
        close(ends[1]);
        if (process < 0) {
            close(file);
            refused(problem);
        }
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;
    ~Child() {
        close(file);
        if (process > 0) {
            kill(process, SIGKILL);
            static_cast<void>(end());
        }
    }

    // False at the end.
    [[nodiscard]] bool read(std::span<std::byte> room) const {
        return readAll(file, room) == static_cast<ssize_t>(room.size());
    }

    // Waits for it. Its status; none where the system keeps none, for a parent that does not want to know.
    std::optional<int> end() {
        int status = 0;
        pid_t ended = 0;
        do {
            ended = waitpid(process, &status, 0);
        } while (ended < 0 && errno == EINTR);
        process = -1;
        return ended > 0 ? std::optional(status) : std::nullopt;
    }

private:
    [[noreturn]] static void refused(int problem) {
        throw Error(ExitCode::OutOfMemory,
                    fmt::format("the system allows no more processes ({})", systemReason(problem)));
    }

    int file = -1;
    pid_t process = -1;
};

std::string sizeText(std::size_t bytes) {
    constexpr std::size_t gibibyte = std::size_t{1} << 30U;
    return bytes % gibibyte == 0 ? fmt::format("{} GiB", bytes / gibibyte)
                                 : fmt::format("{} MiB", bytes >> 20U);
}

std::string reasonOf(int status, const ChildLimits& limits) {
    if (WIFSIGNALED(status)) {
        return fmt::format("was ended by signal {} ({})", WTERMSIG(status), strsignal(WTERMSIG(status)));
    }
    switch (WEXITSTATUS(status)) {
        case tooMuchMemory:
            return fmt::format("takes more than {} of memory", sizeText(limits.memoryBytes));
        case tooLong:
            return fmt::format("takes longer than {} s", static_cast<double>(limits.time.count()) / 1000.0);
        case noMemory:
            return "takes more memory than there is";
        default:
            return fmt::format("ended with {}", WEXITSTATUS(status));
    }
}

}  // namespace

std::string runInChild(const std::function<void(const Tell&)>& work,
                       const std::function<void(std::string_view)>& hear, const ChildLimits& limits) {
    Child child(work, limits);
    std::string message;
    Length length = 1;
    while (length > 0 && child.read(std::as_writable_bytes(std::span(&length, 1)))) {
        message.resize(length);
        if (length > 0 && child.read(std::as_writable_bytes(std::span(message)))) {
            hear(message);
        }
    }
    const std::optional<int> status = child.end();
    if (length == 0) {
        return {};
    }
    return status ? reasonOf(*status, limits) : "ended too early";
}

}  // namespace raytorus::compile
