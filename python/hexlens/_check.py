"""The check of a mesh: counts, the worst cells, sentences for people. The same answers as web/mesh/check.ts."""

import os
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, Final, Literal

import numpy as np
from numpy.typing import NDArray

from ._arrays import HexlensError
from ._classify import Classification, worst_first
from ._histogram import histogram_of
from ._mesh import Mesh
from ._native import CLASSES
from ._numbers import json_number, whole_or_double
from ._report import Report, analyze, place_of

if TYPE_CHECKING:
    from .widget import HexLens

__all__ = ["Cell", "MeshCheck", "check", "check_mesh"]

#: Places in `MeshCheck.standing`.
STANDINGS: Final = ("valid", "invalid", "unanswered", "degenerate")
VALID, INVALID, UNANSWERED, DEGENERATE = range(4)
#: A place in `hexlens.STATUSES`.
_NO_SUCH_POINT: Final = 4

#: Other orders of eight points, as programs write them or as they get mixed up: web/model/node-orders.ts.
_ORDERS: Final = (
    ("Lexicographic", "deal.II, DOLFINx, VTK_VOXEL", "01324576"),
    ("Lexicographic, last coordinate fastest", None, "04621573"),
    ("Both the other way round", "Salome’s MED files", "03214765"),
    ("Top first", "AVS UCD", "45670123"),
    ("Top the other way round", "OpenVolumeMesh", "01234765"),
    ("Bottom the other way round", "PETSc’s DMPlex", "03214567"),
    ("Top turned by one", None, "01237456"),
    ("Top turned by two", None, "01236745"),
    ("Top turned by three", None, "01235674"),
    ("Top turned by one, the other way round", None, "01235476"),
    ("Top turned by two, the other way round", None, "01236547"),
    ("Top turned by three, the other way round", None, "01237654"),
    ("Top first, bottom turned by one", None, "74560123"),
    ("Top first, bottom turned by two", None, "67450123"),
    ("Top first, bottom turned by three", None, "56740123"),
    ("Top first, bottom turned by one, the other way round", None, "54760123"),
    ("Top first, bottom turned by two, the other way round", None, "65470123"),
    ("Top first, bottom turned by three, the other way round", None, "76540123"),
    ("Two points of the bottom exchanged", None, "01324567"),
    ("Two points of the top exchanged", None, "01234576"),
    ("By upright edges", None, "02461357"),
    ("By upright edges, downwards", None, "13570246"),
)


@dataclass(frozen=True)
class Cell:
    """One hexahedron of a mesh, as `hexlens check --json` lists it. One that is unanswered has None, and `error` says why."""

    id: str | None  #: what the file calls it
    index: int  #: among the hexahedra, from 0
    block: str | None  #: the first block, part or group that it is in
    vertices: NDArray[np.float64]
    report: Report | None
    error: str | None

    @property
    def valid(self) -> bool | None:
        return None if self.report is None else self.report.valid

    @property
    def class_(self) -> str | None:
        return None if self.report is None else self.report.class_

    @property
    def boundary_min(self) -> float | None:
        return None if self.report is None else self.report.boundary_min

    @property
    def relative_min(self) -> float | None:
        return None if self.report is None else self.report.relative_min

    def lens(self, **attributes: Any) -> "HexLens":
        """The widget on this cell; `attributes` are those of HexLens."""
        from .widget import HexLens

        if self.report is None:
            raise HexlensError(f"There is nothing to draw: {self.error}")
        return HexLens(self.vertices, **attributes)

    def to_dict(self) -> dict[str, Any]:
        name = {"id": self.id, "index": self.index, "block": self.block}
        report = self.report
        if report is None:
            return {**name, **_UNANSWERED, "error": self.error}
        return {
            **name,
            "valid": report.valid,
            "class": report.class_,
            "coincident": [list(group) for group in report.coincident],
            "shape": report.shape,
            "boundary_min": json_number(report.minimizer.value, report.exponent),
            "relative_min": None if report.relative_min is None else whole_or_double(report.relative_min),
            "volume": json_number(report.volume_mantissa, report.volume_exponent),
            "minimizer": place_of(report.minimizer),
            "decided_by": report.decided_by,
            "accepted_by": list(report.accepted_by),
        }


