// SPDX-License-Identifier: MIT
#include "cli/ray_file.hpp"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "core/console.hpp"
#include "core/error.hpp"
#include "options/numbers.hpp"

namespace raytorus::cli {
namespace {

static_assert(std::endian::native == std::endian::little, "raw files are little-endian");

constexpr std::size_t rayFields = sizeof(trace::TraceRay) / sizeof(float);

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view space = " \t\r";
    const std::size_t first = text.find_first_not_of(space);
    return first == std::string_view::npos ? std::string_view()
                                           : text.substr(first, text.find_last_not_of(space) - first + 1);
}

// The fields of a line. Of those past the last that a ray has there is only the number.
struct Fields {
    explicit Fields(std::string_view line) {
        while (true) {
            const std::size_t comma = line.find(',');
            if (count < texts.size()) {
                texts[count] = trimmed(line.substr(0, comma));
            }
            ++count;
            if (comma == std::string_view::npos) {
                return;
            }
            line.remove_prefix(comma + 1);
        }
    }
    std::array<std::string_view, rayFields> texts;
    std::size_t count = 0;
};

// The names of the columns, in their order. Any other line that holds no ray is a fault: a first ray that is
// misspelt would else be taken for names, and be lost.
constexpr std::array<std::string_view, rayFields> columnNames = {
    "originX", "originY", "originZ", "tMin", "directionX", "directionY", "directionZ", "tMax"};

bool isHeader(const Fields& fields) {
    return fields.count == rayFields && fields.texts == columnNames;
}

// The sign, the nine digits of a float32, and what fmt puts between or behind them: a point and four zeros
// after it, seven zeros before it, or an exponent. With the comma, and rounded up.
constexpr std::size_t longestValue = 32;

char* writeValue(char* to, float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    if (bits == 0 || bits == std::bit_cast<std::uint32_t>(1.0F)) {  // most values of most files
        *to = bits == 0 ? '0' : '1';
        return to + 1;
    }
    return fmt::format_to(to, FMT_COMPILE("{}"), value);
}

const char* csvHeader(trace::Query query) {
    switch (query) {
        case trace::Query::All:
            return "count,t0,t1,t2,t3,x0,y0,z0,x1,y1,z1,x2,y2,z2,x3,y3,z3\n";
        case trace::Query::Any:
            return "hit\n";
        case trace::Query::Nearest:
            break;
    }
    return "hit,t,x,y,z,normalX,normalY,normalZ\n";
}

}  // namespace

RayFormat formatOf(const std::filesystem::path& path) {
    return path.extension() == ".csv" || path.extension() == ".CSV" ? RayFormat::Csv : RayFormat::Raw;
}

RayReader::RayReader(const std::filesystem::path& rayPath, RayFormat rayFormat)
    : path(rayPath), format(rayFormat) {
    if (format == RayFormat::Csv) {
        lines.emplace(rayPath);
        size = lines->size();
        return;
    }
    raw.emplace(rayPath);
    size = raw->size();
    if (size % sizeof(trace::TraceRay) != 0) {
        throw Error(
            ExitCode::File,
            fmt::format(
                "\"{}\" holds {} bytes, no whole number of rays of {} bytes (8 float32: origin, tMin, "
                "direction, tMax)",
                path.string(), size, sizeof(trace::TraceRay)));
    }
}

std::size_t RayReader::read(std::span<trace::TraceRay> room) {
    return format == RayFormat::Raw ? readRaw(room) : readCsv(room);
}

double RayReader::done() const {
    return size > 0 ? static_cast<double>(position) / static_cast<double>(size) : 1.0;
}

std::size_t RayReader::readRaw(std::span<trace::TraceRay> room) {
    const std::size_t count =
        std::min<std::uint64_t>(room.size(), (size - position) / sizeof(trace::TraceRay));
    const std::span<std::byte> bytes = std::as_writable_bytes(room.first(count));
    if (raw->read(bytes) < bytes.size()) {
        throw Error(ExitCode::File, fmt::format("\"{}\" ended while it was being read", path.string()));
    }
    position += bytes.size();
    return count;
}

std::size_t RayReader::readCsv(std::span<trace::TraceRay> room) {
    std::size_t count = 0;
    while (count < room.size()) {
        const std::optional<std::string_view> line = lines->next();
        if (!line) {
            break;
        }
        count += readLine(*line, room[count]) ? 1U : 0U;
    }
    position = lines->position();
    return count;
}

void RayReader::failLine(std::string_view what) const {
    throw Error(ExitCode::File, fmt::format("\"{}\", line {}: {}", path.string(), lines->number(), what));
}

// False: the line holds no ray and needs none.
bool RayReader::readLine(std::string_view line, trace::TraceRay& ray) {
    std::string_view content = trimmed(line);
    constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";  // spreadsheets write one
    if (lines->number() == 1 && content.starts_with(byteOrderMark)) {
        content.remove_prefix(byteOrderMark.size());
    }
    if (content.empty() || content.front() == '#') {
        return false;
    }
    const Fields fields(content);
    if (std::exchange(headerAllowed, false) && isHeader(fields)) {
        return false;
    }
    if (fields.count != rayFields) {
        failLine(fmt::format("{} values instead of 8 (origin x, y, z, tMin, direction x, y, z, tMax)",
                             fields.count));
    }
    std::array<float, rayFields> values{};
    for (std::size_t i = 0; i < rayFields; ++i) {
        const std::optional<float> value = options::parseFloat(fields.texts[i]);
        if (!value) {
            failLine(fmt::format("column {}, {}: \"{}\" is no float32 number", i + 1, columnNames[i],
                                 excerpt(fields.texts[i])));
        }
        values[i] = *value;
    }
    ray = std::bit_cast<trace::TraceRay>(values);
    return true;
}

HitWriter::HitWriter(const std::filesystem::path& path, RayFormat hitFormat, trace::Query query)
    : format(hitFormat), columns(trace::hitFloats(query)), file(path) {
    if (format == RayFormat::Csv) {
        file.write(csvHeader(query));
    }
}

void HitWriter::write(std::span<const float> hits) {
    if (format == RayFormat::Raw) {
        file.write(std::as_bytes(hits));
        return;
    }
    // Some values at a time, so that their text stays in the processor's cache.
    constexpr std::size_t most = 4096;
    text.resize(most * longestValue);
    std::size_t column = 0;
    for (; !hits.empty(); hits = hits.subspan(std::min(most, hits.size()))) {
        char* end = text.data();
        for (const float hit : hits.first(std::min(most, hits.size()))) {
            end = writeValue(end, hit);
            column = column + 1 == columns ? 0 : column + 1;
            *end++ = column == 0 ? '\n' : ',';
        }
        file.write(std::string_view(text.data(), static_cast<std::size_t>(end - text.data())));
    }
}

}  // namespace raytorus::cli
