"""Meshes in pieces on a LocalCluster: what the pieces come to is what one check of all says, and nothing that ends in the middle loses
or doubles a cell."""

import itertools
import json
import os
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace

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
DEADLINE_S = 600
DAMAGED, INTERRUPTED = 7, 10
#: Pieces from here on wait until the run has been ended.
FIRST_LATE = 30


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


def holders(watch: Path, piece: int | None = None) -> set[int]:
    """The workers that have had a piece in hand, this one or any."""
    texts = [path.read_text() for path in watch.glob("*.pid" if piece is None else f"piece-{piece:02}.pid")]
    return {int(text) for text in texts if text}


def answered(record: Path) -> int:
    return len(list(record.glob("*.json")))


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
        run.expect("a worker had the piece, and others were answered", lambda: holders(watch, INTERRUPTED) and answered(record) >= 20)
        (ended,) = holders(watch, INTERRUPTED)
        before = holders(watch) | {ended}
        os.kill(ended, signal.SIGKILL)
        run.expect("the worker was ended", lambda: not is_alive(ended))
        (watch / "worker-ended").touch()
        run.expect("a new worker had a piece", lambda: holders(watch) - before)
    finally:
        run.end()
    assert not (watch / "result.json").exists()
    kept = answered(record)
    assert 20 <= kept < FIRST_LATE
    (watch / "run-ended").touch()

    again = Run(folder, record, watch).result(watch)
    assert again["exit"] == 2
    (failed,) = (piece for piece in again["pieces"] if piece["error"] is not None)
    assert failed["name"] == str(paths[DAMAGED])
    assert "cut off" in failed["error"]
    assert sum(piece["is_from_record"] for piece in again["pieces"]) == kept
    assert answered(record) == PIECES - 1
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


def names_of(sizes: list[int]) -> list[str]:
    starts = np.cumsum([0, *sizes]).tolist()
    return [f"cells {begin} to {end - 1}" for begin, end in itertools.pairwise(starts)]


def test_files_come_as_a_folder_a_list_or_a_pvtu(client: object, files: list[str], meshes: list, tmp_path: Path) -> None:
    whole = hexlens.check(joined(meshes), worst=17)
    sizes = [len(cells) for _, cells in meshes]
    folder = Path(files[0]).parent
    sources = "".join(f'<Piece Source="pieces/{Path(file).name}"/>' for file in files)
    parallel = tmp_path / "all.pvtu"
    parallel.write_text(f'<VTKFile type="PUnstructuredGrid"><PUnstructuredGrid>{sources}</PUnstructuredGrid></VTKFile>')
    for pieces in (str(folder), folder, files, (Path(file) for file in files), str(parallel)):
        result = hexlens.dask.check(pieces, worst=17)
        assert result.exit == whole.exit == 1
        expect_same(result.to_dict(), whole, sizes, files)
        assert len(result.worst) == 17
        assert result.worst[0].lens is not None
        assert result.headline() == whole.headline()


def test_a_file_without_a_folder_and_an_empty_folder_end_in_a_sentence(client: object, tmp_path: Path) -> None:
    result = hexlens.dask.check([tmp_path / "missing.vtu"])
    assert [(piece.name, piece.error) for piece in result.failed] == [
        (str(tmp_path / "missing.vtu"), "missing.vtu cannot be read: it is not there.")
    ]
    assert result.exit == 2
    assert result.headline() == "no hexahedra of eight nodes. 1 of 1 piece failed."
    with pytest.raises(hexlens.HexlensError, match="there is no VTU or VTK file in this folder"):
        hexlens.dask.check(tmp_path)
    with pytest.raises(hexlens.HexlensError, match=r"missing\.pvtu cannot be read"):
        hexlens.dask.check(tmp_path / "missing.pvtu")


def test_delayed_meshes_are_made_by_workers(client: object, meshes: list) -> None:
    @dask.delayed(pure=True)
    def mesh_of(seed: int) -> tuple[np.ndarray, np.ndarray]:
        if seed == 2:
            raise OSError("the disk is gone")
        return box((6, 5, 4), seed)

    pieces = [mesh_of(seed) for seed in range(5)]
    result = hexlens.dask.check(pieces)
    assert [(piece.name, piece.error) for piece in result.failed] == [(pieces[2].key, "OSError: the disk is gone")]
    left = [number for number in range(5) if number != 2]
    whole = hexlens.check(joined([meshes[number] for number in left]))
    expect_same(result.to_dict(), whole, [120] * 4, [pieces[number].key for number in left])
    assert pieces[2].key in result._repr_html_()


