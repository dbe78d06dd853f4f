// SPDX-License-Identifier: MIT
#include "golden/golden_renew.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/file.hpp"
#include "golden/golden_folder.hpp"
#include "image/image_io.hpp"
#include "image/manifest.hpp"
#include "render/scene_json.hpp"
#include "truth/truth.hpp"

namespace raytorus::golden {
namespace {

int marginalPixels(const image::Image& truth) {
    int marginal = 0;
    for (int y = 0; y < truth.height; ++y) {
        for (int x = 0; x < truth.width; ++x) {
            bool flips = false;
            for (const char* name : {"margin", "margin.count", "margin.color"}) {
                flips = flips || truth.pixel(x, y)[static_cast<std::size_t>(truth.channelIndex(name))] < 1.0F;
            }
            marginal += flips ? 1 : 0;
        }
    }
    return marginal;
}

void requireAgreement(const Case& row, const render::Scene& scene, const truth::TruthOptions& options) {
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

void enterInManifest(const Set& set, const Case& row) {
    image::Manifest manifest;
    if (std::filesystem::exists(set.manifest())) {
        manifest = image::readManifest(set.manifest());
    }
    const std::string name = set.truth(row).filename().string();
    const image::Manifest now = image::manifestOf(set.folder());
    manifest.files[name] = now.files.at(name);
    image::writeManifest(set.manifest(), manifest);
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
}

Renewal renew(const Set& set, const Case& row, const std::string& reason,
              const std::function<void(double)>& progress) {
    requireRenewal(reason);
    const render::Scene scene = render::readScene(set.scene(row));
    truth::TruthOptions options;
    options.samplesPerSide = row.samplesPerSide;
    requireAgreement(row, scene, options);
    options.sharpness = true;
    options.progress = progress;
    const image::Image truth = truth::renderTruth(scene, scene.imageWidth, scene.imageHeight, options);
    const Renewal renewal{truth.width * truth.height, marginalPixels(truth)};
    const nlohmann::ordered_json sidecar = {{"case", row.name},
                                            {"reason", reason},
                                            {"reference", "113 bits, questioned by 104 bits"},
                                            {"raytorus", version()},
                                            {"scene", sceneHash(set, row)},
                                            {"samplesPerPixel", row.samplesPerSide * row.samplesPerSide},
                                            {"pixels", renewal.pixels},
                                            {"marginalPixels", renewal.marginal}};
    image::writeImage(set.truth(row), truth);
    const std::string text = sidecar.dump(2) + "\n";
    writeFile(set.sidecar(row), std::as_bytes(std::span(text)));
    enterInManifest(set, row);
    return renewal;
}

}  // namespace raytorus::golden
