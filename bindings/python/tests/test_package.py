"""The installed package: its libraries, documents and examples."""

from __future__ import annotations

import ast
import ctypes.util
import importlib.metadata
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import sfumato
from conftest import EXAMPLES, ROOT

FOLDER = Path(sfumato.__file__).parent
# Whoever tests an installed package sets this; otherwise the Python files of the checkout may be
# tested alone.
INSTALLED = os.environ.get("SFUMATO_INSTALLED") == "1"


@pytest.mark.skipif(not INSTALLED, reason="the text of the checkout carries no libraries")
def test_the_package_carries_its_libraries():
    assert ROOT / "bindings" not in FOLDER.parents
    with open("/proc/self/maps") as maps:
        loaded = {line.split()[-1] for line in maps if ".so" in line}
    for name in ("sfumato", "tbb", "pugixml", "spng", "webp"):
        of_it = {path for path in loaded if Path(path).name.startswith(f"lib{name}.so")}
        assert of_it and {Path(path).parent for path in of_it} == {FOLDER}, of_it
    assert (FOLDER / "licences" / "sfumato.txt").is_file()
    assert (FOLDER / "py.typed").is_file()


@pytest.mark.skipif(not INSTALLED, reason="the text of the checkout carries no libraries")
def test_the_tag_tells_how_new_a_c_library_has_to_be():
    wheel = importlib.metadata.distribution("sfumato").read_text("WHEEL") or ""
    tag = re.search(r"^Tag: py3-none-(?:manylinux_2_(\d+)|linux)_", wheel, re.MULTILINE)
    assert tag, wheel
    libraries = sorted(FOLDER.glob("*.so.*"))
    told = "".join(
        subprocess.run(["objdump", "-p", path], capture_output=True, text=True, check=True).stdout
        for path in libraries
    )
    needed = max(int(minor) for minor in re.findall(r" GLIBC_2\.(\d+)", told))
    if tag[1] is None:
        assert needed > 36
    else:
        assert needed <= int(tag[1]) <= needed + 6
    outside = set(re.findall(r"NEEDED +(\S+)", told)) - {path.name for path in libraries}
    assert outside <= {
        "libc.so.6", "libm.so.6", "libgcc_s.so.1", "libstdc++.so.6", "libz.so.1", "ld-linux-x86-64.so.2"
    }


def imports_at_run_time(module: Path) -> set[str]:
    """Returns the package's modules that a module imports, inside functions too, but not for types alone."""
    found: set[str] = set()

    def look(node: ast.AST) -> None:
        if isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING":
            return
        if isinstance(node, ast.ImportFrom) and node.level == 1:
            found.update([node.module] if node.module else [name.name for name in node.names])
        for child in ast.iter_child_nodes(node):
            look(child)

    look(ast.parse(module.read_text()))
    return found


def test_no_modules_import_each_other_in_a_circle():
    modules = {path.stem: imports_at_run_time(path) for path in FOLDER.glob("*.py")}
    assert {"_library", "_session"} <= modules["_document"]
    left = dict(modules)
    while left:
        done = [name for name, needed in left.items() if not needed & left.keys()]
        assert done, f"a circle among {sorted(left)}"
        for name in done:
            del left[name]


def snippets(document):
    """The programs of a document: its blocks, and the line in its table of ways to use Sfumato."""
    text = document.read_text()
    blocks = re.findall(r"^```python\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
    return blocks + re.findall(r"^\| Python \| `(.*?)`", text, re.MULTILINE)


@pytest.mark.parametrize(
    "name, files", [("README.md", 0), ("bindings/python/README.md", 1), ("docs/python.md", 1)]
)
def test_programs_of_the_documents_run(name, files, tmp_path, monkeypatch):
    (tmp_path / "examples").symlink_to(EXAMPLES)
    monkeypatch.chdir(tmp_path)
    names = {"sfumato": sfumato}
    programs = snippets(ROOT / name)
    assert programs
    for program in programs:
        exec(compile(program, name, "exec"), names)
    image = names["image"]
    assert image.ndim == 3 and len(list(tmp_path.glob("*.pdf"))) == files


def run_example(name, *arguments):
    script = ROOT / "bindings" / "python" / "examples" / name
    done = subprocess.run(
        [sys.executable, str(script), *map(str, arguments)], capture_output=True, text=True, timeout=300
    )
    assert done.returncode == 0, done.stderr
    return [float(number) for number in re.findall(r"\d+\.\d+", done.stdout)]


def test_the_example_fits_colours_to_a_photo(tmp_path):
    pytest.importorskip("PIL.Image")
    before, after = run_example("fit_photo.py", EXAMPLES / "photos" / "lake.jpg", tmp_path / "out.svg")
    assert after < before / 4
    assert len(sfumato.open(tmp_path / "out.svg").layers[0].curves) > 100


def test_the_example_moves_a_curve(tmp_path):
    before, after, away = run_example("optimize.py", tmp_path / "out.svg")
    assert before > 20 and after < 0.1 and away < 0.1


def test_without_a_library_beside_it_the_system_s_is_loaded(tmp_path):
    package = tmp_path / "sfumato"
    package.mkdir()
    for text in FOLDER.glob("*.py"):
        shutil.copy(text, package)
    beside = Path(os.environ.get("SFUMATO_LIBRARY") or FOLDER / "libsfumato.so.1").parent
    rest = {name: value for name, value in os.environ.items() if name != "SFUMATO_LIBRARY"}
    program = "import sfumato; print(sfumato.__file__, sfumato.__version__)"

    def run(**environment):
        return subprocess.run([sys.executable, "-B", "-c", program], capture_output=True, text=True,
                              env={**rest, **environment}, cwd=tmp_path)

    found = run(LD_LIBRARY_PATH=str(beside))
    assert found.stdout == f"{package / '__init__.py'} {sfumato.__version__}\n", found.stderr
    if ctypes.util.find_library("sfumato") is None:
        lost = run()
        assert lost.returncode == 1 and "ImportError: Sfumato's library cannot be loaded" in lost.stderr


def test_a_library_that_is_none_is_an_import_error(tmp_path):
    (tmp_path / "none.so").write_bytes(b"no library")
    for path, words in ((tmp_path / "none.so", "cannot be loaded"), ("libc.so.6", "too old")):
        done = subprocess.run(
            [sys.executable, "-c", "import sfumato"], capture_output=True, text=True,
            env={**os.environ, "SFUMATO_LIBRARY": str(path)},
        )
        assert done.returncode == 1 and "ImportError" in done.stderr and words in done.stderr


@pytest.mark.skipif(not (ROOT / "include").is_dir(), reason="the C header is not here")
def test_a_new_c_function_needs_its_line_in_the_header(tmp_path):
    binding = tmp_path / "bindings" / "python"
    binding.mkdir(parents=True)
    shutil.copy(ROOT / "bindings" / "python" / "interface.py", binding)
    (binding / "sfumato").mkdir()
    header = tmp_path / "include" / "sfumato" / "sfumato.h"
    header.parent.mkdir(parents=True)
    text = (ROOT / "include" / "sfumato" / "sfumato.h").read_text()
    first = text.index("\nSFUMATO_API ")
    header.write_text(f"{text[:first]}\nSFUMATO_API int32_t sfumato_extra(double x);{text[first:]}")
    subprocess.run([sys.executable, "interface.py"], cwd=binding, check=True)
    assert "sfumato_extra" in (binding / "sfumato" / "_interface.py").read_text()
