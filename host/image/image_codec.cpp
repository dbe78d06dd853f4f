// SPDX-License-Identifier: MIT
// PNG by libpng. For EXR a module is loaded when it is first needed: OpenImageIO's, or where that is not,
// OpenEXR's.
#include "image/image_codec.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "image/codec_module.hpp"
#include "image/png.hpp"

namespace raytorus::image {

// Never unloaded: its threads and statics end with the program. The loader looks for it by the program's run
// path.
const Codec* loadCodec(const char* module, std::string& problem) {
    void* const handle = dlopen(module, RTLD_LAZY | RTLD_LOCAL);
    void* const found = handle != nullptr ? dlsym(handle, codecSymbol) : nullptr;
    if (found == nullptr) {
        const char* const words = dlerror();
        problem = words != nullptr ? words : module;
        return nullptr;
    }
    return reinterpret_cast<decltype(&raytorusCodec)>(found)();
}

namespace {

const Codec& codec(std::string_view name) {
    static std::string problems;
    static const Codec* const loaded = [] {
        std::string first;
        std::string second;
        const Codec* const best = loadCodec(openImageIoModule, first);
        const Codec* const other = best != nullptr ? best : loadCodec(openExrModule, second);
        problems = fmt::format("{}; {}", first, second);
        return other;
    }();
    if (loaded == nullptr) {
        throw Error(ExitCode::File, fmt::format("\"{}\" needs {} or {}, and neither can be loaded: {}", name,
                                                openImageIoModule, openExrModule, problems));
    }
    return *loaded;
}

}  // namespace

std::vector<std::byte> encode(const Image& image, Format format, std::string_view name) {
    const std::string problem = shapeProblem(image.width, image.height, image.channelNames);
    const std::size_t values = static_cast<std::size_t>(std::max(image.width, 0)) *
                               static_cast<std::size_t>(std::max(image.height, 0)) *
                               image.channelNames.size();
    if (!problem.empty() || image.pixels.size() != values) {
        throw Error(
            ExitCode::Internal,
            fmt::format("cannot write \"{}\": {}", name,
                        problem.empty() ? "the number of its pixels does not match its size" : problem));
    }
    return format == Format::Png ? encodePng(image, name) : codec(name).encode(image, name);
}

Image decode(std::span<const std::byte> bytes, Format format, std::string_view name) {
    return format == Format::Png ? decodePng(bytes, name) : codec(name).decode(bytes, name);
}

Image decodeHeader(std::span<const std::byte> bytes, Format format, std::string_view name) {
    return format == Format::Png ? decodePngHeader(bytes, name) : codec(name).decodeHeader(bytes, name);
}

}  // namespace raytorus::image
