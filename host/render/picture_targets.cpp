// SPDX-License-Identifier: MIT
#include "render/picture_targets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "image/channels.hpp"

namespace raytorus::render {
namespace {

using image::ChannelKind;

std::vector<std::string> channelNames(bool aovs) {
    return aovs ? image::channelsOf({ChannelKind::Color, ChannelKind::Alpha, ChannelKind::Geometry})
                : image::channelsOf({ChannelKind::Color, ChannelKind::Alpha});
}

// Where the channels of a picture find their values in image i.
struct Way {
    std::size_t component;
    std::size_t channel;
};

std::vector<Way> waysFrom(std::size_t i, const image::Image& picture) {
    std::vector<Way> ways;
    for (std::size_t channel = 0; channel < picture.channelNames.size(); ++channel) {
        const std::string& name = picture.channelNames[channel];
        const image::Quantity& quantity = *image::findQuantity(name);
        if (quantity.first.image == i) {
            const auto before = std::ranges::find(quantity.names, name) - quantity.names.begin();
            ways.push_back({quantity.first.component + static_cast<std::size_t>(before), channel});
        }
    }
    return ways;
}

// The values of image i to the channels that they become.
void distribute(std::span<const float> values, std::size_t i, image::Image& picture) {
    const std::vector<Way> ways = waysFrom(i, picture);
    float* to = picture.pixels.data();
    for (std::size_t pixel = 0; pixel < values.size() / 4; ++pixel) {
        for (const Way& way : ways) {
            to[way.channel] = values[pixel * 4 + way.component];
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
    constexpr auto imageOf = [](const image::Quantity& quantity) { return quantity.first.image; };
    return aovs ? imageOf(std::ranges::max(image::quantities, {}, imageOf)) + 1 : 1;
}

void PictureTargets::begin(VkCommandBuffer commands, gpu::Use use, VkImageLayout layout) const {
    for (const gpu::DeviceImage& target : targets) {
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
    const gpu::Buffer buffer(context, pixels * gpu::DeviceImage::bytesPerPixel, gpu::BufferUse::ReadBack);
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
