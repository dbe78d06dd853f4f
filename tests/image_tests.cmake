# SPDX-License-Identifier: MIT
# Images, their files and their comparison. They need neither a GPU nor a Vulkan loader.
find_package(PkgConfig REQUIRED)
pkg_check_modules(OIIO REQUIRED IMPORTED_TARGET OpenImageIO)
find_package(CLI11 REQUIRED)
find_package(PNG REQUIRED)
find_package(nlohmann_json REQUIRED)
raytorus_add_tests(image_tests
    SOURCES
        image_test.cpp
        image_io_test.cpp
        image_file_error_test.cpp
        image_size_test.cpp
        openexr_codec_test.cpp
        compare_test.cpp
        compare_truth_test.cpp
        comparison_text_test.cpp
        difference_test.cpp
        manifest_test.cpp
        report_test.cpp
        report_data_test.cpp
        report_sample.cpp
        report_browser_test.cpp
        run_program.cpp
        compare_command_test.cpp
        # The command itself, without the program around it.
        "${PROJECT_SOURCE_DIR}/host/cli/compare_command.cpp"
    LIBRARIES raytorus::image raytorus_patterns PkgConfig::OIIO PNG::PNG CLI11::CLI11 nlohmann_json::nlohmann_json)
