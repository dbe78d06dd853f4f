// SPDX-License-Identifier: MIT
// PNG is written without OpenImageIO; for the rest, the module that knows it is loaded when it is first
// needed: OpenImageIO's, or where that is not, OpenEXR's.
#include "image/image_codec.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "image/codec_module.hpp"
#include "image/png_encode.hpp"

namespace raytorus::image {

// Never unloaded: its threads and statics end with the program. The loader looks for it by the program's run
// path.
const Codec* loadCodec(const char* module) {
    void* const handle = dlopen(module, RTLD_LAZY | RTLD_LOCAL);
    void* const found = handle != nullptr ? dlsym(handle, codecSymbol) : nullptr;
    return found != nullptr ? reinterpret_cast<decltype(&raytorusCodec)>(found)() : nullptr;
}

namespace {

const Codec& codec(std::string_view name) {
    static const Codec* const loaded = [] {
        const Codec* const best = loadCodec(openImageIoModule);
        return best != nullptr ? best : loadCodec(openExrModule);
    }();
    if (loaded == nullptr) {
        throw Error(ExitCode::File, fmt::format("neither {} nor {}, which \"{}\" needs, can be loaded",
                                                openImageIoModule, openExrModule, name));
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
    return format == Format::Png ? encodePng(image, name) : codec(name).encodeExr(image, name);
}

Image decode(std::span<const std::byte> bytes, Format format, std::string_view name) {
    return codec(name).decode(bytes, format, name);
}

}  // namespace raytorus::image
