"""Meshes in pieces, on the workers of a Dask cluster: `hexlens.dask.check`."""

import contextlib
import os
import re
import threading
import uuid
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from ._arrays import HexlensError, cells_of, elements_of, points_of
from ._check import MeshCheck, check_mesh
from ._mesh import Mesh
from ._outputs import FileResult, VtuOutput
from ._pieces import Answer, Options, Piece, PieceCell, PiecesCheck, Records, answer_of, written_file
from ._read_vtu import sources_of
from ._sources import mesh_of, read_file

try:
    import dask
    import distributed
except ImportError:
    raise ImportError("hexlens.dask needs Dask: pip install 'hexlens[dask]'.") from None

__all__ = ["Piece", "PieceCell", "PiecesCheck", "check"]

#: Files of a folder: a .pvtu there names others of them.
_FILES: Final = (".vtu", ".vtu.gz", ".vtk")
#: Pieces that a worker looks at in one task to see whether they are as they were: a millisecond each on a slow disk.
_LOOKED_AT: Final = 200


@dataclass(frozen=True)
class _Source:
    """A piece, as it can be read by a worker."""

    #: For people.
    name: str
    #: For records: the same in every run.
    key: str
    #: An absolute path; None where `task` makes the answer.
    path: str | None
    #: The delayed answer; it is given what `needs` comes to.
    task: Callable[["_Question", Any], Any] | None = None
    #: Delayed, too: what has to be known before the task can be made.
    needs: Any = None


@dataclass(frozen=True)
class _Question:
    """What a worker is asked about a piece."""

    options: Options
    threads: int | None
    #: For the cell arrays.
    file: str | None


def check(
    pieces: Any,
    *,
    worst: int = 10,
    min_relative: float | None = None,
    skip_degenerate: bool = False,
    format: str | None = None,  # noqa: A002 - the command's word
    threads: int | None = None,
    annotate: str | os.PathLike[str] | None = None,
    record: str | os.PathLike[str] | None = None,
    client: Any = None,
) -> PiecesCheck:
    """Checks a mesh that is in pieces, each on one of Dask's workers: `hexlens.check` of each, and what they come to.

    pieces           paths, or one: files, a .pvtu, a folder of VTU and VTK files. Or dask.delayed meshes, of all kinds that
                     `hexlens.check` takes; a pair of dask arrays (points, cells); a dask array of n x 8 x 3 coordinates, whose
                     chunks are the pieces. Or a list of these
    worst            how many of the worst cells of all are listed
    min_relative, skip_degenerate, format
                     as in `hexlens.check`
    threads          of a piece; as many as the worker has without
    annotate         a folder that all workers share: for each piece a VTU with its hexahedra and their cell arrays
    record           a folder: what is answered is kept in it, and a run that was cut off goes on where it stopped
    client           the distributed.Client; the current one without

    A piece that fails is named in `failed`, and the others go on. HexlensError says what is wrong with the call itself.
    """
    if isinstance(worst, bool) or not isinstance(worst, int) or worst < 0:
        raise HexlensError(f"worst is {worst!r}; a whole number from 0 on is expected.")
    folder = None if annotate is None else os.path.abspath(os.fspath(annotate))
    options = Options(worst, min_relative, skip_degenerate, format, folder)
    sources = list(_sources(pieces))
    _refuse_twice(sources)
    if folder is not None:
        _refuse_overwriting(sources, folder)
    run = _Run(_client(client), options, threads, None if record is None else Records(os.fspath(record), options))
    return run.result(sources)


def _client(given: Any) -> Any:
    if given is not None:
        return given
    try:
        return distributed.get_client()
    except ValueError:
        raise HexlensError(
            "There is no Dask client: make one first, client = distributed.Client(n_workers=2, threads_per_worker=1)."
        ) from None


def _refuse_twice(sources: list[_Source]) -> None:
    seen = set()
    for source in sources:
        if source.key in seen:
            raise HexlensError(f"{source.name} is given twice: it would be counted twice.")
        seen.add(source.key)


def _refuse_overwriting(sources: list[_Source], folder: str) -> None:
    real = os.path.realpath(folder)
    for source in sources:
        if source.path is not None and os.path.dirname(os.path.realpath(source.path)) == real:
            raise HexlensError(f"{source.name} lies in the folder of `annotate`: name another, whose files are not taken for pieces.")


