"""Runs every example of the pages about Python, as scripts and as notebooks, with the hexlens that is installed:

    python run_examples.py MESH.vtu

MESH.vtu is vtk-raw-none.vtu of ../shared/meshes/made. In order, a page's examples have one namespace; a comment behind print is what it
prints. Nothing else of these tests is needed.
"""

import contextlib
import io
import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGES = ("python/README.md", "docs/python.md", "docs/dask.md")
#: Pages whose examples belong into notebooks, the third only in part.
NOTEBOOKS = ("python/README.md", "docs/python.md", "docs/embedding.md")
#: Nobody has Slurm here: the same class for jobs that are processes.
SLURM = ("from dask_jobqueue import SLURMCluster", "from dask_jobqueue.local import LocalCluster as SLURMCluster")
PIECES = 5


def examples(page: str) -> list[str]:
    text = (ROOT / page).read_text(encoding="utf-8")
    if page == "docs/embedding.md":
        text = text.split("\n## Jupyter\n")[1].split("\n## ")[0]
    found = re.findall(r"```python\n(.*?)```", text, re.DOTALL)
    assert found, page
    return found


def expected(code: str) -> list[str]:
    return re.findall(r"^ *print\(.*\)  # (.*)$", code, re.MULTILINE)


@contextlib.contextmanager
def readers_folder(mesh: Path) -> Iterator[Path]:
    """What the pages name: mesh.vtu, and pieces of which the last is damaged."""
    before = os.getcwd()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        shutil.copy(mesh, folder / "mesh.vtu")
        (folder / "pieces").mkdir()
        for number in range(1, PIECES + 1):
            shutil.copy(mesh, folder / f"pieces/piece-{number}.vtu")
        (folder / f"pieces/piece-{PIECES + 1}.vtu").write_bytes(mesh.read_bytes()[:2000])
        os.chdir(folder)
        try:
            yield folder
        finally:
            os.chdir(before)


def run_page(page: str) -> int:
    """The number of examples that ran."""
    space: dict[str, object] = {"__name__": "__main__"}
    for i, code in enumerate(examples(page)):
        name = f"example {i} of {page}"
        if "mpi4py" in code:
            run_with_mpi(code)
            continue
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            exec(compile(code.replace(*SLURM), name, "exec"), space)
        lines = printed.getvalue().splitlines()
        assert lines[: len(expected(code))] == expected(code), f"{name} prints {lines}"
    return len(examples(page))


def run_with_mpi(code: str) -> None:
    match = re.match(r"# (\w+\.py): mpiexec -n \d+ python \1 pieces/\*\.vtu\n", code)
    assert match, code
    Path(match[1]).write_text(code, encoding="utf-8")
    mpiexec = shutil.which("mpiexec", path=f"{Path(sys.executable).parent}{os.pathsep}{os.environ.get('PATH', '')}")
    assert mpiexec, "mpiexec is not there"
    files = sorted(map(str, Path("pieces").glob("*.vtu")))
    command = [mpiexec, "-n", "2", sys.executable, match[1], *files]
    done = subprocess.run(command, capture_output=True, encoding="utf-8", check=False)
    assert done.returncode == 0, done.stderr
    assert done.stdout.startswith(f"[{6 * PIECES}, {10 * PIECES}, 0] ['piece-{PIECES + 1}.vtu: "), done.stdout


def run_notebook(page: str) -> int:
    """The number of cells that ran. A cell that ends with the widget shows it, and a picture where there is no kernel."""
    import nbclient
    import nbconvert
    import nbformat

    cells = examples(page)
    # A reader looks at what the last of these makes.
    shown = [code if code.rstrip().endswith("\nlens") or "lens =" not in code else f"{code}\nlens" for code in cells]
    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(code) for code in shown])
    nbclient.NotebookClient(notebook, timeout=600, kernel_name="python3").execute()
    for code, cell in zip(cells, notebook.cells, strict=True):
        lines = "".join(output.text for output in cell.outputs if output.get("name") == "stdout").splitlines()
        assert lines[: len(expected(code))] == expected(code), f"A cell of {page} prints {lines}:\n{code}"
    if any("lens =" in code for code in cells):
        (data,) = (output.data for cell in notebook.cells for output in cell.outputs if output.output_type == "execute_result")
        assert "application/vnd.jupyter.widget-view+json" in data
        assert "<svg" in data["text/html"]
        # As JupyterLab saves it; with the widgets' state nbconvert has them load what draws them.
        del notebook.metadata["widgets"]
        assert "Invalid hexahedron, least jacdet -11.28" in nbconvert.HTMLExporter().from_notebook_node(notebook)[0]
    return len(cells)


def main() -> None:
    with readers_folder(Path(sys.argv[1]).resolve()):
        scripts = sum(map(run_page, PAGES))
        notebooks = sum(map(run_notebook, NOTEBOOKS))
    print(f"{scripts} examples and {notebooks} cells of notebooks ran")


if __name__ == "__main__":
    main()
