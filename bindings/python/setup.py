"""Builds one wheel for every Python 3 of a platform. The wheel has no extension module; it carries
shared libraries beside the Python files. cffi makes one of these files, which describes the C
interface (interface.py). CMake builds the C library from the checkout that holds this folder, or
SFUMATO_LIBRARY names a library to use. The wheel also carries the libraries that this one needs and
that a system may lack. With SFUMATO_LIBRARY=system the wheel holds only Python files, which load
the system's libsfumato.so.1; Debian's package is built this way.
"""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Distribution, setup
from setuptools.command.build_py import build_py
from wheel.bdist_wheel import bdist_wheel

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
LIBRARY = "libsfumato.so.1"
CARRIES = os.environ.get("SFUMATO_LIBRARY") != "system"

# By the policies of PyPI every Linux system that accepts such wheels has these libraries. They must
# come from the system, because they belong together.
SYSTEM = re.compile(r"(linux-vdso|ld-linux.*|lib(c|m|dl|rt|pthread|gcc_s|stdc\+\+|z))\.so.*")

# For each tag manylinux_2_N of PyPI's policies: the newest symbol versions that such a system
# surely has.
POLICIES = {
    28: {"GLIBC": (2, 28), "GLIBCXX": (3, 4, 24), "CXXABI": (1, 3, 11), "GCC": (7, 0, 0)},
    31: {"GLIBC": (2, 31), "GLIBCXX": (3, 4, 28), "CXXABI": (1, 3, 12), "GCC": (7, 0, 0)},
    34: {"GLIBC": (2, 34), "GLIBCXX": (3, 4, 29), "CXXABI": (1, 3, 13), "GCC": (7, 0, 0)},
    35: {"GLIBC": (2, 35), "GLIBCXX": (3, 4, 30), "CXXABI": (1, 3, 13), "GCC": (12, 0, 0)},
    36: {"GLIBC": (2, 36), "GLIBCXX": (3, 4, 30), "CXXABI": (1, 3, 13), "GCC": (12, 0, 0)},
}


def run(*command, **how):
    return subprocess.run([str(c) for c in command], check=True, **how)


def built(folder):
    """Builds the library from the checkout and returns its path."""
    if not (ROOT / "CMakeLists.txt").is_file():
        sys.exit("setup.py: Sfumato's sources are not around this folder; install from a checkout")
    for program in ("cmake", "ninja"):
        if shutil.which(program) is None:
            sys.exit(f"setup.py: {program} is missing; scripts/setup build installs what is needed")
    off = [f"-DSFUMATO_{name}=OFF" for name in ("TESTS", "BENCH", "EXAMPLES", "WERROR")]
    run("cmake", "-S", ROOT, "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", *off)
    run("cmake", "--build", folder, "--target", "sfumato_carried")
    return folder / "carried" / LIBRARY


def needed(library):
    """Returns what the loader would load for the library: path by name."""
    told = run("ldd", library, stdout=subprocess.PIPE, text=True).stdout
    found = {}
    for line in told.splitlines():
        if "not found" in line:
            sys.exit(f"setup.py: {line.strip()}")
        match = re.match(r"\s*(\S+) => (/\S+)", line)
        if match and not SYSTEM.fullmatch(match[1]):
            found[match[1]] = Path(match[2])
    return found


def keep_licence(library, folder):
    """Copies the licence text that Debian has for the package of a library into a folder."""
    asked = ["dpkg-query", "--search", str(library.resolve())]
    if shutil.which(asked[0]) is None:
        return
    told = subprocess.run(asked, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout
    package = told.split(":")[0]
    text = Path("/usr/share/doc") / package / "copyright"
    if package and text.is_file():
        shutil.copy(text, folder / f"{package}.txt")


def policy(libraries):
    """Returns the oldest of POLICIES that allows these libraries in a wheel, or None."""
    needs = {}
    for library in libraries:
        told = run("objdump", "-p", library, stdout=subprocess.PIPE, text=True).stdout
        carried = {path.name for path in libraries}
        for name in re.findall(r"NEEDED +(\S+)", told):
            if name not in carried and not SYSTEM.fullmatch(name):
                sys.exit(f"setup.py: {library.name} needs {name}, which is not carried")
        for name, version in re.findall(r" (GLIBC|GLIBCXX|CXXABI|GCC)_([\d.]+)$", told, re.MULTILINE):
            needs[name] = max(needs.get(name, ()), tuple(map(int, version.split("."))))
    for minor, has in POLICIES.items():
        if all(version <= has[name] for name, version in needs.items()):
            return minor
    return None


class Build(build_py):
    """Copies the package, then the libraries into it."""

    def run(self):
        if not sys.platform.startswith("linux"):
            sys.exit("setup.py: wheels are made on Linux alone so far")
        target = Path(self.build_lib) / "sfumato"
        shutil.rmtree(target, ignore_errors=True)  # left by an earlier build
        super().run()
        if CARRIES:
            self.carry(target)

    def carry(self, target):
        given = os.environ.get("SFUMATO_LIBRARY")
        library = Path(given) if given else built(ROOT / "build-python")
        if b"\0$ORIGIN\0" not in library.read_bytes():
            sys.exit(f"setup.py: {library} is not one that the target sfumato_carried makes")
        licences = target / "licences"
        licences.mkdir()
        shutil.copy(ROOT / "LICENSE", licences / "sfumato.txt")
        for name, path in {LIBRARY: library, **needed(library)}.items():
            shutil.copy(path.resolve(), target / name)
            os.chmod(target / name, 0o644)
            if shutil.which("strip") is not None:
                run("strip", "--strip-unneeded", target / name)
            keep_licence(path, licences)


class Wheel(bdist_wheel):
    def finalize_options(self):
        super().finalize_options()
        self.root_is_pure = not CARRIES

    def get_tag(self):
        if not CARRIES:
            return "py3", "none", "any"
        platform = super().get_tag()[2]
        build = self.get_finalized_command("build_py")
        libraries = sorted((Path(build.build_lib) / "sfumato").glob("*.so.*"))
        minor = policy(libraries) if libraries and shutil.which("objdump") else None
        if minor is not None and platform.startswith("linux_"):
            platform = f"manylinux_2_{minor}_{platform[len('linux_'):]}"
        return "py3", "none", platform


class WithLibrary(Distribution):
    def has_ext_modules(self):
        return CARRIES


setup(
    cmdclass={"build_py": Build, "bdist_wheel": Wheel},
    distclass=WithLibrary,
    cffi_modules=["interface.py:ffi"],
)
