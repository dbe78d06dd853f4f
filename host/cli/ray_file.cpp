// SPDX-License-Identifier: MIT
#include "cli/ray_file.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstring>
#include <iterator>

#include "cli/number_text.hpp"
#include "core/error.hpp"

namespace raytorus::cli {
namespace {

static_assert(std::endian::native == std::endian::little, "raw files are little-endian");

constexpr std::size_t rayFields = sizeof(render::TraceRay) / sizeof(float);

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view space = " \t\r";
    const std::size_t first = text.find_first_not_of(space);
    return first == std::string_view::npos ? std::string_view()
                                           : text.substr(first, text.find_last_not_of(space) - first + 1);
}

std::vector<std::string_view> fieldsOf(std::string_view line) {
    std::vector<std::string_view> fields;
    while (true) {
        const std::size_t comma = line.find(',');
        fields.push_back(trimmed(line.substr(0, comma)));
        if (comma == std::string_view::npos) {
            return fields;
        }
        line.remove_prefix(comma + 1);
    }
}

// A header names all the columns: none of its fields is a number.
bool isHeader(const std::vector<std::string_view>& fields) {
    if (fields.size() != rayFields) {
        return false;  // a line with other separators would otherwise pass for one, and its ray be lost
    }
    for (const std::string_view field : fields) {
        if (field.empty() || parseFloat(field)) {
            return false;
        }
    }
    return true;
}

const char* csvHeader(render::Query query) {
    switch (query) {
        case render::Query::All:
            return "count,t0,t1,t2,t3,x0,y0,z0,x1,y1,z1,x2,y2,z2,x3,y3,z3\n";
        case render::Query::Any:
            return "hit\n";
        case render::Query::Nearest:
            break;
    }
    return "hit,t,x,y,z,normalX,normalY,normalZ\n";
}

}  // namespace

RayFormat formatOf(const std::filesystem::path& path) {
    return path.extension() == ".csv" || path.extension() == ".CSV" ? RayFormat::Csv : RayFormat::Raw;
}

RayReader::RayReader(const std::filesystem::path& rayPath, RayFormat rayFormat)
    : path(rayPath),
      format(rayFormat),
      file(openForReading(rayPath)),
      size(std::filesystem::file_size(rayPath)) {
    if (format == RayFormat::Raw && size % sizeof(render::TraceRay) != 0) {
        throw Error(
            ExitCode::File,
            fmt::format(
                "\"{}\" holds {} bytes, no whole number of rays of {} bytes (8 float32: origin, tMin, "
                "direction, tMax)",
                path.string(), size, sizeof(render::TraceRay)));
    }
}

std::vector<render::TraceRay> RayReader::read(std::size_t most) {
    std::vector<render::TraceRay> rays;
    rays.reserve(most);
    if (format == RayFormat::Raw) {
        readRaw(rays, most);
    } else {
        readCsv(rays, most);
    }
    return rays;
}

double RayReader::done() const {
    return size > 0 ? static_cast<double>(position) / static_cast<double>(size) : 1.0;
}

void RayReader::readRaw(std::vector<render::TraceRay>& rays, std::size_t most) {
    rays.resize(std::min<std::uint64_t>(most, (size - position) / sizeof(render::TraceRay)));
    const std::size_t bytes = rays.size() * sizeof(render::TraceRay);
    if (!file.read(reinterpret_cast<char*>(rays.data()), static_cast<std::streamsize>(bytes))) {
        throw Error(ExitCode::File, fmt::format("\"{}\" ended while it was being read", path.string()));
    }
    position += bytes;
}

void RayReader::readCsv(std::vector<render::TraceRay>& rays, std::size_t most) {
    std::string text;
    while (rays.size() < most && std::getline(file, text)) {
        ++line;
        position += text.size() + 1;
        std::string_view content = trimmed(text);
        constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";  // spreadsheets write one
        if (line == 1 && content.starts_with(byteOrderMark)) {
            content.remove_prefix(byteOrderMark.size());
        }
        if (content.empty() || content.front() == '#') {
            continue;
        }
        const std::vector<std::string_view> fields = fieldsOf(content);
        if (std::exchange(headerAllowed, false) && isHeader(fields)) {
            continue;
        }
        if (fields.size() != rayFields) {
            throw Error(
                ExitCode::File,
                fmt::format(
                    "\"{}\", line {}: {} values instead of 8 (origin x, y, z, tMin, direction x, y, z, "
                    "tMax)",
                    path.string(), line, fields.size()));
        }
        std::array<float, rayFields> values{};
        for (std::size_t i = 0; i < rayFields; ++i) {
            const auto value = parseFloat(fields[i]);
            if (!value) {
                throw Error(ExitCode::File, fmt::format("\"{}\", line {}: \"{}\" is no float32 number",
                                                        path.string(), line, fields[i]));
            }
            values[i] = *value;
        }
        rays.push_back(std::bit_cast<render::TraceRay>(values));
    }
}

HitWriter::HitWriter(const std::filesystem::path& path, RayFormat hitFormat, render::Query query)
    : format(hitFormat), columns(render::hitFloats(query)), file(path) {
    if (format == RayFormat::Csv) {
        file.write(csvHeader(query));
    }
}

void HitWriter::write(std::span<const float> hits) {
    if (format == RayFormat::Raw) {
        file.write(std::as_bytes(hits));
        return;
    }
    fmt::memory_buffer text;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        fmt::format_to(std::back_inserter(text), "{}{}", hits[i], (i + 1) % columns == 0 ? '\n' : ',');
    }
    file.write(std::string_view(text.data(), text.size()));
}

}  // namespace raytorus::cli
