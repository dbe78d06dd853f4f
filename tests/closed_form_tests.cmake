# SPDX-License-Identifier: MIT
# The derivation as it stands in shaders/torus/closed_form.glsl: its identities in exact arithmetic, its roots in 113 bits
# and in float32, on the device and off it.
raytorus_compile_shaders(raytorus_closed_form_shaders NAMESPACE raytorus::closed_form_shaders SOURCES closed_form.comp)

find_package(Boost 1.74 REQUIRED)
set(numbers closed_form_exact.cpp closed_form_float.cpp closed_form_integer.cpp closed_form_quad.cpp)
raytorus_add_tests(closed_form_tests
    SOURCES
        ${numbers}
        closed_form_device_test.cpp
        closed_form_float_test.cpp
        closed_form_probe.cpp
        closed_form_test.cpp
        device_fixture.cpp
        identities_test.cpp
        resolvent_identities_test.cpp
    LIBRARIES raytorus::render raytorus::reference raytorus_closed_form_shaders Boost::headers)

# Each file says the same with a type of numbers of its own: none can be compiled together with another.
set_target_properties(closed_form_tests PROPERTIES UNITY_BUILD OFF)

# torus_cxx/*.glsl: the library as C++, written for gpu_tests.
target_include_directories(closed_form_tests PRIVATE "${CMAKE_CURRENT_BINARY_DIR}")
set_source_files_properties(${numbers} PROPERTIES OBJECT_DEPENDS "${torus_cxx}/torus.glsl")
set_source_files_properties(closed_form_float.cpp PROPERTIES COMPILE_OPTIONS -fsingle-precision-constant)
