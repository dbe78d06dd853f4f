// SPDX-License-Identifier: MIT
#include "golden/file_group.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <memory>
#include <system_error>
#include <utility>

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/output_file.hpp"

namespace raytorus::golden {
namespace {

namespace fs = std::filesystem;

// What was there before, by name; a directory stands for a file that was not there. While this folder is
// there, a commit is not done. Its renaming is what ends it, at once and for all files.
constexpr const char* keptName = ".renewal";
constexpr const char* doneName = ".renewal-done";

[[noreturn]] void failKeeping(const fs::path& path, const std::error_code& problem) {
    throw Error(ExitCode::File, fmt::format("cannot keep \"{}\" while it is replaced: {}", path.string(),
                                            systemReason(problem.value())));
}

void keep(const fs::path& target, const fs::path& copy) {
    std::error_code problem;
    const fs::path file = fs::canonical(target, problem);
    if (problem) {  // nothing is there yet
        problem.clear();
        fs::create_directory(copy, problem);
    } else {
        // A link takes no room, so that there is nothing more that could fail when it is put back.
        fs::create_hard_link(file, copy, problem);
        if (problem) {
            fs::copy_file(file, copy, problem);
        }
    }
    if (problem) {
        failKeeping(target, problem);
    }
}

// Empty, or why it did not work.
std::string putBackOne(const fs::path& copy, const fs::path& target) {
    std::error_code problem;
    const fs::path file = fs::weakly_canonical(target, problem);
    if (fs::is_directory(copy)) {
        fs::remove(file, problem);
        return problem ? fmt::format("; \"{}\" is new and could not be removed", target.string()) : "";
    }
    if (fs::equivalent(copy, file, problem)) {
        return "";  // not replaced yet
    }
    fs::rename(copy, file, problem);
    if (problem == std::errc::cross_device_link) {
        fs::copy_file(copy, file, fs::copy_options::overwrite_existing, problem);
    }
    return problem ? fmt::format("; \"{}\" could not be put back from \"{}\"", target.string(), copy.string())
                   : "";
}

// Empty, or what is still to be put back. Ended in the middle, it can be done again.
std::string putBackAll(const fs::path& folder) {
    std::error_code problem;
    std::vector<fs::path> copies;
    for (fs::directory_iterator entry(folder / keptName, problem), end; !problem && entry != end;
         entry.increment(problem)) {
        copies.push_back(entry->path());
    }
    std::string faults = problem ? fmt::format("; cannot list \"{}\"", (folder / keptName).string()) : "";
    for (const fs::path& copy : copies) {
        faults += putBackOne(copy, folder / copy.filename());
    }
    return faults;
}

// From here on there is nothing to put back.
void endCommit(const fs::path& folder) {
    std::error_code problem;
    fs::remove_all(folder / doneName, problem);
    fs::rename(folder / keptName, folder / doneName, problem);
    if (problem) {
        failKeeping(folder / keptName, problem);
    }
    fs::remove_all(folder / doneName, problem);
}

}  // namespace

FolderLock::FolderLock(const fs::path& folder)
    : file(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    // Where a file system knows no locks, people have to take care.
    static_cast<void>(flock(file, LOCK_EX));
    sigset_t held;
    sigemptyset(&held);
    for (const int number : {SIGHUP, SIGINT, SIGTERM}) {
        sigaddset(&held, number);
    }
    pthread_sigmask(SIG_BLOCK, &held, &before);
}

FolderLock::~FolderLock() {
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    if (file >= 0) {
        close(file);
    }
}

void FileGroup::add(const std::string& name, std::span<const std::byte> bytes) {
    members.push_back({name, {bytes.begin(), bytes.end()}});
}

void FileGroup::add(const std::string& name, std::string_view text) {
    add(name, std::as_bytes(std::span(text)));
}

void FileGroup::commit() const {
    std::vector<std::unique_ptr<OutputFile>> files;
    for (const Member& member : members) {
        files.push_back(std::make_unique<OutputFile>(folder / member.name));
        files.back()->write(member.bytes);
        files.back()->close();
    }
    std::error_code problem;
    if (!fs::create_directory(folder / keptName, problem)) {
        failKeeping(folder / keptName, problem ? problem : std::make_error_code(std::errc::file_exists));
    }
    try {
        for (const Member& member : members) {
            keep(folder / member.name, folder / keptName / member.name);
        }
        for (const std::unique_ptr<OutputFile>& file : files) {
            file->commit();
        }
        endCommit(folder);
    } catch (const Error& error) {
        const std::string faults = putBackAll(folder);
        if (faults.empty()) {
            endCommit(folder);
        }
        throw Error(error.exitCode,
                    error.what() + (faults.empty() ? "; all files are as they were" : faults));
    }
}

bool isUnfinished(const fs::path& folder) {
    std::error_code none;
    return fs::is_directory(folder / keptName, none);
}

bool putBack(const fs::path& folder) {
    if (!isUnfinished(folder)) {
        return false;
    }
    if (const std::string faults = putBackAll(folder); !faults.empty()) {
        throw Error(ExitCode::File, "a renewal was ended in the middle" + faults);
    }
    endCommit(folder);
    return true;
}

bool isKept(std::string_view name) {
    return name == keptName || name == doneName;
}

}  // namespace raytorus::golden
