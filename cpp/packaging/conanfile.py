"""Girth for Conan 2: girth::core, girth::io and girth::study, static or shared, and the command if asked for.

From the top of the repository: `conan create cpp/packaging`.
"""

import json
import os

from conan import ConanFile
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, load


class GirthConan(ConanFile):
    name = "girth"
    description = "The intrinsic girth function of triangle meshes"
    license = "MIT"
    topics = ("geometry", "geodesic", "mesh")
    package_type = "library"
    settings = "os", "arch", "compiler", "build_type"
    options = {
        "shared": [True, False],
        "fPIC": [True, False],
        "io": [True, False],
        "command": [True, False],
    }
    default_options = {"shared": False, "fPIC": True, "io": True, "command": False}
    implements = ["auto_shared_fpic"]

    @property
    def _repository(self):
        return os.path.join(self.recipe_folder, "..", "..")

    def set_version(self):
        package = load(self, os.path.join(self._repository, "package.json"))
        self.version = json.loads(package)["version"]

    def export_sources(self):
        for pattern in ("CMakeLists.txt", "package.json", "LICENSE", "CHANGELOG.md", "cpp/*"):
            copy(self, pattern, self._repository, self.export_sources_folder)

    def requirements(self):
        # Headers that the libraries alone are compiled with.
        self.requires("eigen/3.4.0", visible=False)
        self.requires("spectra/1.0.1", visible=False)
        if self.options.io:
            self.requires("draco/1.5.6")
            self.requires("meshoptimizer/0.20")
            self.requires("nlohmann_json/3.11.3", visible=False)
            self.requires("tinygltf/2.8.13", visible=False)
        if self.options.command:
            self.requires("zlib/[>=1.2.11 <2]", visible=False)

    def layout(self):
        cmake_layout(self)

    def generate(self):
        CMakeDeps(self).generate()
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["GIRTH_BUILD_IO"] = bool(self.options.io)
        toolchain.cache_variables["GIRTH_BUILD_COMMAND"] = bool(self.options.command)
        for option in ("BUILD_TESTS", "BUILD_BENCHMARKS", "PRECOMPILE_HEADERS", "UNITY_BUILD"):
            toolchain.cache_variables["GIRTH_" + option] = False
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()

    def package_info(self):
        self._library("core", [])
        if self.settings.os in ("Linux", "FreeBSD"):
            self.cpp_info.components["core"].system_libs = ["m", "pthread"]
        if self.options.shared:
            self.cpp_info.components["core"].defines = ["GIRTH_SHARED"]
        if self.options.io:
            self._library("io", ["core", "draco::draco", "meshoptimizer::meshoptimizer"])
            self._library("study", ["io"])

    def _library(self, name, requires):
        component = self.cpp_info.components[name]
        component.libs = ["girth_" + name]
        component.requires = requires
        component.set_property("cmake_target_name", "girth::" + name)
        component.set_property("pkg_config_name", "girth" if name == "core" else "girth-" + name)
