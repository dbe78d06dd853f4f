# SPDX-License-Identifier: MIT
# Debian's packages of this build: what they are called, need and hold, and that all of it works where it is unpacked.
#
#     cmake -DSCRATCH=<folder> -DBUILD=<build folder> -P <script>
include("${CMAKE_CURRENT_LIST_DIR}/common.cmake")
require_tool(shlibdeps dpkg-shlibdeps dpkg-dev)
require_tool(file file file)
execute_process(COMMAND dpkg --print-architecture OUTPUT_VARIABLE architecture OUTPUT_STRIP_TRAILING_WHITESPACE
    COMMAND_ERROR_IS_FATAL ANY)

# A package of gzip is made in a fifth of the time that xz takes.
run(cpack -G DEB -B "${SCRATCH}/made" -D CPACK_DEBIAN_COMPRESSION_TYPE=gzip --config "${BUILD}/CPackConfig.cmake")

# unpack(<package> <architecture> <file...>): a fault unless it holds these files and no others, all under /usr, as a
# package of Debian's has them. What it holds is put into the folder usr, its control file into control.
function(unpack package kind)
    set(deb "${SCRATCH}/made/${package}_${version}_${kind}.deb")
    run(dpkg-deb --contents "${deb}")
    string(REGEX MATCHALL "[^\n]+" lines "${said}")
    set(held "")
    foreach(line IN LISTS lines)
        if(line MATCHES "^-(rwxr-xr-x root/root .* [.]/usr/bin/|rw-r--r-- root/root .* [.]/usr/(share|lib)/)")
            string(REGEX REPLACE ".* [.]/" "" file "${line}")
            list(APPEND held "${file}")
        elseif(NOT line MATCHES "^drwxr-xr-x root/root .* [.]/usr/")
            fault("${package}: ${line}")
        endif()
    endforeach()
    list(TRANSFORM ARGN PREPEND usr/ OUTPUT_VARIABLE expected)
    list(SORT held)
    list(SORT expected)
    if(NOT held STREQUAL expected)
        fault("${package} holds ${held}\n    instead of ${expected}")
    endif()
    run(dpkg-deb --extract "${deb}" "${SCRATCH}")
    run(dpkg-deb --field "${deb}")
    set(control "\n${said}\n" PARENT_SCOPE)
endfunction()

function(control_has)
    foreach(line IN LISTS ARGN)
        if(NOT control MATCHES "\n${line}\n")
            fault("the control file has no line \"${line}\":${control}")
        endif()
    endforeach()
endfunction()

languages(names)
list(TRANSFORM names PREPEND share/raytorus/)
unpack(raytorus-glsl all ${glsl_files} ${names} share/doc/raytorus-glsl/copyright)
control_has("Package: raytorus-glsl" "Version: ${version}" "Architecture: all" "Maintainer: [^\n]+" "Section: [a-z]+"
    "Description: [^\n]+")
if(control MATCHES "\nDepends:")
    fault("the include depends on something:${control}")
endif()

set(programs raytorus raytorus-verify raytorus-bench raytorus-view)
list(TRANSFORM programs PREPEND bin/ OUTPUT_VARIABLE files)
unpack(raytorus ${architecture} ${files} lib/raytorus/raytorus-openexr.so share/doc/raytorus/copyright)
control_has("Package: raytorus" "Version: ${version}" "Architecture: ${architecture}" "Installed-Size: [0-9]+"
    "Depends: .*mesa-vulkan-drivers [|] vulkan-icd.*")
foreach(library IN ITEMS libc6 libvulkan1 libopenexr libpng16 libssl3 libstdc)
    control_has("Depends: [^\n]*${library}[^\n]*")
endforeach()
if(control MATCHES "openimageio|-dev[ ,\n]")
    fault("the programs depend on what they can do without:${control}")
endif()

# Nothing tells of this machine, neither text nor program.
file(GLOB_RECURSE unpacked "${SCRATCH}/usr/*")
execute_process(COMMAND grep -laF -e "${root}/" -e "${BUILD}" -e "${SCRATCH}" ${unpacked} OUTPUT_VARIABLE telling)
if(telling)
    fault("these name folders of this machine:\n${telling}")
endif()
foreach(file IN LISTS programs ITEMS ../lib/raytorus/raytorus-openexr.so)
    run(readelf --dynamic --section-headers --wide "${SCRATCH}/usr/bin/${file}")
    if(said MATCHES " [.]symtab ")
        fault("${file} is not stripped")
    endif()
    if(NOT said MATCHES "R(UN)?PATH\\) +Library (run)?r?path: \\[[$]ORIGIN/\\.\\./lib/raytorus:[$]ORIGIN/\\.\\./lib\\]")
        fault("${file} finds its libraries elsewhere:\n${said}")
    endif()
endforeach()

# The include, by CMake and by pkg-config; the C++; the programs.
build_example("${SCRATCH}/usr")
use_pkg_config("${SCRATCH}/usr")
use_cxx("${SCRATCH}/usr/share/raytorus")
render("${SCRATCH}/usr/bin/raytorus")
finish()
