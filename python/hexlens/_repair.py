"""A mesh with points moved so that its hexahedra become valid: hl_untangle and hl_reversed_cells of the C library."""

import ctypes
import threading
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from ctypes import CFUNCTYPE, POINTER, byref, c_bool, c_double, c_size_t, c_uint32, c_void_p
from dataclasses import dataclass, field
from typing import Any, Final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _classify
from ._arrays import HexlensError, cells_of, narrowed, points_of
from ._native import STATUSES, Cells, library
from ._place_proofs import Limits, Reason, Star, reason_of

__all__ = ["Reason", "Repair", "repair"]


class _Untangled(ctypes.Structure):
    """hl_untangled."""

    _fields_ = [
        ("invalid_before", c_size_t),
        ("invalid_after", c_size_t),
        ("below_before", c_size_t),
        ("below_after", c_size_t),
        ("moved_count", c_size_t),
        ("place_count", c_size_t),
        ("sweep_count", c_size_t),
        ("too_many_count", c_size_t),
        ("greatest_distance", c_double),
        ("mean_distance", c_double),
        ("least_before", c_double),
        ("least_after", c_double),
        ("is_stopped", c_bool),
    ]


_Work = CFUNCTYPE(None, c_void_p, c_size_t)
_Run = CFUNCTYPE(None, c_void_p, _Work, c_void_p, c_size_t)
_Proceed = CFUNCTYPE(c_bool, c_void_p, POINTER(_Untangled))


class _Untangling(ctypes.Structure):
    """hl_untangling."""

    _fields_ = [
        ("margin", c_double),
        ("moves", c_void_p),
        ("held", c_void_p),
        ("slides", c_bool),
        ("boundary_distance", c_double),
        ("thread_count", c_size_t),
        ("run", _Run),
        ("proceed", _Proceed),
        ("context", c_void_p),
    ]


library.hl_untangle_room.restype = c_size_t
library.hl_untangle_room.argtypes = [c_size_t, c_size_t, c_size_t]
library.hl_untangle.argtypes = [POINTER(Cells), POINTER(_Untangling), c_void_p, c_size_t, c_void_p, POINTER(_Untangled)]

library.hl_untangled_limits.restype = c_bool
library.hl_untangled_limits.argtypes = [c_void_p, c_uint32, POINTER(Limits)]
library.hl_reversed_cells.argtypes = [POINTER(Cells), c_void_p, c_size_t, c_void_p]

#: hl_moves.
_STAYS, _UNLESS_BOUNDARY, _FREED = 0, 1, 2


@dataclass(frozen=True)
class Repair:
    """What `repair` has done. Cells are below where their relative minimum is less than was asked for, or they are invalid."""

    points: NDArray[np.float64]
    #: The cells as they were given; with `reorder` the reversed ones with nodes 0 to 3 and 4 to 7 exchanged.
    cells: NDArray[Any]
    #: Indices of the cells whose nodes were numbered the other way round.
    reversed_cells: NDArray[np.int64]
    #: Counts of `cells`, with the points that were given and with those here.
    invalid_before: int
    invalid_after: int
    below_before: int
    below_after: int
    #: Points that are elsewhere, and how far.
    moved_count: int
    greatest_distance: float
    mean_distance: float
    #: The least relative minima of all cells; NaN where a cell has none.
    least_before: float
    least_after: float
    #: Best places that were sought, and sweeps over the mesh.
    place_count: int
    sweep_count: int
    #: Indices of the points that may move and still have a cell below: none of their own moves helps.
    held: NDArray[np.int64]
    #: The cells that were repaired, the limits of the held points, and the relative minimum that was wanted.
    _meant: NDArray[np.uint32] = field(repr=False)
    _limits: list[Limits] = field(repr=False)
    _margin: float = field(repr=False)

    def reasons(self, ids: Sequence[object] | None = None) -> Iterator[Reason]:
        """Why each held point does not help its cells, with a proof where there is one. Each takes some milliseconds.

        In the proofs cells are called by `ids`, by their indices without.
        """
        around = _cells_around(self._meant, self.held)
        for point, limits in zip(self.held.tolist(), self._limits, strict=True):
            own = around[point]
            names = [str(cell if ids is None else ids[cell]) for cell in own]
            name = f"point {point}: vertex {self.cells[own[0]].tolist().index(point)} of cell {names[0]}"
            yield reason_of(Star(self.points, self._meant[own], point, limits), own, self._margin, name, names)

    def certificates(self, ids: Sequence[object] | None = None) -> list[dict[str, Any]]:
        """The proofs of `reasons`, for `verify`: the list that `hexlens repair --certificates` writes."""
        return [reason.certificate for reason in self.reasons(ids) if reason.certificate is not None]


