# SPDX-License-Identifier: MIT
"""The include for Conan 2: no settings, because it is text."""
import os

from conan import ConanFile
from conan.tools.cmake import CMake, CMakeToolchain
from conan.tools.files import copy, rmdir


class Raytorus(ConanFile):
    name = "raytorus"
    version = "@VERSION@"
    description = "@DESCRIPTION@"
    license = "MIT"
    topics = ("glsl", "vulkan", "torus", "intersection", "raytracing")
    package_type = "header-library"
    no_copy_source = True
    exports_sources = "source/*"

    def generate(self):
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["RAYTORUS_BUILD_HOST"] = False
        toolchain.generate()

    def build(self):
        CMake(self).configure(build_script_folder="source")

    def package(self):
        CMake(self).install()
        copy(self, "LICENSE", os.path.join(self.source_folder, "source"), os.path.join(self.package_folder, "licenses"))
        # Conan writes what CMake and pkg-config ask for itself.
        for folder in ("cmake", "pkgconfig"):
            rmdir(self, os.path.join(self.package_folder, "share", folder))

    def package_info(self):
        self.cpp_info.set_property("cmake_file_name", "raytorus")
        self.cpp_info.set_property("cmake_target_name", "raytorus::glsl")
        self.cpp_info.set_property("pkg_config_name", "raytorus")
        self.cpp_info.includedirs = ["share/raytorus/shaders/torus"]
        self.cpp_info.bindirs = []
        self.cpp_info.libdirs = []
