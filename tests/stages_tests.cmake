# SPDX-License-Identifier: MIT
# The solver's stages one by one, and the fast tier, as C++: no device.
raytorus_add_tests(stages_tests
    SOURCES
        contract_checks.cpp
        fast_leaving_test.cpp
        fast_rays.cpp
        fast_tier_test.cpp
        stage_clip_test.cpp
        stage_contract_test.cpp
        stage_parabola_test.cpp
        stage_rays.cpp
        stage_reduce_test.cpp
        stage_refine_test.cpp
        stage_step_test.cpp
        stages_cxx_exact.cpp
        stages_cxx_fast.cpp
        tier_contract_test.cpp
    LIBRARIES raytorus::render raytorus::reference glm::glm)

# Each tier is the same names with other macros: none can be compiled together with another.
set_target_properties(stages_tests PROPERTIES UNITY_BUILD OFF)

# torus_cxx/*.glsl: the library as C++, written for gpu_tests.
target_include_directories(stages_tests PRIVATE "${CMAKE_CURRENT_BINARY_DIR}")
set_source_files_properties(stages_cxx_exact.cpp stages_cxx_fast.cpp PROPERTIES
    OBJECT_DEPENDS "${torus_cxx}/torus.glsl" COMPILE_OPTIONS -fsingle-precision-constant)
