# SPDX-License-Identifier: MIT
# The version macros agree with the project's version, and a shader that asks for more does not compile.
include("${CMAKE_CURRENT_LIST_DIR}/common.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/glsl_text.cmake")

file(READ "${root}/CMakeLists.txt" project)
string(REGEX MATCH "project\\(raytorus VERSION ([0-9]+)[.]([0-9]+)[.]([0-9]+)" project "${project}")
set(version "${CMAKE_MATCH_1}.${CMAKE_MATCH_2}.${CMAKE_MATCH_3}")
math(EXPR current "${CMAKE_MATCH_1} * 10000 + ${CMAKE_MATCH_2} * 100 + ${CMAKE_MATCH_3}")
math(EXPR larger "${current} + 1")

read_code(code "${LIBRARY}/torus.glsl")
set(macros "")
foreach(part IN ITEMS MAJOR MINOR PATCH)
    string(REGEX MATCH "#define TORUS_VERSION_${part} ([0-9]+)\n" found "${code}")
    list(APPEND macros "${CMAKE_MATCH_1}")
endforeach()
list(JOIN macros "." macros)
if(NOT macros STREQUAL version)
    fault("torus.glsl says ${macros}, project(raytorus VERSION ${version})")
endif()

set(shader "${SCRATCH}/version.comp")
file(WRITE "${shader}" "#version 450\n#extension GL_GOOGLE_include_directive : require\n#include \"torus.glsl\"
#if TORUS_VERSION != ${current}\n#error \"TORUS_VERSION is not ${current}\"\n#endif\nvoid main() {}\n")
compile("${shader}.spv" "${shader}" --target-env vulkan1.1)
compile("${shader}.spv" "${shader}" --target-env vulkan1.1 -DTORUS_VERSION_REQUIRED=${current})

require_tool(glslang glslangValidator glslang-tools)
execute_process(
    COMMAND "${glslang}" --quiet "-I${LIBRARY}" -V -DTORUS_VERSION_REQUIRED=${larger} -o "${shader}.spv" "${shader}"
    RESULT_VARIABLE result OUTPUT_VARIABLE said)
set(expected "torus[.]glsl:[0-9]+: '#error' : the library is older than TORUS_VERSION_REQUIRED")
if(result EQUAL 0 OR NOT said MATCHES "${expected}")
    fault("TORUS_VERSION_REQUIRED ${larger}: result ${result}\n${said}")
endif()
finish()
