"""Points and cells as the C library takes them: as they are where that is possible, else a copy that changes no number."""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["HexlensError", "cells_of", "elements_of", "is_32_bit", "narrowed", "points_of", "vertices_of"]

#: Indices of 32 bits may have a sign.
MOST_POINTS = 2**31 - 1
#: No point has it: what an index that is out of range becomes in 32 bits.
NO_POINT = 2**32 - 1


class HexlensError(ValueError):
    """Input that hexlens cannot answer; its text is a sentence for people."""


def _array(name: str, value: ArrayLike) -> NDArray[Any]:
    if isinstance(value, np.ma.MaskedArray) and np.ma.is_masked(value):
        raise HexlensError(f"{name} are masked: fill or leave out what is masked first.")
    try:
        array = np.asarray(value)
    except (TypeError, ValueError) as error:
        raise HexlensError(f"{name} are no array of numbers: {error}.") from None
    if array.dtype.kind not in "fiu":
        raise HexlensError(f"{name} are of type {array.dtype}, which is not that of real numbers.")
    return array


def _doubles(name: str, array: NDArray[Any]) -> NDArray[np.float64]:
    if array.dtype == np.float64 and array.flags.c_contiguous and array.flags.aligned:
        return array
    doubles = np.ascontiguousarray(array, dtype=np.float64)
    is_wider = array.dtype.itemsize > 8 or (array.dtype.kind in "iu" and array.dtype.itemsize == 8)
    if is_wider and not _is_same(array, doubles):
        raise HexlensError(f"{name} of type {array.dtype} hold numbers that are no doubles: round them yourself.")
    return doubles


def _is_same(array: NDArray[Any], doubles: NDArray[np.float64]) -> bool:
    if array.dtype.kind in "iu":
        # From 2^63 on a double may be no integer of the type any more.
        limit = 2.0**63 if array.dtype.kind == "i" else 2.0**64
        return bool((doubles < limit).all() and (doubles.astype(array.dtype) == array).all())
    return bool(((doubles.astype(array.dtype) == array) | np.isnan(array)).all())


def points_of(value: ArrayLike) -> NDArray[np.float64]:
    """n x 3 doubles."""
    array = _array("The points", value)
    if array.ndim != 2 or array.shape[1] != 3:
        if array.ndim == 2 and array.shape[1] == 2:
            raise HexlensError("The points have two coordinates: a mesh of hexahedra has three.")
        raise HexlensError(f"The points have the shape {_shape(array)}; n x 3 is expected.")
    if array.shape[0] > MOST_POINTS:
        raise HexlensError(f"There are {array.shape[0]} points; at most 2^31 - 1 are taken at once: take the mesh in pieces.")
    return _doubles("The points", array)


def elements_of(value: ArrayLike) -> NDArray[np.float64]:
    """n x 8 x 3 doubles, each cell with its own."""
    array = _array("The points", value)
    if array.shape[1:] not in ((8, 3), (24,)):
        raise HexlensError(
            f"Without cells, the points are n x 8 x 3 coordinates, eight points a hexahedron; they have the shape {_shape(array)}."
        )
    return _doubles("The points", array).reshape(-1, 8, 3)


def vertices_of(value: ArrayLike) -> NDArray[np.float64]:
    """The 8 x 3 doubles of one hexahedron."""
    array = _array("The vertices", value)
    if array.shape not in ((8, 3), (24,)):
        raise HexlensError(f"A hexahedron has 8 x 3 coordinates; these have the shape {_shape(array)}.")
    return _doubles("The vertices", array).reshape(8, 3)


def cells_of(value: ArrayLike) -> NDArray[Any]:
    """n x 8 integers of any size, as they are."""
    array = np.asarray(value)
    if array.size == 0 and array.ndim <= 2 and array.dtype.kind == "f" and not isinstance(value, np.ndarray):
        array = array.astype(np.int64)
    if isinstance(value, np.ma.MaskedArray) and np.ma.is_masked(value):
        raise HexlensError("The cells are masked: leave out what is masked first.")
    if array.dtype.kind not in "iu":
        raise HexlensError(f"The cells are of type {array.dtype}; they are indices of points, whole numbers.")
    if array.shape == (0,):
        array = array.reshape(0, 8)
    if array.ndim != 2 or array.shape[1] != 8:
        raise HexlensError(f"The cells have the shape {_shape(array)}; n x 8 is expected, the points of each hexahedron.")
    return array


def is_32_bit(cells: NDArray[Any]) -> bool:
    """True if the C library can read them where they are."""
    return bool(cells.dtype.itemsize == 4 and cells.dtype.isnative and cells.flags.c_contiguous and cells.flags.aligned)


def narrowed(cells: NDArray[Any], point_count: int, room: NDArray[np.uint32]) -> NDArray[np.uint32]:
    """The cells in 32 bits: as they are if that is what they have, else in `room`. An index out of range stays out of range."""
    if is_32_bit(cells):
        # A negative one becomes 2^31 or more, which no point is.
        return cells.view(np.uint32)
    own = room[: cells.shape[0]]
    if cells.dtype.itemsize < 8:
        np.copyto(own, cells, casting="unsafe")
        return own
    flat = cells if cells.flags.c_contiguous and cells.dtype.isnative else np.ascontiguousarray(cells, cells.dtype.newbyteorder("="))
    # Negative ones are the greatest here.
    unsigned = flat.view(np.uint64)
    if unsigned.size == 0 or unsigned.max() < point_count:
        np.copyto(own, unsigned, casting="unsafe")
    else:
        np.copyto(own, np.where(unsigned < point_count, unsigned, NO_POINT), casting="unsafe")
    return own


def _shape(array: NDArray[Any]) -> str:
    return " x ".join(map(str, array.shape)) or "of a single number"
