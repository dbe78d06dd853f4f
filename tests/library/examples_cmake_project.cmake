# SPDX-License-Identifier: MIT
# examples/cmake_project builds with the source tree and with an installation, which is made of the component `glsl` as
# examples/README.md says; the installed folder is the library, and is all that a bare glslangValidator command needs.
include("${CMAKE_CURRENT_LIST_DIR}/common.cmake")
if(NOT DEFINED EXAMPLES)
    set(EXAMPLES "${root}/examples")
endif()
set(generator "")
if(DEFINED GENERATOR)
    set(generator -G "${GENERATOR}")
endif()

function(run)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE said ERROR_VARIABLE said)
    if(NOT result EQUAL 0 OR said MATCHES "[Ww]arning|WARNING")
        string(REPLACE ";" " " command "${ARGN}")
        message(FATAL_ERROR "${command}: result ${result}\n${said}")
    endif()
endfunction()

# build(<name> arguments...): configures and builds a copy of the project.
function(build name)
    file(COPY "${EXAMPLES}/cmake_project" DESTINATION "${SCRATCH}/${name}")
    set(folder "${SCRATCH}/${name}/build")
    run("${CMAKE_COMMAND}" -S "${SCRATCH}/${name}/cmake_project" -B "${folder}" ${generator} ${ARGN})
    run("${CMAKE_COMMAND}" --build "${folder}")
    validate("${folder}/depth.comp.spv" vulkan1.3)
endfunction()

build(with_sources "-DRAYTORUS_SOURCE=${root}")

set(prefix "${SCRATCH}/prefix")
run("${CMAKE_COMMAND}" -S "${root}" -B "${SCRATCH}/glsl" ${generator} -DRAYTORUS_BUILD_HOST=OFF)
run("${CMAKE_COMMAND}" --install "${SCRATCH}/glsl" --component glsl --prefix "${prefix}")
build(with_installation "-DCMAKE_PREFIX_PATH=${prefix}")
file(STRINGS "${SCRATCH}/with_installation/build/CMakeCache.txt" found REGEX "^raytorus_DIR:PATH=${prefix}/")
if(NOT found)
    fault("with_installation has not used ${prefix}")
endif()

file(GLOB installed RELATIVE "${prefix}/share/raytorus/shaders/torus" "${prefix}/share/raytorus/shaders/torus/*")
if(NOT installed STREQUAL library_files)
    fault("installed: ${installed}\nthe library: ${library_files}")
endif()
set(LIBRARY "${prefix}/share/raytorus/shaders/torus")
compile("${SCRATCH}/first_hit.frag.spv" "${EXAMPLES}/first_hit.frag" --target-env vulkan1.3)
finish()
