// SPDX-License-Identifier: MIT
#include "render/picture_targets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "core/error.hpp"

namespace raytorus::render {
namespace {

// For each image, the channels its four components become; "" is dropped, and comes last.
constexpr std::array<std::array<const char*, 4>, 4> components = {{
    {"R", "G", "B", "A"},
    {"position.x", "position.y", "position.z", "t"},
    {"normal.x", "normal.y", "normal.z", "count"},
    {"uv.u", "uv.v", "id", ""},
}};

const std::array<const char*, 15> channelOrder = {
    "R",        "G",        "B",        "A",    "t",    "position.x", "position.y", "position.z",
    "normal.x", "normal.y", "normal.z", "uv.u", "uv.v", "count",      "id"};

constexpr std::ptrdiff_t colorChannels = 4;

std::vector<std::string> channelNames(bool aovs) {
    return {channelOrder.begin(), aovs ? channelOrder.end() : channelOrder.begin() + colorChannels};
}

// The values of image i to the channels that they become.
void distribute(std::span<const float> values, std::size_t i, image::Image& picture) {
    if (picture.channelCount() == colorChannels) {
        std::ranges::copy(values, picture.pixels.begin());
        return;
    }
    std::array<std::ptrdiff_t, 4> channels{};
    std::size_t used = 0;
    for (; used < channels.size() && components[i][used][0] != '\0'; ++used) {
        channels[used] = picture.channelIndex(components[i][used]);
    }
    float* to = picture.pixels.data();
    for (std::size_t pixel = 0; pixel < values.size() / 4; ++pixel) {
        for (std::size_t component = 0; component < used; ++component) {
            to[channels[component]] = values[pixel * 4 + component];
        }
        to += picture.channelCount();
    }
}

}  // namespace

PictureTargets::PictureTargets(const gpu::Context& context, VkExtent2D extent, bool aovs) {
    const std::string problem = image::shapeProblem(static_cast<int>(extent.width),
                                                    static_cast<int>(extent.height), channelNames(aovs));
    if (!problem.empty()) {
        throw Error(ExitCode::OutOfMemory, fmt::format("the picture is too large: {}", problem));
    }
    for (std::size_t i = 0; i < imageCount(aovs); ++i) {
        targets.emplace_back(context, extent);
    }
}

std::size_t PictureTargets::imageCount(bool aovs) {
    return aovs ? components.size() : 1;
}

void PictureTargets::begin(VkCommandBuffer commands, gpu::Use use, VkImageLayout layout) const {
    for (const gpu::Image& target : targets) {
        gpu::imageBarrier(commands, target, {}, VK_IMAGE_LAYOUT_UNDEFINED, use, layout);
    }
}

image::Image PictureTargets::readBack(gpu::Context& context, VkExtent2D extent, gpu::Use use,
                                      VkImageLayout layout) const {
    const std::size_t pixels = std::size_t{extent.width} * extent.height;
    image::Image picture(static_cast<int>(extent.width), static_cast<int>(extent.height),
                         channelNames(targets.size() > 1));
    // One image at a time through one buffer: a picture with everything needs memory for itself and little
    // more.
    const gpu::Buffer buffer(context, pixels * gpu::Image::bytesPerPixel, gpu::BufferUse::ReadBack);
    for (std::size_t i = 0; i < targets.size(); ++i) {
        context.submit([&](VkCommandBuffer commands) {
            gpu::imageBarrier(commands, targets[i], use, layout, gpu::copyRead,
                              VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
            gpu::copyOut(commands, targets[i], extent, buffer);
            gpu::bufferBarrier(commands, buffer, gpu::copyWrite, gpu::hostRead);
        });
        distribute(buffer.as<const float>().first(pixels * 4), i, picture);
    }
    return picture;
}

}  // namespace raytorus::render
