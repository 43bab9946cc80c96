"""Builds this checkout: conan create packaging/conan"""

import os
import re

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, load

ROOT = os.path.join("..", "..")
EXPORTED = ["CMakeLists.txt", "LICENSE", "core/*", "scripts/cmake/*"]


class AbflatConan(ConanFile):
    name = "abflat"
    license = "MIT"
    description = "UV unwrapping with exact checks: seams, angle based flattening, packing"
    topics = ("uv", "parameterization", "geometry")
    package_type = "library"
    settings = "os", "arch", "compiler", "build_type"
    options = {
        "shared": [True, False],
        "fPIC": [True, False],
        "drawing": [True, False],
        "gltf": [True, False],
    }
    default_options = {"shared": False, "fPIC": True, "drawing": False, "gltf": False}

    def set_version(self):
        header = os.path.join(self.recipe_folder, ROOT, "core/include/abflat/version.h")
        self.version = re.search(r'ABFLAT_VERSION "(.+)"', load(self, header)).group(1)

    def export_sources(self):
        source = os.path.join(self.recipe_folder, ROOT)
        for pattern in EXPORTED:
            copy(self, pattern, source, self.export_sources_folder)

    def config_options(self):
        if self.settings.os == "Windows":
            del self.options.fPIC

    def configure(self):
        if self.options.shared:
            self.options.rm_safe("fPIC")

    def validate(self):
        check_min_cppstd(self, 17)

    def requirements(self):
        self.requires("eigen/3.4.0")
        self.requires("fast_float/6.1.0")
        if self.options.drawing:
            self.requires("zlib/[>=1.2.11 <2]")
        if self.options.gltf:
            self.requires("draco/1.5.6")
            self.requires("meshoptimizer/0.20")
            self.requires("nlohmann_json/3.11.2")

    def layout(self):
        cmake_layout(self)

    def generate(self):
        CMakeDeps(self).generate()
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables.update(
            ABFLAT_PROGRAM=False,
            ABFLAT_INSTALL=True,
            ABFLAT_DRAWING=bool(self.options.drawing),
            ABFLAT_GLTF=bool(self.options.gltf),
        )
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        copy(self, "LICENSE", self.source_folder, os.path.join(self.package_folder, "licenses"))
        CMake(self).install()

    def package_info(self):
        self.cpp_info.set_property("cmake_file_name", "abflat")
        for part in ["abflat"] + [p for p in ("drawing", "gltf") if getattr(self.options, p)]:
            component = self.cpp_info.components[part]
            if part == "abflat":
                component.libs = ["abflat"]
            elif not self.options.shared:  # a shared library contains its parts
                component.libs = [f"abflat_{part}"]
            component.set_property("cmake_target_name", f"abflat::{part}")
            if part != "abflat":
                component.requires = ["abflat"]
        self.cpp_info.components["abflat"].requires = ["eigen::eigen", "fast_float::fast_float"]
        if self.settings.os in ["Linux", "FreeBSD"]:
            self.cpp_info.components["abflat"].system_libs = ["pthread"]
        if self.options.drawing:
            self.cpp_info.components["drawing"].requires.append("zlib::zlib")
        if self.options.gltf:
            self.cpp_info.components["gltf"].requires += [
                "draco::draco",
                "meshoptimizer::meshoptimizer",
                "nlohmann_json::nlohmann_json",
            ]
