"""Proofs that jacdet is positive, or is not, as `hexlens certify` writes them: docs/certificates.md. Of an invalid element a
rational point with jacdet <= 0; of a valid one intervals on which a condition with few signs holds. The same steps as in
web/core/exact, so that the proofs are the same; all in integers."""

import contextlib
import sys
from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import reduce
from typing import Any, Final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import HexlensError, vertices_of
from ._polynomials import (
    Dyadic,
    Polynomial,
    add,
    common_divisor,
    derivative,
    is_negative_beside,
    midpoint,
    multiply,
    points_between,
    refined_to,
    roots_in_unit_interval,
    sign,
    sign_at,
    sign_at_root,
    square_free,
    trimmed,
)
from ._report import not_finite

__all__ = ["EDGES", "FACES", "REFERENCE", "certify", "verify"]

REFERENCE: Final = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))
EDGES: Final = ((0, 1), (1, 2), (3, 2), (0, 3), (4, 5), (5, 6), (7, 6), (4, 7), (0, 4), (1, 5), (3, 7), (2, 6))
#: Axis, side, and the axes of s and t.
FACES: Final = ((0, 0, 1, 2), (0, 1, 1, 2), (1, 0, 0, 2), (1, 1, 0, 2), (2, 0, 0, 1), (2, 1, 0, 1))
THEOREM: Final = (
    "If jacdet > 0 on the six faces then jacdet > 0 on the whole element "
    "(Knupp's conjecture, proved: P. Zhang, Validating Hexahedra through their Boundaries)."
)

Point = tuple[Fraction, Fraction, Fraction]
_Integers = tuple[int, int, int]