def _sources(pieces: Any, prefix: str = "") -> Iterator[_Source]:
    import dask.array

    if isinstance(pieces, (str, os.PathLike)):
        yield from _files(os.fspath(pieces))
    elif isinstance(pieces, dask.array.Array):
        yield from _element_chunks(pieces, prefix)
    elif isinstance(pieces, tuple) and len(pieces) == 2 and isinstance(pieces[1], dask.array.Array):
        yield from _cell_chunks(*pieces, prefix)
    elif dask.is_dask_collection(pieces):
        if not hasattr(pieces, "key"):
            raise HexlensError(f"A {type(pieces).__name__} is no mesh: a dask array or dask.delayed meshes are expected.")
        yield _Source(str(pieces.key), str(pieces.key), None, _task(_answer_object, pieces))
    elif isinstance(pieces, Iterable) and not isinstance(pieces, (bytes, dict, np.ndarray)):
        several = list(pieces)
        # Their chunks have the same numbers.
        for i, piece in enumerate(several):
            yield from _sources(piece, f"mesh {i}, " if len(several) > 1 else "")
    else:
        raise HexlensError(
            f"A {type(pieces).__name__} is none of: paths, dask.delayed meshes, a pair of dask arrays (points, cells), "
            "a dask array of n x 8 x 3 coordinates, a list of these."
        )


def _files(path: str) -> Iterator[_Source]:
    if os.path.isdir(path):
        found = sorted((name for name in os.listdir(path) if name.lower().endswith(_FILES)), key=_by_numbers)
        if not found:
            raise HexlensError(f"{path}: there is no VTU or VTK file in this folder.")
        paths = [os.path.join(path, name) for name in found]
    elif path.lower().endswith(".pvtu"):
        paths = sources_of(path)
    else:
        paths = [path]
    for name in paths:
        own = os.path.abspath(name)
        yield _Source(name, own, own)


def _by_numbers(name: str) -> list[tuple[int, str]]:
    """piece-2 before piece-10."""
    return [(int(part), "") if part.isdigit() else (-1, part) for part in re.split(r"(\d+)", name)]


def _task(function: Callable[..., Answer], *arguments: Any) -> Callable[[_Question, Any], Any]:
    return lambda question, _: dask.delayed(function, pure=False)(question, *arguments)


def _chunk_starts(array: Any, what: str, shape: str) -> list[int]:
    sizes = array.chunks[0]
    if any(np.isnan(size) for size in sizes):
        raise HexlensError(f"{what} have chunks of unknown sizes: call compute_chunk_sizes() first; {shape} is expected.")
    return [0, *np.cumsum(sizes).tolist()]


def _element_chunks(array: Any, prefix: str) -> Iterator[_Source]:
    if array.shape[1:] not in ((8, 3), (24,)):
        raise HexlensError(
            f"A dask array alone is n x 8 x 3 coordinates, eight points a hexahedron; this one has the shape {array.shape}. "
            "Points and cells are a pair (points, cells)."
        )
    starts = _chunk_starts(array, "The coordinates", "n x 8 x 3")
    blocks = array.rechunk(dict.fromkeys(range(1, array.ndim), -1)).to_delayed().ravel()
    for i, block in enumerate(blocks):
        name = _chunk_name(prefix, starts, i)
        yield _Source(name, str(block.key), None, _task(_answer_elements, block))


def _cell_chunks(points: Any, cells: Any, prefix: str) -> Iterator[_Source]:
    import dask.array

    if not isinstance(points, dask.array.Array):
        own = points_of(points)
        points = dask.array.from_array(own, chunks=(len(own), 3))
    if points.ndim != 2 or points.shape[1] != 3:
        raise HexlensError(f"The points have the shape {points.shape}; n x 3 is expected.")
    if cells.ndim != 2 or cells.shape[1] != 8:
        raise HexlensError(f"The cells have the shape {cells.shape}; n x 8 is expected, the points of each hexahedron.")
    starts = _chunk_starts(cells, "The cells", "n x 8")
    begins = np.array(_chunk_starts(points, "The points", "n x 3"))
    point_blocks = list(points.rechunk({1: -1}).to_delayed().ravel())

    def task_of(block: Any) -> Callable[[_Question, Any], Any]:
        def task(question: _Question, needed: list[int] | None) -> Any:
            chosen = range(len(point_blocks)) if needed is None else needed
            chunks = [point_blocks[i] for i in chosen]
            return dask.delayed(_answer_cells, pure=False)(question, block, chunks, list(chosen), begins)

        return task

    for i, block in enumerate(cells.rechunk({1: -1}).to_delayed().ravel()):
        # A task waits for no chunks of points but those that its cells name.
        needs = dask.delayed(_needed_chunks, pure=False)(block, begins) if len(point_blocks) > 1 else None
        yield _Source(_chunk_name(prefix, starts, i), f"{points.name} {block.key}", None, task_of(block), needs)


def _chunk_name(prefix: str, starts: list[int], i: int) -> str:
    return f"{prefix}cells {starts[i]} to {starts[i + 1] - 1}"


