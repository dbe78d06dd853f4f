// SPDX-License-Identifier: MIT
#include "viewer/pictures.hpp"

#include <chrono>

namespace raytorus::viewer {
namespace {

using Clock = std::chrono::steady_clock;

}  // namespace

bool Wish::samePicture(const Wish& other) const {
    const bool sameLeft = shaderVersions[0] == other.shaderVersions[0] && routes[0] == other.routes[0];
    const bool sameRight =
        !right || (shaderVersions[1] == other.shaderVersions[1] && routes[1] == other.routes[1]);
    return sameLeft && sameRight && right == other.right && samplesPerSide == other.samplesPerSide &&
           scene == other.scene;
}

Pictures::Pictures(gpu::Context& gpuContext, VkExtent2D size) : context(&gpuContext), windowSize(size) {
    live[0] = std::make_unique<render::LivePicture>(*context, size);
}

void Pictures::resize(VkExtent2D size) {
    if (size.width == windowSize.width && size.height == windowSize.height) {
        return;
    }
    windowSize = size;
    for (const auto& picture : live) {
        if (picture) {
            picture->resize(size);
        }
    }
    inWork.reset();
    complete.reset();
    lastChange = -1e9;
}

void Pictures::setShaders(const Wish& wish) {
    for (std::size_t i = 0; i < (wish.right ? 2U : 1U); ++i) {
        if (!live[i]) {
            live[i] = std::make_unique<render::LivePicture>(*context, windowSize);
        }
        if (versions[i] != wish.shaderVersions[i] || routes[i] != wish.routes[i]) {
            live[i]->setShaders(wish.scene, wish.shaders[i], wish.routes[i]);
            versions[i] = wish.shaderVersions[i];
            routes[i] = wish.routes[i];
            inWork.reset();
        }
    }
}

std::optional<Quality> Pictures::next(double now) const {
    const bool rests = wanted.still || now - lastChange >= restSeconds;
    if (!complete || complete == Quality::Moving) {
        return rests ? std::optional(Quality::Full) : std::nullopt;
    }
    if (complete == Quality::Full && wanted.samplesPerSide > 1) {
        return Quality::Refined;
    }
    return std::nullopt;
}

void Pictures::update(const Wish& wish, double now) {
    if (inWork == Quality::Moving) {
        // It is finished first, however much has moved since: else a hand that never rests would see nothing.
        return;
    }
    const bool changed = !hasWish || !wanted.samePicture(wish);
    // Another view of a small picture without its geometry needs that geometry.
    const bool missing = wish.aovs && !wanted.aovs && complete == Quality::Moving;
    if (changed || missing) {
        setShaders(wish);
        const bool first = !hasWish;
        wanted = wish;
        hasWish = true;
        complete = first ? std::nullopt : complete;
        lastChange = now;
        begin(first || wish.still ? Quality::Full : Quality::Moving);
        return;
    }
    wanted.aovs = wish.aovs;
    wanted.still = wish.still;
    if (inWork) {
        return;
    }
    if (const std::optional<Quality> quality = next(now)) {
        begin(*quality);
    }
}

void Pictures::begin(Quality quality) {
    workExtent = quality == Quality::Moving ? resolution.movingExtent(windowSize) : windowSize;
    workSamples = quality == Quality::Refined ? wanted.samplesPerSide : 1;
    const bool aovs = quality == Quality::Full || (quality == Quality::Moving && wanted.aovs);
    for (std::size_t i = 0; i < (wanted.right ? 2U : 1U); ++i) {
        const bool sameTori = drawnScene[i] && drawnScene[i]->tori == wanted.scene.tori &&
                              drawnScene[i]->materials == wanted.scene.materials;
        live[i]->begin(wanted.scene, {workExtent, workSamples, aovs}, sameTori);
        drawnScene[i] = wanted.scene;
        ready[i] = false;
    }
    inWork = quality;
}

bool Pictures::draw(double seconds) {
    if (!inWork) {
        return false;
    }
    double left = seconds;
    double spent = 0.0;
    bool all = true;
    bool compiled = false;
    for (std::size_t i = 0; i < (wanted.right ? 2U : 1U); ++i) {
        if (!ready[i] && left > 0.0) {
            const Clock::time_point start = Clock::now();
            ready[i] = live[i]->draw(left);
            left -= std::chrono::duration<double>(Clock::now() - start).count();
        }
        all = all && ready[i];
        spent += live[i]->times().seconds;
        compiled = compiled || live[i]->times().compiled;
    }
    if (!all) {
        return false;
    }
    if (!compiled) {
        resolution.learn(workExtent, workSamples * workSamples, spent);
    }
    complete = inWork;
    inWork.reset();
    shownExtent = workExtent;
    shownSamples = workSamples * workSamples;
    return true;
}

bool Pictures::settled() const {
    if (inWork || !complete || complete == Quality::Moving) {
        return false;
    }
    return complete == Quality::Refined || wanted.samplesPerSide == 1;
}

}  // namespace raytorus::viewer
