"""Many hexahedra at once: hl_classify over pieces of cells, on all cores."""

import os
import threading as _threading
from collections.abc import Callable, Sequence
from ctypes import byref
from typing import TYPE_CHECKING, Any, Final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import HexlensError, cells_of, elements_of, is_32_bit, narrowed, points_of
from ._native import CHECKS, CLASSES, Batch, Cells, library

if TYPE_CHECKING:
    import pandas

__all__ = ["Classification", "classify", "sort_keys", "worst_first"]

#: The most cells that are handed over at once: 3 ms, beside which handing over is nothing.
PIECE = 131_072
#: The fewest, where there are many threads to share the work.
LEAST_PIECE = 8_192
#: Cells whose indices are narrowed at once: a megabyte, which a core's cache holds.
WIDE_PIECE = 32_768
#: hexlens.h: 3 MB of stack are enough for everything.
STACK = 8 * 2**20

_TYPES: Final[dict[str, tuple[Any, int]]] = {
    "verdicts": (np.uint8, 1),
    "statuses": (np.uint8, 1),
    "is_exact": (np.uint8, 1),
    "classes": (np.uint8, 1),
    "accepted_by": (np.uint16, 1),
    "minima": (np.float64, 1),
    "minimizers": (np.float64, 3),
    "exponents": (np.int16, 1),
    "relative_minima": (np.float64, 1),
    "volumes": (np.float64, 1),
    "volume_exponents": (np.int16, 1),
}
#: Lists that are computed together when one of them is first looked at.
_TOGETHER: Final = (
    ("classes",),
    ("accepted_by",),
    ("minima", "minimizers", "exponents", "is_exact", "classes"),
    ("relative_minima", "volumes", "volume_exponents"),
)

_Lists = dict[str, NDArray[Any]]


