# SPDX-License-Identifier: MIT
# The verifier: its judge and its statistics, and the program as users run it.
find_package(nlohmann_json REQUIRED)
raytorus_compile_shaders(raytorus_defective_shaders NAMESPACE raytorus::defective_shaders
    SOURCES "${PROJECT_SOURCE_DIR}/shaders/trace.comp" INTERSECTOR defective_intersector.glsl)
raytorus_compile_shaders(raytorus_invalid_shaders NAMESPACE raytorus::invalid_shaders SOURCES invalid/trace.comp)

raytorus_add_tests(verify_tests
    SOURCES
        histogram_test.cpp
        judge_test.cpp
        program_verify_test.cpp
        run_program.cpp
        verify_cell_test.cpp
    LIBRARIES raytorus::verify raytorus_patterns nlohmann_json::nlohmann_json)
add_dependencies(verify_tests raytorus-verify raytorus_defective_shaders raytorus_invalid_shaders)
target_compile_definitions(verify_tests PRIVATE
    RAYTORUS_VERIFY="$<TARGET_FILE:raytorus-verify>"
    RAYTORUS_DEFECTIVE_SHADER_FOLDER="${CMAKE_CURRENT_BINARY_DIR}/raytorus_defective_shaders"
    RAYTORUS_INVALID_SHADER_FOLDER="${CMAKE_CURRENT_BINARY_DIR}/raytorus_invalid_shaders")

# Rays of the day through every cell; CTest shows the table with -V, and when a bar is broken.
add_test(NAME verify.rays_of_today COMMAND raytorus-verify --rays 1000 --validate)
add_test(NAME verify.fast_rays_of_today COMMAND raytorus-verify --method raytorus-fast --rays 1000 --validate)
set_tests_properties(verify.rays_of_today verify.fast_rays_of_today PROPERTIES TIMEOUT 300)