def test_what_is_no_mesh_is_named(client: object) -> None:
    pieces = [dask.delayed(lambda: "text.stl", pure=True)(), dask.delayed(lambda: np.zeros((3, 2)), pure=True)()]
    first, second = hexlens.dask.check(pieces).pieces
    assert "is not there" in str(first.error)
    assert "A ndarray is none of" in str(second.error)


@pytest.mark.parametrize("point_chunk", [10**6, 37])
def test_points_and_cells_in_chunks(client: object, meshes: list, point_chunk: int) -> None:
    points, cells = joined(meshes)
    cells = np.random.default_rng(3).permutation(cells).astype(np.int64)
    cells[5, 3], cells[444, 0] = len(points), -1
    whole = hexlens.check((points, cells), worst=600)
    assert whole.unanswered == 2
    sizes = [250, 250, 100]
    pair = (array.from_array(points, chunks=(point_chunk, 2)), array.from_array(cells, chunks=(250, 3)))
    expect_same(hexlens.dask.check(pair, worst=600).to_dict(), whole, sizes, names_of(sizes))
    mapped = hexlens.dask.check((points, pair[1]), worst=600)
    expect_same(mapped.to_dict(), whole, sizes, names_of(sizes))


def test_chunks_of_coordinates(client: object, meshes: list) -> None:
    points, cells = joined(meshes)
    coordinates = array.from_array(points[cells], chunks=(250, 8, 3))
    whole = hexlens.check((points, cells))
    sizes = [250, 250, 100]
    expect_same(hexlens.dask.check(coordinates).to_dict(), whole, sizes, names_of(sizes))
    expect_same(hexlens.dask.check(coordinates.reshape(-1, 24)).to_dict(), whole, sizes, names_of(sizes))


def test_cell_arrays_are_written_piece_by_piece(client: object, files: list[str], tmp_path: Path) -> None:
    pyvista = pytest.importorskip("pyvista")
    folder, record = tmp_path / "annotated", tmp_path / "record"
    folder.mkdir()
    result = hexlens.dask.check(files, annotate=folder, record=record)
    assert len(os.listdir(folder)) == len(files)
    for piece in result.pieces:
        own = hexlens.check(piece.name)
        grid = pyvista.read(piece.annotated)
        for name, values in own.arrays().items():
            assert np.array_equal(grid.cell_data[name], values), name
    # The second run writes what is missing, and takes away what a worker left in the middle.
    removed = result.pieces[2].annotated
    os.unlink(removed)
    Path(f"{removed}.0123.part").touch()
    again = hexlens.dask.check(files, annotate=folder, record=record)
    assert [piece.is_from_record for piece in again.pieces] == [True, True, False, True, True]
    assert sorted(os.listdir(folder)) == sorted(os.path.basename(str(piece.annotated)) for piece in result.pieces)
    with pytest.raises(hexlens.HexlensError, match="lies in the folder of `annotate`"):
        hexlens.dask.check(files, annotate=Path(files[0]).parent)


def test_a_record_is_of_the_piece_and_the_question(client: object, files: list[str], tmp_path: Path) -> None:
    record = tmp_path / "record"

    def from_record(**options: object) -> list[bool]:
        return [piece.is_from_record for piece in hexlens.dask.check(files, record=record, **options).pieces]

    assert not any(from_record())
    assert all(from_record())
    assert not any(from_record(min_relative=0.2))
    assert not any(from_record(worst=3))
    assert all(from_record(threads=1))
    # The same bytes at another time; others of the same size; a record that was damaged, and one that is another's.
    os.utime(files[0], ns=(1, 1))
    write_vtu(Path(files[1]), *box((6, 5, 4), 77))
    assert from_record() == [False, False, True, True, True]
    for path in record.glob("*.json"):
        path.write_bytes(path.read_bytes()[:-1])
    assert not any(from_record())
    shutil.rmtree(record)
    from_record()
    one, other, *_ = record.glob("*.json")
    other.write_bytes(one.read_bytes())
    assert sum(from_record()) == len(files) - 1
    delayed = [dask.delayed(box, pure=True)((6, 5, 4), seed) for seed in range(2)]
    assert not any(piece.is_from_record for piece in hexlens.dask.check(delayed, record=record).pieces)
    assert all(piece.is_from_record for piece in hexlens.dask.check(delayed, record=record).pieces)