def _cells_around(cells: NDArray[np.uint32], points: NDArray[np.int64]) -> dict[int, list[int]]:
    """For each of these points, which are ascending, its cells, ascending."""
    around: dict[int, list[int]] = {point: [] for point in points.tolist()}
    at = np.flatnonzero(np.isin(cells.ravel(), points))
    for point, cell in zip(cells.ravel()[at].tolist(), (at // 8).tolist(), strict=True):
        if cell not in around[point][-1:]:
            around[point].append(cell)
    return around


def repair(
    points: ArrayLike,
    cells: ArrayLike,
    *,
    min_relative: float = 0.0,
    slide: bool = False,
    free_boundary: float = 0.0,
    reorder: bool = False,
    fixed: ArrayLike | None = None,
    freed: ArrayLike | None = None,
    threads: int | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> Repair:
    """Moves points so that all hexahedra become valid, and have at least `min_relative`; neither array is changed.

    Each move takes a point to the best place for the worst of its cells, and never makes that worse. Points of the boundary, the faces
    that are not shared by exactly two cells, stay unless something frees them. The result has the same bits with any number of threads.

    min_relative   the relative minimum that is wanted, from 0, for all that are valid, to 1
    slide          points on planar parts of the boundary move in their plane, those on a straight edge between two along it
    free_boundary  points of the boundary move so far at most; with slide only in their planes where they have one
    reorder        cells whose nodes are numbered the other way round get nodes 0 to 3 and 4 to 7 exchanged; without, they are repaired
                   as if they had, and stay as they are, invalid
    fixed, freed   indices of points that stay, and of points that move anywhere, whatever they are
    threads        at most so many; as many as there are cores without
    progress       called now and then with the cells that are below now, and at first; what it raises ends the work and is passed on
    """
    own = points_of(points)
    indices = cells_of(cells)
    thread_count = _classify._thread_count(threads)
    if not 0 <= min_relative <= 1:
        raise HexlensError(f"min_relative is {min_relative!r}; a number from 0 to 1 is expected.")
    if not free_boundary >= 0:
        raise HexlensError(f"free_boundary is {free_boundary!r}; a distance is expected.")
    listed = narrowed(indices, len(own), np.empty(indices.shape, np.uint32))
    reversed_cells = _reversed(own, listed)
    own_indices = _exchanged(listed, reversed_cells)
    moves = np.full(len(own), _UNLESS_BOUNDARY, np.uint8)
    moves[_chosen("fixed", fixed, len(own))] = _STAYS
    moves[_chosen("freed", freed, len(own))] = _FREED
    held = np.zeros(len(own), np.uint8)
    moved = np.empty_like(own)
    memory = np.empty(library.hl_untangle_room(len(own), len(indices), thread_count), np.uint8)
    result = _Untangled()
    before = threading.stack_size(_classify.STACK)
    try:
        pool = ThreadPoolExecutor(thread_count)
        calls = _Calls(pool, progress)
        wanted = _Untangling(
            margin=min_relative,
            moves=moves.ctypes.data,
            held=held.ctypes.data,
            slides=slide,
            boundary_distance=free_boundary,
            thread_count=thread_count,
            run=_Run(calls.run),
            proceed=_Proceed(calls.proceed),
        )
        given = Cells(own.ctypes.data, own.size, own_indices.ctypes.data, own_indices.size)
        with pool:
            status = library.hl_untangle(byref(given), byref(wanted), memory.ctypes.data, memory.size, moved.ctypes.data, byref(result))
        held_points = np.flatnonzero(held).astype(np.int64)
        limits = [_limits_of(memory, point) for point in held_points.tolist()]
    finally:
        threading.stack_size(before)
    if calls.raised is not None:
        raise calls.raised
    if status != 0:
        raise HexlensError(f"The mesh cannot be repaired: {STATUSES.get(status, f'the C library has answered {status}')}.")
    copied = {name: getattr(result, name) for name in _COPIED}
    if not reorder and len(reversed_cells) > 0:
        copied.update(_counts("before", own, listed, min_relative))
        copied.update(_counts("after", moved, listed, min_relative))
    return Repair(
        points=moved,
        cells=_exchanged(indices, reversed_cells) if reorder else indices,
        reversed_cells=reversed_cells,
        held=held_points,
        _meant=own_indices,
        _limits=limits,
        _margin=float(min_relative),
        **copied,
    )


_COPIED: Final = tuple(member[0] for member in _Untangled._fields_ if member[0] in Repair.__dataclass_fields__)


def _reversed(points: NDArray[np.float64], cells: NDArray[np.uint32]) -> NDArray[np.int64]:
    memory = np.empty(library.hl_untangle_room(len(points), len(cells), 1), np.uint8)
    is_reversed = np.zeros(len(cells), np.uint8)
    given = Cells(points.ctypes.data, points.size, cells.ctypes.data, cells.size)
    status = library.hl_reversed_cells(byref(given), memory.ctypes.data, memory.size, is_reversed.ctypes.data)
    if status != 0:
        raise HexlensError(f"The mesh cannot be repaired: {STATUSES.get(status, f'the C library has answered {status}')}.")
    return np.flatnonzero(is_reversed).astype(np.int64)


def _exchanged(cells: NDArray[Any], chosen: NDArray[np.int64]) -> NDArray[Any]:
    """The cells, of those that are chosen nodes 0 to 3 exchanged with 4 to 7."""
    if len(chosen) == 0:
        return cells
    exchanged: NDArray[Any] = cells.copy()
    exchanged[chosen] = cells[chosen][:, [4, 5, 6, 7, 0, 1, 2, 3]]
    return exchanged


def _limits_of(memory: NDArray[np.uint8], point: int) -> Limits:
    limits = Limits()
    library.hl_untangled_limits(memory.ctypes.data, point, byref(limits))
    return limits


def _counts(when: str, points: NDArray[np.float64], cells: NDArray[np.uint32], margin: float) -> dict[str, float]:
    relative = _classify.classify(points, cells, minima=True).relative_min
    return {
        f"invalid_{when}": int(np.count_nonzero(~(relative > 0))),
        f"below_{when}": int(np.count_nonzero(~((relative >= margin) & (relative > 0)))),
        f"least_{when}": float(relative.min()),
    }


class _Calls:
    """What the C library calls back. An exception cannot pass through it, so it is kept until it has returned."""

    def __init__(self, pool: ThreadPoolExecutor, progress: Callable[[int, int], object] | None) -> None:
        self._pool, self._progress = pool, progress
        self.raised: BaseException | None = None

    def run(self, _context: int | None, work: Callable[[int, int], None], piece: int, count: int) -> None:
        # Foreign functions are called without Python's lock.
        list(self._pool.map(lambda thread: work(piece, thread), range(count)))

    def proceed(self, _context: int | None, so_far: "ctypes._Pointer[_Untangled]") -> bool:
        if self._progress is None:
            return True
        try:
            self._progress(so_far.contents.below_after, so_far.contents.below_before)
        except BaseException as error:
            self.raised = error
        return self.raised is None


def _chosen(name: str, value: ArrayLike | None, point_count: int) -> NDArray[np.int64]:
    """Indices of points, or a mask with an entry for each."""
    if value is None:
        return np.empty(0, np.int64)
    array = np.asarray(value)
    if array.dtype == np.bool_ and array.shape == (point_count,):
        return np.flatnonzero(array)
    if array.ndim != 1 or (array.size > 0 and array.dtype.kind not in "iu"):
        raise HexlensError(f"{name} is a list of indices of points, or of {point_count} truth values.")
    if array.size > 0 and (array.min() < 0 or array.max() >= point_count):
        raise HexlensError(f"{name} names a point that does not exist: there are {point_count}.")
    return array.astype(np.int64)
