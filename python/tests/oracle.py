"""Whether jacdet is positive on the six faces, from its definition and in fractions: nothing of the package is used.

On a face jacdet is biquadratic. Where all nine Bernstein coefficients are positive, it is positive; where one at a corner, which is a
value, is not, it is not; any other square is quartered. This ends unless the least value is 0 and at no dyadic point.
"""

from collections.abc import Sequence
from fractions import Fraction
from math import lcm

Row = tuple[int, int, int]
CORNERS = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))
#: More than elements of doubles take that do not touch 0.
MOST_SQUARES = 1_000_000


def is_positive_on_faces(vertices: Sequence[Sequence[float]]) -> bool:
    """An AssertionError where it cannot say."""
    axes = [in_whole_numbers([Fraction(vertex[axis]) for vertex in vertices]) for axis in range(3)]
    return all(is_positive_on(face_coefficients(axes, axis, side)) for axis in range(3) for side in (0, 2))


def in_whole_numbers(values: list[Fraction]) -> list[int]:
    """Times a positive number, which changes no sign of jacdet."""
    unit = lcm(*(value.denominator for value in values))
    return [int(value * unit) for value in values]


def jacdet(axes: list[list[int]], doubled: Sequence[int]) -> int:
    """64 times jacdet at a point whose coordinates are 0, 1 or 2 halves."""

    def slope(xs: list[int], along: int) -> int:
        total = 0
        for x, corner in zip(xs, CORNERS, strict=True):
            weight = 1 if corner[along] else -1
            for axis in range(3):
                if axis != along:
                    weight *= doubled[axis] if corner[axis] else 2 - doubled[axis]
            total += weight * x
        return total

    a, b, c = ([slope(xs, along) for along in range(3)] for xs in axes)
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])


def face_coefficients(axes: list[list[int]], axis: int, side: int) -> list[Row]:
    """The nine Bernstein coefficients on a face, times a positive number, from nine values."""
    rows = []
    for s in range(3):
        values = []
        for t in range(3):
            point = [s, t]
            point.insert(axis, side)
            values.append(jacdet(axes, point))
        rows.append(interpolated(*values))
    return list(zip(*(interpolated(*column) for column in zip(*rows, strict=True)), strict=True))


def interpolated(start: int, middle: int, end: int) -> Row:
    """Twice the Bernstein coefficients of the quadratic with these values at 0, 1/2 and 1."""
    return 2 * start, 4 * middle - start - end, 2 * end


def is_positive_on(square: list[Row]) -> bool:
    squares = [square]
    for _ in range(MOST_SQUARES):
        if not squares:
            return True
        rows = squares.pop()
        if min(map(min, rows)) > 0:
            continue
        if min(rows[0][0], rows[0][2], rows[2][0], rows[2][2]) <= 0:
            return False
        for part in zip(*(halves(row) for row in rows), strict=True):
            columns = [halves(column) for column in zip(*part, strict=True)]
            squares += [list(zip(*(pair[half] for pair in columns), strict=True)) for half in (0, 1)]
    raise AssertionError("The least value may be 0.")


def halves(q: Row) -> tuple[Row, Row]:
    """The coefficients on both halves, times 4."""
    middle = q[0] + 2 * q[1] + q[2]
    return (4 * q[0], 2 * (q[0] + q[1]), middle), (middle, 2 * (q[1] + q[2]), 4 * q[2])
