# SPDX-License-Identifier: MIT
# Whatever needs a device: host/gpu itself, and the library's GLSL judged through real SPIR-V.
raytorus_compile_shaders(raytorus_test_shaders NAMESPACE raytorus::test_shaders SOURCES probe.comp)

raytorus_add_tests(gpu_tests
    SOURCES
        contract_test.cpp
        device_fixture.cpp
        device_test.cpp
        hit_accuracy_test.cpp
        hit_judge.cpp
        known_rays_test.cpp
        surface_test.cpp
    LIBRARIES raytorus::render raytorus_reference raytorus_shaders raytorus_test_shaders)
