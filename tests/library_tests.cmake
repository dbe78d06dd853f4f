# SPDX-License-Identifier: MIT
# The library folder held to its promise, and the examples to theirs: scripts that need glslangValidator and the SPIR-V
# tools, no program of ours. Each has a folder of its own to write in.
foreach(check IN ITEMS alone files names operations version contract equations rebuild broken)
    set(name "library.${check}")
    add_test(NAME ${name} COMMAND "${CMAKE_COMMAND}" "-DSCRATCH=${CMAKE_CURRENT_BINARY_DIR}/output/${name}"
        "-DGENERATOR=${CMAKE_GENERATOR}" -P "${CMAKE_CURRENT_SOURCE_DIR}/library/${check}.cmake")
endforeach()
foreach(check IN ITEMS readme commands cmake_project)
    set(name "examples.${check}")
    add_test(NAME ${name} COMMAND "${CMAKE_COMMAND}" "-DSCRATCH=${CMAKE_CURRENT_BINARY_DIR}/output/${name}"
        "-DGENERATOR=${CMAKE_GENERATOR}" -P "${CMAKE_CURRENT_SOURCE_DIR}/library/examples_${check}.cmake")
endforeach()
