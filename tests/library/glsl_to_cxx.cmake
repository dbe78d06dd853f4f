# SPDX-License-Identifier: MIT
# Writes the library as C++ that GLM's types make compile: `out T x` becomes `T& x`, the rest stays as it is.
#
#     cmake -DLIBRARY=<folder> -DOUTPUT=<folder> -P glsl_to_cxx.cmake
cmake_minimum_required(VERSION 3.25)
file(GLOB files "${LIBRARY}/*.glsl")
foreach(file IN LISTS files)
    file(READ "${file}" text)
    set(word "[A-Za-z0-9_]+")
    string(REGEX REPLACE "([(,][ \n]*)(out|inout) (${word}) (${word})\\[([0-9])\\]" "\\1\\3 (&\\4)[\\5]" text "${text}")
    string(REGEX REPLACE "([(,][ \n]*)(out|inout) (${word}) (${word})" "\\1\\3& \\4" text "${text}")
    cmake_path(GET file FILENAME name)
    file(WRITE "${OUTPUT}/${name}" "${text}")
endforeach()
