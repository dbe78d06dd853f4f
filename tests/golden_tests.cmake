# SPDX-License-Identifier: MIT
# The goldens: every way to be unfit, and all pictures by both routes against their truths.
raytorus_add_tests(golden_tests
    SOURCES golden_test.cpp
    LIBRARIES raytorus::golden raytorus::truth)

# One process, because a process that starts Vulkan costs more than most pictures; the page names the failures. Not with
# sanitizers: they judge the host, which ProgramGolden runs.
if(NOT RAYTORUS_ASAN)
    add_test(NAME golden.check COMMAND raytorus golden check --validate --folder "${PROJECT_SOURCE_DIR}/golden"
        --report "${CMAKE_CURRENT_BINARY_DIR}/output/golden")
    set_tests_properties(golden.check PROPERTIES TIMEOUT 600)
endif()
