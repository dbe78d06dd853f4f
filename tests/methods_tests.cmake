# SPDX-License-Identifier: MIT
# The methods that the library is compared with: each answers ordinary rays, through real SPIR-V.
raytorus_add_tests(methods_tests
    SOURCES device_fixture.cpp methods_test.cpp third_cosine_cxx.cpp third_cosine_test.cpp
    LIBRARIES raytorus::methods raytorus::image raytorus::verify)
set_source_files_properties(third_cosine_cxx.cpp PROPERTIES COMPILE_OPTIONS -fsingle-precision-constant)