_UNANSWERED: Final[dict[str, Any]] = {
    "valid": None,
    "class": None,
    "coincident": [],
    "shape": None,
    "boundary_min": None,
    "relative_min": None,
    "volume": None,
    "minimizer": None,
    "decided_by": None,
    "accepted_by": [],
}


class MeshCheck:
    """What `hexlens check --json` prints of a mesh, as objects; `result[i]` is the hexahedron of index i."""

    def __init__(
        self,
        mesh: Mesh,
        file: str,
        *,
        worst: int | None,
        min_relative: float | None,
        skip_degenerate: bool,
        threads: int | None,
    ) -> None:
        #: As it was named.
        self.file = file
        self.mesh = mesh
        self.min_relative, self.skip_degenerate = min_relative, skip_degenerate
        #: Every answer, cell by cell.
        self.answers = answers = Classification(
            mesh.points, mesh.cells, threads, (("relative_minima", "volumes", "volume_exponents"), ("classes",))
        )
        valid = answers.valid
        is_degenerate = _coincident(mesh.points, mesh.cells, valid, answers.status == 0)
        #: Unanswered cells, of no stated order, with the first order in which they are valid.
        self.open_orders = {} if mesh.is_order_stated else _open_orders(mesh, valid)
        is_answered = answers.status == 0
        is_answered[list(self.open_orders)] = False
        #: Of each hexahedron, its place in STANDINGS.
        self.standing: NDArray[np.uint8] = np.where(is_answered, np.where(valid, VALID, INVALID), UNANSWERED).astype(np.uint8)
        if skip_degenerate:
            self.standing[is_degenerate] = DEGENERATE
        self.is_answered = is_answered
        counts = np.bincount(self.standing, minlength=4).tolist()
        self.hexahedra = len(answers)
        self.valid: int = counts[VALID]
        self.invalid: int = counts[INVALID]
        self.unanswered: int = counts[UNANSWERED]
        #: Cells with coincident vertices.
        self.degenerate = int(np.count_nonzero(is_degenerate))
        is_counted = self.standing <= INVALID
        self.is_below = np.zeros(self.hexahedra, bool) if min_relative is None else self._below(min_relative)
        self.below = int(np.count_nonzero(self.is_below & is_counted))
        self._mirrored = int(np.count_nonzero((answers.class_ == CLASSES.index("inverted")) & is_counted))
        self.format = mesh.format
        self.other = dict(mesh.other)
        self.not_trilinear = {
            "count": len(mesh.corners),
            "valid_by_corners": Classification(mesh.points, mesh.corners, threads, ()).valid_count,
        }
        #: Indices, worst first.
        self.worst_indices = self._worst(worst)
        self.notes = [*mesh.notes, *self._own_notes()]

    def _below(self, bound: float) -> NDArray[np.bool_]:
        """A cell of volume 0 is below everything if its minimum is negative, else it stands among the zeros."""
        relative = self.answers.relative_min
        collapsed = self.answers.class_ == CLASSES.index("collapsed")
        return np.where(np.isnan(relative), np.where(collapsed, bound > 0, True), relative < bound)

    def _worst(self, count: int | None) -> NDArray[np.int64]:
        relative, classes = self.answers.relative_min, self.answers.class_
        if not self.skip_degenerate:
            return worst_first(relative, classes, ~self.is_answered, count)
        listed = np.flatnonzero(self.standing != DEGENERATE)
        chosen: NDArray[np.int64] = listed[worst_first(relative[listed], classes[listed], ~self.is_answered[listed], count)]
        return chosen

    def __len__(self) -> int:
        return self.hexahedra

    def __getitem__(self, index: int) -> Cell:
        if not -self.hexahedra <= index < self.hexahedra:
            raise IndexError(f"there are {self.hexahedra} hexahedra, and no {index}")
        return self._cell(index % self.hexahedra)

    def __iter__(self) -> Iterator[Cell]:
        return map(self._cell, range(self.hexahedra))

    @cached_property
    def worst(self) -> list[Cell]:
        """The worst hexahedra first: as many as were asked for."""
        return [self._cell(int(index)) for index in self.worst_indices]

    @property
    def exit(self) -> Literal[0, 1, 3]:
        """The exit status of the command: 0 all valid; 1 some invalid or below the bound; 3 not all could be answered."""
        if self.invalid > 0 or self.below > 0:
            return 1
        return 0 if self.is_wholly_answered else 3

    @property
    def is_wholly_answered(self) -> bool:
        """Cells that are not hexahedra are nobody's question."""
        return self.hexahedra > 0 and self.unanswered == 0 and not len(self.mesh.corners) and not self.mesh.is_cut_off

    def name_of(self, index: int) -> str:
        """The id in the file; the index if it has none."""
        return str(index) if self.mesh.ids is None else _name(self.mesh.ids[index])

    def block_of(self, index: int) -> str | None:
        """The first block that the cell is in."""
        place = self._first_blocks[index] if self.mesh.blocks else -1
        return self.mesh.blocks[place][0] if place >= 0 else None

    @cached_property
    def _first_blocks(self) -> NDArray[np.int64]:
        places = np.full(self.hexahedra, -1)
        for i in reversed(range(len(self.mesh.blocks))):
            places[self.mesh.blocks[i][1]] = i
        return places

    def _cell(self, index: int) -> Cell:
        vertices = self.answers.vertices(index)
        order = self.open_orders.get(index)
        report, error = None, None
        if self.answers.status[index] == _NO_SUCH_POINT:
            error = self._missing_point(index)
        elif order is not None:
            error = f"The order of its nodes is not stated; in the order “{_ORDERS[order][0]}” it is valid."
        else:
            try:
                report = analyze(vertices)
            except HexlensError as why:
                error = str(why)
        name = None if self.mesh.ids is None else self.name_of(index)
        return Cell(name, index, self.block_of(index), vertices, report, error)

    def _missing_point(self, index: int) -> str:
        points = [int(point) for point in self.mesh.cells[index]]
        first = next(point for point in points if not 0 <= point < len(self.mesh.points))
        return f"It names point {first}, which does not exist."

    def histogram(self) -> NDArray[np.int64]:
        """How many relative minima are in each bin: between places of `hexlens.HISTOGRAM_EDGES`."""
        return histogram_of(self.answers.relative_min)

    def to_dict(self) -> dict[str, Any]:
        """The entry of this mesh in what `hexlens check --json` prints: docs/check.schema.json."""
        return {**self.head(), "worst": [cell.to_dict() for cell in self.worst]}

    def head(self) -> dict[str, Any]:
        """`to_dict` without the worst cells."""
        return {
            "file": self.file,
            "format": self.format,
            "hexahedra": self.hexahedra,
            "valid": self.valid,
            "invalid": self.invalid,
            "unanswered": self.unanswered,
            "degenerate": self.degenerate,
            "below": self.below,
            "not_trilinear": dict(self.not_trilinear),
            "other": dict(self.other),
            "notes": list(self.notes),
        }

    def arrays(self) -> dict[str, NDArray[Any]]:
        """The arrays that `--annotate` writes, one entry a hexahedron: valid is 255, and numbers NaN, where one is unanswered."""
        answers = self.answers
        return {
            "valid": np.where(self.is_answered, answers.valid, 255).astype(np.uint8),
            **{
                name: np.where(self.is_answered, values, np.nan)
                for name, values in (
                    ("boundary_min", answers.boundary_min),
                    ("relative_min", answers.relative_min),
                    ("volume", answers.volume),
                )
            },
        }

    def annotate(self, mesh: Any) -> Any:
        """Puts `arrays` into the cell data of the mesh that was checked, a meshio.Mesh or a pyvista grid, and returns it.

        Cells that are not hexahedra of eight nodes have 255 and NaN. ParaView shows what is then saved.
        """
        from ._sources import put_cell_arrays

        return put_cell_arrays(self, mesh)

    def headline(self) -> str:
        """The first sentence, as the command says it: "15 hexahedra, 10 INVALID, 5 valid." """
        skipped = self.degenerate if self.skip_degenerate else 0
        return sentence_of_counts(self.hexahedra, self.valid, self.invalid, self.unanswered, skipped)

    def count_sentences(self) -> list[str]:
        """Coincident vertices, and cells that are not hexahedra."""
        sentences = []
        if self.degenerate:
            cells = counted(self.degenerate, "hexahedron has", "hexahedra have")
            beside = " and count neither as valid nor as invalid" if self.skip_degenerate else ""
            sentences.append(f"{cells} coincident vertices{beside}.")
        if self.other:
            kinds = ", ".join(counted(n, kind, _PLURALS.get(kind, f"{kind}s")) for kind, n in self.other.items())
            sentences.append(f"Not checked: {kinds}.")
        return sentences

    def __repr__(self) -> str:
        return f"<MeshCheck of {self.file} ({self.format}): {self.headline()}>"

    def _repr_html_(self) -> str:
        from ._html import mesh_markup

        return mesh_markup(self, 3, stands_alone=False)

    def _own_notes(self) -> Iterator[str]:
        if self.open_orders:
            yield self._order_note()
        if self._mirrored:
            yield self._mirrored_note()
        yield from self._unanswered_note()
        count = len(self.mesh.corners)
        if count:
            cells = counted(count, "cell has more than eight nodes and is", "cells have more than eight nodes and are")
            yield f"{cells} not trilinear: by the eight corners {self.not_trilinear['valid_by_corners']} would be valid."
        if self.mesh.is_cut_off:
            yield "The file is cut off: the answer is for what is whole in it."

    def _order_note(self) -> str:
        first, order = next(iter(self.open_orders.items()))
        name, used_by, _ = _ORDERS[order]
        words = f"“{name}”{f' ({used_by})' if used_by else ''}"
        stated = "It is not stated in which order the nodes are"
        if self.hexahedra == 1:
            return f"{stated}, so the verdict is open: in the order of the text the hexahedron is not valid, in the order {words} it is."
        several = counted(len(self.open_orders), "hexahedron is", "hexahedra are")
        return f"{stated}: {several} not valid in the order of the text, but in another, first {self._said(first)} in the order {words}."

    def _mirrored_note(self) -> str:
        count, one = self._mirrored, self._mirrored == 1
        which = "All" if count == self.hexahedra and self.hexahedra > 1 else f"{count} of"
        are, them, their, they = ("is", "it", "its", "it is") if one else ("are", "them", "their", "they are")
        return (
            f"{which} {counted(self.hexahedra, 'hexahedron', 'hexahedra')} {are} mirrored, jacdet < 0 everywhere in {them}, "
            f"because {their} nodes are numbered the other way round or an axis is reversed; "
            f"with nodes 0 to 3 and 4 to 7 exchanged {they} valid."
        )

    def _unanswered_note(self) -> Iterator[str]:
        cells = np.flatnonzero(self.standing == UNANSWERED)
        cells = cells[~np.isin(cells, list(self.open_orders))]
        if not len(cells):
            return
        why = self._cell(int(cells[0])).error or ""
        why = why[:1].lower() + why[1:]
        if len(cells) == 1:
            yield f"The hexahedron {self._said(int(cells[0]))} is unanswered: {why}"
        else:
            yield f"{len(cells)} hexahedra are unanswered, first {self._said(int(cells[0]))}: {why}"

    def _said(self, index: int) -> str:
        return f"with index {index}" if self.mesh.ids is None else self.name_of(index)


