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

IncludeSearch::IncludeSearch(const fs::path& entry, const std::vector<fs::path>& roots,
                             std::vector<VirtualInclude> virtualIncludes)
    : rootCount(roots.size()), virtualFiles(std::move(virtualIncludes)) {
    std::for_each(roots.begin(), roots.end(), [this](const fs::path& root) { addRoot(root); });
    const fs::path path = absoluteNormal(entry);
    addRoot(entry.parent_path().empty() ? fs::path(".") : entry.parent_path());
    const SourceFile file = look(path);
    problemOfEntry = !file.problem.empty() ? file.problem : file.text.empty() ? "it is empty" : "";
    totalBytes = file.text.size();
    readPaths.push_back(path);
    read.push_back({path.parent_path(), nameOf(path), file.text, findDirectives(file.text)});
}

void IncludeSearch::addRoot(const fs::path& given) {
    std::error_code problem;
    const fs::path real = fs::canonical(given, problem);
    allowed.push_back({given, absoluteNormal(given), problem ? fs::path() : real});
}

bool IncludeSearch::isInside(const fs::path& path, fs::path Root::*form) const {
    return std::any_of(allowed.begin(), allowed.end(),
                       [&](const Root& root) { return isWithin(path, root.*form); });
}

// By symbolic links.
bool IncludeSearch::leadsOutside(const fs::path& path) const {
    std::error_code problem;
    const fs::path real = fs::canonical(path, problem);
    return !problem && !isInside(real, &Root::real);
}

std::string IncludeSearch::nameOf(const fs::path& path) const {
    for (std::size_t i = 0; i < allowed.size(); ++i) {
        if (isWithin(path, allowed[i].absolute)) {
            const fs::path below = path.lexically_relative(allowed[i].absolute);
            return (i == 0 && rootCount > 0 ? below : allowed[i].given / below).lexically_normal().string();
        }
    }
    return path.string();
}

std::vector<fs::path> IncludeSearch::folders() const {
    std::vector<fs::path> list;
    for (std::size_t i = chain.size(); i-- > 0;) {
        list.push_back(read[chain[i]].folder);
    }
    std::transform(allowed.begin(), allowed.begin() + static_cast<std::ptrdiff_t>(rootCount),
                   std::back_inserter(list), [](const Root& root) { return root.absolute; });
    std::vector<fs::path> once;
    for (fs::path& folder : list) {
        if (!folder.empty() && std::find(once.begin(), once.end(), folder) == once.end()) {
            once.push_back(std::move(folder));
        }
    }
    return once;
}

SourceFile IncludeSearch::look(const fs::path& path) {
    SourceFile file = readSourceFile(path);
    if (std::none_of(seen.begin(), seen.end(), [&](const FileState& state) { return state.path == path; })) {
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
    for (std::size_t i = 0; i < virtualFiles.size(); ++i) {
        if (virtualFiles[i].name == name) {
            const auto known = std::find_if(read.begin(), read.end(), [&](const Source& source) {
                return source.folder.empty() && source.name == name;
            });
            return known != read.end()
                       ? Found{&*known, static_cast<std::size_t>(known - read.begin()), {}}
                       : add({{}, name, virtualFiles[i].text, findDirectives(virtualFiles[i].text)});
        }
    }
    const std::string leaves = fmt::format("cannot include \"{}\": it leaves the shader folders", name);
    if (fs::path(name).is_absolute()) {
        return {nullptr, 0, leaves};
    }
    bool allLeave = true;
    std::string searched;
    for (const fs::path& folder : folders()) {
        const fs::path path = absoluteNormal(folder / name);
        if (!isInside(path, &Root::absolute)) {
            continue;
        }
        allLeave = false;
        const auto known = std::find(readPaths.begin(), readPaths.end(), path);
        if (known != readPaths.end()) {
            const auto id = static_cast<std::size_t>(known - readPaths.begin());
            return {&read[id], id, {}};
        }
        const SourceFile file = look(path);
        if (!file.missing) {
            return open(name, path, file);
        }
        searched += fmt::format("{}\"{}\"", searched.empty() ? "" : ", ", nameOf(path));
    }
    return {nullptr, 0,
            allLeave ? leaves : fmt::format("cannot include \"{}\": there is no {}", name, searched)};
}

IncludeSearch::Found IncludeSearch::open(const std::string& name, const fs::path& path,
                                         const SourceFile& file) {
    if (leadsOutside(path)) {
        return {nullptr, 0,
                fmt::format("cannot include \"{}\": {} is a link that leaves the shader folders", name,
                            nameOf(path))};
    }
    if (!file.problem.empty()) {
        return {nullptr, 0, fmt::format("cannot include \"{}\": {}: {}", name, nameOf(path), file.problem)};
    }
    const Found found = add({path.parent_path(), nameOf(path), file.text, findDirectives(file.text)});
    readPaths.back() = path;
    return found;
}

IncludeSearch::Found IncludeSearch::add(Source source) {
    readPaths.emplace_back();
    read.push_back(std::move(source));
    return {&read.back(), read.size() - 1, {}};
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
