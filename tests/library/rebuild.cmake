# SPDX-License-Identifier: MIT
# CompileShader.cmake, in a project of its own: a change to an included file compiles exactly the shaders that include
# it, nothing is compiled when nothing changed, and an error names the file and line it stands in.
include("${CMAKE_CURRENT_LIST_DIR}/common.cmake")
# Another copy of the folder above the library may be checked, too.
cmake_path(GET LIBRARY PARENT_PATH shaders)

file(COPY "${shaders}/" DESTINATION "${SCRATCH}/shaders")
set(head "#version 450\n#extension GL_GOOGLE_include_directive : require\n")
file(WRITE "${SCRATCH}/own.glsl" "float own() { return 1.0; }\n")
file(WRITE "${SCRATCH}/user.comp" "${head}#include \"torus/torus.glsl\"\nvoid main() {}\n")
file(WRITE "${SCRATCH}/other.comp" "${head}#include \"own.glsl\"\nvoid main() { own(); }\n")
file(WRITE "${SCRATCH}/both.comp"
    "${head}#include \"own.glsl\"\n#include \"torus/torus.glsl\"\nvoid main() { own(); }\n")
file(WRITE "${SCRATCH}/CMakeLists.txt" "cmake_minimum_required(VERSION 3.25)\nproject(scratch LANGUAGES CXX)
include(shaders/CompileShader.cmake)
raytorus_compile_shaders(scratch_shaders NAMESPACE scratch SOURCES user.comp other.comp both.comp)\n")
set(generator "")
if(DEFINED GENERATOR)
    set(generator -G "${GENERATOR}")
endif()
execute_process(COMMAND "${CMAKE_COMMAND}" -S "${SCRATCH}" -B "${SCRATCH}/build" ${generator}
    OUTPUT_VARIABLE said ERROR_VARIABLE said RESULT_VARIABLE result)
if(NOT result EQUAL 0)
    message(FATAL_ERROR "${said}")
endif()

function(build)
    execute_process(COMMAND "${CMAKE_COMMAND}" --build "${SCRATCH}/build"
        OUTPUT_VARIABLE said ERROR_VARIABLE said RESULT_VARIABLE result)
    set(said "${said}" PARENT_SCOPE)
    set(result "${result}" PARENT_SCOPE)
endfunction()

# expect(<why> <shader>...): builds, and these shaders are compiled, no others.
function(expect why)
    build()
    if(NOT result EQUAL 0)
        fault("${why}: the build fails\n${said}")
    endif()
    string(REGEX MATCHALL "Compiling shader [^ \n]+" compiled "${said}")
    list(TRANSFORM compiled REPLACE "Compiling shader " "")
    list(SORT compiled)
    if(NOT compiled STREQUAL "${ARGN}")
        fault("${why}: compiles \"${compiled}\" instead of \"${ARGN}\"")
    endif()
endfunction()

expect("from nothing" both.comp other.comp user.comp)
expect("nothing changed")
file(TOUCH "${SCRATCH}/own.glsl")
expect("own.glsl changed" both.comp other.comp)
file(TOUCH "${SCRATCH}/other.comp")
expect("other.comp changed" other.comp)
file(TOUCH "${SCRATCH}/shaders/torus/march.glsl")
expect("march.glsl changed" both.comp user.comp)
expect("nothing changed since")

file(APPEND "${SCRATCH}/own.glsl" "float wrong() { return missing; }\n")
build()
if(result EQUAL 0 OR NOT said MATCHES "own[.]glsl:2: 'missing' : undeclared identifier")
    fault("an error in own.glsl: result ${result}, no file and line of it in\n${said}")
endif()
file(WRITE "${SCRATCH}/own.glsl" "float own() { return 2.0; }\n")
expect("own.glsl repaired" both.comp other.comp)
finish()