class _Run:
    """One call of `check`."""

    def __init__(self, client: Any, options: Options, threads: int | None, records: Records | None) -> None:
        self._client, self._options, self._threads, self._records = client, options, threads, records

    def result(self, sources: list[_Source]) -> PiecesCheck:
        kept = self._kept(sources)
        found = {**kept, **self._answers([source for source in sources if source.key not in kept])}
        if self._options.annotate is not None:
            _remove_partial(self._options.annotate, sources)
        return PiecesCheck([(source.name, found[source.key], source.key in kept) for source in sources], self._options)

    def _kept(self, sources: list[_Source]) -> dict[str, Answer]:
        """Answers of earlier runs to pieces that are still the same, by their keys."""
        if self._records is None:
            return {}
        known = [(source, record) for source in sources if (record := self._records.find(source.key)) is not None]
        looks = [(source.path, record["identity"], record["answer"].get("annotated")) for source, record in known]
        groups = [looks[begin : begin + _LOOKED_AT] for begin in range(0, len(looks), _LOOKED_AT)]
        # A worker looks: the piece may lie where this process sees nothing.
        are_same = [same for group in self._client.gather(self._client.map(_are_same, groups, pure=False)) for same in group]
        return {source.key: record["answer"] for (source, record), is_same in zip(known, are_same, strict=True) if is_same}

    def _answers(self, sources: list[_Source]) -> dict[str, Answer]:
        found, ended = self._round(sources)
        # Whatever else a worker had when it ended is suspected, too: alone it is clear which piece ends workers.
        for source in ended:
            answers, is_guilty = self._round([source])
            found.update({source.key: {"error": _ENDED}} if is_guilty else answers)
        return found

    def _round(self, sources: list[_Source]) -> tuple[dict[str, Answer], list[_Source]]:
        """The answers by the pieces' keys, and the pieces with which workers ended again and again."""
        found: dict[str, Answer] = {}
        ended: list[_Source] = []
        # Futures that have not come, each with its piece; and of these the ones that only say what a piece needs.
        open_: dict[Any, _Source] = {}
        preparing = set()
        for source in sources:
            future = self._begun(source)
            open_[future] = source
            if source.needs is not None:
                preparing.add(future)
        # With results: one that was lost with its worker, and is computed again, holds up no other.
        arriving = distributed.as_completed(list(open_), with_results=True, raise_errors=False)
        try:
            for future, result in arriving:
                source = open_.pop(future)
                error = _error_of(future)
                if isinstance(error, distributed.KilledWorker):
                    ended.append(source)
                elif error is not None:
                    found[source.key] = {"error": _sentence(error)}
                elif future in preparing:
                    following = self._asked(source, result)
                    open_[following] = source
                    arriving.add(following)
                else:
                    found[source.key] = self._kept_answer(source, result)
                # The scheduler forgets what failed, too, so that it can be asked again.
                future.release()
        finally:
            self._client.cancel(list(open_))
        return found, ended

    def _kept_answer(self, source: _Source, answer: Answer) -> Answer:
        identity = answer.pop("identity", None)
        if self._records is not None and "error" not in answer:
            self._records.keep(source.key, identity, answer)
        return answer

    def _begun(self, source: _Source) -> Any:
        return self._asked(source, None) if source.needs is None else self._client.compute(source.needs)

    def _asked(self, source: _Source, needed: Any) -> Any:
        question = self._question(source)
        if source.task is None:
            return self._client.submit(_answer_path, question, source.path, pure=False)
        return self._client.compute(source.task(question, needed))

    def _question(self, source: _Source) -> _Question:
        folder = self._options.annotate
        return _Question(self._options, self._threads, None if folder is None else written_file(folder, source.key))


_ENDED: Final = "Each worker that had it ended, again and again: it may need more memory than a worker has."


def _error_of(future: Any) -> BaseException | None:
    """None if there is an answer. HexlensError if nobody is left to give it."""
    if future.status == "finished":
        return None
    if future.status != "error":
        raise HexlensError("The run was cancelled, or the scheduler is lost. What is in the record is not asked again.")
    error: BaseException = future.exception()
    return error


def _sentence(error: BaseException) -> str:
    if isinstance(error, HexlensError):
        return str(error)
    if isinstance(error, MemoryError):
        return "It needs more memory than the worker has."
    return f"{type(error).__name__}: {error}"


def _remove_partial(folder: str, sources: list[_Source]) -> None:
    """What workers were writing when they ended: now none is."""
    with contextlib.suppress(OSError):
        ours = {os.path.basename(written_file(folder, source.key)) for source in sources}
        for name in os.listdir(folder):
            if name.endswith(_PARTIAL) and name.removesuffix(_PARTIAL).rsplit(".", 1)[0] in ours:
                os.unlink(os.path.join(folder, name))


