// SPDX-License-Identifier: MIT
// PNG is written without OpenImageIO; for the rest, the module that knows it is loaded when it is first
// needed. Without the module there is less that can be read.
#include "image/image_codec.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "image/openimageio_codec.hpp"
#include "image/plain_codec.hpp"
#include "image/png_encode.hpp"

namespace raytorus::image {

namespace {

Image decodePlainly(std::span<const std::byte> bytes, Format format, std::string_view name) {
    return format == Format::Exr ? plain::decodeExr(bytes, name) : plain::decodePng(bytes, name);
}

// Never unloaded: its threads and statics end with the program. The loader looks for it by the program's run
// path.
Codec load() {
    void* const module = dlopen(codecModule, RTLD_LAZY | RTLD_LOCAL);
    const void* const found = module != nullptr ? dlsym(module, codecSymbol) : nullptr;
    return found != nullptr ? *static_cast<const Codec*>(found) : Codec{plain::encodeExr, decodePlainly};
}

const Codec& codec() {
    static const Codec loaded = load();
    return loaded;
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
    return format == Format::Png ? encodePng(image, name) : codec().encodeExr(image, name);
}

Image decode(std::span<const std::byte> bytes, Format format, std::string_view name) {
    return codec().decode(bytes, format, name);
}

}  // namespace raytorus::image
