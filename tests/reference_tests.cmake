# SPDX-License-Identifier: MIT
# The reference and the ray generator are judged before they judge the shaders.

raytorus_add_tests(reference_tests
    SOURCES
        reference_test.cpp
        rays_test.cpp
        reference/double_double_test.cpp
        reference/extrema_test.cpp
        reference/property_test.cpp
        reference/roots_test.cpp
        reference/surface_test.cpp
    LIBRARIES raytorus::reference)
