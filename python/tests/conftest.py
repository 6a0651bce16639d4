"""Where things lie, and the Node command, whose answers these are compared with."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, settings

#: A busy machine fails no test.
settings.register_profile("untimed", deadline=None, suppress_health_check=[HealthCheck.too_slow])
settings.load_profile("untimed")

ROOT = Path(__file__).resolve().parents[2]
#: Meshes and hard cases lie beside the repository; the vectors of the repository are a part of them.
SHARED = Path(os.environ.get("HEXLENS_SHARED", ROOT / "../shared")).resolve()
if not SHARED.exists():
    SHARED = Path(os.environ.get("HEXLENS_SHARED", ROOT / "../../shared")).resolve()
MESHES = SHARED / "meshes"
VECTORS = ROOT / "tests/vectors"


def node(*arguments: str, cwd: Path = ROOT, text: str | None = None) -> subprocess.CompletedProcess[str]:
    """The command line of this repository."""
    command = shutil.which("node")
    assert command, "node is not on PATH"
    return subprocess.run(
        [command, str(ROOT / "tools/hexlens.mjs"), *arguments], cwd=cwd, input=text, capture_output=True, encoding="utf-8", check=False
    )


def python(*arguments: str, cwd: Path = ROOT, text: str | None = None) -> subprocess.CompletedProcess[str]:
    """`python -m hexlens`."""
    command = [sys.executable, "-m", "hexlens", *arguments]
    return subprocess.run(command, cwd=cwd, input=text, capture_output=True, encoding="utf-8", check=False)


def hard_cases() -> list[dict[str, Any]]:
    """Elements near the border, with names."""
    cases = [json.loads((VECTORS / name).read_text()) for name in ("public_cases.json", "depth_guard_false_negatives.json")]
    return [{"name": case["name"], "vertices": case["vertices"]} for group in cases for case in group]


def lattice(n: int, move: float = 0.0, seed: int = 1) -> tuple[np.ndarray, np.ndarray]:
    """n^3 cells that share points, moved by as much as `move` of a side."""
    axes = np.meshgrid(*[np.arange(n + 1.0)] * 3, indexing="ij")
    points = np.stack(axes, axis=-1)
    points += np.random.default_rng(seed).uniform(-move, move, points.shape)
    i, j, k = np.meshgrid(*[np.arange(n)] * 3, indexing="ij")
    corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    cells = np.stack([((i + a) * (n + 1) + j + b) * (n + 1) + k + c for a, b, c in corners], axis=-1)
    return np.ascontiguousarray(points.reshape(-1, 3)), cells.reshape(-1, 8).astype(np.int32)


@pytest.fixture
def cube() -> np.ndarray:
    return np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]], dtype=float)


def write_vtu(path: Path, points: np.ndarray, cells: np.ndarray, ghosts: np.ndarray | None = None) -> None:
    """Hexahedra as a raw VTU."""
    count = len(cells)
    arrays = [
        ("Points", "Points", "Float64", ' NumberOfComponents="3"', points),
        ("Cells", "connectivity", "Int32", "", cells.astype(np.int32)),
        ("Cells", "offsets", "Int64", "", np.arange(8, 8 * count + 8, 8)),
        ("Cells", "types", "UInt8", "", np.full(count, 12, np.uint8)),
    ]
    if ghosts is not None:
        arrays.append(("CellData", "vtkGhostType", "UInt8", "", ghosts.astype(np.uint8)))
    offset, sections = 0, {}
    for section, name, kind, more, values in arrays:
        line = f'<DataArray type="{kind}" Name="{name}"{more} format="appended" offset="{offset}"/>'
        sections[section] = sections.get(section, "") + line
        offset += 8 + values.nbytes
    inner = "".join(f"<{section}>{lines}</{section}>" for section, lines in sections.items())
    head = '<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" header_type="UInt64"><UnstructuredGrid>'
    piece = f'<Piece NumberOfPoints="{len(points)}" NumberOfCells="{count}">{inner}</Piece></UnstructuredGrid>'
    with open(path, "wb") as file:
        file.write(f'{head}{piece}<AppendedData encoding="raw">_'.encode())
        for *_, values in arrays:
            file.write(np.uint64(values.nbytes).tobytes() + np.ascontiguousarray(values).tobytes())
        file.write(b"</AppendedData></VTKFile>")
