"""Meshes in pieces on a LocalCluster: what the pieces come to is what one check of all says, and nothing that ends in the middle loses
or doubles a cell."""

import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from conftest import write_vtu

import hexlens

distributed = pytest.importorskip("distributed")
dask = pytest.importorskip("dask")
array = pytest.importorskip("dask.array")
import hexlens.dask as in_pieces  # noqa: E402

IS_WHOLE = bool(os.environ.get("HEXLENS_ALL"))
#: Cells along the axes of a piece: 40 of these are 20 million cells, or 160,000.
SIDES = (100, 100, 50) if IS_WHOLE else (20, 20, 10)
PIECES = 40
#: A run that hangs is ended.
DEADLINE_S = 300
DAMAGED, INTERRUPTED = 7, 10
#: Pieces from here on wait until the run has been ended.
FIRST_LATE = 25


def box(sides: tuple[int, int, int], seed: int) -> tuple[np.ndarray, np.ndarray]:
    """Cells that share points, moved so far that some are invalid."""
    counts = [side + 1 for side in sides]
    points = np.stack(np.meshgrid(*[np.arange(float(count)) for count in counts], indexing="ij"), axis=-1)
    points += np.random.default_rng(seed).uniform(-0.3, 0.3, points.shape)
    places = np.meshgrid(*[np.arange(side) for side in sides], indexing="ij")
    corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    cells = [np.ravel_multi_index([place + step for place, step in zip(places, corner, strict=True)], counts) for corner in corners]
    return points.reshape(-1, 3), np.stack(cells, axis=-1).reshape(-1, 8).astype(np.int32)


def joined(meshes: list[tuple[np.ndarray, np.ndarray]]) -> tuple[np.ndarray, np.ndarray]:
    starts = np.cumsum([0, *(len(points) for points, _ in meshes)])
    cells = [cells + start for (_, cells), start in zip(meshes, starts[:-1], strict=True)]
    return np.concatenate([points for points, _ in meshes]), np.concatenate(cells)


def expect_same(own: dict, whole: hexlens.MeshCheck, sizes: list[int], names: list[str]) -> None:
    """The pieces' result is that of the whole: counts, histogram, and the worst cells with where they are."""
    for name in ("hexahedra", "valid", "invalid", "unanswered", "degenerate", "below"):
        assert own[name] == getattr(whole, name), name
    assert own["histogram"] == whole.histogram().tolist()
    starts = np.cumsum([0, *sizes])
    expected = []
    for cell in whole.worst:
        piece = int(np.searchsorted(starts, cell.index, side="right")) - 1
        expected.append({"piece": names[piece], **cell.to_dict(), "index": cell.index - int(starts[piece])})
    assert own["worst"] == expected


@pytest.fixture(scope="module")
def client() -> Iterator[object]:
    """Workers are threads of this process here: it is quicker."""
    with (
        distributed.LocalCluster(n_workers=2, threads_per_worker=2, processes=False, dashboard_address=":0") as cluster,
        cluster.get_client() as client,
    ):
        yield client


@pytest.fixture
def meshes() -> list[tuple[np.ndarray, np.ndarray]]:
    return [box((6, 5, 4), seed) for seed in range(5)]


@pytest.fixture
def files(tmp_path: Path, meshes: list[tuple[np.ndarray, np.ndarray]]) -> list[str]:
    folder = tmp_path / "pieces"
    folder.mkdir()
    # piece-10 comes behind piece-2.
    paths = [str(folder / f"piece-{number}.vtu") for number in (1, 2, 3, 10, 11)]
    for path, mesh in zip(paths, meshes, strict=True):
        write_vtu(Path(path), *mesh)
    return paths


