# SPDX-License-Identifier: MIT
# Whatever shows that drivers agree bit by bit, once more on each driver that scripts/drivers has fetched or that
# RAYTORUS_DRIVERS names. ctest looks for them when it runs: a driver that comes later needs no new configuring. Whole
# suites, because a process that compiles the library's pipelines again costs more than most tests.
# Not with sanitizers: they judge the host, which the first driver has run in full.
if(NOT RAYTORUS_ASAN)
    configure_file(drivers.cmake.in "${CMAKE_CURRENT_BINARY_DIR}/drivers.cmake" @ONLY)
    set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES "${CMAKE_CURRENT_BINARY_DIR}/drivers.cmake")
endif()
