"""The package as it is published: what the wheel and the sdist hold, what a build without its parts says, and every example of its
pages, as scripts and as notebooks."""

import os
import re
import shutil
import subprocess
import sys
import tarfile
import zipfile
from email.parser import Parser
from pathlib import Path

import numpy as np
import pytest
import run_examples
from conftest import MESHES, ROOT

import hexlens

BUILDS = Path(os.environ.get("HEXLENS_BUILDS", "/nowhere"))
built = pytest.mark.skipif(not BUILDS.exists(), reason="npm run test:python builds it")


@built
def test_the_wheel_has_all_of_it_and_a_tag_for_every_python() -> None:
    (wheel,) = BUILDS.glob("*.whl")
    assert re.fullmatch(r"hexlens-[\d.]+-py3-none-\w+\.whl", wheel.name)
    with zipfile.ZipFile(wheel) as archive:
        names = archive.namelist()
        (metadata_name,) = (name for name in names if name.endswith("METADATA"))
        metadata = Parser().parsestr(archive.read(metadata_name).decode())
    for name in ("py.typed", "_checker.py", "_checker.pyi", "hexlens.anywidget.js", "hexlens.mesh-worker.js"):
        assert f"hexlens/{name}" in names
    assert any(name.endswith("licenses/LICENSE") for name in names)
    assert not [name for name in names if "test" in name]
    assert metadata["License-Expression"] == "MIT"
    assert metadata["Version"] == hexlens.__version__
    assert metadata["Requires-Python"] == ">=3.10"
    assert "Exact answers" in str(metadata.get_payload())
    plain = [need for need in metadata.get_all("Requires-Dist", []) if "extra" not in need]
    assert plain == ["numpy>=1.23"]


@built
def test_the_sdist_holds_the_c_sources() -> None:
    (sdist,) = BUILDS.glob("*.tar.gz")
    with tarfile.open(sdist) as archive:
        names = {name.split("/", 1)[-1] for name in archive.getnames()}
    sources = {f"wasm/src/{path.name}" for path in (ROOT / "wasm/src").glob("*.[ch]")}
    assert sources <= names
    assert {"wasm/include/hexlens.h", "wasm/Makefile", "certificates/check_certificates.py", "LICENSE", "README.md"} <= names
    assert "hexlens/hexlens.anywidget.js" in names
    assert not (ROOT / "python/wasm").exists()


def test_the_licence_and_the_version_are_the_repository_s() -> None:
    assert (ROOT / "python/LICENSE").read_text() == (ROOT / "LICENSE").read_text()
    assert f'"version": "{hexlens.__version__}"' in (ROOT / "package.json").read_text()
    assert f'version = "{hexlens.__version__}"' in (ROOT / "python/pyproject.toml").read_text()


def build_in(folder: Path, **environment: str) -> subprocess.CompletedProcess[str]:
    program = f"import build_backend; build_backend.build_wheel({str(folder / 'out')!r})"
    return subprocess.run(
        [sys.executable, "-c", program], cwd=folder, env={**os.environ, **environment}, capture_output=True, encoding="utf-8", check=False
    )


@pytest.fixture
def sources(tmp_path: Path) -> Path:
    folder = tmp_path / "python"
    shutil.copytree(ROOT / "python", folder, ignore=shutil.ignore_patterns("build", "dist", "tests", ".*", "__pycache__"))
    for name in ("hexlens.anywidget.js", "hexlens.mesh-worker.js"):
        (folder / "hexlens" / name).touch()
    return folder


def test_without_its_script_a_wheel_is_not_built(sources: Path) -> None:
    pytest.importorskip("scikit_build_core")
    (sources / "hexlens/hexlens.anywidget.js").unlink()
    done = build_in(sources)
    assert done.returncode == 1
    assert "make it with `npm run build`" in done.stderr
    assert "Traceback" not in done.stderr


def test_without_a_compiler_a_sentence_says_so(sources: Path) -> None:
    pytest.importorskip("scikit_build_core")
    for environment in ({"PATH": "/nowhere", "CC": ""}, {"CC": "no-such-compiler"}):
        done = build_in(sources, **environment)
        assert done.returncode == 1
        assert "needs a C compiler" in done.stderr
        assert "Traceback" not in done.stderr


def test_without_its_library_an_import_says_so(tmp_path: Path) -> None:
    shutil.copytree(Path(hexlens.__file__).parent, tmp_path / "hexlens", ignore=shutil.ignore_patterns("*.so", "*.dylib", "*.js"))
    done = subprocess.run([sys.executable, "-c", "import hexlens"], cwd=tmp_path, capture_output=True, encoding="utf-8", check=False)
    assert "Hexlens lacks its C library" in done.stderr


needs_meshes = pytest.mark.skipif(not MESHES.exists(), reason="the meshes are not beside the repository")
#: A mesh that the examples are about.
MESH = MESHES / "made/vtk-raw-none.vtu"
#: What the examples need beside the package: notebooks, MPI, and the class that submits jobs.
BESIDE = ("ipykernel", "nbclient", "nbconvert", "mpi4py", "mpich", "dask-jobqueue")


@needs_meshes
@pytest.mark.parametrize("page", run_examples.PAGES)
def test_every_example_runs(page: str) -> None:
    for name in ("anywidget", "pyvista", "meshio", "distributed", "dask_jobqueue", "mpi4py"):
        pytest.importorskip(name)
    with run_examples.readers_folder(MESH):
        assert run_examples.run_page(page) >= 2


@needs_meshes
@pytest.mark.parametrize("page", run_examples.NOTEBOOKS)
def test_every_notebook_runs(page: str) -> None:
    for name in ("anywidget", "nbclient", "nbconvert"):
        pytest.importorskip(name)
    with run_examples.readers_folder(MESH):
        assert run_examples.run_notebook(page) >= 2


if os.environ.get("HEXLENS_ALL"):

    @built
    @needs_meshes
    @pytest.mark.parametrize("way", ["the folder", "the wheel", "the sdist"])
    def test_each_way_of_installing_runs_every_example(way: str, tmp_path: Path) -> None:
        """In a virtual environment that has nothing else."""
        source = {"the folder": ROOT / "python", "the wheel": next(BUILDS.glob("*.whl")), "the sdist": next(BUILDS.glob("*.tar.gz"))}[way]
        uv = Path(sys.executable).with_name("uv")
        subprocess.run([sys.executable, "-m", "venv", "--without-pip", tmp_path / "venv"], check=True)
        interpreter = tmp_path / "venv/bin/python"
        own = f"hexlens[widget,dask,files] @ {source.as_uri()}"
        subprocess.run([uv, "pip", "install", "--quiet", "--python", interpreter, own, *BESIDE], check=True)
        program = [interpreter, ROOT / "python/tests/run_examples.py", MESH]
        done = subprocess.run(program, cwd=tmp_path, capture_output=True, encoding="utf-8", check=False)
        assert done.returncode == 0, done.stderr
        assert re.fullmatch(r"\d+ examples and \d+ cells of notebooks ran\n", done.stdout)


def test_vertices_of_the_widget_go_both_ways() -> None:
    pytest.importorskip("anywidget")
    lens = hexlens.HexLens()
    seen = []
    lens.observe(lambda change: seen.append(change["new"]), "vertices")
    moved = lens.vertices.copy()
    moved[6] = [0.25, 0.25, 0.25]
    lens.vertices = moved
    assert np.array_equal(seen[0], moved)
    with pytest.raises(ValueError, match="read-only"):
        lens.vertices[0, 0] = 1
