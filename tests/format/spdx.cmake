# SPDX-License-Identifier: MIT
# Script: fails unless each source names its licence within its first four lines.
cmake_minimum_required(VERSION 3.25)
include("${CMAKE_CURRENT_LIST_DIR}/sources.cmake")

raytorus_sources(files "cmake;examples;host;packaging;shaders;tests;web"
    "*.js;*.css;*.html;*.ts;*.cpp;*.hpp;*.h;*.glsl;*.vert;*.frag;*.comp;*.rint;*.cmake;CMakeLists.txt")
raytorus_sources(scripts "scripts;.ci" "*")
raytorus_sources(recipes "packaging" "*.cmake;*.py;*.rs;*.toml;*.comp;CMakeLists.txt")
set(faults 0)
foreach(file IN LISTS files scripts recipes ITEMS "${root}/CMakeLists.txt")
    file(READ "${file}" head LIMIT 1000)
    set(line "[^\n]*\n")
    if(NOT head MATCHES "^(${line})?(${line})?(${line})?[^\n]*SPDX-License-Identifier: MIT( \\*/| -->)?\n")
        message("${file}:1: no \"SPDX-License-Identifier: MIT\" in the first four lines")
        math(EXPR faults "${faults} + 1")
    endif()
endforeach()
if(faults)
    message(FATAL_ERROR "Files that do not name their licence: ${faults}")
endif()
