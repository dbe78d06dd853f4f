# SPDX-License-Identifier: MIT
# scripts/bundle: the folder that is carried to other machines, made of this build. Not with sanitizers, whose programs
# are no users', and not without the viewer, whose own tests say what is missing then.
if(NOT RAYTORUS_ASAN AND TARGET raytorus-view)
    foreach(check IN ITEMS relocated steps)
        set(name "bundle.${check}")
        add_test(NAME ${name} COMMAND "${CMAKE_COMMAND}" "-DSCRATCH=${CMAKE_CURRENT_BINARY_DIR}/output/${name}"
            "-DBUILD=${PROJECT_BINARY_DIR}" -P "${CMAKE_CURRENT_SOURCE_DIR}/bundle/${check}.cmake")
        set_tests_properties(${name} PROPERTIES TIMEOUT 300)
    endforeach()
endif()
