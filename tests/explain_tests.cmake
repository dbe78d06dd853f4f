# SPDX-License-Identifier: MIT
# host/explain: the exact side against identities, what the shaders say against the tracer, and the three ways to print.
find_package(nlohmann_json REQUIRED)
raytorus_add_tests(explain_tests
    SOURCES
        device_fixture.cpp
        explain_conclusion_test.cpp
        explain_exact_test.cpp
        explain_output_test.cpp
        explain_test.cpp
    LIBRARIES raytorus::explain nlohmann_json::nlohmann_json)
