// SPDX-License-Identifier: MIT
// Ray and hit files of `raytorus trace`, a piece at a time, so that their size does not matter.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <vector>

#include "core/file.hpp"
#include "render/tracer.hpp"

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

    /// Up to `most` rays; none at the end of the file. Throws Error{File} that names the line or the byte.
    std::vector<render::TraceRay> read(std::size_t most);

    /// The part of the file that was read, 0 to 1.
    [[nodiscard]] double done() const;

private:
    void readRaw(std::vector<render::TraceRay>& rays, std::size_t most);
    void readCsv(std::vector<render::TraceRay>& rays, std::size_t most);

    std::filesystem::path path;
    RayFormat format;
    std::ifstream file;
    std::uint64_t size = 0;
    std::uint64_t position = 0;  // bytes read
    std::uint64_t line = 0;
    bool headerAllowed = true;
};

/// Hits in the order of the rays. The columns are those of trace_io.h; CSV has a header line and the shortest
/// decimals that give the same float32.
class HitWriter {
public:
    HitWriter(const std::filesystem::path& path, RayFormat format, render::Query query);

    void write(std::span<const float> hits);
    void commit() { file.commit(); }

private:
    RayFormat format;
    std::size_t columns;
    OutputFile file;
};

}  // namespace raytorus::cli
