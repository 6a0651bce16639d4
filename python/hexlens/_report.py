"""All that is known of one hexahedron: hl_analyze as frozen dataclasses."""

from ctypes import byref
from dataclasses import dataclass
from typing import Any, Final, Literal, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native
from ._arrays import HexlensError, vertices_of
from ._native import CHECKS, CLASSES, KINDS, SHAPES, library
from ._numbers import json_number, scaled, whole_or_double

__all__ = ["Candidate", "Check", "Face", "FaceRoot", "Report", "VolumeMinimum", "analyze"]

Point: TypeAlias = tuple[float, float, float]
Kind: TypeAlias = Literal["vertex", "edge", "face"]
_FATES: Final = ("kept", "a-not-positive", "s-outside")


@dataclass(frozen=True, slots=True)
class Candidate:
    """A boundary point that may be the minimizer, on a vertex 0 to 7, an edge 0 to 11 or a face 0 to 5."""

    kind: Kind
    id: int
    point: Point  #: xi, eta, zeta in [0, 1]
    position: Point  #: where that is in space
    value: float  #: jacdet there, times 2 to the report's exponent


@dataclass(frozen=True, slots=True)
class FaceRoot:
    """A root t of the quartic P of a face, and what became of it."""

    t: float
    a: float
    s: float | None  #: None where a is not positive
    fate: Literal["kept", "a-not-positive", "s-outside"]


@dataclass(frozen=True, slots=True)
class Face:
    """What Algorithm 1 finds on a face."""

    id: int
    bernstein: tuple[float, ...]  #: nine, [3 * i + j] with i in s, j in t
    lower_bound: float
    running_minimum: float
    skipped_by_minimum_rule: bool
    skipped_by_validity_rule: bool
    quartic: tuple[float, ...]  #: times 2 to the quartic_exponent
    quartic_exponent: int
    quartic_is_zero: bool
    roots: tuple[FaceRoot, ...]


@dataclass(frozen=True, slots=True)
class VolumeMinimum:
    """The least jacdet over the closed element is in [lower, upper], times 2 to the report's exponent."""

    lower: float
    upper: float
    point: Point
    position: Point


@dataclass(frozen=True, slots=True)
class Check:
    """A check of other programs: its number, a jacdet times 2 to the report's exponent but for "corners-and-centre"."""

    value: float
    passes: bool


@dataclass(frozen=True, slots=True)
class Report:
    """All that is known of one hexahedron.

    Every jacdet is a number times 2 to the `exponent`, which is 0 wherever all of them are normal doubles, as they nearly always
    are. `boundary_min` and `volume` are the doubles that come of it.
    """

    vertices: tuple[Point, ...]
    valid: bool
    decided_by: Literal["filter", "exact"]
    exponent: int
    minimizer: Candidate
    minimum_error: float
    volume_minimum: VolumeMinimum
    checks: dict[str, Check]
    maximizer: Candidate
    corner_minimum: float
    edge_minimum: float
    scaled_jacobian: float
    bernstein: tuple[float, ...]  #: 27, [9 * i + 3 * j + k] with i in xi, j in eta, k in zeta
    faces: tuple[Face, ...]
    candidates: tuple[Candidate, ...]
    class_: Literal["valid", "invalid", "inverted", "collapsed"]
    shape: Literal["wedge", "pyramid", "tetrahedron"] | None
    coincident: tuple[tuple[int, ...], ...]  #: groups of vertices at the same position
    volume_mantissa: float
    volume_exponent: int
    relative_min: float | None  #: the boundary minimum over |volume|; None where that is 0

    @property
    def boundary_min(self) -> float:
        """The least jacdet on the boundary; an infinity or 0 where it is beyond the doubles."""
        return scaled(self.minimizer.value, self.exponent)

    @property
    def volume(self) -> float:
        """The mean of jacdet, rounded once."""
        return scaled(self.volume_mantissa, self.volume_exponent)

    @property
    def accepted_by(self) -> tuple[str, ...]:
        """The checks of other programs that take it for valid."""
        return tuple(name for name, check in self.checks.items() if check.passes)

    def to_dict(self, name: str = "") -> dict[str, Any]:
        """What `hexlens analyze` prints of it."""

        def jacdet(value: float) -> float | int | str:
            return json_number(value, self.exponent)

        return {
            "name": name,
            "valid": self.valid,
            "class": self.class_,
            "coincident": [list(group) for group in self.coincident],
            "shape": self.shape,
            "boundary_min": jacdet(self.minimizer.value),
            "boundary_min_error": jacdet(self.minimum_error),
            "minimizer": place_of(self.minimizer),
            "corner_min": jacdet(self.corner_minimum),
            "edge_min": jacdet(self.edge_minimum),
            "volume_min": [jacdet(self.volume_minimum.lower), jacdet(self.volume_minimum.upper)],
            "volume_minimizer": [whole_or_double(x) for x in self.volume_minimum.point],
            "volume": json_number(self.volume_mantissa, self.volume_exponent),
            "relative_min": None if self.relative_min is None else whole_or_double(self.relative_min),
            "decided_by": self.decided_by,
            "checks": {
                name: {
                    "value": whole_or_double(check.value) if name == "corners-and-centre" else jacdet(check.value),
                    "passes": check.passes,
                }
                for name, check in self.checks.items()
            },
        }


