// SPDX-License-Identifier: MIT
// Ray and hit files of `raytorus trace`, a piece at a time, so that their size does not matter.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/file.hpp"
#include "trace/tracer.hpp"

namespace raytorus::cli {

enum class RayFormat {
    Csv,  ///< a ray a line: origin x, y, z, tMin, direction x, y, z, tMax
    Raw,  ///< the same as little-endian float32, 32 bytes a ray
};

/// By extension: .csv is Csv, everything else Raw.
RayFormat formatOf(const std::filesystem::path& path);

class RayReader {
public:
    RayReader(const std::filesystem::path& path, RayFormat format);

    /// Reads rays into `room`, in order, until it is full or the file ends, and returns how many. Throws
    /// Error{File} that names the line or the byte.
    std::size_t read(std::span<trace::TraceRay> room);

    /// The part of the file that was read, 0 to 1.
    [[nodiscard]] double done() const;

private:
    std::size_t readRaw(std::span<trace::TraceRay> room);
    std::size_t readCsv(std::span<trace::TraceRay> room);
    bool readLine(std::string_view line, trace::TraceRay& ray);

    [[noreturn]] void failLine(std::string_view what) const;

    std::filesystem::path path;
    RayFormat format;
    std::optional<InputFile> raw;
    std::optional<LineReader> lines;
    std::uint64_t size = 0;
    std::uint64_t position = 0;  // bytes read
    bool headerAllowed = true;
};

/// Hits in the order of the rays. The columns are those of trace_io.h; CSV has a header line and the shortest
/// decimals that give the same float32.
class HitWriter {
public:
    HitWriter(const std::filesystem::path& path, RayFormat format, trace::Query query);

    void write(std::span<const float> hits);
    void commit() { file.commit(); }

private:
    RayFormat format;
    std::size_t columns;
    OutputFile file;
    std::vector<char> text;  // of some rows
};

}  // namespace raytorus::cli
