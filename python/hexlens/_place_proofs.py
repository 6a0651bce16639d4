"""Why a point that `repair` has left does not help its cells: its best place, and the proof that none is better. The same steps as in
web/core/repair/held.ts, place-proof.ts and place-certificate.ts, so that the proofs are the same; nothing rounds."""

import ctypes
from collections.abc import Sequence
from ctypes import POINTER, byref, c_bool, c_double, c_int, c_size_t, c_uint32, c_void_p
from dataclasses import dataclass
from fractions import Fraction
from itertools import combinations
from typing import Any, Final, Literal

import numpy as np
from numpy.typing import NDArray

from ._arrays import HexlensError
from ._certificates import EDGES, REFERENCE
from ._native import STATUSES, Cells, library

__all__ = ["Limits", "Reason", "Star", "reason_of"]


class Limits(ctypes.Structure):
    """hl_limits."""

    _fields_ = [("low", c_double * 3), ("high", c_double * 3), ("normals", (c_double * 3) * 2)]


class _Star(ctypes.Structure):
    """hl_star."""

    _fields_ = [("cells", Cells), ("moving", c_void_p), ("vertex", c_uint32), ("limits", POINTER(Limits))]


class _Hold(ctypes.Structure):
    """hl_hold."""

    _fields_ = [("cell", c_uint32), ("point", c_double * 3), ("weight", c_double), ("scale", c_double), ("is_by_sign", c_bool)]


class _Place(ctypes.Structure):
    """hl_place."""

    _fields_ = [
        ("position", c_double * 3),
        ("is_moved", c_bool),
        ("is_closed", c_bool),
        ("measure", c_int),
        ("value", c_double),
        ("bound", c_double),
        ("relative_minimum", c_double),
        ("present_relative_minimum", c_double),
        ("unit_exponent", c_int),
        ("round_count", c_int),
        ("hold_count", c_int),
        ("holds", _Hold * 4),
    ]


library.hl_best_place_room.restype = c_size_t
library.hl_best_place_room.argtypes = [c_size_t]
library.hl_best_place.argtypes = [POINTER(_Star), c_void_p, c_size_t, POINTER(_Place)]

_BY_VOLUME: Final = 1
_BOX_SIDE: Final = 0xFFFFFFFF
#: Half side of the box in which places are sought, in units of 2^unit_exponent.
_BOX_BITS: Final = 20
#: Points of holds are multiples of 2^-26.
_POINT_BITS: Final = 26

_Vector = tuple[int, int, int]
_Affine = tuple[_Vector, int]


@dataclass(frozen=True)
class Reason:
    """Why a point that may move and still has a cell below could not help it."""

    point: int
    #: Indices of the cells around it.
    cells: tuple[int, ...]
    #: What no place of the point gives all of them: "valid", or the "margin" that was asked for. None where neither is proved.
    forbids: Literal["valid", "margin"] | None
    #: No place where all are valid has a greater least relative minimum, but for rounding; None where no place makes them valid.
    bound: float | None
    #: The proof for `verify`, as `hexlens repair --certificates` writes it. None where nothing is proved, or where the point stays in a
    #: plane or is held by a limit: then there is a proof about those places alone.
    certificate: dict[str, Any] | None


@dataclass(frozen=True)
class Star:
    """A point that moves, and the cells around it."""

    points: NDArray[np.float64]
    cells: NDArray[np.uint32]
    point: int
    limits: Limits


def reason_of(star: Star, around: Sequence[int], margin: float, name: str, names: Sequence[str]) -> Reason:
    """`around` are the indices of the star's cells, `names` what they are called in the certificate."""
    place = _best_place(star)
    exact = _ExactStar(star, place.unit_exponent)
    proof = _prove(exact, place)
    is_by_volume = place.measure == _BY_VOLUME
    forbids: Literal["valid", "margin"] | None = None
    if proof is not None:
        forbids = ("margin" if place.bound < margin else None) if is_by_volume else ("valid" if proof.is_impossible else None)
    has_plane = any(any(normal) for normal in star.limits.normals)
    certificate = None
    if forbids is not None and proof is not None and not has_plane:
        certificate = _certificate(name, names, exact, place, proof)
    return Reason(star.point, tuple(around), forbids, place.bound if is_by_volume else None, certificate)


def _best_place(star: Star) -> _Place:
    points, cells = star.points, np.ascontiguousarray(star.cells)
    given = Cells(points.ctypes.data, points.size, cells.ctypes.data, cells.size)
    memory = np.empty(library.hl_best_place_room(len(cells)), np.uint8)
    place = _Place()
    status = library.hl_best_place(
        byref(_Star(given, None, star.point, ctypes.pointer(star.limits))), memory.ctypes.data, memory.size, byref(place)
    )
    if status != 0:
        why = STATUSES.get(status, f"the C library has answered {status}")
        raise HexlensError(f"The best place of point {star.point} is not known: {why}.")
    return place


