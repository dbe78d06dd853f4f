# SPDX-License-Identifier: MIT
# For the scripts beside, which use raytorus as strangers do.
include("${CMAKE_CURRENT_LIST_DIR}/../library/common.cmake")
file(STRINGS "${root}/CMakeLists.txt" project REGEX "^project[(]raytorus VERSION ")
string(REGEX MATCH "[0-9]+[.][0-9]+[.][0-9]+" version "${project}")

# run(<command...>): what it said is left in said; a fault unless it succeeds without a warning.
function(run)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE said ERROR_VARIABLE said)
    if(NOT result EQUAL 0 OR said MATCHES "[Ww]arning|WARNING")
        string(REPLACE ";" " " command "${ARGN}")
        message(FATAL_ERROR "${command}: result ${result}\n${said}")
    endif()
    set(said "${said}" PARENT_SCOPE)
endfunction()

# files_of(<folder> <variable>): the files in it, sorted.
function(files_of folder variable)
    file(GLOB_RECURSE files LIST_DIRECTORIES false RELATIVE "${folder}" "${folder}/*")
    list(SORT files)
    set(${variable} "${files}" PARENT_SCOPE)
endfunction()

# The files of the component `glsl`, in an installation.
list(TRANSFORM library_files PREPEND share/raytorus/shaders/torus/ OUTPUT_VARIABLE glsl_files)
list(APPEND glsl_files share/raytorus/LICENSE share/pkgconfig/raytorus.pc share/cmake/raytorus/raytorus-config.cmake
    share/cmake/raytorus/raytorus-config-version.cmake)
list(SORT glsl_files)

# Before a command: no compiler is found, nor named.
set(without_compiler "${CMAKE_COMMAND}" -E env --unset=CFLAGS "PATH=${SCRATCH}" CC=/bin/false CXX=/nonexistent)
find_program(ninja ninja REQUIRED)
set(generator -G Ninja "-DCMAKE_MAKE_PROGRAM=${ninja}")

# expect(<what> <value> <expected>)
function(expect what value expected)
    if(NOT value STREQUAL expected)
        fault("${what}: ${value}\n    instead of ${expected}")
    endif()
endfunction()

# use_pkg_config(<prefix>): the version is the project's, and a shader compiles by what pkg-config says.
function(use_pkg_config prefix)
    set(pkg_config "${CMAKE_COMMAND}" -E env "PKG_CONFIG_LIBDIR=${prefix}/share/pkgconfig" pkg-config)
    run(${pkg_config} --modversion raytorus)
    if(NOT said STREQUAL "${version}\n")
        fault("pkg-config: version ${said}, not ${version}")
    endif()
    run(${pkg_config} --cflags raytorus)
    separate_arguments(flags UNIX_COMMAND "${said}")
    run(glslangValidator --quiet --target-env vulkan1.3 ${flags} "${root}/examples/first_hit.frag" -o "${SCRATCH}/pkg_config.spv")
    foreach(variable IN ITEMS shaderdir includedir)
        run(${pkg_config} --variable=${variable} raytorus)
        string(STRIP "${said}" said)
        if(NOT EXISTS "${said}/torus.glsl")
            fault("pkg-config: ${variable} is ${said}, without torus.glsl")
        endif()
    endforeach()
endfunction()

# build_example(<prefix>): examples/cmake_project finds the include there.
function(build_example prefix)
    file(COPY "${root}/examples/cmake_project" DESTINATION "${SCRATCH}/example")
    set(build "${SCRATCH}/example/build")
    run("${CMAKE_COMMAND}" -S "${SCRATCH}/example/cmake_project" -B "${build}" "-DCMAKE_PREFIX_PATH=${prefix}")
    run("${CMAKE_COMMAND}" --build "${build}")
    validate("${build}/depth.comp.spv" vulkan1.3)
    file(STRINGS "${build}/CMakeCache.txt" found REGEX "^raytorus_DIR:PATH=${prefix}/")
    if(NOT found)
        fault("the example has not used ${prefix}")
    endif()
endfunction()

# languages(<variable>): the names of what scripts/dist writes, but for the folders.
function(languages variable)
    run("${root}/scripts/dist" --list)
    string(REGEX MATCHALL "\nraytorus[a-z_.]*" names "\n${said}")
    list(TRANSFORM names STRIP)
    set(${variable} "${names}" PARENT_SCOPE)
endfunction()

# use_cxx(<folder>): a program that includes raytorus.hpp of this folder hits a torus.
function(use_cxx folder)
    file(WRITE "${SCRATCH}/use.cpp" "#include \"raytorus.hpp\"
int main() {
    using namespace raytorus_cxx;
    TorusHit hit;
    const bool found = torusIntersect(Torus{1.0F, 0.25F}, vec3(3.0F, 0.0F, 0.0F), 0.0F, vec3(-1.0F, 0.0F, 0.0F), 9.0F, hit);
    return found && hit.t == 1.75F ? 0 : 1;
}\n")
    run(c++ -std=c++11 -Wall -Werror "-I${folder}" "${SCRATCH}/use.cpp" -o "${SCRATCH}/use")
    run("${SCRATCH}/use")
endfunction()

# render(<program>): it knows its version, finds a device and draws a ring, as EXR, by the module that it loads at need.
function(render program)
    set(clean "${CMAKE_COMMAND}" -E env --unset=LD_LIBRARY_PATH)
    run(${clean} "${program}" --version)
    if(NOT said MATCHES "${version}\n$")
        fault("${program} --version: ${said}, not ${version}")
    endif()
    run(${clean} "${program}" doctor)
    run(${clean} "${program}" render "${root}/scenes/ring.json" --size 32x24 -o "${SCRATCH}/ring.exr")
    run(${clean} "${program}" compare "${SCRATCH}/ring.exr" "${SCRATCH}/ring.exr")
    if(NOT said MATCHES "identical")
        fault("${program} compare: ${said}")
    endif()
endfunction()
