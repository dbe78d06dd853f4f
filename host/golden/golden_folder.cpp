// SPDX-License-Identifier: MIT
#include "golden/golden_folder.hpp"

#include <fmt/format.h>

#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <system_error>

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/json_text.hpp"
#include "core/sha256.hpp"
#include "golden/file_group.hpp"
#include "image/manifest.hpp"
#include "scene/json_node.hpp"

namespace raytorus::golden {
namespace {

namespace fs = std::filesystem;
using scene::JsonNode;

// What is wrong in these files is a fault of the file, wherever else such JSON may be a scene.
void readJson(const fs::path& path, const std::function<void(const JsonNode&)>& read) {
    const std::string text = readTextFile(path);
    const std::string name = path.string();
    try {
        const Json tree = parseStrictJson(text, name);
        read(JsonNode(tree, name));
    } catch (const Error& error) {
        throw Error(ExitCode::File, error.what());
    }
}

struct Sidecar {
    std::string scene;
    int samplesPerPixel = 0;
};

Sidecar readSidecar(const fs::path& path) {
    Sidecar sidecar;
    readJson(path, [&sidecar](const JsonNode& top) {
        top.expectObject();
        sidecar.scene = top.requiredMember("scene").text();
        sidecar.samplesPerPixel =
            top.requiredMember("samplesPerPixel").integer(1, std::numeric_limits<int>::max());
        // These are for people, and nothing else is asked of them.
        for (const char* key : {"case", "reason", "reference", "raytorus"}) {
            if (const auto member = top.member(key)) {
                static_cast<void>(member->text());
            }
        }
        for (const char* key : {"pixels", "marginalPixels"}) {
            if (const auto member = top.member(key)) {
                static_cast<void>(member->integer(0, std::numeric_limits<int>::max()));
            }
        }
    });
    return sidecar;
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

// Not what is in a stray folder: the folder is stray, and may be one that cannot be listed.
void addStrays(const Set& set, std::vector<std::string>& faults) {
    const std::set<std::string> expected = expectedFiles(set);
    std::set<std::string> strays;
    for (const fs::path& folder : {set.folder(), set.folder() / "scenes"}) {
        std::error_code problem;
        for (fs::directory_iterator entry(folder, problem), end; !problem && entry != end;
             entry.increment(problem)) {
            const std::string name = entry->path().lexically_relative(set.folder()).generic_string();
            if (!expected.contains(name) && !isKept(name)) {
                strays.insert(name);
            }
        }
        if (problem) {
            faults.push_back(fmt::format("cannot list the folder \"{}\": {}", folder.string(),
                                         systemReason(problem.value())));
        }
    }
    for (const std::string& name : strays) {
        faults.push_back(
            fmt::format("{}: no case in cases.json has this file", (set.folder() / name).string()));
    }
}

std::string sidecarFault(const Set& set, const Case& row) {
    const Sidecar sidecar = readSidecar(set.sidecar(row));
    if (sidecar.scene != sha256(readFile(set.scene(row)))) {
        return fmt::format("{}: the scene has changed since its truth was made", set.scene(row).string());
    }
    if (sidecar.samplesPerPixel != row.samplesPerSide * row.samplesPerSide) {
        return fmt::format("{}: the truth was made with another number of samples", set.truth(row).string());
    }
    return "";
}

// What a part of the folder's check finds, where it finds faults and where it cannot look.
void addFaults(std::vector<std::string>& faults, const std::function<void()>& look) {
    try {
        look();
    } catch (const Error& error) {
        faults.emplace_back(error.what());
    }
}

}  // namespace

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

std::string renewalFault(const Set& set) {
    return isUnfinished(set.folder()) ? fmt::format(
                                            "{}: a renewal is under way, or was ended in the middle; the "
                                            "next \"raytorus golden renew\" "
                                            "first puts back what that one replaced",
                                            set.folder().string())
                                      : "";
}

std::vector<std::string> folderFaults(const Set& set) {
    std::vector<std::string> faults;
    addFaults(faults,
              [&] { faults = image::manifestFaults(image::readManifest(set.manifest()), set.folder()); });
    if (const std::string fault = renewalFault(set); !fault.empty()) {
        faults.insert(faults.begin(), fault);
    }
    addStrays(set, faults);
    for (const Case& row : set.cases()) {
        addFaults(faults, [&] {
            if (const std::string fault = sidecarFault(set, row); !fault.empty()) {
                faults.push_back(fault);
            }
        });
    }
    addFaults(faults, [&] {
        const std::map<std::string, std::string> bits = readBits(set);
        for (const Case& row : set.cases()) {
            if (!bits.contains(row.name)) {
                faults.push_back(fmt::format("{}: nothing about {}", set.bits().string(), row.name));
            }
        }
    });
    return faults;
}

std::map<std::string, std::string> readBits(const Set& set) {
    std::map<std::string, std::string> bits;
    readJson(set.bits(), [&bits](const JsonNode& top) {
        top.expectObject();
        const JsonNode pictures = top.requiredMember("sha256");
        pictures.expectObject();
        for (std::size_t i = 0; i < pictures.value().size(); ++i) {
            const JsonNode hash = pictures.child(i);
            bits[std::string(hash.key())] = hash.text();
        }
    });
    return bits;
}

void writeBits(const Set& set, const std::map<std::string, std::string>& bits, const std::string& reason) {
    const nlohmann::ordered_json json = {{"reason", reason}, {"raytorus", version()}, {"sha256", bits}};
    const std::string text = dumpJson(json) + "\n";
    writeFile(set.bits(), std::as_bytes(std::span(text)));
}

}  // namespace raytorus::golden
