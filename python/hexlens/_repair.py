"""A mesh with points moved so that its hexahedra become valid: hl_untangle of the C library."""

import ctypes
import threading
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from ctypes import CFUNCTYPE, POINTER, byref, c_bool, c_double, c_size_t, c_void_p
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _classify
from ._arrays import HexlensError, cells_of, narrowed, points_of
from ._native import STATUSES, Cells, library

__all__ = ["Repair", "repair"]


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

#: hl_moves.
_STAYS, _UNLESS_BOUNDARY, _FREED = 0, 1, 2


@dataclass(frozen=True)
class Repair:
    """What `repair` has done. Cells are below where their relative minimum is less than was asked for, or they are invalid."""

    points: NDArray[np.float64]
    #: Counts of cells.
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


def repair(
    points: ArrayLike,
    cells: ArrayLike,
    *,
    min_relative: float = 0.0,
    slide: bool = False,
    free_boundary: float = 0.0,
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
    own_indices = narrowed(indices, len(own), np.empty(indices.shape, np.uint32))
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
    finally:
        threading.stack_size(before)
    if calls.raised is not None:
        raise calls.raised
    if status != 0:
        raise HexlensError(f"The mesh cannot be repaired: {STATUSES.get(status, f'the C library has answered {status}')}.")
    return Repair(
        points=moved,
        held=np.flatnonzero(held).astype(np.int64),
        **{name: getattr(result, name) for name in _COPIED},
    )


_COPIED: Final = tuple(name for name in Repair.__dataclass_fields__ if name not in ("points", "held"))


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