# From here on: what runs on a worker.

_PARTIAL: Final = ".part"
#: A worker of several threads has one piece in its memory all the same, and all threads are that piece's.
_ONE_PIECE: Final = threading.Lock()


def _are_same(looks: list[tuple[str | None, Any, list[Any] | None]]) -> list[bool]:
    """Whether each path is the file that it was, and whether what was written of it is there."""

    def is_same(path: str | None, identity: Any, annotated: list[Any] | None) -> bool:
        try:
            return (path is None or _identity(path) == identity) and (annotated is None or os.path.getsize(annotated[0]) == annotated[1])
        except OSError:
            return False

    return [is_same(*look) for look in looks]


def _identity(path: str) -> list[int]:
    """A file that was written again has another size or time."""
    status = os.stat(path)
    return [status.st_size, status.st_mtime_ns]


def _answer_path(question: _Question, path: str) -> Answer:
    def answer() -> Answer:
        before = _identity(path) if os.path.exists(path) else None
        own = _answer(question, read_file(path, question.options.format), path)
        if _identity(path) != before:
            raise HexlensError("It was changed while it was read.")
        return {**own, "identity": before}

    return _caught(answer)


def _answer_object(question: _Question, mesh: Any) -> Answer:
    return _caught(lambda: _answer(question, mesh_of(mesh), "mesh"))


def _answer_elements(question: _Question, coordinates: NDArray[Any]) -> Answer:
    def answer() -> Answer:
        own = elements_of(coordinates)
        index = np.int32 if 8 * len(own) < 2**31 else np.int64
        return _answer(question, Mesh("arrays", own.reshape(-1, 3), np.arange(8 * len(own), dtype=index).reshape(-1, 8)), "arrays")

    return _caught(answer)


def _needed_chunks(cells: NDArray[Any], begins: NDArray[np.int64]) -> list[int]:
    """The chunks of points that cells name; `begins` are the chunks' first points, and the number of all."""
    own = cells_of(cells)
    named = own[(own >= 0) & (own < begins[-1])]
    found: list[int] = np.unique(np.searchsorted(begins, named, side="right") - 1).tolist()
    return found


def _answer_cells(
    question: _Question, cells: NDArray[Any], chunks: list[NDArray[Any]], numbers: list[int], begins: NDArray[np.int64]
) -> Answer:
    """Of cells that name points of all chunks, with those chunks that they name."""

    def answer() -> Answer:
        own = cells_of(cells)
        if len(begins) == 2:
            return _answer(question, Mesh("arrays", points_of(chunks[0]), own), "arrays")
        points = [points_of(chunk) for chunk in chunks]
        # From where a point is among all to where it is among these.
        moved = np.zeros(len(begins), np.int64)
        starts = np.cumsum([0, *map(len, points)])[:-1]
        moved[numbers] = starts - begins[numbers]
        # An index that is no point's stays what it is: there are no more points here than in all.
        is_point = (own >= 0) & (own < begins[-1])
        local = own.astype(np.int64)
        local[is_point] += moved[np.searchsorted(begins, local[is_point], side="right") - 1]
        return _answer(question, Mesh("arrays", np.concatenate(points) if points else np.empty((0, 3)), local), "arrays")

    return _caught(answer)


def _caught(work: Callable[[], Answer]) -> Answer:
    try:
        with _ONE_PIECE:
            return work()
    except Exception as error:
        return {"error": _sentence(error)}


def _answer(question: _Question, mesh: Mesh, name: str) -> Answer:
    options = question.options
    threads = question.threads
    if threads is None:
        threads = int(distributed.get_worker().state.nthreads)
    result = check_mesh(
        mesh,
        name,
        worst=options.worst,
        min_relative=options.min_relative,
        skip_degenerate=options.skip_degenerate,
        threads=threads,
    )
    answer = answer_of(result)
    if question.file is not None:
        answer["annotated"] = [question.file, _write(question.file, result)]
    return answer


def _write(file: str, result: MeshCheck) -> int:
    """The size of the file, which is there whole or not at all."""
    partial = f"{file}.{uuid.uuid4().hex}{_PARTIAL}"
    try:
        os.makedirs(os.path.dirname(file), exist_ok=True)
        with open(partial, "wb") as target:
            for chunk in VtuOutput().file(FileResult(result.file, 0, result)):
                target.write(chunk)
        size = os.path.getsize(partial)
        os.replace(partial, file)
    except OSError as error:
        with contextlib.suppress(OSError):
            os.unlink(partial)
        raise HexlensError(f"{file} cannot be written: {(error.strerror or str(error)).lower()}.") from None
    return size
