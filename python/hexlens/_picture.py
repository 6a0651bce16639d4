"""A still drawing of a hexahedron as SVG, for where no script runs: its faces by the sign of jacdet at their vertices, its edges,
its vertices by number, and a ring at the minimizer."""

from collections.abc import Callable
from typing import Final

import numpy as np
from numpy.typing import NDArray

from ._certificates import EDGES, FACES, REFERENCE
from ._numbers import speak_jacdet
from ._report import Report

__all__ = ["picture"]

_SIDE, _MARGIN = 220.0, 22.0
#: From where it is seen: x to the right, a little towards the eye; z up.
_RIGHT: Final = np.array([0.9, 0.44, 0.0])
_UP: Final = np.array([-0.17, 0.35, 0.92])
_TOWARDS: Final = np.cross(_RIGHT, _UP)
#: Pieces of a side of a face: its edges are straight, and what is between them is not flat.
_TILES: Final = 8
_POSITIVE, _NEGATIVE = "#6b9bd1", "#d1495b"


def picture(report: Report) -> str:
    """Colours are right on light and on dark paper; what is negative has stripes, too."""
    vertices = np.array(report.vertices)
    spread = np.ptp(vertices, axis=0).max() or 1.0
    world = (vertices - (vertices.min(axis=0) + vertices.max(axis=0)) / 2) / spread
    flat = world @ np.stack([_RIGHT, -_UP], axis=1)
    size = np.ptp(flat, axis=0).max() or 1.0
    middle = (flat.min(axis=0) + flat.max(axis=0)) / 2

    def place(points: NDArray[np.float64]) -> NDArray[np.float64]:
        seen: NDArray[np.float64] = (points @ np.stack([_RIGHT, -_UP], axis=1) - middle) * ((_SIDE - 2 * _MARGIN) / size) + _SIDE / 2
        return seen

    at = place(world)
    ring = place((np.array([report.minimizer.position]) - (vertices.min(axis=0) + vertices.max(axis=0)) / 2) / spread)[0]
    verdict = "Valid" if report.valid else "Invalid"
    least = speak_jacdet(report.minimizer.value, report.exponent)
    name = f"{verdict} hexahedron, least jacdet {least} at {report.minimizer.kind} {report.minimizer.id}"
    lines = "".join(f'<path d="M{at[a][0]:.1f} {at[a][1]:.1f}L{at[b][0]:.1f} {at[b][1]:.1f}"/>' for a, b in EDGES)
    numbers = "".join(
        f'<circle cx="{x:.1f}" cy="{y:.1f}" r="2.5" fill="currentColor" stroke="none"/>'
        f'<text x="{x + 5:.1f}" y="{y - 5:.1f}" fill="currentColor" stroke="none" font-size="12">{v}</text>'
        for v, (x, y) in enumerate(at.tolist())
    )
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {_SIDE:g} {_SIDE:g}" width="{_SIDE:g}" height="{_SIDE:g}" role="img" '
        f'aria-label="{name}"><title>{name}</title>{_tiles(report, world, place)}'
        f'<g fill="none" stroke="currentColor" stroke-width="1.2">{lines}{numbers}'
        f'<circle cx="{ring[0]:.1f}" cy="{ring[1]:.1f}" r="7" stroke-width="2"/></g></svg>'
    )


def _tiles(report: Report, world: NDArray[np.float64], place: Callable[[NDArray[np.float64]], NDArray[np.float64]]) -> str:
    """The tiles of the six faces, from the farthest to the nearest."""
    steps = np.linspace(0, 1, _TILES + 1)
    tiles: list[tuple[float, str]] = []
    for number, (axis, side, s_axis, t_axis) in enumerate(FACES):
        grid = np.empty((_TILES + 1, _TILES + 1, 3))
        grid[..., axis], grid[..., s_axis], grid[..., t_axis] = side, steps[:, None], steps[None, :]
        points = np.einsum("ijv,vc->ijc", _weights(grid), world)
        seen = place(points.reshape(-1, 3)).reshape(_TILES + 1, _TILES + 1, 2)
        half = (steps[:-1] + steps[1:]) / 2
        values = np.einsum("ia,jb,ab->ij", _quadratic(half), _quadratic(half), np.array(report.faces[number].bernstein).reshape(3, 3))
        for i in range(_TILES):
            for j in range(_TILES):
                depth = float((points[i, j] + points[i + 1, j + 1]) @ _TOWARDS)
                corners = (seen[i, j], seen[i + 1, j], seen[i + 1, j + 1], seen[i, j + 1])
                path = "L".join(f"{x:.1f} {y:.1f}" for x, y in corners)
                is_negative = values[i, j] <= 0
                colour = _NEGATIVE if is_negative else _POSITIVE
                stripe = f'<path d="M{path.split("L")[0]}L{path.split("L")[2]}" stroke="#fff" stroke-opacity=".7"/>' if is_negative else ""
                tiles.append((depth, f'<path d="M{path}Z" fill="{colour}" fill-opacity=".55"/>{stripe}'))
    return "".join(tile for _, tile in sorted(tiles, key=lambda entry: entry[0]))


def _weights(grid: NDArray[np.float64]) -> NDArray[np.float64]:
    corners = np.array(REFERENCE, dtype=np.float64)
    weights: NDArray[np.float64] = np.prod(np.where(corners == 1, grid[..., None, :], 1 - grid[..., None, :]), axis=-1)
    return weights


def _quadratic(x: NDArray[np.float64]) -> NDArray[np.float64]:
    """Bernstein polynomials."""
    return np.stack([(1 - x) ** 2, 2 * x * (1 - x), x * x], axis=1)
