# SPDX-License-Identifier: MIT
# A method is one file, and its head is its row in the tables. Its name is the file's, with - for _.
#
#     // SPDX-License-Identifier: MIT
#     // Method: bracketed Newton between the critical points of the reduced quartic.
#     // Tolerance: 4e-7 (R + r).
#
# A baseline of the benchmark begins with `// Baseline: ...` and has no tolerance: it answers another query, or times what no method does. A
# line `// Needs: float64.` after either leaves the file out where the device has none.
include_guard()

# raytorus_read_method(<file> <kind>): sets method_name, method_description, method_tolerance (INFINITY of a baseline)
# and method_needs_float64 in the caller. <kind> is Method or Baseline.
function(raytorus_read_method file kind)
    cmake_path(GET file STEM stem)
    string(REPLACE "_" "-" method_name "${stem}")
    # Not file(STRINGS), which splits a line at a semicolon.
    file(READ "${file}" text LIMIT 2000)
    if(NOT text MATCHES "^// SPDX-License-Identifier: MIT\n// ${kind}: ([^\n\"\\]+)[.]\n([^\n]*)\n([^\n]*)\n")
        message(FATAL_ERROR "${file}: the second line of this file has to be \"// ${kind}: <what it does, for tables>.\"")
    endif()
    set(method_description "${CMAKE_MATCH_1}")
    set(needs "${CMAKE_MATCH_2}")
    set(method_tolerance INFINITY)
    if(kind STREQUAL "Method")
        set(needs "${CMAKE_MATCH_3}")
        if(NOT CMAKE_MATCH_2 MATCHES "^// Tolerance: ([1-9][.0-9]*e-[0-9]+) [(]R [+] r[)][.]$")
            message(FATAL_ERROR "${file}: the third line of this file has to be \"// Tolerance: <number> (R + r).\", "
                                "the number as 4e-7")
        endif()
        set(method_tolerance "${CMAKE_MATCH_1}")
    endif()
    set(method_needs_float64 false)
    if(needs STREQUAL "// Needs: float64.")
        set(method_needs_float64 true)
    elseif(needs MATCHES "^// Needs:")
        message(FATAL_ERROR "${file}: of needs there is one, \"// Needs: float64.\"")
    endif()
    return(PROPAGATE method_name method_description method_tolerance method_needs_float64)
endfunction()

# raytorus_embed_methods(<target> KIND <Method or Baseline> FOLDER <folder> SOURCES <shader>...)
#
# Compiles the shaders with each .glsl file of the folder, and embeds them: #include "<target>.hpp" declares
# raytorus::<target>::all, an array of EmbeddedMethod in the order of the names. A new file is seen by the next build.
function(raytorus_embed_methods target)
    cmake_parse_arguments(ARG "" "KIND;FOLDER" "SOURCES" ${ARGN})
    file(GLOB files CONFIGURE_DEPENDS "${ARG_FOLDER}/*.glsl")
    add_library(${target} INTERFACE)
    set(includes "#include \"methods/embedded_method.hpp\"\n")
    set(rows "")
    foreach(file IN LISTS files)
        set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
        raytorus_read_method("${file}" ${ARG_KIND})
        cmake_path(GET file STEM stem)
        raytorus_compile_shaders(${target}_${stem} NAMESPACE raytorus::${target}::${stem} METHOD "${file}"
            SOURCES ${ARG_SOURCES})
        target_link_libraries(${target} INTERFACE ${target}_${stem})
        string(APPEND includes "#include \"${target}_${stem}.hpp\"\n")
        string(APPEND rows "    {\"${method_name}\", \"${method_description}\", ${method_tolerance}, "
                           "${method_needs_float64}, ${stem}::find},\n")
    endforeach()
    file(CONFIGURE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/${target}/${target}.hpp" @ONLY CONTENT "// Written by host/methods/MethodFiles.cmake.
#pragma once
#include <cmath>
@includes@
namespace raytorus::@target@ {
inline constexpr EmbeddedMethod all[] = {
@rows@};
}
")
    target_include_directories(${target} INTERFACE "${CMAKE_CURRENT_BINARY_DIR}/${target}")
endfunction()
