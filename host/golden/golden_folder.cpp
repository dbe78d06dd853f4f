// SPDX-License-Identifier: MIT
#include "golden/golden_folder.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/sha256.hpp"
#include "image/manifest.hpp"

namespace raytorus::golden {
namespace {

namespace fs = std::filesystem;

nlohmann::json readJson(const fs::path& path) {
    const std::string text = readTextFile(path);
    nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
    if (!json.is_object()) {
        throw Error(ExitCode::File, fmt::format("{}: no JSON object", path.string()));
    }
    return json;
}

std::set<std::string> expectedFiles(const Set& set) {
    std::set<std::string> files = {"README.md", "cases.json", "manifest.json", "bits.json", "scenes"};
    for (const Case& row : set.cases()) {
        for (const fs::path& path : {set.scene(row), set.truth(row), set.sidecar(row)}) {
            files.insert(path.lexically_relative(set.folder()).generic_string());
        }
    }
    return files;
}

void addStrays(const Set& set, std::vector<std::string>& faults) {
    const std::set<std::string> expected = expectedFiles(set);
    std::set<std::string> strays;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(set.folder())) {
        const std::string name = entry.path().lexically_relative(set.folder()).generic_string();
        if (!expected.contains(name)) {
            strays.insert(name);
        }
    }
    for (const std::string& name : strays) {
        faults.push_back(
            fmt::format("{}: no case in cases.json has this file", (set.folder() / name).string()));
    }
}

std::string sidecarFault(const Set& set, const Case& row) {
    const nlohmann::json sidecar = readJson(set.sidecar(row));
    if (sidecar.value("scene", "") != sceneHash(set, row)) {
        return fmt::format("{}: the scene has changed since its truth was made", set.scene(row).string());
    }
    if (sidecar.value("samplesPerPixel", 0) != row.samplesPerSide * row.samplesPerSide) {
        return fmt::format("{}: the truth was made with another number of samples", set.truth(row).string());
    }
    return "";
}

}  // namespace

std::string sceneHash(const Set& set, const Case& row) {
    return sha256(readFile(set.scene(row)));
}

std::string pictureHash(const image::Image& picture) {
    std::string text = fmt::format("{} x {}", picture.width, picture.height);
    for (const std::string& name : picture.channelNames) {
        text += fmt::format(" {}", name);
    }
    text += fmt::format(" {}", sha256(std::as_bytes(std::span(picture.pixels))));
    return sha256(std::as_bytes(std::span(text)));
}

std::string truthFault(const Set& set, const Case& row) {
    const std::string fault = image::manifestFault(image::readManifest(set.manifest()), set.truth(row));
    return fault.empty() ? sidecarFault(set, row) : fault;
}

std::vector<std::string> folderFaults(const Set& set) {
    std::vector<std::string> faults =
        image::manifestFaults(image::readManifest(set.manifest()), set.folder());
    addStrays(set, faults);
    const std::map<std::string, std::string> bits = readBits(set);
    for (const Case& row : set.cases()) {
        try {
            if (const std::string fault = sidecarFault(set, row); !fault.empty()) {
                faults.push_back(fault);
            }
        } catch (const Error& error) {
            faults.emplace_back(error.what());
        }
        if (!bits.contains(row.name)) {
            faults.push_back(fmt::format("{}: nothing about {}", set.bits().string(), row.name));
        }
    }
    return faults;
}

std::map<std::string, std::string> readBits(const Set& set) {
    const nlohmann::json json = readJson(set.bits());
    std::map<std::string, std::string> bits;
    const auto pictures = json.find("sha256");
    if (pictures == json.end() || !pictures->is_object()) {
        throw Error(ExitCode::File, fmt::format("{}: no object \"sha256\"", set.bits().string()));
    }
    for (const auto& [name, hash] : pictures->items()) {
        bits[name] = hash.is_string() ? hash.get<std::string>() : "";
    }
    return bits;
}

void writeBits(const Set& set, const std::map<std::string, std::string>& bits, const std::string& reason) {
    const nlohmann::ordered_json json = {{"reason", reason}, {"raytorus", version()}, {"sha256", bits}};
    const std::string text = json.dump(2) + "\n";
    writeFile(set.bits(), std::as_bytes(std::span(text)));
}

}  // namespace raytorus::golden
