# SPDX-License-Identifier: MIT
"""A project that compiles a shader with the package."""
import os

from conan import ConanFile
from conan.tools.cmake import CMake, cmake_layout


class RaytorusTest(ConanFile):
    settings = "os", "arch", "compiler", "build_type"
    generators = "CMakeDeps", "CMakeToolchain"

    def requirements(self):
        self.requires(self.tested_reference_str)

    def layout(self):
        cmake_layout(self)

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def test(self):
        assert os.path.getsize(os.path.join(self.build_folder, "use.spv")) > 1000
