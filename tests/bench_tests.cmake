# SPDX-License-Identifier: MIT
# The benchmark: that it verifies and counts right, and the program as users run it. Nothing here depends on a time.
find_package(nlohmann_json REQUIRED)
set(bench_shader "${PROJECT_SOURCE_DIR}/host/bench/bench.comp")
raytorus_compile_shaders(raytorus_bench_defective NAMESPACE raytorus::bench_defective
    SOURCES "${bench_shader}" "${PROJECT_SOURCE_DIR}/shaders/trace.comp" INTERSECTOR defective_intersector.glsl)
raytorus_compile_shaders(raytorus_bench_fickle NAMESPACE raytorus::bench_fickle
    SOURCES "${bench_shader}" "${PROJECT_SOURCE_DIR}/shaders/trace.comp" INTERSECTOR fickle_intersector.glsl)

raytorus_add_tests(bench_tests
    SOURCES
        bench_against_test.cpp
        bench_correctness_test.cpp
        bench_groups_test.cpp
        bench_isa_test.cpp
        bench_measure_test.cpp
        bench_output_test.cpp
        bench_run.cpp
        bench_timing_test.cpp
        bench_workload_test.cpp
        device_fixture.cpp
        program_bench_test.cpp
        run_program.cpp
    LIBRARIES raytorus::bench raytorus_bench_defective raytorus_bench_fickle raytorus_patterns
        nlohmann_json::nlohmann_json)
add_dependencies(bench_tests raytorus-bench)
target_compile_definitions(bench_tests PRIVATE RAYTORUS_BENCH="$<TARGET_FILE:raytorus-bench>")