_PLURALS: Final = {"tetrahedron": "tetrahedra", "polyhedron": "polyhedra", "vertex": "vertices", "other": "others"}


def sentence_of_counts(hexahedra: int, valid: int, invalid: int, unanswered: int, skipped: int) -> str:
    """The first sentence of the command; `skipped` are degenerate ones that count for nothing else."""
    cells = counted(hexahedra, "hexahedron", "hexahedra")
    if hexahedra == 0:
        return "no hexahedra of eight nodes."
    if valid == hexahedra:
        return "1 hexahedron, VALID." if hexahedra == 1 else f"{cells}, all VALID."
    counts = ((invalid, "INVALID"), (valid, "valid"), (unanswered, "unanswered"), (skipped, "degenerate"))
    return f"{cells}, {', '.join(f'{count} {word}' for count, word in counts if count)}."


def counted(count: int, one: str, many: str) -> str:
    """ "1 wedge", "2 wedges"."""
    return f"{count} {one if count == 1 else many}"


def _name(value: Any) -> str:
    return value if isinstance(value, str) else str(int(value))


#: Vertices 0 and 6, 1 and 7, 2 and 4, 3 and 5 are the diagonals through the middle.
_DIAGONALS: Final = ((0, 6), (1, 7), (2, 4), (3, 5))
_PAIRS: Final = tuple((a, b) for a in range(8) for b in range(a + 1, 8))
#: Cells at once, so that their coordinates stay in a core's cache.
_CHUNK: Final = 16_384


