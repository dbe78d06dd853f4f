# SPDX-License-Identifier: MIT
# Whatever needs a device: host/gpu itself, and the library's GLSL judged through real SPIR-V.
raytorus_compile_shaders(raytorus_test_shaders NAMESPACE raytorus::test_shaders SOURCES probe.comp)

raytorus_add_tests(gpu_tests
    SOURCES
        contract_checks.cpp
        contract_test.cpp
        cxx_twin_test.cpp
        denormal_test.cpp
        device_fixture.cpp
        device_test.cpp
        extreme_ranges_test.cpp
        fused_fma_test.cpp
        hit_accuracy_test.cpp
        hit_judge.cpp
        hit_match.cpp
        known_rays_test.cpp
        loose_arithmetic.cpp
        loose_arithmetic_test.cpp
        once_compiled_test.cpp
        picture_checks.cpp
        picture_test.cpp
        pipeline_store_test.cpp
        quartic_rays_test.cpp
        special_lines.cpp
        special_lines_test.cpp
        stress_rays_test.cpp
        submission_test.cpp
        surface_checks.cpp
        surface_probe.cpp
        surface_test.cpp
        torus_cxx.cpp
        torus_cxx_fused.cpp
    LIBRARIES raytorus::render raytorus::verify raytorus_shaders raytorus_test_shaders glm::glm)

# The library as C++, for cxx_twin_test.cpp: torus_cxx/*.glsl in the build folder, included by torus_cxx.cpp.
find_package(glm CONFIG REQUIRED)
file(GLOB torus_glsl CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/shaders/torus/*.glsl")
set(torus_cxx "${CMAKE_CURRENT_BINARY_DIR}/torus_cxx")
set(torus_cxx_script "${CMAKE_CURRENT_SOURCE_DIR}/library/glsl_to_cxx.cmake")
add_custom_command(OUTPUT "${torus_cxx}/torus.glsl"
    COMMAND "${CMAKE_COMMAND}" "-DLIBRARY=${PROJECT_SOURCE_DIR}/shaders/torus" "-DOUTPUT=${torus_cxx}"
            -P "${torus_cxx_script}"
    DEPENDS ${torus_glsl} "${torus_cxx_script}" VERBATIM COMMENT "Writing the library as C++")
target_include_directories(gpu_tests PRIVATE "${CMAKE_CURRENT_BINARY_DIR}")
set_source_files_properties(torus_cxx.cpp torus_cxx_fused.cpp loose_arithmetic.cpp PROPERTIES
    OBJECT_DEPENDS "${torus_cxx}/torus.glsl" COMPILE_OPTIONS -fsingle-precision-constant)
