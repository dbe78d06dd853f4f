// SPDX-License-Identifier: MIT
#include "gpu/driver_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string_view>
#include <system_error>

#include "core/console.hpp"
#include "core/error.hpp"

namespace raytorus::gpu {
namespace {

namespace fs = std::filesystem;

std::string variable(const char* name) {
    const char* const value = std::getenv(name);
    return value != nullptr ? value : "";
}

std::vector<std::string> partsOf(const std::string& list) {
    std::vector<std::string> parts;
    for (std::size_t begin = 0; begin < list.size();) {
        const std::size_t end = std::min(list.find(':', begin), list.size());
        if (end > begin) {
            parts.push_back(list.substr(begin, end - begin));
        }
        begin = end + 1;
    }
    return parts;
}

// A file, or all files of a folder, as the loader tells them apart.
void add(std::vector<std::string>& files, const std::string& path) {
    if (path.ends_with(".json")) {
        files.push_back(path);
        return;
    }
    std::error_code problem;
    for (fs::directory_iterator entry(path, problem), end; !problem && entry != end;
         entry.increment(problem)) {
        if (entry->path().extension() == ".json") {
            files.push_back(entry->path().string());
        }
    }
}

std::vector<std::string> folders() {
    const std::string home = variable("HOME");
    const auto orElse = [](const std::string& value, const std::string& usual) {
        return value.empty() ? usual : value;
    };
    std::vector<std::string> list;
    const auto addAll = [&list](const std::string& paths) {
        for (const std::string& path : partsOf(paths)) {
            list.push_back(path + "/vulkan/icd.d");
        }
    };
    addAll(orElse(variable("XDG_CONFIG_HOME"), home.empty() ? "" : home + "/.config"));
    addAll(orElse(variable("XDG_CONFIG_DIRS"), "/etc/xdg"));
    addAll("/etc");
    addAll(orElse(variable("XDG_DATA_HOME"), home.empty() ? "" : home + "/.local/share"));
    addAll(orElse(variable("XDG_DATA_DIRS"), "/usr/local/share:/usr/share"));
    return list;
}

std::vector<std::string> allFiles() {
    std::vector<std::string> files;
    for (const char* name : {"VK_DRIVER_FILES", "VK_ICD_FILENAMES"}) {
        if (const std::string list = variable(name); !list.empty()) {
            for (const std::string& path : partsOf(list)) {
                add(files, path);
            }
            return files;
        }
    }
    for (const std::string& path : partsOf(variable("VK_ADD_DRIVER_FILES"))) {
        add(files, path);
    }
    for (const std::string& folder : folders()) {
        add(files, folder);
    }
    return files;
}

// A file that cannot be read is passed over by the loader itself.
std::string problemOf(const std::string& path) {
    std::error_code ignored;
    if (!fs::is_regular_file(path, ignored)) {
        return {};  // to open a pipe would be to wait for somebody
    }
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        return {};
    }
    const std::string text(std::istreambuf_iterator<char>(file), {});
    const auto json = nlohmann::json::parse(text, nullptr, false);
    if (json.is_discarded()) {
        return "it is no JSON";
    }
    const bool names = json.is_object() && json.contains("ICD") && json["ICD"].is_object() &&
                       json["ICD"].contains("library_path") && json["ICD"]["library_path"].is_string();
    return names ? "" : "it does not say /ICD/library_path";
}

}  // namespace

DriverFiles findDriverFiles() {
    DriverFiles found;
    for (const std::string& path : allFiles()) {
        if (const std::string problem = problemOf(path); !problem.empty()) {
            found.damaged.push_back(fmt::format("\"{}\": {}", excerpt(path), problem));
        } else {
            found.good.push_back(path);
        }
    }
    return found;
}

void leaveOutDamagedDrivers() {
    static std::mutex oneAtATime;
    const std::scoped_lock lock(oneAtATime);
    const DriverFiles found = findDriverFiles();
    if (found.damaged.empty()) {
        return;
    }
    if (found.good.empty()) {
        throw Error(ExitCode::NoDevice,
                    fmt::format("the Vulkan driver file is damaged, and there is no other: {}",
                                found.damaged.front()));
    }
    for (const std::string& damaged : found.damaged) {
        writeError(fmt::format("raytorus: a damaged Vulkan driver file is left out: {}\n", damaged));
    }
    ::setenv("VK_DRIVER_FILES", fmt::format("{}", fmt::join(found.good, ":")).c_str(), 1);
}

}  // namespace raytorus::gpu