def place_of(minimizer: Candidate) -> dict[str, Any]:
    """As JSON has it."""
    return {"kind": minimizer.kind, "id": minimizer.id, "point": [whole_or_double(x) for x in minimizer.point]}


def analyze(vertices: ArrayLike) -> Report:
    """Everything about one hexahedron, 8 x 3 coordinates in VTK_HEXAHEDRON order.

    HexlensError for a coordinate that is not finite, or another shape.
    """
    array = vertices_of(vertices)
    raw = _native.RawReport()
    if library.hl_analyze(array.ctypes.data, byref(raw)) != 0:
        raise HexlensError(not_finite(array))
    return _report(array, raw)


def not_finite(array: NDArray[np.float64]) -> str:
    """The sentence for the first coordinate that is not."""
    vertex, axis = np.argwhere(~np.isfinite(array))[0]
    return f"Vertex {vertex} {'xyz'[axis]} is not a finite number."


def _report(array: NDArray[np.float64], raw: _native.RawReport) -> Report:
    groups = [tuple(v for v in range(8) if raw.coincident[v] == first) for first in range(8)]
    return Report(
        vertices=tuple((x, y, z) for x, y, z in array.tolist()),
        valid=raw.verdict == 1,
        decided_by="exact" if raw.is_exact else "filter",
        exponent=raw.exponent,
        minimizer=_candidate(raw.minimizer),
        minimum_error=raw.minimum_error,
        volume_minimum=VolumeMinimum(
            raw.volume_minimum.lower,
            raw.volume_minimum.upper,
            _point(raw.volume_minimum.point),
            _point(raw.volume_minimum.position),
        ),
        checks={name: Check(value, value > 0) for name, value in zip(CHECKS, raw.checks, strict=True)},
        maximizer=_candidate(raw.maximizer),
        corner_minimum=raw.corner_minimum,
        edge_minimum=raw.edge_minimum,
        scaled_jacobian=raw.scaled_jacobian,
        bernstein=tuple(raw.bernstein),
        faces=tuple(_face(i, face) for i, face in enumerate(raw.faces)),
        candidates=tuple(_candidate(candidate) for candidate in raw.candidates[: raw.candidate_count]),
        class_=CLASSES[raw.element_class],  # type: ignore[arg-type]
        shape=SHAPES[raw.shape],
        coincident=tuple(group for group in groups if len(group) > 1),
        volume_mantissa=raw.volume,
        volume_exponent=raw.volume_exponent,
        relative_min=None if raw.volume == 0 else raw.relative_minimum,
    )


def _point(three: Any) -> Point:
    x, y, z = three
    return x, y, z


def _candidate(raw: _native.Candidate) -> Candidate:
    kind: Any = KINDS[raw.kind]
    return Candidate(kind, raw.id, _point(raw.point), _point(raw.position), raw.value)


def _face(number: int, raw: _native.FaceReport) -> Face:
    return Face(
        number,
        tuple(raw.bernstein),
        raw.lower_bound,
        raw.running_minimum,
        raw.skipped_by_minimum_rule,
        raw.skipped_by_validity_rule,
        tuple(raw.quartic),
        raw.quartic_exponent,
        raw.quartic_is_zero,
        tuple(_root(root) for root in raw.roots[: raw.root_count]),
    )


def _root(raw: Any) -> FaceRoot:
    fate: Any = _FATES[raw.fate]
    return FaceRoot(raw.t, raw.a, None if fate == "a-not-positive" else raw.s, fate)
