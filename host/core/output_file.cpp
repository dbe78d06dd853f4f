// SPDX-License-Identifier: MIT
#include "core/output_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstring>
#include <map>
#include <mutex>
#include <random>
#include <set>
#include <string>
#include <system_error>
#include <utility>

#include "core/descriptor.hpp"
#include "core/error.hpp"
#include "core/file.hpp"

namespace raytorus {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t bufferBytes = std::size_t{1} << 16U;
constexpr std::size_t randomDigits = 16;
// The system's longest name, without the two points and the random digits of a temporary one.
constexpr std::size_t longestStem = NAME_MAX - 2 - randomDigits;

// The files that a signal removes. A signal's handler may take no lock, so each place says who has it.
enum Place : int { Free, Filling, Full };
struct Unfinished {
    std::atomic<int> state = Free;
    std::array<char, PATH_MAX> path{};
};
constexpr std::size_t mostUnfinished = 64;
std::array<Unfinished, mostUnfinished> unfinished;

// mostUnfinished where all are taken, or the path is too long: a signal leaves that file.
std::size_t remember(const std::string& path) {
    for (std::size_t i = 0; i < mostUnfinished && path.size() < PATH_MAX; ++i) {
        int free = Free;
        if (unfinished[i].state.compare_exchange_strong(free, Filling)) {
            std::memcpy(unfinished[i].path.data(), path.c_str(), path.size() + 1);
            unfinished[i].state = Full;
            return i;
        }
    }
    return mostUnfinished;
}

void forget(std::size_t place) {
    if (place < mostUnfinished) {
        unfinished[place].state = Free;
    }
}

extern "C" void removeUnfinished(int number) {
    removeUnfinishedFiles();
    // SA_RESETHAND: the signal now does what it does by itself.
    raise(number);
}

// Hidden, and in the target's folder so that renaming is atomic: ".name.", and random digits.
std::string temporaryStem(const fs::path& target) {
    return "." + target.filename().string().substr(0, longestStem) + ".";
}

bool isTemporaryOf(const std::string& stem, const std::string& name) {
    return name.size() == stem.size() + randomDigits && name.starts_with(stem) &&
           name.find_first_not_of("0123456789abcdef", stem.size()) == std::string::npos;
}

// Names that begin and end as those of temporary files, in a folder as it was when this process first wrote
// there: to look again for each of many files would take a time that grows with their square.
const std::set<std::string>& leftIn(const fs::path& folder) {
    static std::mutex mutex;
    static std::map<fs::path, std::set<std::string>> found;
    const std::scoped_lock lock(mutex);
    const auto [place, isNew] = found.try_emplace(folder);
    std::error_code none;
    for (fs::directory_iterator entry(folder, none), end; isNew && !none && entry != end;
         entry.increment(none)) {
        const std::string name = entry->path().filename().string();
        if (name.size() > randomDigits && isTemporaryOf(name.substr(0, name.size() - randomDigits), name) &&
            name.starts_with('.')) {
            place->second.insert(name);
        }
    }
    return place->second;
}

// Whoever writes a temporary file has it locked, and the system lets go of a lock when its program ends.
void removeStale(const fs::path& target) {
    const std::string stem = temporaryStem(target);
    const fs::path folder = target.has_parent_path() ? target.parent_path() : ".";
    const std::set<std::string>& left = leftIn(folder);
    for (auto name = left.lower_bound(stem); name != left.end() && name->starts_with(stem); ++name) {
        if (!isTemporaryOf(stem, *name)) {
            continue;
        }
        const fs::path path = folder / *name;
        const int stale = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
        if (stale >= 0) {
            if (flock(stale, LOCK_EX | LOCK_NB) == 0) {
                unlink(path.c_str());
            }
            ::close(stale);
        }
    }
}

// Where a path leads. A link to what is not there leads there too.
fs::path followed(fs::path path) {
    constexpr int mostLinks = 40;  // as the system
    std::error_code none;
    for (int i = 0; i < mostLinks && fs::is_symlink(path, none); ++i) {
        const fs::path link = fs::read_symlink(path, none);
        path = none ? path : path.parent_path() / link;
    }
    return path;
}

}  // namespace

