// SPDX-License-Identifier: MIT
#include "golden/golden_renew.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "core/console.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/json_text.hpp"
#include "core/sha256.hpp"
#include "golden/file_group.hpp"
#include "image/channels.hpp"
#include "image/image_codec.hpp"
#include "image/manifest.hpp"
#include "scene/scene_json.hpp"
#include "truth/truth.hpp"

namespace raytorus::golden {
namespace {

int marginalPixels(const image::Image& truth) {
    const std::vector<std::string> margins = image::channelsOf({image::ChannelKind::Margin});
    int marginal = 0;
    for (int y = 0; y < truth.height; ++y) {
        for (int x = 0; x < truth.width; ++x) {
            bool flips = false;
            for (const std::string& name : margins) {
                flips = flips || truth.at(x, y, name) < 1.0F;
            }
            marginal += flips ? 1 : 0;
        }
    }
    return marginal;
}

void requireAgreement(const Case& row, const scene::Scene& scene, const truth::TruthOptions& options) {
    const auto found = truth::disagreements(scene, scene.imageWidth, scene.imageHeight, options);
    if (!found.empty()) {
        const truth::Disagreement& first = found.front();
        throw Error(
            ExitCode::ComparisonFailed,
            fmt::format("{}: the reference disagrees with itself in {} values: {} of pixel ({}, {}) is {} "
                        "in 113 bits and {} in 104",
                        row.name, found.size(), first.channel, first.x, first.y, first.arbiter, first.other));
    }
}

// A case to renew, as it is before anything is rendered: the scene that is rendered is the one that is
// hashed.
struct Task {
    const Case* row;
    scene::Scene scene;
    std::string hash;
};

image::Manifest manifestNow(const Set& set) {
    std::error_code ignored;
    // Not of what a link leads to: a manifest that cannot be read is not one that is not there.
    const bool missing = std::filesystem::symlink_status(set.manifest(), ignored).type() ==
                         std::filesystem::file_type::not_found;
    return missing ? image::Manifest() : image::readManifest(set.manifest());
}

std::vector<Task> prepare(const Set& set, std::span<const Case> rows) {
    std::vector<Task> tasks;
    for (const Case& row : rows) {
        const std::string text = readTextFile(set.scene(row));
        tasks.push_back(
            {&row, scene::parseScene(text, set.scene(row).string()), sha256(std::as_bytes(std::span(text)))});
        requireWritable(set.truth(row));
        requireWritable(set.sidecar(row));
    }
    static_cast<void>(manifestNow(set));
    requireWritable(set.manifest());
    return tasks;
}

std::string sidecarText(const Task& task, const Renewal& renewal, const std::string& reason) {
    const int side = task.row->samplesPerSide;
    const nlohmann::ordered_json sidecar = {{"case", task.row->name},
                                            {"reason", reason},
                                            {"reference", "113 bits, questioned by 104 bits"},
                                            {"raytorus", version()},
                                            {"scene", task.hash},
                                            {"samplesPerPixel", side * side},
                                            {"pixels", renewal.pixels},
                                            {"marginalPixels", renewal.marginal}};
    return dumpJson(sidecar) + "\n";
}

image::Image truthOf(const Task& task, const std::function<void(double)>& progress) {
    truth::TruthOptions options;
    options.samplesPerSide = task.row->samplesPerSide;
    requireAgreement(*task.row, task.scene, options);
    options.sharpness = true;
    options.progress = progress;
    return truth::renderTruth(task.scene, task.scene.imageWidth, task.scene.imageHeight, options);
}

}  // namespace

void requireRenewal(const std::string& reason) {
    const char* const ci = std::getenv("CI");
    if (ci != nullptr && *ci != '\0') {
        throw Error(ExitCode::Usage, "goldens are renewed by people, not in CI");
    }
    if (reason.find_first_not_of(" \t\n") == std::string::npos) {
        throw Error(ExitCode::Usage, "--reason says why the goldens change; it cannot be blank");
    }
    if (!isUtf8(reason)) {
        throw Error(ExitCode::Usage, "--reason is kept as JSON; it must be UTF-8");
    }
}

bool recover(const Set& set) {
    const FolderLock lock(set.folder());
    return putBack(set.folder());
}

std::vector<Renewal> renew(const Set& set, std::span<const Case> rows, const std::string& reason,
                           const std::function<void(double)>& progress) {
    requireRenewal(reason);
    const std::vector<Task> tasks = prepare(set, rows);
    std::vector<Renewal> renewals;
    std::map<std::string, image::ManifestEntry> entries;
    FileGroup files(set.folder());
    for (const Task& task : tasks) {
        const auto partDone = [&](double done) {
            if (progress) {
                progress((static_cast<double>(renewals.size()) + done) / static_cast<double>(tasks.size()));
            }
        };
        const std::filesystem::path path = set.truth(*task.row);
        const image::Image truth = truthOf(task, partDone);
        const std::vector<std::byte> bytes = image::encode(truth, image::Format::Exr, path.string());
        renewals.push_back({truth.width * truth.height, marginalPixels(truth)});
        entries[path.filename().string()] = image::manifestEntry(bytes);
        files.add(path.filename().string(), bytes);
        files.add(set.sidecar(*task.row).filename().string(), sidecarText(task, renewals.back(), reason));
    }
    // As it is now: rendering may have taken minutes.
    const FolderLock lock(set.folder());
    putBack(set.folder());
    image::Manifest manifest = manifestNow(set);
    for (const auto& [name, entry] : entries) {
        manifest.files[name] = entry;
    }
    files.add(set.manifest().filename().string(), image::manifestText(manifest));
    files.commit();
    return renewals;
}

}  // namespace raytorus::golden
