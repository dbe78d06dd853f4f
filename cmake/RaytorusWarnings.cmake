# SPDX-License-Identifier: MIT
# raytorus_warnings: link it PRIVATE to each of our own targets. It never reaches users of the libraries.
add_library(raytorus_warnings INTERFACE)
target_compile_features(raytorus_warnings INTERFACE cxx_std_20)
target_compile_options(raytorus_warnings INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wold-style-cast -Wnon-virtual-dtor
    # A Vulkan structure is named by its first member; that the others are zero is the point.
    -Wno-missing-field-initializers
    $<$<BOOL:${RAYTORUS_WERROR}>:-Werror>
    # Floating-point expressions mean the same on the host as in the shaders: no contraction into fma.
    -ffp-contract=off)
if(RAYTORUS_ASAN)
    # -fno-sanitize=vptr,alignment,null: with them g++ 12 needs minutes for a translation unit that includes
    # large template headers; AddressSanitizer finds the null pointers anyway.
    set(_sanitize -fsanitize=address,undefined -fno-sanitize=null,vptr,alignment -fno-sanitize-recover=undefined
        -fno-omit-frame-pointer)
    target_compile_options(raytorus_warnings INTERFACE ${_sanitize})
    # The sanitizer stands between a program and dlopen, and a run path of the newer kind holds for calls from the
    # program itself alone: host/image's module would not be found.
    target_link_options(raytorus_warnings INTERFACE ${_sanitize} LINKER:--disable-new-dtags)
    add_library(raytorus_sanitizer STATIC "${CMAKE_CURRENT_LIST_DIR}/sanitizer.cpp")
    set_target_properties(raytorus_sanitizer PROPERTIES POSITION_INDEPENDENT_CODE ON)  # for modules
    target_link_libraries(raytorus_warnings INTERFACE "$<LINK_LIBRARY:WHOLE_ARCHIVE,raytorus_sanitizer>")
endif()

# raytorus_add_library(<name> SOURCES ... [PUBLIC target...] [PRIVATE target...])
# A static library of the host: include root is host/, so users write #include "gpu/buffer.hpp".
function(raytorus_add_library name)
    cmake_parse_arguments(ARG "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
    add_library(raytorus_${name} STATIC ${ARG_SOURCES})
    add_library(raytorus::${name} ALIAS raytorus_${name})
    target_include_directories(raytorus_${name} PUBLIC "${PROJECT_SOURCE_DIR}/host")
    target_compile_features(raytorus_${name} PUBLIC cxx_std_20)
    target_link_libraries(raytorus_${name} PUBLIC ${ARG_PUBLIC} PRIVATE raytorus_warnings ${ARG_PRIVATE})
endfunction()
# g++ 12 sees overlaps where strings are joined and there are none (GCC bug 105651).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    target_compile_options(raytorus_warnings INTERFACE -Wno-restrict)
endif()