OutputFile::OutputFile(fs::path path) : name(std::move(path)), target(followed(name)), place(mostUnfinished) {
    if (name == "-") {
        throw Error(ExitCode::Usage, "\"-\" is not standard output; a file of that name is \"./-\"");
    }
    if (std::error_code none; fs::is_symlink(target, none)) {
        fail(ELOOP);
    }
    struct stat status {};
    const bool exists = stat(target.c_str(), &status) == 0;
    if (exists && S_ISDIR(status.st_mode)) {
        failWriting(name, "it is a directory");
    }
    // To rename over a device or a pipe would put a file in its place.
    if (exists && !S_ISREG(status.st_mode)) {
        failWriting(name, "it is not a regular file");
    }
    removeStale(target);
    buffer.reserve(bufferBytes);  // what can fail goes before there is a file to leave
    create(exists ? status.st_mode & 07777U : 0);
    place = remember(temporary.string());
}

// With these permissions, or those of any new file.
void OutputFile::create(unsigned permissions) {
    constexpr mode_t everybody = 0666;  // less the user's mask
    std::random_device random;
    // Between its making and its lock another program can take it for stale, and remove it.
    constexpr int mostTries = 100;
    for (int i = 0; i < mostTries; ++i) {
        temporary =
            target.parent_path() / fmt::format("{}{:08x}{:08x}", temporaryStem(target), random(), random());
        file = open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, everybody);
        if (file < 0) {
            fail(errno);
        }
        // Where a file system knows no locks, what is left behind stays.
        static_cast<void>(flock(file, LOCK_EX));
        if (access(temporary.c_str(), F_OK) == 0) {
            break;
        }
        ::close(std::exchange(file, -1));
    }
    if (file < 0) {
        fail(ENOENT);
    }
    if (permissions != 0) {
        static_cast<void>(fchmod(file, permissions));
    }
}

OutputFile::~OutputFile() {
    if (!temporary.empty()) {
        unlink(temporary.c_str());
    }
    if (file >= 0) {
        ::close(file);
    }
    forget(place);
}

void OutputFile::fail(int code) const {
    failWriting(name, systemReason(code));
}

void OutputFile::flush() {
    if (!writeAll(file, buffer)) {
        fail(errno);
    }
    buffer.clear();
}

void OutputFile::write(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const std::size_t part = std::min(bytes.size(), bufferBytes - buffer.size());
        buffer.insert(buffer.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(part));
        bytes = bytes.subspan(part);
        if (buffer.size() == bufferBytes) {
            flush();
        }
    }
}

// Some file systems tell only when a file is closed that they could not keep it.
void OutputFile::close() {
    flush();
    if (::close(std::exchange(file, -1)) != 0) {
        fail(errno);
    }
}

void OutputFile::commit() {
    if (file >= 0) {
        flush();
        // Renamed while it is open, and so locked: nobody takes it for stale. What is closed is a second
        // name.
        const int copy = dup(file);
        if (copy < 0 || ::close(copy) != 0) {
            fail(errno);
        }
    }
    if (rename(temporary.c_str(), target.c_str()) != 0) {
        fail(errno);
    }
    temporary.clear();
    forget(place);
    place = mostUnfinished;
    if (file >= 0) {
        ::close(std::exchange(file, -1));
    }
}

void requireWritable(const fs::path& path) {
    const OutputFile probe(path);
}

void writeFile(const fs::path& path, std::span<const std::byte> bytes) {
    OutputFile out(path);
    out.write(bytes);
    out.commit();
}

void removeUnfinishedFiles() noexcept {
    for (const Unfinished& one : unfinished) {
        if (one.state == Full) {
            unlink(one.path.data());
        }
    }
}

void cleanUpOnSignals() {
    struct sigaction action {};
    action.sa_handler = removeUnfinished;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    for (const int number : {SIGHUP, SIGINT, SIGTERM}) {
        struct sigaction before {};
        // What was ignored, as by nohup, stays so.
        if (sigaction(number, nullptr, &before) == 0 && before.sa_handler != SIG_IGN) {
            sigaction(number, &action, nullptr);
        }
    }
    signal(SIGXFSZ, SIG_IGN);  // write() then fails with EFBIG
}

}  // namespace raytorus
