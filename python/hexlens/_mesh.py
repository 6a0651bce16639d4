"""A mesh as the check takes it, and how it is made of what libraries hold: the same cells, counts and names as web/mesh has them."""

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from ._arrays import HexlensError

__all__ = ["CellArrays", "Grid", "Mesh", "MeshMaker", "cell_names"]

HEXAHEDRON, VOXEL, POLYHEDRON, LAGRANGE = 12, 11, 42, 72


@dataclass
class Mesh:
    """Hexahedra and what stands beside them."""

    format: str
    points: NDArray[np.float64]
    cells: NDArray[Any]
    #: The cell of the source that each hexahedron is, and how many cells the source has; None for all in their order.
    places: NDArray[np.int64] | None = None
    source_count: int = 0
    #: What the source calls them.
    ids: Sequence[str] | NDArray[Any] | None = None
    blocks: list[tuple[str, NDArray[np.int64]]] = field(default_factory=list)
    #: Eight corners of each cell that has more nodes.
    corners: NDArray[np.int64] = field(default_factory=lambda: np.empty((0, 8), np.int64))
    other: dict[str, int] = field(default_factory=dict)
    notes: list[str] = field(default_factory=list)
    is_order_stated: bool = True
    is_cut_off: bool = False


#: Kind and number of nodes (0: any) of VTK's cell types, vtkCellType.h. "-" is a hexahedron of more nodes than its corners.
_KINDS: Final[dict[int, tuple[str, int]]] = {
    0: ("other", 0), 1: ("vertex", 1), 2: ("vertex", 0), 3: ("line", 2), 4: ("line", 0), 5: ("triangle", 3),
    6: ("other", 0), 7: ("polygon", 0), 8: ("quadrilateral", 4), 9: ("quadrilateral", 4), 10: ("tetrahedron", 4),
    VOXEL: ("voxel", 8), HEXAHEDRON: ("hexahedron", 8), 13: ("wedge", 6), 14: ("pyramid", 5), 15: ("other", 10),
    16: ("other", 12), 21: ("line", 3), 22: ("triangle", 6), 23: ("quadrilateral", 8), 24: ("tetrahedron", 10),
    25: ("-", 20), 26: ("wedge", 15), 27: ("pyramid", 13), 28: ("quadrilateral", 9), 29: ("-", 27),
    30: ("quadrilateral", 6), 31: ("wedge", 12), 32: ("wedge", 18), 33: ("-", 24), 34: ("triangle", 7), 35: ("line", 4),
    36: ("polygon", 0), 37: ("pyramid", 19), 41: ("other", 0), POLYHEDRON: ("polyhedron", 0), 51: ("line", 0),
    **dict.fromkeys(range(52, 57), ("other", 0)),
    **dict.fromkeys((60, 68, 75), ("line", 0)),
    **dict.fromkeys((61, 69, 76), ("triangle", 0)),
    **dict.fromkeys((62, 70, 77), ("quadrilateral", 0)),
    63: ("polygon", 0),
    **dict.fromkeys((64, 71, 78), ("tetrahedron", 0)),
    **dict.fromkeys((65, 73, 80), ("wedge", 0)),
    **dict.fromkeys((66, 74, 81), ("pyramid", 0)),
    67: ("-", 0), LAGRANGE: ("-", 0), 79: ("-", 0),
}  # fmt: skip
VOXEL_ORDER: Final = [0, 1, 3, 2, 4, 5, 7, 6]


@dataclass
class CellArrays:
    """Arrays of a number for each cell of the source, by their names; `global_ids` is the one that the source calls so."""

    arrays: Mapping[str, NDArray[Any]] = field(default_factory=dict)
    global_ids: str | None = None


