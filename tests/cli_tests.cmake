# SPDX-License-Identifier: MIT
# The raytorus program, run as users run it, and the small pieces under it.
find_package(nlohmann_json REQUIRED)
raytorus_compile_shaders(raytorus_cli_test_shaders NAMESPACE raytorus::cli_test_shaders
    SOURCES undeclared_push_constant.frag)

raytorus_add_tests(cli_tests
    SOURCES
        number_text_test.cpp
        frame_options_test.cpp
        picture_writer_test.cpp
        ray_batches_test.cpp
        ray_file_test.cpp
        progress_test.cpp
        run_program.cpp
        program_test.cpp
        program_help_test.cpp
        program_usage_test.cpp
        program_exit_code_test.cpp
        program_start_test.cpp
        program_render_test.cpp
        program_render_frames_test.cpp
        program_stats_test.cpp
        program_golden_test.cpp
        program_routes_test.cpp
        program_method_test.cpp
        program_trace_test.cpp
        program_bulk_test.cpp
        program_compare_test.cpp
        program_doctor_test.cpp
        program_explain_test.cpp
        program_documentation_test.cpp
    LIBRARIES raytorus::cli raytorus::methods raytorus_patterns nlohmann_json::nlohmann_json)
add_dependencies(cli_tests raytorus raytorus_cli_test_shaders)
target_compile_definitions(cli_tests PRIVATE
    RAYTORUS_PROGRAM="$<TARGET_FILE:raytorus>"
    RAYTORUS_PROJECT_VERSION="${PROJECT_VERSION}"
    RAYTORUS_SHADER_FOLDER="${PROJECT_BINARY_DIR}/shaders/raytorus_shaders"
    RAYTORUS_TEST_SHADER_FOLDER="${CMAKE_CURRENT_BINARY_DIR}/raytorus_cli_test_shaders")