class Classification:
    """The answers for many cells: arrays with one entry a cell, in the order of the cells.

    What `classify` was not asked for is computed when it is first looked at, from the same points and cells, which must be the
    same until then; RuntimeError if they are seen to have changed.
    """

    def __init__(
        self,
        points: NDArray[np.float64],
        cells: NDArray[Any] | None,
        threads: int | None,
        groups: Sequence[Sequence[str]],
    ) -> None:
        self._points, self._cells, self._threads = points, cells, threads
        self._lists, counts = self._run(("verdicts", "statuses", *(name for group in groups for name in group)))
        #: Counts of cells.
        self.valid_count, self.invalid_count = (sum(own) for own in zip((0, 0), *counts, strict=True))
        #: Cells that are none: `status` says why.
        self.unanswered_count = len(self) - self.valid_count - self.invalid_count

    def __len__(self) -> int:
        return len(self._lists["verdicts"])

    def __repr__(self) -> str:
        count = f"{len(self)} {'hexahedron' if len(self) == 1 else 'hexahedra'}"
        open_ = f", {self.unanswered_count} unanswered" if self.unanswered_count else ""
        return f"<Classification: {count}, {self.invalid_count} invalid, {self.valid_count} valid{open_}>"

    @property
    def valid(self) -> NDArray[np.bool_]:
        """Whether jacdet > 0 in the whole cell: certain. False, too, where a cell is unanswered."""
        verdicts: NDArray[np.uint8] = self._lists["verdicts"]
        return np.equal(verdicts, 1)

    @property
    def status(self) -> NDArray[np.uint8]:
        """0, or why a cell is unanswered: 1, a coordinate is not finite; 4, it names a point that does not exist."""
        return self._lists["statuses"]

    @property
    def boundary_min(self) -> NDArray[np.float64]:
        """The least jacdet on the boundary; NaN where a cell is unanswered.

        What is beyond the doubles is an infinity or 0: `boundary_min_parts` has it whole, `valid` its sign.
        """
        return _scaled(*self.boundary_min_parts)

    @property
    def boundary_min_parts(self) -> tuple[NDArray[np.float64], NDArray[np.int16]]:
        """Numbers and exponents: the least jacdet is a number times 2 to the exponent, which is 0 where that is a normal double."""
        return self._list("minima"), self._list("exponents")

    @property
    def minimizer(self) -> NDArray[np.float64]:
        """Where the least jacdet is attained, n x 3: xi, eta, zeta in [0, 1]."""
        return self._list("minimizers").reshape(-1, 3)

    @property
    def relative_min(self) -> NDArray[np.float64]:
        """The least jacdet over |volume|, at most 1; NaN where the volume is 0. The number to sort a mesh by."""
        return self._list("relative_minima")

    @property
    def volume(self) -> NDArray[np.float64]:
        """The mean of jacdet, rounded once; an infinity or 0 where it is beyond the doubles, as `volume_parts` is not."""
        return _scaled(*self.volume_parts)

    @property
    def volume_parts(self) -> tuple[NDArray[np.float64], NDArray[np.int16]]:
        """Numbers and exponents, as in `boundary_min_parts`."""
        return self._list("volumes"), self._list("volume_exponents")

    @property
    def class_(self) -> NDArray[np.uint8]:
        """Places in `hexlens.CLASSES`: unanswered, valid, invalid, inverted (jacdet < 0 everywhere), collapsed (= 0 everywhere)."""
        return self._list("classes")

    @property
    def accepted_by(self) -> NDArray[np.uint16]:
        """Bit 1 << c for the check `hexlens.CHECKS[c]` of other programs that takes the cell for valid."""
        return self._list("accepted_by")

    @property
    def exact(self) -> NDArray[np.bool_]:
        """True where doubles left the minimum open and integers decided."""
        return self._list("is_exact").view(np.bool_)

    def worst(self, n: int | None = 10) -> NDArray[np.int64]:
        """The indices of the worst `n` cells, worst first; None for all.

        First those of volume 0 with a negative minimum, then by rising relative minimum, collapsed cells among the zeros, ties by
        index; unanswered cells come last.
        """
        return worst_first(self.relative_min, self.class_, self.status != 0, n)

    def to_pandas(self) -> "pandas.DataFrame":
        """A table with a row for each cell, and a column for each answer; `accepted_by` is a column for each check."""
        import pandas

        categorical: Any = pandas.Categorical
        accepted = self.accepted_by
        table: pandas.DataFrame = pandas.DataFrame(
            {
                "valid": self.valid,
                "status": self.status,
                "class": categorical.from_codes(self.class_.astype(np.int8), list(CLASSES)),
                "boundary_min": self.boundary_min,
                "relative_min": self.relative_min,
                "volume": self.volume,
                **{name: self.minimizer[:, axis] for axis, name in enumerate(("xi", "eta", "zeta"))},
                "exact": self.exact,
                **{f"accepted by {name}": (accepted >> c) & 1 == 1 for c, name in enumerate(CHECKS)},
            }
        )
        return table

    def vertices(self, cell: int) -> NDArray[np.float64]:
        """The 8 x 3 coordinates of a cell; NaN for a point that does not exist."""
        chosen: NDArray[np.float64]
        if self._cells is None:
            chosen = self._points[cell]
            return chosen
        index = self._cells[cell].astype(np.int64)
        is_point = (index >= 0) & (index < len(self._points))
        chosen = np.full((8, 3), np.nan)
        chosen[is_point] = self._points[index[is_point]]
        return chosen

    def _list(self, name: str) -> NDArray[Any]:
        if name not in self._lists:
            group = next(names for names in _TOGETHER if name in names)
            lists, _ = self._run(("verdicts", *group))
            if not np.array_equal(lists["verdicts"], self._lists["verdicts"]):
                raise RuntimeError("The points or the cells have changed since they were classified.")
            self._lists = {**lists, **self._lists}
        return self._lists[name]

    def _run(self, names: Sequence[str]) -> tuple[_Lists, list[tuple[int, int]]]:
        """The lists, and how many are valid and invalid in each piece."""
        points, cells = self._points, self._cells
        count = len(points) if cells is None else len(cells)
        point_count = len(points)
        lists: _Lists = {name: np.empty(count * _TYPES[name][1], _TYPES[name][0]) for name in names}
        # Nothing but addition happens where the work is.
        addresses = [(name, array.ctypes.data, array.itemsize * _TYPES[name][1]) for name, array in lists.items()]
        coordinates = points.ctypes.data

        is_narrow = cells is None or is_32_bit(cells)
        counts: list[tuple[int, int]] = []

        def new_worker() -> Callable[[int, int], None]:
            room = np.empty((0 if is_narrow else min(WIDE_PIECE, count), 8), np.uint32)

            def decide(begin: int, end: int) -> None:
                if cells is None:
                    piece = Cells(coordinates + 192 * begin, 24 * (end - begin), None, 0)
                else:
                    indices = narrowed(cells[begin:end], point_count, room)
                    piece = Cells(coordinates, 3 * point_count, indices.ctypes.data, 8 * (end - begin))
                batch = Batch(**{name: address + size * begin for name, address, size in addresses})
                status = library.hl_classify(byref(piece), byref(batch))
                if status != 0:
                    raise AssertionError(f"hl_classify refuses lists that are whole: {status}")
                counts.append((batch.valid, batch.invalid))

            return decide

        _in_pieces(count, _thread_count(self._threads), PIECE if is_narrow else WIDE_PIECE, new_worker)
        return lists, counts


