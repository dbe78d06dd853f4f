// SPDX-License-Identifier: MIT
// Which file an #include names, found as glslangValidator -I finds it: beside the file that includes, beside
// those that include that one, out to the entry, then in the roots in their order. Every file that was read
// or missed on the way is kept account of. Knows no glslang.
#pragma once

#include <cstddef>
#include <deque>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "compile/directives.hpp"
#include "compile/source_file.hpp"

namespace raytorus::compile {

struct Source {
    std::filesystem::path path;  ///< absolute and normal
    std::string name;            ///< for people: relative to the first root, or as its root was given
    std::string text;
    std::vector<Directive> directives;
};

class IncludeSearch {
public:
    IncludeSearch(const std::filesystem::path& entry, const std::vector<std::filesystem::path>& roots);

    /// The entry is read at once; why it could not be, or nothing.
    [[nodiscard]] const std::string& entryProblem() const { return problemOfEntry; }

    struct Found {
        const Source* source = nullptr;  ///< valid as long as the search; null: refused
        std::size_t id = 0;              ///< its place in sources()
        std::string refusal;             ///< a sentence
    };

    /// `depth` counts the files around: 1 if the entry includes. Each file is read once; its text stays what
    /// it was. After a refusal for size or depth or a cycle all else is refused, so that an end is near.
    [[nodiscard]] Found find(std::string_view name, std::size_t depth);

    /// The entry, then what was found, in that order.
    [[nodiscard]] const std::deque<Source>& sources() const { return read; }

    /// What was read, what was missing where it was looked for, and what was there but refused.
    [[nodiscard]] const std::vector<FileState>& files() const { return seen; }

private:
    struct Root {
        std::filesystem::path given;
        std::filesystem::path absolute;  // and normal
        std::filesystem::path real;      // without symbolic links; empty if there is no such folder
    };

    void addRoot(const std::filesystem::path& given);
    [[nodiscard]] bool isInside(const std::filesystem::path& path, std::filesystem::path Root::*form) const;
    [[nodiscard]] bool leadsOutside(const std::filesystem::path& path) const;
    [[nodiscard]] std::string nameOf(const std::filesystem::path& path) const;
    [[nodiscard]] std::vector<std::filesystem::path> folders() const;
    [[nodiscard]] Found search(const std::string& name);
    Found enter(Found found);
    [[nodiscard]] Found refuseAll(std::string sentence);
    SourceFile look(const std::filesystem::path& path);

    std::vector<Root> roots;  // those given, then the entry's folder, in which nothing more is searched
    std::deque<Source> read;
    std::vector<FileState> seen;
    std::vector<std::size_t> chain;  // from the entry to the file that includes
    std::size_t totalBytes = 0;
    std::string problemOfEntry;
    std::string refusalOfAll;
};

}  // namespace raytorus::compile