def _coincident(
    points: NDArray[np.float64], cells: NDArray[Any], valid: NDArray[np.bool_], has_points: NDArray[np.bool_]
) -> NDArray[np.bool_]:
    """Cells with vertices at the same position. Where the ends of an edge or of a face's diagonal coincide, jacdet is 0 at a vertex,
    so in a valid cell only the four diagonals through the middle are left to compare."""
    found = np.zeros(len(cells), bool)
    x = points[:, 0]
    for begin in range(0, len(cells), _CHUNK):
        own = slice(begin, begin + _CHUNK)
        chunk = cells[own]
        if valid[own].all():
            # The first coordinates tell nearly all apart.
            maybe = np.zeros(len(chunk), bool)
            xs = x[chunk]
            for a, b in _DIAGONALS:
                maybe |= xs[:, a] == xs[:, b]
            if not maybe.any():
                continue
        if valid[own].all():
            _mark(points, chunk, np.flatnonzero(maybe), _DIAGONALS, found[own])
            continue
        _mark(points, chunk, np.flatnonzero(valid[own]), _DIAGONALS, found[own])
        # A cell of which a point is missing is unanswered; one that is not finite may have coincident vertices all the same.
        others = np.flatnonzero(~valid[own])
        others = others[((chunk[others] >= 0) & (chunk[others] < len(points))).all(axis=1)]
        _mark(points, chunk, others, _PAIRS, found[own])
    return found


