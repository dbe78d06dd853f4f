// SPDX-License-Identifier: MIT
// OpenEXR files of rows: a header of attributes, a table of where the chunks are, and chunks of 1 or 16 rows,
// each row one channel after the other.
#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <optional>

#include "image/codec_checks.hpp"
#include "image/plain_codec.hpp"

namespace raytorus::image::plain {

namespace {

static_assert(std::endian::native == std::endian::little, "numbers are copied as they lie in the file");

constexpr std::uint32_t magic = 20000630;
constexpr std::uint32_t version = 2, tiled = 0x200, longNames = 0x400, deep = 0x800, severalParts = 0x1000;
constexpr std::size_t shortName = 31;
enum : std::int32_t { Half = 1, Float = 2 };  // of a channel
enum : std::uint8_t { NotCompressed = 0, ZipOfOneRow = 2, Zip = 3 };
constexpr int rowsOfZip = 16;
constexpr int zipLevel = 4;  // OpenEXR's

// Bytes read one after the other.
class Reader {
public:
    Reader(std::span<const std::byte> allBytes, std::string_view imageName)
        : bytes(allBytes), name(imageName) {}

    template <typename T>
    T number() {
        T value;
        std::memcpy(&value, take(sizeof value).data(), sizeof value);
        return value;
    }

    std::string text() {
        const auto end = std::ranges::find(bytes, std::byte{0});
        const std::span<const std::byte> found = take(static_cast<std::size_t>(end - bytes.begin()));
        take(1);
        return {reinterpret_cast<const char*>(found.data()), found.size()};
    }

    std::span<const std::byte> take(std::size_t size) {
        if (size > bytes.size()) {
            failReading(name, "it is truncated or corrupt");
        }
        const std::span<const std::byte> taken = bytes.first(size);
        bytes = bytes.subspan(size);
        return taken;
    }

private:
    std::span<const std::byte> bytes;
    std::string_view name;
};

struct Window {
    std::int32_t xMin = 0, yMin = 0, xMax = -1, yMax = -1;

    friend bool operator==(const Window&, const Window&) = default;
};

struct Header {
    std::vector<std::string> names;
    std::vector<std::int32_t> types;  // of the channels
    std::optional<std::uint8_t> compression;
    Window data, display;
    int width = 0, height = 0;

