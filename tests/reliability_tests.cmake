# SPDX-License-Identifier: MIT
# What must not be lost, nor pass in silence: docs/reliability.md.
raytorus_add_tests(reliability_tests
    SOURCES
        console_test.cpp
        input_file_test.cpp
        number_checks_test.cpp
        output_file_test.cpp
        reliability_memory_test.cpp
        reliability_table_test.cpp
        reliability_test.cpp
        reliability_words_test.cpp
        run_program.cpp
    LIBRARIES raytorus::cli nlohmann_json::nlohmann_json)
add_dependencies(reliability_tests raytorus raytorus-verify raytorus-bench raytorus-view raytorus_failing_calls)
# System calls that fail, loaded before a program.
add_library(raytorus_failing_calls MODULE failing_calls.cpp)
target_link_libraries(raytorus_failing_calls PRIVATE raytorus_warnings ${CMAKE_DL_LIBS})
add_library(raytorus_failing_modules MODULE failing_modules.cpp)
target_link_libraries(raytorus_failing_modules PRIVATE raytorus_warnings ${CMAKE_DL_LIBS})
add_dependencies(reliability_tests raytorus_failing_modules)
target_compile_definitions(reliability_tests PRIVATE
    RAYTORUS_FAILING_MODULES="$<TARGET_FILE:raytorus_failing_modules>"
    RAYTORUS_PROGRAM="$<TARGET_FILE:raytorus>"
    RAYTORUS_PROGRAMS="$<TARGET_FILE_DIR:raytorus>"
    RAYTORUS_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
    RAYTORUS_FAILING_CALLS="$<TARGET_FILE:raytorus_failing_calls>")
