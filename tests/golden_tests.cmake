# SPDX-License-Identifier: MIT
# The goldens: every way to be unfit, and all pictures by both routes against their truths.
find_package(nlohmann_json REQUIRED)
raytorus_add_tests(golden_tests
    SOURCES
        failing_rename.cpp
        file_group_test.cpp
        golden_test.cpp
        golden_files_test.cpp
        golden_options_test.cpp
        shell_quote_test.cpp
        run_program.cpp
        program_test.cpp
        program_golden_faults_test.cpp
        program_golden_commands_test.cpp
    LIBRARIES raytorus::golden raytorus::truth nlohmann_json::nlohmann_json)
add_dependencies(golden_tests raytorus)
target_compile_definitions(golden_tests PRIVATE
    RAYTORUS_PROGRAM="$<TARGET_FILE:raytorus>"
    RAYTORUS_SHADER_FOLDER="${PROJECT_BINARY_DIR}/shaders/raytorus_shaders")

# One process, because a process that starts Vulkan costs more than most pictures; the page names the failures. Not with
# sanitizers: they judge the host, which ProgramGolden runs.
if(NOT RAYTORUS_ASAN)
    add_test(NAME golden.check COMMAND raytorus golden check --validate --folder "${PROJECT_SOURCE_DIR}/golden"
        --report "${CMAKE_CURRENT_BINARY_DIR}/output/golden")
    set_tests_properties(golden.check PROPERTIES TIMEOUT 600)
endif()
