// SPDX-License-Identifier: MIT
// GLSL for Vulkan 1.3 to SPIR-V, in the running program: the same words as glslangValidator --target-env
// vulkan1.3 of the same version gives, in some 10 ms (the first time a tenth of a second, for glslang's
// tables).
//
//     const CompiledShader shader = compileShader({"shaders/scene.frag", {"shaders"}, {}});
//     if (!shader.ok()) show(describe(shader.errors.front()));
//     watch.watch(shader.files);
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "compile/bounded_child.hpp"
#include "compile/glslang_log.hpp"
#include "compile/include_search.hpp"

namespace raytorus::compile {

struct Define {
    std::string name;
    std::string value;  ///< may be empty; one line
};

struct ShaderRequest {
    /// Its extension says the stage: .vert, .frag or .comp. It may lie outside the roots.
    std::filesystem::path entry;
    /// Where #include looks after the folders of the including files, in this order. The first one is the
    /// shader folder, to which names in errors are relative. Only what lies in these folders, or in the
    /// entry's, may be included, whatever "..", absolute paths and symbolic links say.
    std::vector<std::filesystem::path> roots;
    std::vector<Define> defines;
    /// Of one compilation. What exceeds them is refused as any shader that does not compile.
    ChildLimits limits{};
};

struct CompiledShader {
    std::vector<std::uint32_t> words;  ///< SPIR-V 1.6; empty if there are errors
    std::vector<CompileError> errors;  ///< the first is the one to show: others may follow from it
    /// Every file that was read, or looked for and not found, as it was then, errors or not: until one of
    /// these changes, the result stays the same. The entry is the first.
    std::vector<FileState> files;

    /// The compilation was ended, for its limits or because it crashed; the last error says which.
    bool ended = false;

    [[nodiscard]] bool ok() const { return errors.empty(); }
};

/// Any fault of the request or of a file is in the result's errors; only what the system lacks is thrown,
/// memory or processes. May be called from any thread, and by several at once. No file damages this process:
/// files and what they include are limited to 1 MiB together and 64 levels, and glslang runs in a process of
/// its own, with limits of memory and time. A shader whose macros or structures
/// double themselves some thirty times ends there.
[[nodiscard]] CompiledShader compileShader(const ShaderRequest& request);

/// "torus/torus.glsl:12: 'x' : undeclared identifier".
[[nodiscard]] std::string describe(const CompileError& error);

}  // namespace raytorus::compile
