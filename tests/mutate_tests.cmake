# SPDX-License-Identifier: MIT
# How sharp the other tests are: raytorus-mutate puts faults into the shaders. The whole run takes minutes and is a
# command of its own (docs/testing.md); what runs here shows that it can be believed.
find_package(Vulkan REQUIRED COMPONENTS glslangValidator)
set(mutations
    mutate/arithmetic_mutations.cpp
    mutate/contract_mutations.cpp
    mutate/fast_mutations.cpp
    mutate/hit_mutations.cpp
    mutate/scene_mutations.cpp
    mutate/shading_mutations.cpp
    mutate/solver_mutations.cpp
    mutate/surface_mutations.cpp)
add_library(raytorus_mutate STATIC
    ${mutations}
    contract_checks.cpp
    hit_match.cpp
    mutate/golden_suite.cpp
    mutate/mutant.cpp
    mutate/mutation.cpp
    mutate/mutation_run.cpp
    mutate/number_suite.cpp
    mutate/outcome.cpp
    picture_checks.cpp
    run_program.cpp
    special_lines.cpp
    surface_checks.cpp
    surface_probe.cpp)
# Each is a table, and has short names for the lines that it alters.
set_source_files_properties(${mutations} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
target_include_directories(raytorus_mutate PUBLIC "${CMAKE_CURRENT_SOURCE_DIR}")
target_compile_definitions(raytorus_mutate PRIVATE RAYTORUS_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
    RAYTORUS_GLSLANG="$<TARGET_FILE:Vulkan::glslangValidator>")
target_link_libraries(raytorus_mutate
    PUBLIC raytorus::golden raytorus::verify
    PRIVATE raytorus::methods raytorus_warnings raytorus_test_shaders nlohmann_json::nlohmann_json)

add_executable(raytorus-mutate mutate/main.cpp)
target_link_libraries(raytorus-mutate PRIVATE raytorus_mutate raytorus::cli raytorus_warnings)

raytorus_add_tests(mutate_tests SOURCES mutate_test.cpp LIBRARIES raytorus_mutate)
add_dependencies(mutate_tests raytorus-mutate)
target_compile_definitions(mutate_tests PRIVATE RAYTORUS_MUTATE="$<TARGET_FILE:raytorus-mutate>")

# A few faults, as people run them.
add_test(NAME mutate.some COMMAND raytorus-mutate --validate
    --only camera-upside-down,lift-missing,second-dip-forgotten,precise-dropped,uv-octants,direction-unchecked)
set_tests_properties(mutate.some PROPERTIES LABELS mutation TIMEOUT 300)
