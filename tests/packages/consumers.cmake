# SPDX-License-Identifier: MIT
# Projects that use the include: with and without a language, from the sources, fetched, installed and moved. Without a
# language there is no compiler: the search path is empty, and CC and CXX name none.
#
#     cmake -DSCRATCH=<folder> [-DCMAKE=<another cmake>] [-DGENERATOR=<name>] -P <script>
include("${CMAKE_CURRENT_LIST_DIR}/common.cmake")
if(NOT DEFINED CMAKE)
    set(CMAKE "${CMAKE_COMMAND}")
endif()

# consumer(<name> <languages> <how it gets raytorus> cmake arguments...): configures, builds and installs a project that
# has a file of its own. Sets include to the library's folder as it sees it, installed to what it installs.
function(consumer name languages gets)
    set(folder "${SCRATCH}/${name}")
    file(WRITE "${folder}/mine.txt" "mine\n")
    file(WRITE "${folder}/CMakeLists.txt" "cmake_minimum_required(VERSION 3.22...3.25)
project(consumer LANGUAGES ${languages})
include(FetchContent)
${gets}
file(GENERATE OUTPUT include.txt CONTENT \"$<TARGET_PROPERTY:raytorus::glsl,INTERFACE_INCLUDE_DIRECTORIES>\")
install(FILES mine.txt DESTINATION .)\n")
    set(start "")
    if(languages STREQUAL "NONE")
        set(start ${without_compiler})
    endif()
    run(${start} "${CMAKE}" ${generator} -S "${folder}" -B "${folder}/build" ${ARGN})
    if(NOT "-DRAYTORUS_BUILD_HOST=ON" IN_LIST ARGN)
        run(${start} "${CMAKE}" --build "${folder}/build")
    endif()
    run(${start} "${CMAKE}" --install "${folder}/build" --prefix "${folder}/prefix")
    file(READ "${folder}/build/include.txt" include)
    files_of("${folder}/prefix" installed)
    set(include "${include}" PARENT_SCOPE)
    set(installed "${installed}" PARENT_SCOPE)
endfunction()

# From the sources.
set(subdirectory "add_subdirectory(\"${root}\" raytorus)")
foreach(languages IN ITEMS NONE C CXX)
    consumer("subdirectory ${languages}" "${languages}" "${subdirectory}")
    expect("subdirectory ${languages}" "${include}" "${LIBRARY}")
    expect("subdirectory ${languages} installs" "${installed}" mine.txt)
endforeach()
foreach(languages IN ITEMS NONE CXX)
    consumer("asked ${languages}" "${languages}" "include(GNUInstallDirs OPTIONAL)\n${subdirectory}" -DRAYTORUS_INSTALL=ON
        -DCMAKE_INSTALL_LIBDIR=lib)
    expect("asked to install, ${languages}" "${installed}" "mine.txt;${glsl_files}")
endforeach()

# Fetched, as an archive of what the include needs.
execute_process(COMMAND "${CMAKE_COMMAND}" -E tar czf "${SCRATCH}/raytorus.tar.gz" CMakeLists.txt LICENSE shaders
    WORKING_DIRECTORY "${root}" COMMAND_ERROR_IS_FATAL ANY)
file(SHA256 "${SCRATCH}/raytorus.tar.gz" hash)
set(fetch "FetchContent_Declare(raytorus URL \"${SCRATCH}/raytorus.tar.gz\" URL_HASH SHA256=${hash})
FetchContent_MakeAvailable(raytorus)")
foreach(languages IN ITEMS NONE CXX)
    consumer("fetched ${languages}" "${languages}" "${fetch}")
    expect("fetched ${languages}" "${include}" "${SCRATCH}/fetched ${languages}/build/_deps/raytorus-src/shaders/torus")
    expect("fetched ${languages} installs" "${installed}" mine.txt)
endforeach()

# The whole host as a part of a project installs nothing either, which needs nothing built to show.
if(CMAKE STREQUAL CMAKE_COMMAND)
    consumer("host" CXX "${subdirectory}" -DRAYTORUS_BUILD_HOST=ON)
    expect("the host installs" "${installed}" mine.txt)
endif()

# Installed, then moved, then found by CMake and by pkg-config.
run(${without_compiler} "${CMAKE}" ${generator} -S "${root}" -B "${SCRATCH}/glsl"
    -DRAYTORUS_BUILD_HOST=OFF)
run(${without_compiler} "${CMAKE}" --install "${SCRATCH}/glsl" --prefix "${SCRATCH}/prefix")
files_of("${SCRATCH}/prefix" installed)
expect("installed" "${installed}" "${glsl_files}")
file(RENAME "${SCRATCH}/prefix" "${SCRATCH}/moved")
foreach(file IN LISTS installed)
    file(READ "${SCRATCH}/moved/${file}" text)
    if(text MATCHES "${SCRATCH}|${root}/")
        fault("${file} names a folder of this machine: ${CMAKE_MATCH_0}")
    endif()
endforeach()
foreach(languages IN ITEMS NONE CXX)
    consumer("found ${languages}" "${languages}" "find_package(raytorus ${version} REQUIRED)"
        "-DCMAKE_PREFIX_PATH=${SCRATCH}/moved")
    expect("found ${languages}" "${include}" "${SCRATCH}/moved/share/raytorus/shaders/torus")
endforeach()
use_pkg_config("${SCRATCH}/moved")

# As docs/packages.md says.
run("${CMAKE}" --install "${SCRATCH}/glsl" --prefix "${SCRATCH}/prefix")
run(sh -c "xargs rm -- <\"${SCRATCH}/glsl/install_manifest.txt\"")
files_of("${SCRATCH}/prefix" installed)
expect("uninstalled, there is left" "${installed}" "")
finish()