def classify(
    points: ArrayLike,
    cells: ArrayLike | None = None,
    *,
    minima: bool = False,
    checks: bool = False,
    threads: int | None = None,
) -> Classification:
    """Decides for many hexahedra whether jacdet > 0 everywhere, exactly.

    points     n x 3 coordinates; without cells n x 8 x 3, eight points a hexahedron
    cells      n x 8 indices of points, in VTK_HEXAHEDRON order
    minima     also the boundary minimum, its place, the class and who decided, in the same pass
    checks     also which checks of other programs accept the cell: 3 us a cell
    threads    at most so many; as many as there are cores without

    Doubles in C order and indices of 32 bits are read where they are; indices of 64 bits are checked and narrowed piece by piece,
    and other arrays copied. Python's lock is released. A cell that is none, for a coordinate is not finite or an index is not
    that of a point, has a status and does not stop the others. HexlensError for arrays of a wrong shape or type.
    """
    _thread_count(threads)
    if cells is None:
        own, indices = elements_of(points), None
    else:
        own, indices = points_of(points), cells_of(cells)
    groups = (_TOGETHER[2] if minima else (), _TOGETHER[1] if checks else ())
    return Classification(own, indices, threads, groups)


def worst_first(
    relative: NDArray[np.float64], classes: NDArray[np.uint8], is_unanswered: NDArray[np.bool_], n: int | None
) -> NDArray[np.int64]:
    """`Classification.worst`, of any lists."""
    if n is not None and n < 0:
        raise HexlensError(f"There are no {n} worst cells.")
    keys = sort_keys(relative, classes, is_unanswered)
    if n is None or n >= len(keys):
        return np.argsort(keys, kind="stable")
    if n == 0:
        return np.empty(0, np.int64)
    # All that are as bad as the n-th: ties go by index.
    bound = np.partition(keys, n - 1)[n - 1]
    few = np.flatnonzero(keys <= bound)
    worst: NDArray[np.int64] = few[np.argsort(keys[few], kind="stable")][:n]
    return worst


def sort_keys(relative: NDArray[np.float64], classes: NDArray[np.uint8], is_unanswered: NDArray[np.bool_]) -> NDArray[np.float64]:
    """Rising from the worst on: relative minima are above the least double, and nothing is above an infinity."""
    keys = np.where(np.isnan(relative), np.where(classes == CLASSES.index("collapsed"), 0.0, -np.inf), relative)
    keys[is_unanswered] = np.inf
    return keys


def _scaled(numbers: NDArray[np.float64], exponents: NDArray[np.int16]) -> NDArray[np.float64]:
    if not exponents.any():
        return numbers
    with np.errstate(over="ignore", under="ignore"):
        doubles: NDArray[np.float64] = np.ldexp(numbers, exponents)
        return doubles


def _thread_count(threads: int | None) -> int:
    if threads is None:
        return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    if isinstance(threads, bool) or not isinstance(threads, int) or threads < 1:
        raise HexlensError(f"threads is {threads!r}; a whole number from 1 on is expected.")
    return threads


def _in_pieces(count: int, threads: int, most: int, new_worker: Callable[[], Callable[[int, int], None]]) -> None:
    """Hands out pieces of 0 to `count`, of `most` or fewer cells, until all are done; the first error ends it."""
    piece = max(LEAST_PIECE, min(most, -(-count // (4 * threads))))
    begins = range(0, count, piece)
    if min(threads, len(begins)) <= 1:
        work = new_worker()
        for begin in begins:
            work(begin, min(begin + piece, count))
        return
    left = iter(begins)
    lock = _threading.Lock()
    errors: list[BaseException] = []

    def run() -> None:
        try:
            work = new_worker()
            while True:
                with lock:
                    begin = None if errors else next(left, None)
                if begin is None:
                    return
                work(begin, min(begin + piece, count))
        except BaseException as error:
            errors.append(error)

    before = _threading.stack_size(STACK)
    try:
        helpers = [_threading.Thread(target=run) for _ in range(min(threads, len(begins)))]
        for helper in helpers:
            helper.start()
    finally:
        _threading.stack_size(before)
    try:
        for helper in helpers:
            helper.join()
    except BaseException as interruption:
        errors.append(interruption)
        for helper in helpers:
            helper.join()
        raise
    if errors:
        raise errors[0]
