"""`repair`: a noisy grid becomes valid, its input stays as it is, threads do not matter, and what is no mesh is refused."""

from pathlib import Path

import numpy as np
import pytest
from conftest import lattice, python

import hexlens


def noisy(n: int, sigma: float, seed: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The grid with noise inside, and which points are inside."""
    points, cells = lattice(n)
    inside = ((points > 0) & (points < n)).all(axis=1)
    points[inside] += sigma * np.random.default_rng(seed).normal(size=(inside.sum(), 3))
    return points, cells, inside


def test_all_are_repaired_and_the_input_stays() -> None:
    points, cells, inside = noisy(10, 0.17, 1)
    given = points.copy()
    done = hexlens.repair(points, cells, min_relative=0.1)
    assert (points == given).all()
    assert done.invalid_before == hexlens.classify(points, cells).invalid_count > 0
    answers = hexlens.classify(done.points, cells)
    assert answers.invalid_count == done.invalid_after == 0
    assert done.least_after == answers.relative_min.min() >= 0.1
    assert done.below_after == 0
    assert len(done.held) == 0
    moved = (done.points != points).any(axis=1)
    assert moved.sum() == done.moved_count
    assert inside[moved].all()
    distances = np.linalg.norm(done.points - points, axis=1)[moved]
    assert done.greatest_distance == pytest.approx(distances.max())
    assert done.mean_distance == pytest.approx(distances.mean())


def test_threads_do_not_matter() -> None:
    points, cells, _ = noisy(10, 0.25, 2)
    one, two, three = (hexlens.repair(points, cells, min_relative=0.2, threads=threads) for threads in (1, 2, 3))
    assert one.points.tobytes() == two.points.tobytes() == three.points.tobytes()
    assert one.place_count == two.place_count == three.place_count
    assert one.least_after >= one.least_before


def test_boundary_and_choice() -> None:
    points, cells, inside = noisy(6, 0.25, 3)
    fixed = hexlens.repair(points, cells, min_relative=1, fixed=~inside)
    assert (fixed.points[~inside] == points[~inside]).all()
    slid = hexlens.repair(points, cells, min_relative=1, slide=True)
    ends = (points == 0) | (points == 6)
    assert (slid.points[ends] == points[ends]).all()
    near = hexlens.repair(points, cells, min_relative=1, free_boundary=0.05)
    assert 0 < np.linalg.norm((near.points - points)[~inside], axis=1).max() <= 0.05
    freed = hexlens.repair(points, cells, min_relative=1, fixed=np.arange(len(points)), freed=[0])
    assert set(np.flatnonzero((freed.points != points).any(axis=1))) == {0}
    assert 0 in freed.held


def test_progress_can_stop() -> None:
    points, cells, _ = noisy(10, 0.3, 4)
    told: list[tuple[int, int]] = []

    def progress(below: int, before: int) -> None:
        told.append((below, before))
        if len(told) == 3:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        hexlens.repair(points, cells, progress=progress)
    assert told[0][0] == told[0][1] > told[2][0]


def test_refusals() -> None:
    points, cells, _ = noisy(2, 0.1, 5)
    with pytest.raises(hexlens.HexlensError, match="not a finite number"):
        hexlens.repair(np.where(points == 0, np.nan, points), cells)
    with pytest.raises(hexlens.HexlensError, match="does not exist"):
        hexlens.repair(points, cells + 1)
    with pytest.raises(hexlens.HexlensError, match="from 0 to 1"):
        hexlens.repair(points, cells, min_relative=2)
    with pytest.raises(hexlens.HexlensError, match="a distance"):
        hexlens.repair(points, cells, free_boundary=-1)
    with pytest.raises(hexlens.HexlensError, match="fixed names a point"):
        hexlens.repair(points, cells, fixed=[27])


def test_command(tmp_path: Path) -> None:
    points, cells, _ = noisy(6, 0.22, 6)
    source, target = tmp_path / "in.vtu", tmp_path / "out.vtu"

    def array(kind: str, name: str, values: np.ndarray) -> str:
        text = " ".join(map(repr, values.ravel().tolist()))
        components = ' NumberOfComponents="3"' if name == "Points" else ""
        return f'<DataArray type="{kind}" Name="{name}"{components} format="ascii">{text}</DataArray>'

    source.write_text(
        f'<VTKFile type="UnstructuredGrid"><UnstructuredGrid><Piece NumberOfPoints="{len(points)}" NumberOfCells="{len(cells)}">'
        f"<Points>{array('Float64', 'Points', points)}</Points><Cells>{array('Int32', 'connectivity', cells)}"
        f"{array('Int32', 'offsets', 8 * np.arange(1, len(cells) + 1))}{array('UInt8', 'types', np.full(len(cells), 12))}</Cells>"
        "</Piece></UnstructuredGrid></VTKFile>"
    )
    before = source.read_bytes()
    done = python("repair", str(source), "-o", str(target), "--min-relative", "0.1")
    assert (done.returncode, done.stderr) == (0, "")
    assert "Repaired: " in done.stdout
    assert "all VALID" in done.stdout
    assert source.read_bytes() == before
    assert python("check", str(target), "--min-relative", "0.1").returncode == 0
    refused = python("repair", str(source), "-o", str(source))
    assert refused.returncode == 2
    assert "stays as it is" in refused.stderr
    assert source.read_bytes() == before
    assert "--slide" in python("repair", "--help").stdout
    assert "required" in python("repair", str(source)).stderr