class _ExactStar:
    """Coordinates as integers on one grid; cell by cell, and which vertices move."""

    def __init__(self, star: Star, unit_exponent: int) -> None:
        limits = star.limits
        vertices, moving = star.points[star.cells], star.cells == star.point
        ends = [[float(x) for x in side] for side in (limits.low, limits.high)]
        numbers = [Fraction(x) for x in vertices.ravel().tolist()]
        finite = [Fraction(x) for side in ends for x in side if np.isfinite(x)]
        self.scale = max(x.denominator for x in (*numbers, *finite))
        self.doubles: list[list[list[float]]] = vertices.tolist()
        self.moving: list[list[int]] = [np.flatnonzero(own).tolist() for own in moving]
        whole = [int(x * self.scale) for x in numbers]
        self.vertices = [[_vector(whole[24 * c + 3 * v : 24 * c + 3 * v + 3]) for v in range(8)] for c in range(len(vertices))]
        self.present = self.vertices[0][self.moving[0][0]]
        self.tangents = _tangents([_integers(normal) for normal in limits.normals if any(normal)])
        self.low, self.high = ([Fraction(x) * self.scale if np.isfinite(x) else None for x in side] for side in ends)
        self.half_box = Fraction(2) ** (_BOX_BITS + unit_exponent) * self.scale


def _integers(numbers: Sequence[float]) -> _Vector:
    fractions = [Fraction(x) for x in numbers]
    scale = max(x.denominator for x in fractions)
    return _vector([int(x * scale) for x in fractions])


def _vector(numbers: Sequence[int]) -> _Vector:
    x, y, z = numbers
    return x, y, z


@dataclass(frozen=True)
class _Proof:
    #: Holds of the place by index, with weights that sum to 1 over the cells.
    holds: list[tuple[int, Fraction]]
    is_impossible: bool


def _prove(star: _ExactStar, place: _Place) -> _Proof | None:
    """(R10) of docs/repair.md: the functions of some holds cancel with positive weights, and are not positive together."""
    count = place.hold_count
    is_by_volume = place.measure == _BY_VOLUME
    if count == 0:
        return _Proof([], False) if is_by_volume and place.bound >= 1 else None
    functions = [_from_present(star, _function_of(star, place, place.holds[i])) for i in range(count)]
    subsets = (sorted(combinations(range(count), size), key=lambda chosen: sum(1 << i for i in chosen)) for size in range(1, count + 1))
    for chosen in (chosen for group in subsets for chosen in group):
        weights = _cancelling([functions[i][0] for i in chosen])
        if weights is None:
            continue
        constant = sum(weight * functions[i][1] for weight, i in zip(weights, chosen, strict=True))
        if is_by_volume and constant > 0:
            continue
        total = sum(weight for weight, i in zip(weights, chosen, strict=True) if place.holds[i].cell != _BOX_SIDE)
        if total == 0:
            return None
        holds = [(i, Fraction(weight, total)) for weight, i in zip(weights, chosen, strict=True)]
        return _Proof(holds, not is_by_volume and constant <= 0)
    return None


def _from_present(star: _ExactStar, function: _Affine) -> _Affine:
    """The function of steps along the tangents from the present place."""
    gradient, constant = function
    along = [_dot(gradient, tangent) for tangent in star.tangents]
    return _vector([*along, 0, 0][:3]), constant + _dot(gradient, star.present)


def _function_of(star: _ExactStar, place: _Place, hold: _Hold) -> _Affine:
    """jacdet - bound * volume, times a factor that is the same for all; of a side the distance from it, times one of its own."""
    if hold.cell == _BOX_SIDE:
        return _distance_from_side(star, hold.point)
    jacdet = _jacdet_at(star, hold.cell, _vector([int(x * (1 << _POINT_BITS)) for x in hold.point]))
    if place.measure != _BY_VOLUME:
        return jacdet
    level = Fraction(place.bound)
    terms = [(24 * level.denominator, jacdet)]
    if not hold.is_by_sign:
        terms.append((-level.numerator, _twenty_four_volumes(star, hold.cell)))
    return _sum_of(terms)


def _distance_from_side(star: _ExactStar, normal: Sequence[float]) -> _Affine:
    """The side of the box or that of the limits, whichever is nearer."""
    gradient = _vector([-int(x) for x in normal])
    axis = next(r for r in range(3) if gradient[r] != 0)
    slope = gradient[axis]
    constant = star.half_box - slope * star.present[axis]
    limit = (star.high if slope < 0 else star.low)[axis]
    if limit is not None:
        constant = min(constant, -slope * limit)
    return _vector([x * constant.denominator for x in gradient]), constant.numerator


