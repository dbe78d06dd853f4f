// SPDX-License-Identifier: MIT
#include "golden/file_group.hpp"

#include <fmt/format.h>

#include <memory>
#include <random>
#include <system_error>
#include <utility>

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/output_file.hpp"

namespace raytorus::golden {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longestStem = 200;  // with the rest a name that file systems take

// What a path leads to, hidden and kept until the whole group is in its place.
class Kept {
public:
    explicit Kept(const fs::path& path) : name(path) {
        std::error_code problem;
        target = fs::canonical(path, problem);
        if (problem) {
            return;  // nothing is there yet
        }
        std::random_device random;
        const std::string stem = target.filename().string().substr(0, longestStem);
        copy = target.parent_path() / fmt::format(".{}.old-{:08x}{:08x}", stem, random(), random());
        // A link takes no room, so that there is nothing more that could fail when it is put back.
        fs::create_hard_link(target, copy, problem);
        if (problem) {
            fs::copy_file(target, copy, problem);
        }
        if (problem) {
            throw Error(ExitCode::File, fmt::format("cannot keep \"{}\" while it is replaced: {}",
                                                    path.string(), systemReason(problem.value())));
        }
    }
    Kept(const Kept&) = delete;
    Kept& operator=(const Kept&) = delete;
    ~Kept() {
        std::error_code ignored;
        if (!copy.empty()) {
            fs::remove(copy, ignored);
        }
    }

    /// Empty, or why it did not work and where the old content is.
    std::string putBack() {
        std::error_code problem;
        if (copy.empty()) {
            fs::remove(fs::canonical(name, problem), problem);
            return problem ? fmt::format("\"{}\" is new and could not be removed", name.string()) : "";
        }
        fs::rename(copy, target, problem);
        if (!problem) {
            return "";
        }
        return fmt::format("\"{}\" could not be put back from \"{}\"", name.string(),
                           std::exchange(copy, fs::path()).string());
    }

private:
    fs::path name;
    fs::path target;  // where the name leads
    fs::path copy;    // empty: there was no file
};

std::string putBackAll(const std::vector<std::unique_ptr<Kept>>& kept, std::size_t count) {
    std::string faults;
    for (std::size_t i = count; i-- > 0;) {
        if (const std::string fault = kept[i]->putBack(); !fault.empty()) {
            faults += "; " + fault;
        }
    }
    return faults.empty() ? "; all files are as they were" : faults;
}

}  // namespace

void FileGroup::add(fs::path path, std::span<const std::byte> bytes) {
    members.push_back({std::move(path), {bytes.begin(), bytes.end()}});
}

void FileGroup::add(fs::path path, std::string_view text) {
    add(std::move(path), std::as_bytes(std::span(text)));
}

void FileGroup::commit() const {
    std::vector<std::unique_ptr<OutputFile>> files;
    std::vector<std::unique_ptr<Kept>> kept;
    for (const Member& member : members) {
        files.push_back(std::make_unique<OutputFile>(member.path));
        files.back()->write(member.bytes);
    }
    for (const Member& member : members) {
        kept.push_back(std::make_unique<Kept>(member.path));
    }
    for (std::size_t i = 0; i < files.size(); ++i) {
        try {
            files[i]->commit();
        } catch (const Error& error) {
            throw Error(error.exitCode, error.what() + putBackAll(kept, i));
        }
    }
}

}  // namespace raytorus::golden
