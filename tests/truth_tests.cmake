# SPDX-License-Identifier: MIT
# The truth that pictures are held to: its own facts, and the shaders' pictures beside it.
raytorus_add_tests(truth_tests
    SOURCES
        device_fixture.cpp
        random_scene.cpp
        truth_judge.cpp
        truth_picture_test.cpp
        truth_rounded_test.cpp
        truth_shader_test.cpp
        truth_verdict_test.cpp
    LIBRARIES raytorus::truth)
