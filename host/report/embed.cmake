# SPDX-License-Identifier: MIT
# cmake -DFOLDER=<this folder> -DOUTPUT=<file.cpp> -P embed.cmake
file(READ "${FOLDER}/report.css" style)
file(READ "${FOLDER}/report.js" script)
file(WRITE "${OUTPUT}" "#include <string_view>

namespace raytorus::report {

extern const std::string_view styleSheet, script;

const std::string_view styleSheet = R\"embedded(\n${style})embedded\";

const std::string_view script = R\"embedded(\n${script})embedded\";

}  // namespace raytorus::report
")