@dataclass
class Grid:
    """Cells in a row, as VTK has them."""

    points: NDArray[np.float64]
    types: NDArray[np.uint8]
    #: Where each cell ends in `connectivity`.
    ends: NDArray[np.int64]
    connectivity: NDArray[Any]
    data: CellArrays = field(default_factory=CellArrays)
    #: Of coordinates of size 1: how far rounding moves a middle.
    tolerance: float = 8 * 2.0**-52
    #: True if a polyhedron's nodes are its faces as a row of numbers, as in legacy files.
    has_face_streams: bool = False


class MeshMaker:
    """Puts grids together, each with its own points."""

    def __init__(self, format_: str, refuse: Callable[[str], HexlensError]) -> None:
        self._format, self._refuse = format_, refuse
        self._points: list[NDArray[np.float64]] = []
        self._cells: list[NDArray[Any]] = []
        self._corners: list[NDArray[np.int64]] = []
        self._places: list[NDArray[np.int64] | None] = []
        self._ids: list[NDArray[Any]] | None = []
        self._blocks: dict[str, list[NDArray[np.int64]]] = {}
        self._grids: list[tuple[str, NDArray[np.int64]]] = []
        self._other: dict[str, int] = {}
        self._point_count = self._cell_count = self._source_count = 0
        self._voxels = self._other_order = 0
        self.notes: list[str] = []
        self.is_cut_off = False

    def add(self, grid: Grid, block: str | None = None) -> None:
        """A grid, with its hexahedra as a block of this name if there is one."""
        cells, places = self._hexahedra(grid)
        before = self._cell_count
        self._add_data(grid.data, len(grid.types), places, before, len(cells))
        if block is not None:
            self._grids.append((block, np.arange(before, before + len(cells))))
        if self._point_count > 0:
            cells = cells.astype(np.int64) + self._point_count
        self._points.append(grid.points)
        self._cells.append(cells)
        self._places.append(places)
        self._point_count += len(grid.points)
        self._cell_count += len(cells)
        self._source_count += len(grid.types)

    def _hexahedra(self, grid: Grid) -> tuple[NDArray[Any], NDArray[np.int64] | None]:
        types, ends, connectivity = grid.types, grid.ends, grid.connectivity
        count = len(types)
        if len(ends) != count:
            raise self._refuse(f"it has {count} types of cells and {len(ends)} ends.")
        total = int(ends[-1]) if count else 0
        if total != len(connectivity):
            raise self._refuse(f"the cells name {total} points, and {len(connectivity)} are listed.")
        starts = np.concatenate([np.zeros(1, ends.dtype), ends[:-1]]) if count else ends
        sizes = ends - starts
        if count and sizes.min() < 0:
            first = int(np.flatnonzero(sizes < 0)[0])
            raise self._refuse(f"cell {first} ends before it begins.")
        self._check_range(grid, starts, sizes)
        if count and (types == HEXAHEDRON).all() and (sizes == 8).all():
            return connectivity.reshape(-1, 8), None
        is_hexahedron = np.zeros(count, bool)
        for kind in np.unique(types).tolist():
            known = _KINDS.get(kind)
            of_kind = types == kind
            if known is None:
                raise self._refuse(f"cell {np.flatnonzero(of_kind)[0]} has type {kind}, which VTK does not have.")
            name, nodes = known
            wrong = np.flatnonzero(of_kind & (sizes != nodes)) if nodes else np.empty(0, np.int64)
            if len(wrong):
                first = int(wrong[0])
                raise self._refuse(f"cell {first} of type {kind} has {sizes[first]} points; it must have {nodes}.")
            if name in ("hexahedron", "voxel"):
                is_hexahedron |= of_kind
            elif name == "-":
                few = np.flatnonzero(of_kind & (sizes < 8))
                if len(few):
                    raise self._refuse(f"cell {few[0]} of type {kind} has {sizes[few[0]]} points; it must have at least 8.")
                # A Lagrange hexahedron of order 1 is trilinear.
                is_hexahedron |= of_kind & (sizes == 8)
                more = np.flatnonzero(of_kind & (sizes > 8))
                if len(more):
                    self._corners.append(self._eight(connectivity, starts[more]).astype(np.int64) + self._point_count)
            else:
                self._other[name] = self._other.get(name, 0) + int(np.count_nonzero(of_kind))
        places = np.flatnonzero(is_hexahedron)
        cells = self._eight(connectivity, starts[places])
        voxels = np.flatnonzero(types[places] == VOXEL)
        if len(voxels):
            self._check_boxes(grid, cells[voxels], voxels)
            cells[voxels] = cells[voxels][:, VOXEL_ORDER]
        return cells, places

    @staticmethod
    def _eight(connectivity: NDArray[Any], starts: NDArray[Any]) -> NDArray[Any]:
        return connectivity[starts[:, None] + np.arange(8)]

    def _check_range(self, grid: Grid, starts: NDArray[Any], sizes: NDArray[Any]) -> None:
        connectivity = grid.connectivity
        if not len(connectivity):
            return
        if grid.has_face_streams and (grid.types == POLYHEDRON).any():
            is_plain = np.repeat(grid.types != POLYHEDRON, sizes)
            bad = np.flatnonzero(is_plain & ((connectivity < 0) | (connectivity >= len(grid.points))))
        elif connectivity.min() >= 0 and connectivity.max() < len(grid.points):
            return
        else:
            bad = np.flatnonzero((connectivity < 0) | (connectivity >= len(grid.points)))
        if not len(bad):
            return
        at = int(bad[0])
        cell = int(np.searchsorted(starts + sizes, at, side="right"))
        have = f"the points are 0 to {len(grid.points) - 1}" if len(grid.points) else "there are no points"
        raise self._refuse(f"cell {cell} names point {connectivity[at]} as its vertex {at - int(starts[cell])}; {have}.")

    def _check_boxes(self, grid: Grid, voxels: NDArray[Any], indices: NDArray[np.int64]) -> None:
        """Some programs write hexahedra as voxels: a voxel's corners lie on two planes along each axis."""
        corners = grid.points[voxels]

        def are_boxes(bits: Sequence[int]) -> NDArray[np.bool_]:
            low, high = corners[:, 0], corners[:, bits.index(7)]
            within = grid.tolerance * np.maximum(np.abs(low), np.abs(high))
            with np.errstate(invalid="ignore"):
                off = [
                    np.abs(corners[:, v] - np.where([(bit >> axis) & 1 for axis in range(3)], high, low)) > within
                    for v, bit in enumerate(bits)
                ]
            are: NDArray[np.bool_] = ~np.any(off, axis=(0, 2))
            return are

        not_boxes = ~are_boxes(range(8))
        self._voxels += int(np.count_nonzero(not_boxes))
        self._other_order += int(np.count_nonzero(not_boxes & are_boxes(VOXEL_ORDER)))
        if not_boxes.any():
            first = self._cell_count + int(indices[not_boxes][0])
            some = f"{np.count_nonzero(not_boxes)} of the voxels (type 11) are no boxes along the axes"
            self.notes.append(f"{some}, first the hexahedron of index {first}: they are answered as hexahedra with these corners.")

    def _add_data(self, data: CellArrays, source_count: int, places: NDArray[np.int64] | None, before: int, count: int) -> None:
        arrays = {name: np.asarray(array) for name, array in data.arrays.items()}
        arrays = {name: array for name, array in arrays.items() if array.shape == (source_count,) and array.dtype.kind in "iuf"}
        ids, block = cell_names(arrays, data.global_ids)
        own = slice(None) if places is None else places
        if ids is not None and self._ids is not None:
            self._ids.append(arrays[ids][own])
        elif count > 0:
            self._ids = None
        if block is None:
            return
        values = arrays[block][own]
        distinct, first = np.unique(values, return_index=True)
        for value in distinct[np.argsort(first)]:
            cells = before + np.flatnonzero(values == value)
            self._blocks.setdefault(f"{block} {_whole(value)}", []).append(cells)

    def mesh(self) -> Mesh:
        blocks = [(name, np.concatenate(cells)) for name, cells in self._blocks.items()]
        one_in_order = len(self._places) <= 1 and all(places is None for places in self._places)
        return Mesh(
            format=self._format,
            points=_joined(self._points, np.empty((0, 3))),
            cells=_joined(self._cells, np.empty((0, 8), np.int64)),
            places=None if one_in_order else self._all_places(),
            source_count=self._source_count,
            ids=_joined(self._ids, np.empty(0)) if self._ids and self._cell_count > 0 else None,
            blocks=blocks + self._grids,
            corners=_joined(self._corners, np.empty((0, 8), np.int64)),
            # In the order of the types, as all outputs list them.
            other={name: self._other[name] for name, _ in dict.fromkeys(_KINDS.values()) if name in self._other},
            notes=self.notes,
            is_order_stated=self._other_order == 0,
            is_cut_off=self.is_cut_off,
        )

    def _all_places(self) -> NDArray[np.int64] | None:
        # Only a single grid's cells are given arrays of answers.
        return self._places[0] if len(self._places) == 1 else None