def test_a_file_that_changes_while_it_is_read_fails(client: object, files: list[str], monkeypatch: pytest.MonkeyPatch) -> None:
    read = in_pieces.read_file

    def read_and_touch(path: str, format_: str | None) -> object:
        mesh = read(path, format_)
        if path == files[3]:
            os.utime(path, ns=(1, 1))
        return mesh

    monkeypatch.setattr(in_pieces, "read_file", read_and_touch)
    (failed,) = hexlens.dask.check(files).failed
    assert (failed.name, failed.error) == (files[3], "It was changed while it was read.")


def test_wrong_calls_end_in_a_sentence(client: object, files: list[str], meshes: list) -> None:
    points, cells = meshes[0]
    wrong: list[tuple[object, dict, str]] = [
        ([files[0], files[0]], {}, "is given twice"),
        (7, {}, "A int is none of: paths"),
        ((array.from_array(points[:, :2]), array.from_array(cells)), {}, r"shape \(210, 2\)"),
        ((array.from_array(points), array.from_array(cells[:, :4])), {}, r"shape \(120, 4\)"),
        (array.from_array(points), {}, "Points and cells are a pair"),
        (files, {"worst": -1}, "worst is -1"),
        (files, {"worst": None}, "worst is None"),
        (files, {"record": files[0]}, "cannot hold records"),
    ]
    for pieces, options, sentence in wrong:
        with pytest.raises(hexlens.HexlensError, match=sentence):
            hexlens.dask.check(pieces, **options)


def test_without_a_client_a_sentence_says_what_to_do(files: list[str], tmp_path: Path) -> None:
    program = f"import hexlens.dask\ntry: hexlens.dask.check({files!r})\nexcept hexlens.HexlensError as error: print(error)"
    done = subprocess.run([sys.executable, "-c", program], cwd=tmp_path, capture_output=True, encoding="utf-8", check=True)
    assert done.stdout.startswith("There is no Dask client: make one first")


def test_without_dask_a_sentence_says_what_to_do(tmp_path: Path) -> None:
    program = "import sys; sys.modules['dask'] = None; import hexlens.dask"
    done = subprocess.run([sys.executable, "-c", program], cwd=tmp_path, capture_output=True, encoding="utf-8", check=False)
    assert done.stderr.endswith("ImportError: hexlens.dask needs Dask: pip install 'hexlens[dask]'.\n")


def test_a_piece_that_ends_its_workers_is_named_and_no_other(client: object, files: list[str], tmp_path: Path) -> None:
    """Dask says it so of all that its workers had when they ended: whatever is asked again alone shows which piece it is."""

    @dask.delayed(pure=True)
    def ends_workers(name: str, times: int) -> str:
        asked = tmp_path / Path(name).stem
        with open(asked, "a") as file:
            file.write("x")
        if asked.stat().st_size <= times:
            raise distributed.KilledWorker(name, SimpleNamespace(address="gone"), 3)
        return name

    pieces = [*files[:2], ends_workers(files[2], 9), ends_workers(files[3], 1), files[4]]
    result = hexlens.dask.check(pieces)
    assert [piece.name for piece in result.failed] == [pieces[2].key]
    assert "it may need more memory than a worker has" in str(result.failed[0].error)
    assert [(tmp_path / Path(name).stem).stat().st_size for name in files[2:4]] == [2, 2]
    assert result.hexahedra == 4 * 120


def test_ghosts_are_said(tmp_path: Path, meshes: list) -> None:
    points, cells = meshes[0]
    path = tmp_path / "ghosts.vtu"
    write_vtu(path, points, cells, ghosts=np.arange(len(cells)) < 7)
    (note,) = hexlens.check(path).notes
    assert note == "7 cells are ghosts, copies of cells of another piece; they are counted in both."
