// SPDX-License-Identifier: MIT
// OpenEXR both ways, and PNG from a file, by way of OpenImageIO. A module of its own, see CMakeLists.txt.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <tuple>
#include <utility>

#include "core/error.hpp"
#include "image/codec_checks.hpp"
#include "image/codec_module.hpp"
#include "image/png_chunks.hpp"

namespace raytorus::image {

namespace {

const char* pluginName(Format format) {
    return format == Format::Exr ? "openexr" : "png";
}

std::vector<std::byte> encodeExr(const Image& image, std::string_view name) {
    OIIO::ImageSpec spec(image.width, image.height, image.channelCount(), OIIO::TypeDesc::FLOAT);
    spec.channelnames = image.channelNames;
    spec.attribute("compression", "zip");
    spec.attribute("DateTime", "");  // left out, OpenImageIO would store the time of writing
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    OIIO::Filesystem::IOProxy* const proxy = &memory;
    spec.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(pluginName(Format::Exr));
    if (!output) {
        failWriting(name, oneLine(OIIO::geterror()));
    }
    if (!output->open(std::string(name), spec) || !output->write_image(spec.format, image.pixels.data()) ||
        !output->close()) {
        failWriting(name, oneLine(output->geterror()));
    }
    const auto stored = std::as_bytes(std::span(bytes));
    return {stored.begin(), stored.end()};
}

void checkSpec(const OIIO::ImageSpec& spec, Format format, std::string_view name) {
    if (const std::string problem = shapeProblem(spec.width, spec.height, spec.channelnames);
        !problem.empty()) {
        failReading(name, problem);
    }
    if (spec.deep || spec.depth > 1) {
        failReading(name, "it holds deep or volume pixels, not one value a channel");
    }
    if (spec.x != spec.full_x || spec.y != spec.full_y || spec.width != spec.full_width ||
        spec.height != spec.full_height) {
        failReading(name, "its data window is not its display window");
    }
    for (int channel = 0; format == Format::Exr && channel < spec.nchannels; ++channel) {
        if (!spec.channelformat(channel).is_floating_point()) {
            failReading(name,
                        fmt::format("its channel {} holds integers, not floats", spec.channel_name(channel)));
        }
    }
}

SampleType sampleTypeOf(const OIIO::ImageSpec& spec, Format format) {
    if (format == Format::Png) {
        return spec.format == OIIO::TypeDesc::UINT16 ? SampleType::Unsigned16 : SampleType::Unsigned8;
    }
    for (int channel = 0; channel < spec.nchannels; ++channel) {
        if (spec.channelformat(channel) == OIIO::TypeDesc::HALF) {
            return SampleType::Float16;
        }
    }
    return SampleType::Float32;
}

// The values as stored, in the file's order of channels, as floats.
template <typename Stored>
std::vector<float> readValues(OIIO::ImageInput& input, OIIO::TypeDesc type, float one,
                              std::string_view name) {
    const OIIO::ImageSpec spec = input.spec();
    std::vector<Stored> stored(static_cast<std::size_t>(spec.image_pixels()) *
                               static_cast<std::size_t>(spec.nchannels));
    if (!input.read_image(0, 0, 0, spec.nchannels, type, stored.data())) {
        failReading(name, fmt::format("it is truncated or corrupt ({})", oneLine(input.geterror())));
    }
    if constexpr (std::is_same_v<Stored, float>) {
        return stored;
    } else {
        std::vector<float> values(stored.size());
        std::ranges::transform(stored, values.begin(),
                               [one](Stored value) { return static_cast<float>(value) / one; });
        return values;
    }
}

Image decodeImage(std::span<const std::byte> bytes, Format format, std::string_view name) {
    checkSignature(bytes, format, name);
    if (const std::string problem = format == Format::Png ? pngProblem(bytes) : std::string();
        !problem.empty()) {
        failReading(name, problem);
    }
    OIIO::Filesystem::IOMemReader memory(const_cast<std::byte*>(bytes.data()), bytes.size());
    OIIO::Filesystem::IOProxy* const proxy = &memory;
    OIIO::ImageSpec config;
    config.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
    config.attribute("oiio:UnassociatedAlpha", 1);  // values as stored: not multiplied by alpha
    const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create(pluginName(format));
    if (!input) {
        failReading(name, oneLine(OIIO::geterror()));
    }
    OIIO::ImageSpec spec;
    if (!input->open(std::string(name), spec, config)) {
        failReading(name, fmt::format("it is truncated or corrupt ({})", oneLine(input->geterror())));
    }
    checkSpec(spec, format, name);
    std::vector<float> values;
    if (format == Format::Exr) {
        values = readValues<float>(*input, OIIO::TypeDesc::FLOAT, 1.0f, name);
    } else if (spec.format == OIIO::TypeDesc::UINT16) {
        values = readValues<std::uint16_t>(*input, OIIO::TypeDesc::UINT16, 65535.0f, name);
    } else {
        values = readValues<std::uint8_t>(*input, OIIO::TypeDesc::UINT8, 255.0f, name);
    }
    if (input->seek_subimage(1, 0)) {
        failReading(name, "it has several parts, not one image");
    }
    std::ignore =
        input->geterror();  // that there is no second part is no error; unread, OpenImageIO prints it

    Image image = arrangedImage(spec.width, spec.height, spec.channelnames, values);
    image.sampleType = sampleTypeOf(spec, format);
    return image;
}

constexpr Codec codec = {encodeExr, decodeImage};

}  // namespace

}  // namespace raytorus::image

extern "C" const raytorus::image::Codec* raytorusCodec() {
    return &raytorus::image::codec;
}