    [[nodiscard]] int rowsOfChunk() const { return compression == Zip ? rowsOfZip : 1; }
    [[nodiscard]] std::size_t rowBytes() const {
        std::size_t bytes = 0;
        for (const std::int32_t type : types) {
            bytes += static_cast<std::size_t>(width) * (type == Half ? 2 : 4);
        }
        return bytes;
    }
};

void readChannels(Header& header, Reader reader, std::string_view name) {
    for (std::string channel = reader.text(); !channel.empty(); channel = reader.text()) {
        const auto type = reader.number<std::int32_t>();
        reader.number<std::uint32_t>();  // linear or not, which only a lossy compression asks for
        const auto across = reader.number<std::int32_t>(), down = reader.number<std::int32_t>();
        if (type != Half && type != Float) {
            failReading(name, fmt::format("its channel {} holds integers, not floats", channel));
        }
        if (across != 1 || down != 1) {
            failReading(name, fmt::format("its channel {} has not a value for every pixel", channel));
        }
        header.names.push_back(channel);
        header.types.push_back(type);
    }
}

void checkHeader(Header& header, std::string_view name) {
    const Window& data = header.data;
    const std::int64_t width = std::int64_t{data.xMax} - data.xMin + 1;
    const std::int64_t height = std::int64_t{data.yMax} - data.yMin + 1;
    const auto asInt = [](std::int64_t side) {
        return static_cast<int>(std::clamp<std::int64_t>(side, 0, std::int64_t{INT32_MAX}));
    };
    header.width = asInt(width);
    header.height = asInt(height);
    if (const std::string problem = shapeProblem(header.width, header.height, header.names);
        !problem.empty()) {
        failReading(name, problem);
    }
    if (data != header.display) {
        failReading(name, "its data window is not its display window");
    }
    if (header.compression != NotCompressed && header.compression != ZipOfOneRow &&
        header.compression != Zip) {
        failReading(name, "it is compressed in a way that needs OpenImageIO, which could not be loaded");
    }
}

Header readHeader(Reader& reader, std::string_view name) {
    reader.number<std::uint32_t>();  // the signature
    const auto flags = reader.number<std::uint32_t>();
    if ((flags & deep) != 0) {
        failReading(name, "it holds deep or volume pixels, not one value a channel");
    }
    if ((flags & severalParts) != 0) {
        failReading(name, "it has several parts, not one image");
    }
    if ((flags & ~longNames) != version) {
        failReading(name, "it is laid out in a way that needs OpenImageIO, which could not be loaded");
    }
    Header header;
    for (std::string attribute = reader.text(); !attribute.empty(); attribute = reader.text()) {
        const std::string type = reader.text();
        const std::span<const std::byte> value = reader.take(reader.number<std::uint32_t>());
        if (attribute == "channels" && type == "chlist") {
            readChannels(header, Reader(value, name), name);
        } else if (attribute == "compression") {
            header.compression = Reader(value, name).number<std::uint8_t>();
        } else if (attribute == "dataWindow") {
            header.data = Reader(value, name).number<Window>();
        } else if (attribute == "displayWindow") {
            header.display = Reader(value, name).number<Window>();
        }
    }
    checkHeader(header, name);
    return header;
}

// Before a chunk is zipped, bytes at even places go to its first half and each becomes the difference to the
// one before.
std::vector<std::uint8_t> unzipped(std::span<const std::byte> stored, std::size_t size,
                                   std::string_view name) {
    std::vector<std::uint8_t> mixed(size);
    uLongf got = size;
    const auto* const from = reinterpret_cast<const Bytef*>(stored.data());
    if (uncompress(mixed.data(), &got, from, stored.size()) != Z_OK || got != size) {
        failReading(name, "it is truncated or corrupt (a chunk cannot be unzipped)");
    }
    for (std::size_t i = 1; i < size; ++i) {
        mixed[i] = static_cast<std::uint8_t>(mixed[i - 1] + mixed[i] - 128);
    }
    std::vector<std::uint8_t> plain(size);
    const std::size_t half = (size + 1) / 2;
    for (std::size_t i = 0; i < size; ++i) {
        plain[i] = mixed[i / 2 + (i % 2 != 0 ? half : 0)];
    }
    return plain;
}

std::vector<std::uint8_t> zipped(std::span<const std::uint8_t> plain, std::string_view name) {
    const std::size_t size = plain.size(), half = (size + 1) / 2;
    std::vector<std::uint8_t> mixed(size);
    for (std::size_t i = 0; i < size; ++i) {
        mixed[i / 2 + (i % 2 != 0 ? half : 0)] = plain[i];
    }
    for (std::size_t i = size; i-- > 1;) {
        mixed[i] = static_cast<std::uint8_t>(mixed[i] - mixed[i - 1] + 128);
    }
    uLongf bytes = compressBound(size);
    std::vector<std::uint8_t> stored(bytes);
    if (compress2(stored.data(), &bytes, mixed.data(), size, zipLevel) != Z_OK) {
        failWriting(name, "zlib could not be set up");
    }
    stored.resize(bytes);
    return stored.size() < size ? stored : std::vector<std::uint8_t>(plain.begin(), plain.end());
}

float floatOf(std::uint16_t half) {
    const std::uint32_t sign = (half & 0x8000u) << 16, exponent = half >> 10 & 31u, mantissa = half & 1023u;
    if (exponent == 0) {  // zero or denormal
        const float size = static_cast<float>(mantissa) * 0x1p-24f;
        return sign != 0 ? -size : size;
    }
    const std::uint32_t wide = exponent == 31 ? 255 : exponent + 112;
    return std::bit_cast<float>(sign | wide << 23 | mantissa << 13);
}

// values: interleaved, of all rows of a chunk.
void readRows(const Header& header, std::span<const std::uint8_t> rows, std::span<float> values) {
    const auto width = static_cast<std::size_t>(header.width);
    const std::size_t channels = header.types.size(), rowValues = width * channels;
    const std::uint8_t* from = rows.data();
    for (std::size_t row = 0; row < values.size(); row += rowValues) {
        for (std::size_t channel = 0; channel < channels; ++channel) {
            for (std::size_t x = 0; x < width; ++x) {
                float& to = values[row + x * channels + channel];
                if (header.types[channel] == Half) {
                    std::uint16_t half = 0;
                    std::memcpy(&half, from, sizeof half);
                    to = floatOf(half);
                    from += sizeof half;
                } else {
                    std::memcpy(&to, from, sizeof to);
                    from += sizeof to;
                }
            }
        }
    }
}

std::vector<std::uint8_t> chunkRows(const Header& header, std::span<const std::byte> stored, std::size_t size,
                                    std::string_view name) {
    if (header.compression != NotCompressed && stored.size() < size) {
        return unzipped(stored, size, name);
    }
    if (stored.size() != size) {
        failReading(name, "it is truncated or corrupt (a chunk has the wrong size)");
    }
    const auto* const from = reinterpret_cast<const std::uint8_t*>(stored.data());
    return {from, from + size};
}

class Writer {
public:
    template <typename T>
    void number(T value) {
        const auto raw = std::bit_cast<std::array<std::byte, sizeof(T)>>(value);
        bytes.insert(bytes.end(), raw.begin(), raw.end());
    }
    void text(std::string_view text) {
        const auto raw = std::as_bytes(std::span(text));
        bytes.insert(bytes.end(), raw.begin(), raw.end());
        bytes.push_back(std::byte{0});
    }
    template <typename T>
    void attribute(std::string_view name, std::string_view type, T value) {
        text(name);
        text(type);
        number(static_cast<std::uint32_t>(sizeof value));
        number(value);
    }

