// SPDX-License-Identifier: MIT
// OpenEXR both ways by its own library: for where OpenImageIO, which is far larger than all else, is not. A
// module of its own, see CMakeLists.txt.
#include <Iex.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfTileDescription.h>
#include <ImfVersion.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>

#include "image/codec_checks.hpp"
#include "image/codec_module.hpp"

namespace raytorus::image {

namespace {

constexpr std::size_t headerStart = 8;  // after the signature and the version, 4 bytes each

class Input : public Imf::IStream {
public:
    explicit Input(std::span<const std::byte> allBytes) : IStream("the file"), bytes(allBytes) {}

    bool read(char* to, int size) override {
        if (size < 0 || static_cast<std::size_t>(size) > bytes.size() - place) {
            throw Iex::InputExc("it ends too early");
        }
        std::memcpy(to, bytes.data() + place, static_cast<std::size_t>(size));
        place += static_cast<std::size_t>(size);
        return place < bytes.size();
    }
    std::uint64_t tellg() override { return place; }
    void seekg(std::uint64_t to) override { place = std::min<std::uint64_t>(to, bytes.size()); }

private:
    std::span<const std::byte> bytes;
    std::size_t place = 0;
};

class Output : public Imf::OStream {
public:
    Output() : OStream("the file") {}

    void write(const char* from, int size) override {
        const auto raw = std::as_bytes(std::span(from, static_cast<std::size_t>(size)));
        bytes.resize(std::max(bytes.size(), place + raw.size()));
        std::ranges::copy(raw, bytes.begin() + static_cast<std::ptrdiff_t>(place));
        place += raw.size();
    }
    std::uint64_t tellp() override { return place; }
    void seekp(std::uint64_t to) override { place = to; }

