"""`repair`: a noisy grid becomes valid, its input stays as it is, threads do not matter, and what is no mesh is refused."""

import json
from pathlib import Path

import numpy as np
import pytest
from conftest import lattice, node, python

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


def mirrored(cells: np.ndarray, chosen: np.ndarray) -> np.ndarray:
    own = cells.copy()
    own[chosen] = cells[chosen][:, [4, 5, 6, 7, 0, 1, 2, 3]]
    return own


def test_mirrored_cells() -> None:
    points, cells, _ = noisy(8, 0.2, 7)
    chosen = np.flatnonzero(np.random.default_rng(7).random(len(cells)) < 0.3)
    given = mirrored(cells, chosen)
    plain = hexlens.repair(points, cells, min_relative=0.1)
    assert len(plain.reversed_cells) == 0
    kept = hexlens.repair(points, given, min_relative=0.1)
    assert (kept.cells == given).all()
    assert (kept.reversed_cells == chosen).all()
    assert kept.points.tobytes() == plain.points.tobytes()
    for moved, invalid, below, least in (
        (points, kept.invalid_before, kept.below_before, kept.least_before),
        (kept.points, kept.invalid_after, kept.below_after, kept.least_after),
    ):
        answers = hexlens.classify(moved, given)
        assert (invalid, below) == (answers.invalid_count, (answers.relative_min < 0.1).sum())
        assert least == answers.relative_min.min()
    assert kept.invalid_after == len(chosen)
    right = hexlens.repair(points, given, min_relative=0.1, reorder=True)
    assert (right.cells == cells).all()
    assert right.invalid_after == hexlens.classify(right.points, right.cells).invalid_count == 0
    every = hexlens.repair(points, mirrored(cells, np.arange(len(cells))), reorder=True)
    assert (every.cells == cells).all()


def test_certificates() -> None:
    points, cells, inside = noisy(5, 0.2, 8)
    done = hexlens.repair(points, cells, min_relative=0.7)
    reasons = list(done.reasons())
    assert [reason.point for reason in reasons] == done.held.tolist()
    certificates = done.certificates()
    assert len(certificates) == sum(reason.certificate is not None for reason in reasons) > 10
    hexlens.verify(certificates[:6])
    for reason in reasons:
        own = np.flatnonzero((cells == reason.point).any(axis=1))
        assert reason.cells == tuple(own.tolist())
        if reason.forbids == "margin":
            assert reason.bound is not None
            assert hexlens.classify(done.points, cells).relative_min[own].min() <= reason.bound < 0.7
    tampered = {**certificates[0], "level": "0"}
    with pytest.raises(hexlens.HexlensError, match="refused"):
        hexlens.verify(tampered)
    # A vertex whose cells are folded by what stays: no place makes them valid.
    points, cells, inside = noisy(2, 0.0, 9)
    points[np.flatnonzero(~inside)[-1]] = [-1, -1, -1]
    (reason,) = hexlens.repair(points, cells).reasons()
    assert (reason.forbids, reason.bound) == ("valid", None)
    assert reason.certificate is not None
    assert reason.certificate["level"] == "0"
    hexlens.verify(reason.certificate)
    slid = hexlens.repair(*noisy(4, 0.3, 10)[:2], min_relative=1, slide=True)
    kinds = {reason.certificate is None for reason in slid.reasons()}
    assert kinds == {True, False}


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


def text_vtu(points: np.ndarray, cells: np.ndarray) -> str:
    def array(kind: str, name: str, values: np.ndarray) -> str:
        text = " ".join(map(repr, values.ravel().tolist()))
        components = ' NumberOfComponents="3"' if name == "Points" else ""
        return f'<DataArray type="{kind}" Name="{name}"{components} format="ascii">{text}</DataArray>'

    return (
        f'<VTKFile type="UnstructuredGrid"><UnstructuredGrid><Piece NumberOfPoints="{len(points)}" NumberOfCells="{len(cells)}">'
        f"<Points>{array('Float64', 'Points', points)}</Points><Cells>{array('Int32', 'connectivity', cells)}"
        f"{array('Int32', 'offsets', 8 * np.arange(1, len(cells) + 1))}{array('UInt8', 'types', np.full(len(cells), 12))}</Cells>"
        "</Piece></UnstructuredGrid></VTKFile>"
    )


def test_command(tmp_path: Path) -> None:
    points, cells, _ = noisy(6, 0.22, 6)
    source, target = tmp_path / "in.vtu", tmp_path / "out.vtu"
    source.write_text(text_vtu(points, cells))
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
    assert python("--version").stdout == f"{hexlens.__version__}\n"
    assert "required" in python("repair", str(source)).stderr
    missing = python("repair", str(source), "-o", str(target), "--step", "2")
    assert (missing.returncode, missing.stderr) == (2, "hexlens: in.vtu: it has one time step, and step 2 was asked for.\n")


@pytest.mark.node
def test_command_is_that_of_node(tmp_path: Path) -> None:
    points, cells, _ = noisy(5, 0.25, 11)
    source = tmp_path / "in.vtu"
    source.write_text(text_vtu(points, mirrored(cells, np.array([3, 40]))))
    for options in (["--reorder"], ["--slide", "--free-boundary", "0.1"]):
        said = []
        for command in (python, node):
            own = tmp_path / command.__name__
            own.mkdir(exist_ok=True)
            words = ["repair", str(source), "-o", "out.vtu", "--min-relative", "0.6", "--certificates", "proofs.json", *options]
            done = command(*words, cwd=own)
            order = next(line for line in done.stdout.splitlines() if "mirrored" in line and "Repaired" not in line)
            said.append((done.returncode, order.split(";")[0], next(line for line in done.stdout.splitlines() if "Repaired" in line)))
        assert said[0] == said[1]
        assert said[0][0] == 1
        proofs = [(tmp_path / command.__name__ / "proofs.json").read_text() for command in (python, node)]
        assert proofs[0] == proofs[1]
        entries = json.loads(proofs[0])
        assert len(entries) > 10
        hexlens.verify(entries[:2])
    checks = [python("check", "--json", "out.vtu", cwd=tmp_path / command.__name__).stdout for command in (python, node)]
    assert checks[0] == checks[1]