    std::vector<std::byte> bytes;
};

void writeHeader(Writer& writer, const Image& image, std::span<const std::size_t> order) {
    std::size_t listBytes = 1;
    std::uint32_t flags = version;
    for (const std::string& name : image.channelNames) {
        listBytes += name.size() + 17;
        flags |= name.size() > shortName ? longNames : 0u;
    }
    writer.number(magic);
    writer.number(flags);
    writer.text("capDate");  // OpenImageIO's, who insists on having one
    writer.text("string");
    writer.number(std::uint32_t{0});
    writer.text("channels");
    writer.text("chlist");
    writer.number(static_cast<std::uint32_t>(listBytes));
    for (const std::size_t channel : order) {
        writer.text(image.channelNames[channel]);
        for (const std::int32_t number : {std::int32_t{Float}, 0, 1, 1}) {
            writer.number(number);
        }
    }
    writer.text("");
    const Window window = {0, 0, image.width - 1, image.height - 1};
    writer.attribute("compression", "compression", std::uint8_t{Zip});
    writer.attribute("dataWindow", "box2i", window);
    writer.attribute("displayWindow", "box2i", window);
    writer.attribute("lineOrder", "lineOrder", std::uint8_t{0});
    writer.attribute("pixelAspectRatio", "float", 1.0f);
    writer.attribute("screenWindowCenter", "v2f", std::array{0.0f, 0.0f});
    writer.attribute("screenWindowWidth", "float", 1.0f);
    writer.text("");
}

std::vector<std::uint8_t> rowsOf(const Image& image, std::span<const std::size_t> order, int first, int end) {
    std::vector<std::uint8_t> rows(static_cast<std::size_t>(end - first) *
                                   static_cast<std::size_t>(image.width) * order.size() * sizeof(float));
    std::uint8_t* to = rows.data();
    for (int y = first; y < end; ++y) {
        for (const std::size_t channel : order) {
            for (int x = 0; x < image.width; ++x) {
                std::memcpy(to, &image.pixel(x, y)[channel], sizeof(float));
                to += sizeof(float);
            }
        }
    }
    return rows;
}

}  // namespace

Image decodeExr(std::span<const std::byte> bytes, std::string_view name) {
    checkSignature(bytes, Format::Exr, name);
    Reader reader(bytes, name);
    const Header header = readHeader(reader, name);
    const std::size_t rowValues = static_cast<std::size_t>(header.width) * header.types.size();
    std::vector<std::uint64_t> places;
    for (int y = 0; y < header.height; y += header.rowsOfChunk()) {
        places.push_back(reader.number<std::uint64_t>());
    }
    std::vector<float> values(rowValues * static_cast<std::size_t>(header.height));
    int y = 0;
    for (const std::uint64_t place : places) {
        Reader chunk(bytes, name);
        chunk.take(place);
        if (chunk.number<std::int32_t>() != header.data.yMin + y) {
            failReading(name, "it is truncated or corrupt (a chunk is not where it should be)");
        }
        const std::span<const std::byte> stored = chunk.take(chunk.number<std::uint32_t>());
        const auto rows = static_cast<std::size_t>(std::min(header.rowsOfChunk(), header.height - y));
        readRows(header, chunkRows(header, stored, rows * header.rowBytes(), name),
                 std::span(values).subspan(rowValues * static_cast<std::size_t>(y), rowValues * rows));
        y += static_cast<int>(rows);
    }
    Image image = arrangedImage(header.width, header.height, header.names, values);
    const bool half = std::ranges::find(header.types, std::int32_t{Half}) != header.types.end();
    image.sampleType = half ? SampleType::Float16 : SampleType::Float32;
    return image;
}

std::vector<std::byte> encodeExr(const Image& image, std::string_view name) {
    std::vector<std::size_t> order(image.channelNames.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        order[i] = i;
    }
    std::ranges::sort(order, {},
                      [&](std::size_t channel) { return std::string_view(image.channelNames[channel]); });
    Writer writer;
    writeHeader(writer, image, order);
    const int chunks = (image.height + rowsOfZip - 1) / rowsOfZip;
    const std::size_t table = writer.bytes.size();
    writer.bytes.resize(table + static_cast<std::size_t>(chunks) * sizeof(std::uint64_t));
    for (int chunk = 0; chunk < chunks; ++chunk) {
        const std::uint64_t place = writer.bytes.size();
        std::memcpy(&writer.bytes[table + static_cast<std::size_t>(chunk) * sizeof place], &place,
                    sizeof place);
        const int first = chunk * rowsOfZip;
        const std::vector<std::uint8_t> stored =
            zipped(rowsOf(image, order, first, std::min(first + rowsOfZip, image.height)), name);
        writer.number(static_cast<std::int32_t>(first));
        writer.number(static_cast<std::uint32_t>(stored.size()));
        const auto raw = std::as_bytes(std::span(stored));
        writer.bytes.insert(writer.bytes.end(), raw.begin(), raw.end());
    }
    return std::move(writer.bytes);
}

}  // namespace raytorus::image::plain