class Run:
    """pieces_run.py, with its workers, in a process group of its own."""

    def __init__(self, *words: Path) -> None:
        command = [sys.executable, str(Path(__file__).with_name("pieces_run.py")), *map(str, words)]
        self.deadline = time.monotonic() + DEADLINE_S
        self.process = subprocess.Popen(command, start_new_session=True, stderr=subprocess.PIPE, encoding="utf-8")

    def expect(self, what: str, is_so: object) -> None:
        """Waits for it, as long as the run goes on."""
        while not is_so():  # type: ignore[operator]
            assert time.monotonic() < self.deadline, f"It is too late for this: {what}."
            assert self.process.poll() is None, f"It ended before {what}: {self.process.communicate()[1]}"
            time.sleep(0.005)

    def end(self) -> None:
        os.killpg(self.process.pid, signal.SIGKILL)
        self.process.wait()

    def result(self, watch: Path) -> dict:
        try:
            _, errors = self.process.communicate(timeout=DEADLINE_S)
        except subprocess.TimeoutExpired:
            self.end()
            raise
        assert self.process.returncode == 0, errors
        return json.loads((watch / "result.json").read_text())


def is_alive(pid: int) -> bool:
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    return True


def test_nothing_is_lost_and_nothing_counted_twice(tmp_path: Path) -> None:
    """One piece is damaged, a worker is ended by SIGKILL with a piece in hand, then the whole run; it is started again."""
    folder, record, watch = tmp_path / "pieces", tmp_path / "record", tmp_path / "watch"
    folder.mkdir(), watch.mkdir()
    meshes = [box(SIDES, seed) for seed in range(PIECES)]
    paths = [folder / f"piece-{number:02}.vtu" for number in range(PIECES)]
    for path, mesh in zip(paths, meshes, strict=True):
        write_vtu(path, *mesh)
    os.truncate(paths[DAMAGED], os.path.getsize(paths[DAMAGED]) // 2)
    (watch / f"{paths[INTERRUPTED].stem}.gate").write_text("worker-ended")
    for path in paths[FIRST_LATE:]:
        (watch / f"{path.stem}.gate").write_text("run-ended")

    run = Run(folder, record, watch)
    try:
        holder = watch / f"{paths[INTERRUPTED].stem}.pid"
        # The worker that waits may have been handed another early piece, too.
        run.expect("the other early pieces were answered", lambda: len(list(record.glob("*.json"))) >= FIRST_LATE - 3)
        ended = int(holder.read_text())
        os.kill(ended, signal.SIGKILL)
        run.expect("the worker was ended", lambda: not is_alive(ended))
        (watch / "worker-ended").touch()
        run.expect("the piece was answered", lambda: len(list(record.glob("*.json"))) == FIRST_LATE - 1)
        assert int(holder.read_text()) != ended
    finally:
        run.end()
    assert not (watch / "result.json").exists()
    (watch / "run-ended").touch()

    again = Run(folder, record, watch).result(watch)
    assert again["exit"] == 2
    (failed,) = (piece for piece in again["pieces"] if piece["error"] is not None)
    assert failed["name"] == str(paths[DAMAGED])
    assert "cut off" in failed["error"]
    assert [piece["is_from_record"] for piece in again["pieces"]] == [
        number < FIRST_LATE and number != DAMAGED for number in range(PIECES)
    ]
    left = [number for number in range(PIECES) if number != DAMAGED]
    whole = hexlens.check(joined([meshes[number] for number in left]))
    names = [str(paths[number]) for number in left]
    expect_same(again, whole, [len(meshes[number][1]) for number in left], names)
    assert again["hexahedra"] == (PIECES - 1) * int(np.prod(SIDES))
    piece_bytes = os.path.getsize(paths[0])
    print(f"\n{again['headline']} {again['seconds']:.2f} s for the pieces that were left; a worker grew by "
          f"{again['growth'] / piece_bytes:.1f} pieces of {piece_bytes / 1e6:.1f} MB")  # fmt: skip

    # A piece that was changed and one that was mended are asked again, and only these.
    write_vtu(paths[DAMAGED], *meshes[DAMAGED])
    meshes[3][0][0] = [2.5, 2.5, 2.5]
    write_vtu(paths[3], *meshes[3])
    last = Run(folder, record, watch).result(watch)
    assert [number for number, piece in enumerate(last["pieces"]) if not piece["is_from_record"]] == [3, DAMAGED]
    expect_same(last, hexlens.check(joined(meshes)), [len(cells) for _, cells in meshes], list(map(str, paths)))
    assert not list(record.glob("*.part"))
