"""Has CMake build the extension module `certet._certet`, from the sources beside this folder.

Of the optional libraries a wheel has muParser (formulas) and oneTBB where they are found, and no
reader of files for images: arrays are all that Python needs.  `CMAKE_ARGS` adds to what CMake is
called with, like CMAKE_ARGS=-DCERTET_ASSIMP=ON.
"""

import os
import pathlib
import re
import shlex
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

SOURCE = pathlib.Path(__file__).resolve().parents[2]
LEFT_OUT = ("ITK", "ASSIMP", "OPENVDB", "HDF5", "PNG", "THREE")


def version():
    """That of the project."""
    return re.search(r"project\(certet VERSION ([0-9.]+)",
                     (SOURCE / "CMakeLists.txt").read_text()).group(1)


class CMakeBuild(build_ext):
    def build_extension(self, extension):
        target = pathlib.Path(self.get_ext_fullpath(extension.name)).resolve()
        build = pathlib.Path(self.build_temp).resolve()
        subprocess.run(
            ["cmake", "-S", SOURCE, "-B", build, "-DCMAKE_BUILD_TYPE=Release",
             f"-DPYTHON_EXECUTABLE={sys.executable}", f"-DCERTET_PYTHON_OUTPUT={target.parent}",
             "-DCERTET_PYBIND11=ON", "-DCERTET_UNITY=ON", "-DCERTET_COMMAND=OFF",
             "-DCERTET_TESTS=OFF", "-DCERTET_BENCH=OFF", "-DCERTET_INSTALL=OFF",
             *(f"-DCERTET_{part}=OFF" for part in LEFT_OUT), *self.pybind11(),
             *shlex.split(os.environ.get("CMAKE_ARGS", ""))], check=True)
        subprocess.run(["cmake", "--build", build, "--target", "certet_python", "--parallel",
                        str(os.cpu_count() or 1)], check=True)

    @staticmethod
    def pybind11():
        """Where the pybind11 of this Python has its CMake files, if it has one of its own."""
        try:
            import pybind11

            return [f"-Dpybind11_DIR={pybind11.get_cmake_dir()}"]
        except ImportError:
            return []


setup(version=version(), ext_modules=[Extension("certet._certet", [])],
      cmdclass={"build_ext": CMakeBuild})
