# SPDX-License-Identifier: MIT
# Pictures against golden/, and the tool that renews those.
raytorus_add_tests(golden_tests
    SOURCES device_fixture.cpp golden_check.cpp golden_test.cpp
    LIBRARIES raytorus::render raytorus::image)

add_executable(raytorus-golden golden_check.cpp golden_tool.cpp)
target_compile_definitions(raytorus-golden PRIVATE RAYTORUS_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
target_link_libraries(raytorus-golden PRIVATE
    raytorus_warnings raytorus::render raytorus::image CLI11::CLI11 nlohmann_json::nlohmann_json)
