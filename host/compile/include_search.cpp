// SPDX-License-Identifier: MIT
#include "compile/include_search.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace raytorus::compile {
namespace {

namespace fs = std::filesystem;

// Deeper than anybody writes, and soon reached by a guard that does not guard.
constexpr std::size_t maxDepth = 64;

fs::path absoluteNormal(const fs::path& path) {
    std::error_code problem;
    fs::path absolute = fs::absolute(path, problem);
    if (problem) {
        absolute = path;  // the working folder is gone
    }
    fs::path normal = absolute.lexically_normal();
    return normal.has_filename() ? normal : normal.parent_path();  // "a/" is "a"
}

// Both absolute and normal.
bool isWithin(const fs::path& path, const fs::path& folder) {
    const auto [end, rest] = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
    return !folder.empty() && end == folder.end();
}

}  // namespace

IncludeSearch::IncludeSearch(const fs::path& entry, const std::vector<fs::path>& givenRoots) {
    std::ranges::for_each(givenRoots, [this](const fs::path& root) { addRoot(root); });
    addRoot(entry.parent_path().empty() ? fs::path(".") : entry.parent_path());
    const fs::path path = absoluteNormal(entry);
    const SourceFile file = look(path);
    problemOfEntry = !file.problem.empty() ? file.problem : file.text.empty() ? "it is empty" : "";
    totalBytes = file.text.size();
    read.push_back({path, nameOf(path), file.text, findDirectives(file.text)});
}

void IncludeSearch::addRoot(const fs::path& given) {
    std::error_code problem;
    const fs::path real = fs::canonical(given, problem);
    roots.push_back({given, absoluteNormal(given), problem ? fs::path() : real});
}

bool IncludeSearch::isInside(const fs::path& path, fs::path Root::*form) const {
    return std::ranges::any_of(roots, [&](const Root& root) { return isWithin(path, root.*form); });
}

// By symbolic links.
bool IncludeSearch::leadsOutside(const fs::path& path) const {
    std::error_code problem;
    const fs::path real = fs::canonical(path, problem);
    return !problem && !isInside(real, &Root::real);
}

std::string IncludeSearch::nameOf(const fs::path& path) const {
    for (const Root& root : roots) {
        if (isWithin(path, root.absolute)) {
            const fs::path below = path.lexically_relative(root.absolute);
            const bool first = &root == &roots.front() && roots.size() > 1;
            return (first ? below : root.given / below).lexically_normal().string();
        }
    }
    return path.string();
}

std::vector<fs::path> IncludeSearch::folders() const {
    std::vector<fs::path> list;
    for (std::size_t i = chain.size(); i-- > 0;) {
        list.push_back(read[chain[i]].path.parent_path());
    }
    std::transform(roots.begin(), roots.end() - 1, std::back_inserter(list),
                   [](const Root& root) { return root.absolute; });
    std::vector<fs::path> once;
    for (fs::path& folder : list) {
        if (std::ranges::find(once, folder) == once.end()) {
            once.push_back(std::move(folder));
        }
    }
    return once;
}

SourceFile IncludeSearch::look(const fs::path& path) {
    SourceFile file = readSourceFile(path);
    if (std::ranges::find(seen, path, &FileState::path) == seen.end()) {
        seen.push_back({path, fingerprint(file)});
    }
    return file;
}

IncludeSearch::Found IncludeSearch::find(std::string_view name, std::size_t depth) {
    if (!refusalOfAll.empty()) {
        return {nullptr, 0, refusalOfAll};
    }
    if (chain.empty()) {
        chain.push_back(0);
    }
    chain.resize(std::min(std::max<std::size_t>(depth, 1), chain.size()));
    std::string path(name);
    std::replace(path.begin(), path.end(), '\\', '/');  // as glslangValidator does
    return enter(search(path));
}

IncludeSearch::Found IncludeSearch::search(const std::string& name) {
    if (name.empty()) {
        return {nullptr, 0, "cannot include \"\": that is no file name"};
    }
    const std::string leaves = fmt::format("cannot include \"{}\": it leaves the shader folders", name);
    if (fs::path(name).is_absolute()) {
        return {nullptr, 0, leaves};
    }
    std::string searched;
    for (const fs::path& folder : folders()) {
        const fs::path path = absoluteNormal(folder / name);
        if (!isInside(path, &Root::absolute)) {
            continue;
        }
        const auto known = std::ranges::find(read, path, &Source::path);
        if (known != read.end()) {
            return {&*known, static_cast<std::size_t>(known - read.begin()), {}};
        }
        const SourceFile file = look(path);
        if (!file.missing && leadsOutside(path)) {
            return {nullptr, 0,
                    fmt::format("cannot include \"{}\": {} is a link that leaves the shader folders", name,
                                nameOf(path))};
        }
        if (file.problem.empty()) {
            read.push_back({path, nameOf(path), file.text, findDirectives(file.text)});
            return {&read.back(), read.size() - 1, {}};
        }
        if (!file.missing) {
            return {nullptr, 0,
                    fmt::format("cannot include \"{}\": {}: {}", name, nameOf(path), file.problem)};
        }
        searched += fmt::format("{}\"{}\"", searched.empty() ? "" : ", ", nameOf(path));
    }
    return {nullptr, 0,
            searched.empty() ? leaves : fmt::format("cannot include \"{}\": there is no {}", name, searched)};
}

IncludeSearch::Found IncludeSearch::refuseAll(std::string sentence) {
    refusalOfAll = std::move(sentence);
    return {nullptr, 0, refusalOfAll};
}

// Into the chain, unless that would not end.
IncludeSearch::Found IncludeSearch::enter(Found found) {
    if (found.source == nullptr) {
        return found;
    }
    const auto again = std::find(chain.rbegin(), chain.rend(), found.id);
    if (again != chain.rend() && (!hasIncludeGuard(found.source->directives) || chain.size() >= maxDepth)) {
        std::string cycle;
        for (auto id = again.base() - 1; id != chain.end(); ++id) {
            cycle += read[*id].name + " includes ";
        }
        return refuseAll(fmt::format("include cycle: {}{}", cycle, found.source->name));
    }
    if (chain.size() >= maxDepth) {
        return refuseAll(
            fmt::format("cannot include \"{}\": it lies {} includes deep", found.source->name, maxDepth));
    }
    totalBytes += found.source->text.size();
    if (totalBytes > maxSourceBytes) {
        return refuseAll(fmt::format("cannot include \"{}\": all together would be more than {} bytes",
                                     found.source->name, maxSourceBytes));
    }
    chain.push_back(found.id);
    return found;
}

}  // namespace raytorus::compile