def _mark(
    points: NDArray[np.float64],
    cells: NDArray[Any],
    which: NDArray[np.int64],
    pairs: tuple[tuple[int, int], ...],
    found: NDArray[np.bool_],
) -> None:
    corners = points[cells[which]]
    for a, b in pairs:
        found[which] |= (corners[:, a] == corners[:, b]).all(axis=1)


def _open_orders(mesh: Mesh, valid: NDArray[np.bool_]) -> dict[int, int]:
    """Cells that are not valid, but are in an order that programs use: with the first of these."""
    left = np.flatnonzero(~valid)
    found: dict[int, int] = {}
    for order, (_, _, permutation) in enumerate(_ORDERS):
        answers = Classification(mesh.points, mesh.cells[left][:, [int(v) for v in permutation]], None, ())
        found.update((int(cell), order) for cell in left[answers.valid])
        left = left[~answers.valid]
    return dict(sorted(found.items()))


def check(
    mesh: Any,
    *,
    worst: int | None = 10,
    min_relative: float | None = None,
    skip_degenerate: bool = False,
    format: str | None = None,  # noqa: A002 - the command's word
    threads: int | None = None,
) -> MeshCheck:
    """Checks what people have: a tuple (points, cells), the path of a file, a meshio.Mesh, a pyvista.UnstructuredGrid, or Gmsh's
    model in memory (`gmsh.model`).

    worst            how many of the worst cells are put in order; None for all
    min_relative     cells whose minimum over |volume| is below it count in `below`
    skip_degenerate  cells with coincident vertices count in `degenerate` alone
    format           of a file: the name of the format, whatever it looks like
    threads          as many as there are cores without

    HexlensError says in a sentence why something cannot be read.
    """
    from ._sources import mesh_of

    found = mesh_of(mesh, format)
    file = os.fspath(mesh) if isinstance(mesh, (str, os.PathLike)) else found.format
    return check_mesh(found, str(file), worst=worst, min_relative=min_relative, skip_degenerate=skip_degenerate, threads=threads)


def check_mesh(
    mesh: Mesh,
    file: str,
    *,
    worst: int | None = 10,
    min_relative: float | None = None,
    skip_degenerate: bool = False,
    threads: int | None = None,
) -> MeshCheck:
    """`check` of a mesh that is read already."""
    return MeshCheck(mesh, file, worst=worst, min_relative=min_relative, skip_degenerate=skip_degenerate, threads=threads)