def _jacdet_at(star: _ExactStar, cell: int, point: _Vector) -> _Affine:
    """By columns u + alpha p and so on, (R1) of docs/repair.md; the point is over 2^26."""
    vertices, moving = star.vertices[cell], star.moving[cell]
    columns: list[tuple[int, _Vector]] = []
    for direction in range(3):
        factor, column = 0, [0, 0, 0]
        for v in range(8):
            slope = _slope_of(v, direction, point)
            if v in moving:
                factor += slope
                continue
            for r in range(3):
                column[r] += slope * vertices[v][r]
        columns.append((factor, _vector(column)))
    (alpha, u), (beta, v_), (gamma, w) = columns
    crosses = _cross(v_, w), _cross(w, u), _cross(u, v_)
    gradient = _vector([alpha * crosses[0][r] + beta * crosses[1][r] + gamma * crosses[2][r] for r in range(3)])
    return gradient, _dot(u, crosses[0])


def _slope_of(v: int, direction: int, point: _Vector) -> int:
    """The derivative of a vertex's trilinear function, times 2^52."""
    one = 1 << _POINT_BITS
    product = 1
    for axis in range(3):
        side = REFERENCE[v][axis]
        if axis == direction:
            product *= 1 if side else -1
        else:
            product *= point[axis] if side else one - point[axis]
    return product


def _twenty_four_volumes(star: _ExactStar, cell: int) -> _Affine:
    """A sixth of jacdet in the middles of the edges less an eighth of that at the vertices, (R2) of docs/repair.md."""

    def at(halves: Sequence[int]) -> _Affine:
        return _jacdet_at(star, cell, _vector([x << (_POINT_BITS - 1) for x in halves]))

    middles = [(4, at([x + y for x, y in zip(REFERENCE[a], REFERENCE[b], strict=True)])) for a, b in EDGES]
    return _sum_of([*middles, *((-3, at([2 * x for x in corner])) for corner in REFERENCE)])


def _sum_of(terms: Sequence[tuple[int, _Affine]]) -> _Affine:
    gradient = _vector([sum(factor * function[0][r] for factor, function in terms) for r in range(3)])
    return gradient, sum(factor * function[1] for factor, function in terms)


def _dot(a: _Vector, b: _Vector) -> int:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def _cross(a: _Vector, b: _Vector) -> _Vector:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


_AXES: Final[tuple[_Vector, ...]] = ((1, 0, 0), (0, 1, 0), (0, 0, 1))


def _tangents(normals: Sequence[_Vector]) -> tuple[_Vector, ...]:
    """What is at right angles to the normals, none to two of them."""
    if not normals:
        return _AXES
    if len(normals) == 2:
        return (_cross(*normals),)
    first = next(tangent for tangent in (_cross(axis, normals[0]) for axis in _AXES) if any(tangent))
    return first, _cross(normals[0], first)


def _cancelling(vectors: Sequence[_Vector]) -> list[int] | None:
    """Positive integers whose combination of the vectors is 0, if these have one dimension less than their number."""
    weights = _dependency(vectors)
    if weights is None or all(weight > 0 for weight in weights):
        return weights
    return [-weight for weight in weights] if all(weight < 0 for weight in weights) else None


def _dependency(vectors: Sequence[_Vector]) -> list[int] | None:
    """By Cramer's rule on what does not vanish: for one to four vectors."""
    if len(vectors) == 1:
        return None if any(vectors[0]) else [1]
    if len(vectors) == 2:
        a, b = vectors
        axis = next((r for r in range(3) if a[r] != 0), None)
        return None if axis is None or any(_cross(a, b)) else [b[axis], -a[axis]]
    if len(vectors) == 3:
        a, b, c = vectors
        if _dot(a, _cross(b, c)) != 0:
            return None
        normals = _cross(b, c), _cross(c, a), _cross(a, b)
        axis = next((r for r in range(3) if any(normal[r] for normal in normals)), None)
        return None if axis is None else [normal[axis] for normal in normals]
    a, b, c, d = vectors
    weights = [_dot(b, _cross(c, d)), -_dot(a, _cross(c, d)), _dot(a, _cross(b, d)), -_dot(a, _cross(b, c))]
    return weights if any(weights) else None


def _certificate(name: str, names: Sequence[str], star: _ExactStar, place: _Place, proof: _Proof) -> dict[str, Any] | None:
    """An entry of docs/certificates.md, section 5: only cells that hold the vertex are in it. None where a side is among the holds."""
    holds = [(place.holds[i], weight) for i, weight in proof.holds]
    if any(hold.cell == _BOX_SIDE for hold, _ in holds):
        return None
    used = sorted({hold.cell for hold, _ in holds}) if holds else list(range(len(names)))
    level = Fraction(0) if place.measure != _BY_VOLUME else Fraction(place.bound) if holds else Fraction(1)
    return {
        "name": name,
        "cells": [{"name": names[c], "vertices": star.doubles[c], "moving": star.moving[c]} for c in used],
        "level": str(level),
        "holds": [
            {
                "cell": used.index(hold.cell),
                "point": [str(Fraction(x)) for x in hold.point],
                "weight": str(weight),
                **({"bySign": True} if hold.is_by_sign else {}),
            }
            for hold, weight in holds
        ],
    }
