# SPDX-License-Identifier: MIT
# host/compile: the same words as the build's compiler, errors in the right file and line, and the watch over files.
raytorus_add_tests(compile_tests
    SOURCES
        compile_test.cpp
        compile_error_test.cpp
        compile_fault_test.cpp
        bounded_child_test.cpp
        compile_include_test.cpp
        compile_limit_test.cpp
        compile_mutation_test.cpp
        directives_test.cpp
        file_watch_test.cpp
        shader_folder.cpp
    LIBRARIES raytorus::compile raytorus::methods raytorus_shaders)
