// SPDX-License-Identifier: MIT
#include "render/picture_targets.hpp"

#include <array>
#include <string>

namespace raytorus::render {
namespace {

// For each image, the channels its four components become; "" is dropped.
constexpr std::array<std::array<const char*, 4>, 4> components = {{
    {"R", "G", "B", "A"},
    {"position.x", "position.y", "position.z", "t"},
    {"normal.x", "normal.y", "normal.z", "count"},
    {"uv.u", "uv.v", "id", ""},
}};

const std::array<const char*, 15> channelOrder = {
    "R",        "G",        "B",        "A",    "t",    "position.x", "position.y", "position.z",
    "normal.x", "normal.y", "normal.z", "uv.u", "uv.v", "count",      "id"};

constexpr std::size_t colorChannels = 4;

}  // namespace

PictureTargets::PictureTargets(const gpu::Context& context, VkExtent2D extent, bool aovs) {
    for (std::size_t i = 0; i < (aovs ? components.size() : 1); ++i) {
        targets.emplace_back(context, extent);
    }
}

void PictureTargets::begin(VkCommandBuffer commands, gpu::Use use, VkImageLayout layout) const {
    for (const gpu::Image& target : targets) {
        gpu::imageBarrier(commands, target, {}, VK_IMAGE_LAYOUT_UNDEFINED, use, layout);
    }
}

image::Image PictureTargets::readBack(gpu::Context& context, gpu::Use use, VkImageLayout layout) const {
    const VkExtent2D extent = targets.front().extent();
    const std::size_t pixels = std::size_t{extent.width} * extent.height;
    const std::size_t channels = targets.size() > 1 ? channelOrder.size() : colorChannels;
    image::Image picture(
        static_cast<int>(extent.width), static_cast<int>(extent.height),
        std::vector<std::string>(channelOrder.begin(),
                                 channelOrder.begin() + static_cast<std::ptrdiff_t>(channels)));
    // One image at a time through one buffer: a picture with everything needs memory for itself and little
    // more.
    const gpu::Buffer buffer(context, pixels * gpu::Image::bytesPerPixel, gpu::BufferUse::ReadBack);
    for (std::size_t i = 0; i < targets.size(); ++i) {
        context.submit([&](VkCommandBuffer commands) {
            gpu::imageBarrier(commands, targets[i], use, layout, gpu::copyRead,
                              VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
            gpu::copyOut(commands, targets[i], buffer, 0);
            gpu::bufferBarrier(commands, buffer, gpu::copyWrite, gpu::hostRead);
        });
        const std::span<const float> values = buffer.as<const float>();
        for (std::size_t component = 0; component < 4; ++component) {
            const int channel = picture.channelIndex(components[i][component]);
            if (channel < 0) {
                continue;
            }
            float* to = picture.pixels.data() + channel;
            for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
                to[pixel * channels] = values[pixel * 4 + component];
            }
        }
    }
    return picture;
}

}  // namespace raytorus::render
