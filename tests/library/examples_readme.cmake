# SPDX-License-Identifier: MIT
# README.md prints the first example word for word.
cmake_minimum_required(VERSION 3.25)
get_filename_component(root "${CMAKE_CURRENT_LIST_DIR}/../.." ABSOLUTE)
if(NOT DEFINED README)
    set(README "${root}/README.md")
endif()
file(READ "${root}/examples/first_hit.frag" example)
file(READ "${README}" readme)
string(FIND "${readme}" "```glsl\n${example}```\n" at)
if(at EQUAL -1)
    message(FATAL_ERROR "README.md does not show examples/first_hit.frag as it is, as one glsl block.")
endif()
