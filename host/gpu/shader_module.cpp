// SPDX-License-Identifier: MIT
#include "gpu/shader_module.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "gpu/result.hpp"

namespace raytorus::gpu {
namespace {

// SPIR-V specification, 2.3: the header is five words, of which the first is the magic number.
constexpr std::size_t headerWords = 5;
constexpr std::uint32_t magicNumber = 0x07230203;

// OpFunctionEnd, one word long: no module with a function ends otherwise.
constexpr std::uint32_t functionEnd = 0x00010038;

// Every instruction says its own length in words (2.3 again); together they fill the module exactly, up to
// the end of its last function. A file that was cut off is found here: drivers and layers may crash on one.
bool isWhole(std::span<const std::uint32_t> words) {
    if (words.size() <= headerWords || words[0] != magicNumber || words.back() != functionEnd) {
        return false;
    }
    std::size_t at = headerWords;
    while (at < words.size()) {
        const std::size_t length = words[at] >> 16U;
        if (length == 0) {
            return false;
        }
        at += length;
    }
    return at == words.size();
}

}  // namespace

ShaderModule::ShaderModule(const Context& context, std::span<const std::uint32_t> words,
                           const std::string& name) {
    if (!isWhole(words)) {
        throw Error(ExitCode::Shader, fmt::format("{}: this is no complete SPIR-V module", name));
    }
    VkShaderModuleCreateInfo info{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
    info.codeSize = words.size_bytes();
    info.pCode = words.data();
    VkShaderModule created = VK_NULL_HANDLE;
    const VkResult result = vkCreateShaderModule(context.device(), &info, nullptr, &created);
    if (result != VK_SUCCESS && result != VK_ERROR_OUT_OF_HOST_MEMORY &&
        result != VK_ERROR_OUT_OF_DEVICE_MEMORY) {
        throw Error(ExitCode::Shader, fmt::format("{}: {} refuses this shader ({})", name,
                                                  context.info().name, resultName(result)));
    }
    check(result, "vkCreateShaderModule");
    module = {context.scope(), created};
}

}  // namespace raytorus::gpu
