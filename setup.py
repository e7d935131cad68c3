"""Builds the Python package: the module, with the library and the program of Keyblock beside it.

CMake builds all, for processors since about 2013 (KEYBLOCK_ARCH). If KEYBLOCK_LIBRARY names a ready libkeyblock.so, only
the module is compiled; that library is copied, and the program `keyblock` of its folder if there is one.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).resolve().parent
VERSION = re.search(r"project\(keyblock VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1]
LIBRARY = os.environ.get("KEYBLOCK_LIBRARY")
SONAME = "libkeyblock.so." + VERSION.split(".")[0]


class Build(build_ext):
    def build_extension(self, ext):
        target = Path(self.get_ext_fullpath(ext.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        if LIBRARY:
            super().build_extension(ext)
            library = Path(LIBRARY)
        else:
            folder = ROOT / "build-wheel"  # kept: a second wheel takes a minute
            subprocess.check_call(["cmake", "-S", str(ROOT), "-B", str(folder), "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                                   "-DKEYBLOCK_PYTHON=ON", f"-DKEYBLOCK_PYTHON_PROGRAM={sys.executable}"])
            jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL") or str(os.cpu_count() or 1)
            subprocess.check_call(["cmake", "--build", str(folder), "--target", "keyblock_python", "keyblock", "--parallel", jobs])
            module, = (folder / "python" / "keyblock").glob("_keyblock*.so")
            shutil.copy(module, target)
            library = folder / "libkeyblock.so"
        shutil.copy(library, target.parent / SONAME)  # the file that the link leads to
        program = library.parent / "keyblock"
        if program.is_file():
            (target.parent / "bin").mkdir(exist_ok=True)
            shutil.copy(program, target.parent / "bin" / "keyblock")


linked = {}
if LIBRARY:
    linked = dict(include_dirs=["include"], extra_objects=[str(Path(LIBRARY).resolve())],
                  extra_compile_args=["-std=c++20", "-fvisibility=hidden", "-g0"], extra_link_args=["-Wl,-rpath,$ORIGIN"])
setup(
    name="keyblock",
    version=VERSION,
    description="discontinuous deformation analysis and numerical manifold method",
    license="GPL-3.0-or-later",
    python_requires=">=3.9",
    install_requires=["numpy"],
    extras_require={"frames": ["pandas"], "plots": ["matplotlib"]},
    package_dir={"": "python"},
    packages=["keyblock"],
    package_data={"keyblock": ["py.typed", "*.pyi"]},
    ext_modules=[Extension("keyblock._keyblock", ["python/src/module.cpp"], language="c++", **linked)],
    cmdclass={"build_ext": Build},
)
