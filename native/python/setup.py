"""Has CMake build the C++ part. ABFLAT_BUILD names a folder of CMake to build in."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext
from setuptools.command.sdist import sdist

HERE = Path(__file__).resolve().parent
# A source distribution has what CMake reads in a folder of its own.
IN_SDIST = HERE / "source"
SOURCE = IN_SDIST if IN_SDIST.is_dir() else HERE.parents[1]
NEEDED = ["CMakeLists.txt", "LICENSE", "core", "native/python", "scripts/cmake", "scripts/licenses"]
NOT_SOURCE = shutil.ignore_patterns("__pycache__", "*.egg-info", "*.so", "build", "dist", "source")


WORK = SOURCE / "build/python-package"


def version():
    text = (SOURCE / "core/include/abflat/version.h").read_text(encoding="utf-8")
    return re.search(r'define ABFLAT_VERSION "([0-9.]+)"', text)[1]


class BuildWithCMake(build_ext):
    def build_extension(self, ext):
        module = Path(self.get_ext_fullpath(ext.name)).resolve()
        build = Path(os.environ.get("ABFLAT_BUILD", self.build_temp)).resolve()
        if not (build / "CMakeCache.txt").exists():
            settings = {
                "CMAKE_BUILD_TYPE": "Release",
                "ABFLAT_PYTHON": "ON",
                "ABFLAT_PROGRAM": "OFF",
                "ABFLAT_TESTS": "OFF",
                "Python_EXECUTABLE": sys.executable,
            }
            given = os.environ.get("CMAKE_ARGS", "").split()
            defined = [f"-D{name}={value}" for name, value in settings.items()]
            run("cmake", "-S", SOURCE, "-B", build, *defined, *given)
        run("cmake", "--build", build, "--target", "abflat_python", "--parallel", os.cpu_count() or 1)
        if self.inplace:
            (built,) = (build / "python/abflat").glob("_abflat*" + module.suffix)
            shutil.copyfile(built, module)
        else:
            run("cmake", "--install", build, "--prefix", module.parents[1], "--component", "python")


class SdistWithSource(sdist):
    def make_release_tree(self, base_dir, files):
        super().make_release_tree(base_dir, files)
        for name in NEEDED:
            source, target = SOURCE / name, Path(base_dir) / "source" / name
            if source.is_dir():
                shutil.copytree(source, target, ignore=NOT_SOURCE)
            else:
                target.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(source, target)


def run(*command):
    subprocess.run([str(part) for part in command], check=True)


# setuptools would put what is left there from another version into a wheel.
for old in WORK.glob("lib*"):
    shutil.rmtree(old)
WORK.mkdir(parents=True, exist_ok=True)
setup(
    version=version(),
    options={"build": {"build_base": str(WORK)}, "egg_info": {"egg_base": str(WORK)}},
    ext_modules=[Extension("abflat._abflat", [])],
    cmdclass={"build_ext": BuildWithCMake, "sdist": SdistWithSource},
)