    std::vector<std::byte> bytes;

private:
    std::size_t place = 0;
};

std::uint32_t numberAt(std::span<const std::byte> bytes, std::size_t place) {
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < sizeof number; ++i) {
        number |= std::to_integer<std::uint32_t>(bytes[place + i]) << 8 * i;
    }
    return number;
}

// OpenEXR makes room for a whole attribute before it sees that the file ends.
bool attributesFit(std::span<const std::byte> rest) {
    const auto passText = [&] {
        const auto size = static_cast<std::size_t>(std::ranges::find(rest, std::byte{0}) - rest.begin());
        rest = rest.subspan(std::min(size + 1, rest.size()));
        return size;
    };
    while (passText() > 0) {  // its name
        passText();           // its type
        if (rest.size() < sizeof(std::uint32_t) || numberAt(rest, 0) > rest.size() - sizeof(std::uint32_t)) {
            return false;
        }
        rest = rest.subspan(sizeof(std::uint32_t) + numberAt(rest, 0));
    }
    return true;
}

// What a file says of itself, before any of its values is read or room for them made.
struct Shape {
    Imath::Box2i window;
    int width = 0, height = 0;
    std::vector<std::string> names;
    SampleType sampleType = SampleType::Float32;
    int step = 1;  // rows of a tile
};

int asInt(std::int64_t side) {
    return static_cast<int>(std::clamp<std::int64_t>(side, 0, std::int64_t{INT32_MAX}));
}

Shape shapeOf(const Imf::Header& header, std::string_view name) {
    Shape shape;
    shape.window = header.dataWindow();
    shape.width = asInt(std::int64_t{shape.window.max.x} - shape.window.min.x + 1);
    shape.height = asInt(std::int64_t{shape.window.max.y} - shape.window.min.y + 1);
    for (auto i = header.channels().begin(); i != header.channels().end(); ++i) {
        const Imf::Channel& channel = i.channel();
        if (channel.type != Imf::HALF && channel.type != Imf::FLOAT) {
            failReading(name, fmt::format("its channel {} holds integers, not floats", i.name()));
        }
        if (channel.xSampling != 1 || channel.ySampling != 1) {
            failReading(name, fmt::format("its channel {} has not a value for every pixel", i.name()));
        }
        shape.names.emplace_back(i.name());
        shape.sampleType = channel.type == Imf::HALF ? SampleType::Float16 : shape.sampleType;
    }
    if (const std::string problem = shapeProblem(shape.width, shape.height, shape.names); !problem.empty()) {
        failReading(name, problem);
    }
    if (header.hasTileDescription()) {  // OpenEXR makes room for whole tiles
        const Imf::TileDescription& tile = header.tileDescription();
        if (!shapeProblem(asInt(tile.xSize), asInt(tile.ySize), shape.names).empty()) {
            failReading(name, fmt::format("its tiles of {} x {} are none", tile.xSize, tile.ySize));
        }
        shape.step = asInt(tile.ySize);
    }
    if (header.dataWindow() != header.displayWindow()) {
        failReading(name, "its data window is not its display window");
    }
    return shape;
}

template <typename Read>
void reading(std::string_view name, Read read) {
    std::string problem;
    try {
        read();
        return;
    } catch (const std::exception& exception) {
        problem = exception.what();
    }
    failReading(name, fmt::format("it is truncated or corrupt ({})", oneLine(problem)));
}

Shape readShape(std::span<const std::byte> bytes, std::string_view name) {
    checkSignature(bytes, Format::Exr, name);
    if (bytes.size() < headerStart || !attributesFit(bytes.subspan(headerStart))) {
        failReading(name, "it is truncated or corrupt (it ends too early)");
    }
    int version = static_cast<int>(numberAt(bytes, headerStart / 2));
    if (Imf::isNonImage(version)) {
        failReading(name, "it holds deep or volume pixels, not one value a channel");
    }
    if (Imf::isMultiPart(version)) {
        failReading(name, "it has several parts, not one image");
    }
    Imf::Header header;
    reading(name, [&] {
        Input input(bytes);
        input.seekg(headerStart);
        header.readFrom(input, version);
    });
    return shapeOf(header, name);
}

// Interleaved values of these channels, from the window's first row. Only written to when a file is read into
// it.
Imf::FrameBuffer frameBuffer(const float* values, const Imath::Box2i& window, int width,
                             std::span<const std::string> names) {
    const std::size_t pixel = names.size() * sizeof(float);
    Imf::FrameBuffer frame;
    for (std::size_t i = 0; i < names.size(); ++i) {
        frame.insert(names[i], Imf::Slice::Make(Imf::FLOAT, values + i, window, pixel,
                                                pixel * static_cast<std::size_t>(width)));
    }
    return frame;
}

Image decodeHeader(std::span<const std::byte> bytes, std::string_view name) {
    const Shape shape = readShape(bytes, name);
    return ImageFill(shape.width, shape.height, shape.names, shape.sampleType).take();
}

Image decodeExr(std::span<const std::byte> bytes, std::string_view name) {
    const Shape shape = readShape(bytes, name);
    ImageFill fill(shape.width, shape.height, shape.names, shape.sampleType);
    const int rows = rowsAtATime(shape.width, shape.height, shape.names.size(), shape.step);
    std::vector<float> values(static_cast<std::size_t>(shape.width) * static_cast<std::size_t>(rows) *
                              shape.names.size());
    reading(name, [&] {
        Input input(bytes);
        Imf::InputFile file(input, 0);
        for (int row = 0; row < shape.height; row += rows) {
            Imath::Box2i band = shape.window;
            band.min.y += row;
            band.max.y = std::min(band.min.y + rows - 1, shape.window.max.y);
            file.setFrameBuffer(frameBuffer(values.data(), band, shape.width, shape.names));
            file.readPixels(band.min.y, band.max.y);
            const auto count = static_cast<std::size_t>(band.max.y - band.min.y + 1);
            fill.append(
                std::span(values).first(count * static_cast<std::size_t>(shape.width) * shape.names.size()));
        }
    });
    return fill.take();
}

std::vector<std::byte> encodeExr(const Image& image, std::string_view name) {
    Output output;
    try {
        Imf::Header header(image.width, image.height);
        header.compression() = Imf::ZIP_COMPRESSION;
        Imf::addCapDate(header, "");  // as OpenImageIO, who insists on having one
        for (const std::string& channel : image.channelNames) {
            header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
        }
        Imf::OutputFile file(output, header, 0);
        file.setFrameBuffer(
            frameBuffer(image.pixels.data(), header.dataWindow(), image.width, image.channelNames));
        file.writePixels(image.height);
    } catch (const std::exception& exception) {
        failWriting(name, oneLine(exception.what()));
    }
    return std::move(output.bytes);
}

constexpr Codec codec = {encodeExr, decodeHeader, decodeExr};

}  // namespace

}  // namespace raytorus::image

extern "C" const raytorus::image::Codec* raytorusCodec() {
    return &raytorus::image::codec;
}