class _Jacdet:
    """Four times jacdet's 27 Bernstein coefficients, over a power of two; the cube's centre is left 0."""

    def __init__(self, vertices: NDArray[np.float64]) -> None:
        axes = [[Fraction(float(x)) for x in vertices[:, axis]] for axis in range(3)]
        self.units = [reduce(max, (x.denominator for x in xs)) for xs in axes]
        points = [tuple(int(xs[v] * unit) for xs, unit in zip(axes, self.units, strict=True)) for v in range(8)]
        along = {(REFERENCE[a], REFERENCE[b]): tuple(q - p for p, q in zip(points[a], points[b], strict=True)) for a, b in EDGES}

        def edge(axis: int, first: int, second: int) -> _Integers:
            low = [first, second]
            low.insert(axis, 0)
            high = [first, second]
            high.insert(axis, 1)
            return along[(tuple(low), tuple(high))]  # type: ignore[index,return-value]

        self.bernstein = [0] * 27
        add_to = self._add
        for i in (0, 1):
            for j in (0, 1):
                for k in (0, 1):
                    normal = _cross(edge(0, j, k), edge(1, i, k))
                    add_to(2 * i, 2 * j, 2 * k, 4 * _dot(normal, edge(2, i, j)))
                    add_to(1, 2 * j, 2 * k, 2 * _dot(normal, edge(2, 1 - i, j)))
                    add_to(2 * i, 1, 2 * k, 2 * _dot(normal, edge(2, i, 1 - j)))
                for k in (0, 1):
                    normal = _cross(edge(0, j, k), edge(1, i, 1 - k))
                    add_to(2 * i, 2 * j, 1, 2 * _dot(normal, edge(2, i, j)))
        for face in range(6):
            nine = [self.bernstein[index] for index in _FACE_INDICES[face]]
            middle = (2 * (nine[1] + nine[3] + nine[5] + nine[7]) - (nine[0] + nine[2] + nine[6] + nine[8])) // 4
            self.bernstein[_FACE_INDICES[face][4]] = middle

    def _add(self, i: int, j: int, k: int, value: int) -> None:
        self.bernstein[9 * i + 3 * j + k] += value

    def vertex(self, vertex: int) -> int:
        i, j, k = REFERENCE[vertex]
        return self.bernstein[18 * i + 6 * j + 2 * k]

    def edge(self, edge: int) -> _Integers:
        low, high = (REFERENCE[v] for v in EDGES[edge])
        a, b = (18 * i + 6 * j + 2 * k for i, j, k in (low, high))
        return self.bernstein[a], self.bernstein[(a + b) // 2], self.bernstein[b]

    def face(self, face: int) -> list[int]:
        return [self.bernstein[index] for index in _FACE_INDICES[face]]

    def at(self, point: Point) -> Fraction:
        """Four times jacdet at a point of the boundary, over the power of two."""
        weights = [((1 - x) ** 2, 2 * x * (1 - x), x * x) for x in point]
        return sum(
            (c * weights[0][n // 9] * weights[1][n // 3 % 3] * weights[2][n % 3] for n, c in enumerate(self.bernstein)),
            Fraction(0),
        )

    def jacdet(self, point: Point) -> Fraction:
        return self.at(point) / (4 * self.units[0] * self.units[1] * self.units[2])


def _face_indices(axis: int, side: int, s: int, t: int) -> tuple[int, ...]:
    strides = (9, 3, 1)
    return tuple(2 * side * strides[axis] + i * strides[s] + j * strides[t] for i in range(3) for j in range(3))


_FACE_INDICES: Final = [_face_indices(*face) for face in FACES]


def _cross(a: _Integers, b: _Integers) -> _Integers:
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def _dot(a: _Integers, b: _Integers) -> int:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


class _Parabolas:
    """A face's parabolas in s, as polynomials in t: f = a s^2 + 2B s + c with N = a + B, and d = ac - B^2."""

    def __init__(self, beta: Sequence[int]) -> None:
        rows = [beta[3 * i : 3 * i + 3] for i in range(3)]
        self.b = _from_bernstein([y - x for x, y in zip(rows[0], rows[1], strict=True)])
        self.n = _from_bernstein([y - x for x, y in zip(rows[1], rows[2], strict=True)])
        self.c = _from_bernstein(rows[0])
        self.a = add(self.n, self.b, -1)
        self.d = add(multiply(self.a, self.c), multiply(self.b, self.b), -1)


def _from_bernstein(q: Sequence[int]) -> Polynomial:
    return trimmed((q[0], 2 * (q[1] - q[0]), q[0] - 2 * q[1] + q[2]))


def _boundary_sign(jacdet: _Jacdet) -> int:
    """-1, 0 or 1: some jacdet on the boundary is negative; none is, but one is zero; all are positive."""
    least = 1
    for now in _entity_signs(jacdet):
        if now < 0:
            return -1
        least = min(least, now)
    return least


def _entity_signs(jacdet: _Jacdet) -> Iterator[int]:
    for vertex in range(8):
        yield sign(jacdet.vertex(vertex))
    for edge in range(12):
        q0, q1, q2 = jacdet.edge(edge)
        yield sign(q0 * q2 - q1 * q1) if q1 < 0 else 1
    for face in range(6):
        yield _face_sign(jacdet.face(face))


def _face_sign(beta: Sequence[int]) -> int:
    """The sign of the least value strictly inside a face whose edges are not negative; 1 where the edges are lower or equal.

    A value below both ends of its parabola lies at the parabola's vertex, inside where B < 0 < N, and is d/a there. So the
    set {B < 0 < N} is searched for d < 0 and d = 0: at one point of each of its intervals, and at the roots of d in it.
    """
    if all(coefficient > 0 for coefficient in beta):
        return 1
    parabolas = _Parabolas(beta)
    b, n, d = parabolas.b, parabolas.n, parabolas.d
    ends = square_free(multiply(b, n))
    if not ends:
        return 1
    least = 1
    for point in points_between(ends, roots_in_unit_interval(ends)):
        if sign_at(b, point) < 0 < sign_at(n, point):
            least = min(least, sign_at(d, point))
    if least < 0:
        return -1
    simple = square_free(d)
    for root in roots_in_unit_interval(simple):
        if sign_at_root(b, simple, root) >= 0 or sign_at_root(n, simple, root) <= 0:
            continue
        if is_negative_beside(d, root):
            return -1
        least = 0
    return least


def _witness(jacdet: _Jacdet, least: int) -> Point:
    """A point where jacdet has the sign of the boundary minimum: a vertex if one has it, else on an edge, else on a face."""
    found = _least_vertex(jacdet, least) or _least_on_edges(jacdet, least)
    if found:
        return _simplest(jacdet, found) if least < 0 else found
    return _simplest(jacdet, _least_on_faces(jacdet)) if least < 0 else _touched_on_faces(jacdet)


def _simplest(jacdet: _Jacdet, point: Point) -> Point:
    """The point with its coordinates rounded to as few bits as leave jacdet negative, as it is at the point itself."""
    for bits in _precisions():
        x, y, z = (_rounded(bits, coordinate) for coordinate in point)
        if jacdet.at((x, y, z)) < 0:
            return x, y, z
    raise AssertionError("jacdet is continuous.")


def _precisions() -> Iterator[int]:
    """1, 2, 3, 4, 6, 8, 12, 16, 24 and on."""
    yield 1
    bits = 2
    while True:
        yield bits
        yield bits + bits // 2
        bits *= 2


def _rounded(bits: int, x: Fraction) -> Fraction:
    return Fraction(((x.numerator << (bits + 1)) + x.denominator) // (2 * x.denominator), 1 << bits)


def _least_vertex(jacdet: _Jacdet, least: int) -> Point | None:
    values = [jacdet.vertex(vertex) for vertex in range(8)]
    if sign(min(values)) != least:
        return None
    x, y, z = REFERENCE[values.index(min(values))]
    return Fraction(x), Fraction(y), Fraction(z)


def _least_on_edges(jacdet: _Jacdet, least: int) -> Point | None:
    """The least of the edges' candidates (9), at a rational point."""
    best: tuple[Fraction, Point] | None = None
    for edge, (start, end) in enumerate(EDGES):
        q0, q1, q2 = jacdet.edge(edge)
        numerator = q0 * q2 - q1 * q1
        if q1 >= q0 or q1 >= q2 or sign(numerator) != least:
            continue
        denominator = q0 - 2 * q1 + q2
        r = Fraction(q0 - q1, denominator)
        x, y, z = (Fraction(a) if a == b else r for a, b in zip(REFERENCE[start], REFERENCE[end], strict=True))
        value = Fraction(numerator, denominator)
        if best is None or value < best[0]:
            best = value, (x, y, z)
    return best and best[1]


def _least_on_faces(jacdet: _Jacdet) -> Point:
    """The least value near the roots of P (12), if a face is negative, but no vertex and no edge."""
    roots = []
    for face in range(6):
        parabolas = _Parabolas(jacdet.face(face))
        a, b = parabolas.a, parabolas.b
        g = add(multiply(a, derivative(parabolas.c)), multiply(derivative(b), b), -2)
        quartic = square_free(add(multiply(a, g), multiply(derivative(a), multiply(b, b))))
        roots += [
            (face, parabolas, quartic, root)
            for root in roots_in_unit_interval(quartic)
            if sign_at_root(b, quartic, root) < 0 < sign_at_root(parabolas.n, quartic, root)
        ]
    bits = 64
    while True:
        best: tuple[Fraction, Point] | None = None
        for face, parabolas, quartic, root in roots:
            low, high = refined_to(quartic, root, bits)
            middle = low if low == high else midpoint(low, high)
            point = _at_parabola_vertex(face, parabolas, _fraction(middle))
            if point is None:
                continue
            value = jacdet.at(point)
            if best is None or value < best[0]:
                best = value, point
        if best is not None and best[0] < 0:
            return best[1]
        bits *= 2


def _fraction(at: Dyadic) -> Fraction:
    return Fraction(at.numerator, 1 << at.shift)


def _touched_on_faces(jacdet: _Jacdet) -> Point:
    """The zero at the one root of gcd(D, D'), if only faces attain it: docs/certificates.md (C8)."""
    for face in range(6):
        parabolas = _Parabolas(jacdet.face(face))
        t = _root_of_linear(common_divisor(parabolas.d, derivative(parabolas.d)))
        point = None if t is None else _at_parabola_vertex(face, parabolas, t)
        if point:
            return point
    raise AssertionError("A least value of zero is attained.")


def _root_of_linear(p: Polynomial) -> Fraction | None:
    """The root if it is in (0,1)."""
    if len(p) != 2:
        return None
    t = Fraction(-p[0], p[1])
    return t if 0 < t < 1 else None


def _at_parabola_vertex(face: int, parabolas: _Parabolas, t: Fraction) -> Point | None:
    """(s*(t), t) on the face, s* = -B/a; None unless it is strictly inside."""
    b, n = (sum((a * t**i for i, a in enumerate(p)), Fraction(0)) for p in (parabolas.b, parabolas.n))
    if b >= 0 or n <= 0:
        return None
    _, side, s_axis, t_axis = FACES[face]
    point = [Fraction(side)] * 3
    point[s_axis] = b / (b - n)
    point[t_axis] = t
    x, y, z = point
    return x, y, z


def _certified_intervals(beta: Sequence[int]) -> list[tuple[Fraction, Fraction, str]]:
    """[0,1] bisected until a condition holds on each subinterval. By docs/certificates.md (C7) this ends on a positive face."""
    rows = [tuple(beta[3 * i : 3 * i + 3]) for i in range(3)]
    # A list, not a recursion: subintervals can be smaller than a stack is deep. The lowest is its last.
    subintervals = [(Fraction(0), Fraction(1), rows)]
    intervals = []
    while subintervals:
        start, end, rows = subintervals.pop()
        by = _condition_on(rows)
        if by:
            intervals.append((start, end, by))
            continue
        middle = (start + end) / 2
        halves = [_halved(row) for row in rows]
        subintervals += [(middle, end, [half[1] for half in halves]), (start, middle, [half[0] for half in halves])]
    return intervals


def _condition_on(rows: Sequence[Sequence[int]]) -> str | None:
    """The first of (C4), (C5), (C3) and (C6) that shows in the signs of Bernstein coefficients: simple reasons first."""
    c, middle, end = rows
    if min(c) <= 0 or min(end) <= 0:
        return None
    if all(m >= x for m, x in zip(middle, c, strict=True)):
        return "b"
    if all(m >= x for m, x in zip(middle, end, strict=True)):
        return "2a+b"
    if min(middle) > 0:
        return "middle"
    b = [m - x for m, x in zip(middle, c, strict=True)]
    a = [e - m - x for e, m, x in zip(end, middle, b, strict=True)]
    return "D" if all(x > y for x, y in zip(_times(a, c), _times(b, b), strict=True)) else None


def _times(x: Sequence[int], y: Sequence[int]) -> list[int]:
    """The product's five Bernstein coefficients, the m-th times C(4,m): docs/algorithm.md (13)."""
    return [
        x[0] * y[0],
        2 * (x[0] * y[1] + x[1] * y[0]),
        x[0] * y[2] + 4 * x[1] * y[1] + x[2] * y[0],
        2 * (x[1] * y[2] + x[2] * y[1]),
        x[2] * y[2],
    ]


def _halved(q: Sequence[int]) -> tuple[tuple[int, int, int], tuple[int, int, int]]:
    """De Casteljau's scheme at 1/2, everything times 4."""
    middle = q[0] + 2 * q[1] + q[2]
    return (4 * q[0], 2 * (q[0] + q[1]), middle), (middle, 2 * (q[1] + q[2]), 4 * q[2])


def certify(vertices: ArrayLike, name: str = "") -> dict[str, Any]:
    """A proof of the verdict on one hexahedron, 8 x 3 coordinates, as an entry of what `hexlens certify` writes.

    docs/certificates.md says what it holds, `json.dump([proof], file)` writes it, and `verify` checks it. It always ends, however
    near the border the element is. HexlensError for a coordinate that is not finite.
    """
    array = vertices_of(vertices)
    if not np.isfinite(array).all():
        raise HexlensError(not_finite(array))
    with _long_integers():
        jacdet = _Jacdet(array)
        least = _boundary_sign(jacdet)
        entry: dict[str, Any] = {"name": name, "vertices": array.tolist(), "valid": least > 0}
        if least <= 0:
            point = _witness(jacdet, least)
            return {**entry, "point": [str(x) for x in point], "jacdet": str(jacdet.jacdet(point))}
        faces = [
            [{"t": [str(start), str(end)], "by": by} for start, end, by in _certified_intervals(jacdet.face(face))] for face in range(6)
        ]
        return {**entry, "theorem": THEOREM, "faces": faces}


def verify(certificate: Mapping[str, Any] | Iterable[Mapping[str, Any]], vertices: ArrayLike | None = None) -> None:
    """Checks a proof, or a list of them, from the definitions: in fractions, without the C library and without what made it.

    It is tests/certificates/check_certificates.py, which may be read on one page. HexlensError says why a proof does not hold;
    that says nothing about its element. With `vertices`, the proof must be about these very doubles (0 and -0 are the same).
    """
    from . import _checker

    entries = [certificate] if isinstance(certificate, Mapping) else list(certificate)
    if vertices is not None and len(entries) != 1:
        raise HexlensError("vertices belong to one proof; several were given.")
    with _long_integers():
        for i, entry in enumerate(entries):
            try:
                _checker.check(_with_doubles(entry))
                if vertices is not None:
                    _checker.require("vertices" in entry, "it is about several elements")
                    _checker.require(vertices_of(vertices).tolist() == _with_doubles(entry)["vertices"], "it is about other vertices")
            except ValueError as why:
                place = "" if len(entries) == 1 else f" {i}"
                raise HexlensError(f"The certificate{place} ({entry.get('name', '')}) is refused: {why}.") from None


def _with_doubles(entry: Mapping[str, Any]) -> dict[str, Any]:
    """An entry as the checker reads it from JSON, where every number is a double."""
    own = dict(entry)
    points = own.get("vertices")
    if isinstance(points, list) and all(isinstance(point, list) for point in points):
        own["vertices"] = [[float(x) if type(x) is int else x for x in point] for point in points]
    cells = own.get("cells")
    if isinstance(cells, list) and all(isinstance(cell, Mapping) for cell in cells):
        own["cells"] = [_with_doubles(cell) for cell in cells]
    return own


@contextlib.contextmanager
def _long_integers() -> Iterator[None]:
    """Integers are written and read however long they are: where exponents are far apart they have thousands of digits."""
    get, put = (getattr(sys, name, None) for name in ("get_int_max_str_digits", "set_int_max_str_digits"))
    if get is None or put is None:
        yield
        return
    before = get()
    put(0)
    try:
        yield
    finally:
        put(before)
