# SPDX-License-Identifier: MIT
# raytorus-view: its parts that need no window, then the program in real windows on a display of the tests' own.
if(NOT TARGET raytorus-view)
    add_test(NAME viewer.missing COMMAND "${CMAKE_COMMAND}" -P "${CMAKE_CURRENT_SOURCE_DIR}/viewer_missing.cmake")
    set_tests_properties(viewer.missing PROPERTIES SKIP_REGULAR_EXPRESSION "skipped: ")
    return()
endif()
find_package(nlohmann_json REQUIRED)
find_package(Vulkan REQUIRED)
pkg_check_modules(XCB REQUIRED IMPORTED_TARGET xcb)

raytorus_add_tests(viewer_tests
    SOURCES
        run_program.cpp
        viewer_analysis_test.cpp
        viewer_documentation_test.cpp
        viewer_navigation_test.cpp
        viewer_output_test.cpp
        viewer_resolution_test.cpp
        window_display.cpp
        window_failure_test.cpp
        window_fault_test.cpp
        window_hand_test.cpp
        window_key_test.cpp
        window_picture_test.cpp
        window_process.cpp
        window_reload_test.cpp
        window_size_test.cpp
        window_test.cpp
        window_view_test.cpp
        window_words_test.cpp
    LIBRARIES raytorus::viewer nlohmann_json::nlohmann_json PkgConfig::XCB)

# A Vulkan layer that fails windows on time, with a manifest for the loader.
add_library(raytorus_fault_layer MODULE layer_faults.cpp layer_schedule.cpp)
set_target_properties(raytorus_fault_layer PROPERTIES CXX_VISIBILITY_PRESET hidden)
target_link_libraries(raytorus_fault_layer PRIVATE raytorus_warnings Vulkan::Headers)
set(fault_layer_folder "${CMAKE_CURRENT_BINARY_DIR}/fault_layer")
file(READ "${CMAKE_CURRENT_SOURCE_DIR}/layer_faults.json.in" manifest)
string(REPLACE "@library@" "$<TARGET_FILE:raytorus_fault_layer>" manifest "${manifest}")
file(GENERATE OUTPUT "${fault_layer_folder}/layer_faults.json" CONTENT "${manifest}")

add_dependencies(viewer_tests raytorus raytorus-view raytorus_fault_layer)
target_compile_definitions(viewer_tests PRIVATE
    RAYTORUS_FAULT_LAYER_FOLDER="${fault_layer_folder}"
    RAYTORUS_PROGRAM="$<TARGET_FILE:raytorus>"
    RAYTORUS_VIEW="$<TARGET_FILE:raytorus-view>")
