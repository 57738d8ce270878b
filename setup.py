# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Lets CMake build the extension modules of the Python package and the command, and setuptools pack them.

import os
import re
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = os.path.dirname(os.path.abspath(__file__))


class BuildByCMake(build_ext):
    """builds all extension modules and the command at once."""

    def run(self):
        folder = os.path.dirname(os.path.abspath(self.get_ext_fullpath("intrinsic_triangulations._core")))
        build = os.path.join(ROOT, "build", "python-package")
        subprocess.run(
            ["cmake", "-S", ROOT, "-B", build, "-DCMAKE_BUILD_TYPE=Release",
             f"-DPython_EXECUTABLE={sys.executable}",
             f"-DINTRINSIC_TRIANGULATIONS_PYTHON_FOLDER={folder}",
             "-DINTRINSIC_TRIANGULATIONS_BUILD_PYTHON=ON", "-DINTRINSIC_TRIANGULATIONS_BUILD_COMMAND=ON"]
            + [f"-DINTRINSIC_TRIANGULATIONS_BUILD_{part}=OFF" for part in ("TESTS", "BENCHMARKS")],
            check=True)
        # Two at once, as a source can take 2 GB; CMAKE_BUILD_PARALLEL_LEVEL says otherwise.
        environment = {"CMAKE_BUILD_PARALLEL_LEVEL": "2", **os.environ}
        subprocess.run(["cmake", "--build", build, "--target", "intrinsic_triangulations_python", "idt"], check=True, env=environment)
        shutil.copy(os.path.join(build, "bin", "idt"), folder)  # which writes pages


def version():
    with open(os.path.join(ROOT, "CMakeLists.txt"), encoding="utf-8") as file:
        return re.search(r"^  VERSION (\S+)$", file.read(), re.MULTILINE).group(1)


# What is built, also beside the sources, stays in the folder for that.
os.makedirs(os.path.join(ROOT, "build"), exist_ok=True)
setup(
    version=version(),
    ext_modules=[Extension(f"intrinsic_triangulations.{name}", []) for name in ("_core", "_point_cloud", "_repair")],
    cmdclass={"build_ext": BuildByCMake},
    options={"egg_info": {"egg_base": "build"}, "build": {"build_base": "build/setuptools"}},
)
