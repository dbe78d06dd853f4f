// SPDX-License-Identifier: MIT
// OpenEXR both ways, by way of OpenImageIO. A module of its own, see CMakeLists.txt.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <tuple>
#include <utility>

#include "core/error.hpp"
#include "image/codec_checks.hpp"
#include "image/codec_module.hpp"

namespace raytorus::image {

namespace {

constexpr const char* pluginName = "openexr";

std::vector<std::byte> encodeExr(const Image& image, std::string_view name) {
    OIIO::ImageSpec spec(image.width, image.height, image.channelCount(), OIIO::TypeDesc::FLOAT);
    spec.channelnames = image.channelNames;
    spec.attribute("compression", "zip");
    spec.attribute("DateTime", "");  // left out, OpenImageIO would store the time of writing
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    OIIO::Filesystem::IOProxy* const proxy = &memory;
    spec.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(pluginName);
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

void checkSpec(const OIIO::ImageSpec& spec, std::string_view name) {
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
    for (int channel = 0; channel < spec.nchannels; ++channel) {
        if (!spec.channelformat(channel).is_floating_point()) {
            failReading(name,
                        fmt::format("its channel {} holds integers, not floats", spec.channel_name(channel)));
        }
    }
}

SampleType sampleTypeOf(const OIIO::ImageSpec& spec) {
    for (int channel = 0; channel < spec.nchannels; ++channel) {
        if (spec.channelformat(channel) == OIIO::TypeDesc::HALF) {
            return SampleType::Float16;
        }
    }
    return SampleType::Float32;
}

// An open file, of which the header has been read.
class Input {
public:
    Input(std::span<const std::byte> bytes, std::string_view fileName)
        : name(fileName), memory(const_cast<std::byte*>(bytes.data()), bytes.size()), proxy(&memory) {
        checkSignature(bytes, Format::Exr, name);
        OIIO::ImageSpec config;
        config.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
        input = OIIO::ImageInput::create(pluginName);
        if (!input) {
            failReading(name, oneLine(OIIO::geterror()));
        }
        if (!input->open(std::string(name), spec, config)) {
            fail();
        }
        checkSpec(spec, name);
    }

    [[nodiscard]] ImageFill fill() const {
        return {spec.width, spec.height, spec.channelnames, sampleTypeOf(spec)};
    }

    [[nodiscard]] Image image() {
        ImageFill filled = fill();
        const auto channels = static_cast<std::size_t>(spec.nchannels);
        const bool tiled = spec.tile_width > 0;
        const int rows = rowsAtATime(spec.width, spec.height, channels, tiled ? spec.tile_height : 1);
        std::vector<float> values(static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(rows) *
                                  channels);
        for (int row = 0; row < spec.height; row += rows) {
            const int end = std::min(row + rows, spec.height);
            const int y = spec.y;
            const OIIO::TypeDesc type = OIIO::TypeDesc::FLOAT;
            const bool whole =
                tiled ? input->read_tiles(0, 0, spec.x, spec.x + spec.width, y + row, y + end, spec.z,
                                          spec.z + 1, 0, spec.nchannels, type, values.data())
                      : input->read_scanlines(0, 0, y + row, y + end, spec.z, 0, spec.nchannels, type,
                                              values.data());
            if (!whole) {
                fail();
            }
            filled.append(std::span(values).first(static_cast<std::size_t>(end - row) *
                                                  static_cast<std::size_t>(spec.width) * channels));
        }
        return filled.take();
    }

    void requireOnePart() {
        if (input->seek_subimage(1, 0)) {
            failReading(name, "it has several parts, not one image");
        }
        std::ignore =
            input->geterror();  // that there is no second part is no error; unread, OpenImageIO prints it
    }

private:
    [[noreturn]] void fail() {
        failReading(name, fmt::format("it is truncated or corrupt ({})", oneLine(input->geterror())));
    }

    std::string_view name;
    OIIO::Filesystem::IOMemReader memory;
    OIIO::Filesystem::IOProxy* proxy;
    std::unique_ptr<OIIO::ImageInput> input;
    OIIO::ImageSpec spec;
};

Image decodeHeader(std::span<const std::byte> bytes, std::string_view name) {
    Input input(bytes, name);
    input.requireOnePart();
    return input.fill().take();
}

Image decodeExr(std::span<const std::byte> bytes, std::string_view name) {
    Input input(bytes, name);
    Image image = input.image();
    input.requireOnePart();
    return image;
}

constexpr Codec codec = {encodeExr, decodeHeader, decodeExr};

}  // namespace

}  // namespace raytorus::image

extern "C" const raytorus::image::Codec* raytorusCodec() {
    return &raytorus::image::codec;
}
