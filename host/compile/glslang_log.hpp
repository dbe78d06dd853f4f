// SPDX-License-Identifier: MIT
// glslang's log as a list of errors in files and lines.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "compile/include_search.hpp"

namespace raytorus::compile {

struct CompileError {
    std::string file;  ///< relative to the first root, or as its root was given, or what a #line says
    int line = 0;      ///< from 1; 0: the file as a whole
    std::string text;  ///< one line, without a stop at its end
};

/// What glslang is told to be the name of a source, and what of a refused include: names that no path,
/// however strange, makes ambiguous in the log.
[[nodiscard]] std::string logName(std::size_t sourceId);
[[nodiscard]] std::string logRefusal(std::size_t refusal);

/// Errors only, in their order. Left out is what follows from them alone, "compilation terminated". An #if
/// that is left open is placed where it was opened; glslang has it at the end of the entry.
[[nodiscard]] std::vector<CompileError> readLog(std::string_view log, const IncludeSearch& search,
                                                const std::vector<std::string>& refusals);

}  // namespace raytorus::compile
