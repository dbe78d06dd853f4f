# SPDX-License-Identifier: MIT
# Scenes, their JSON form and the bounding volume hierarchy. They need no GPU.
find_package(nlohmann_json REQUIRED)
find_package(valijson REQUIRED)
raytorus_add_tests(scene_tests
    SOURCES
        scene_animation_test.cpp
        scene_json_test.cpp
        scene_fault_test.cpp
        scene_mutation_test.cpp
        schema_validation.cpp
        scene_schema_test.cpp
        shipped_scenes_test.cpp
        chain_test.cpp
        bvh_test.cpp
        torus_bounds_test.cpp
    LIBRARIES raytorus::scene nlohmann_json::nlohmann_json valijson)
# valijson uses std::regex, at which g++ 12 warns by mistake when it sanitizes (GCC bug 105562), and adds short strings,
# at which it does when it optimises (GCC bug 105651).
set_source_files_properties(schema_validation.cpp
    PROPERTIES COMPILE_OPTIONS "-Wno-maybe-uninitialized;-Wno-restrict")