def _joined(arrays: Sequence[NDArray[Any]] | None, empty: NDArray[Any]) -> NDArray[Any]:
    if not arrays:
        return empty
    return arrays[0] if len(arrays) == 1 else np.concatenate(arrays)


def _whole(value: Any) -> int:
    return int(value)


_IDS: Final = re.compile(
    r"(?:vtk|global|pedigree|original)?(?:cell|elem|element)(?:global)?(?:ids?|gids?|nos?|nr|numbers?|labels?)"
    r"|(?:vtk)?(?:global|pedigree)ids?|eids?"
)
#: The most telling first.
_BLOCKS: Final = [
    re.compile(pattern)
    for pattern in (
        r"gmshphysical|physical(?:group)?(?:ids?|tags?)?",
        r"(?:material|mat|property|prop|section|attribute|meditref)(?:ids?|nos?|nr|numbers?|index|tags?|markers?)?|[pm]ids?",
        r"(?:elementblock|elemblock|block|cellentity|region|zone|group|part|component)(?:ids?|nos?|nr|numbers?|index|tags?|markers?)?",
        r"(?:subdomain|domain|object)(?:ids?|nos?|index|tags?|markers?)?|gmshgeometrical|(?:cell)?(?:tags?|markers?)",
    )
]
_MOST_BLOCKS: Final = 10_000
_MOST_EXACT: Final = 2**53 - 1


