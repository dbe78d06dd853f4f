# SPDX-License-Identifier: MIT
# Script: fails unless the C++ sources are formatted as .clang-format says.
cmake_minimum_required(VERSION 3.25)
include("${CMAKE_CURRENT_LIST_DIR}/sources.cmake")

find_program(clang_format NAMES clang-format-14 clang-format)
if(NOT clang_format)
    message(FATAL_ERROR "clang-format is missing (Debian package clang-format).")
endif()
raytorus_sources(files "cmake;examples;host;tests" "*.cpp;*.hpp")
execute_process(COMMAND "${clang_format}" --dry-run --Werror ${files} RESULT_VARIABLE result)
if(NOT result EQUAL 0)
    execute_process(COMMAND "${clang_format}" --version OUTPUT_VARIABLE version OUTPUT_STRIP_TRAILING_WHITESPACE)
    message(FATAL_ERROR "Format the files above with clang-format 14, clang-format -i <file> (this is ${version}).")
endif()