def cell_data_rank(name: str) -> int:
    """The rank of a name: 0 for ids, then blocks; -1 for arrays that say neither."""
    plain = re.sub(r"[^a-z]", "", name.lower())
    if _IDS.fullmatch(plain):
        return 0
    return next((rank for rank, pattern in enumerate(_BLOCKS, 1) if pattern.fullmatch(plain)), -1)


def cell_names(arrays: Mapping[str, NDArray[Any]], global_ids: str | None) -> tuple[str | None, str | None]:
    """The arrays that are ids and that put cells into blocks, known by the names that programs give them."""
    ranks = {name: cell_data_rank(name) for name in arrays}
    candidates = sorted((name for name in arrays if name == global_ids or ranks[name] == 0), key=lambda name: name != global_ids)
    blocks = sorted((name for name in arrays if name != global_ids and ranks[name] > 0), key=lambda name: ranks[name])
    ids = next((name for name in candidates if _are_whole(arrays[name]) and len(np.unique(arrays[name])) == len(arrays[name])), None)
    block = next((name for name in blocks if _are_whole(arrays[name]) and 0 < len(np.unique(arrays[name])) <= _MOST_BLOCKS), None)
    return ids, block


def _are_whole(values: NDArray[Any]) -> bool:
    if values.dtype.kind == "f":
        with np.errstate(invalid="ignore"):
            return bool(((np.floor(values) == values) & (np.abs(values) <= _MOST_EXACT)).all())
    return bool((values <= _MOST_EXACT).all() and (values.dtype.kind == "u" or (values >= -_MOST_EXACT).all()))
