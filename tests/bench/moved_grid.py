"""What the peers of npm run bench -- repair share: the grid on standard input, as tests/bench/untangle.c writes it, and the verdicts of the
library (argument 1) on what became of it."""

import ctypes
import struct
import sys

import numpy as np


def read():
    """Points and cells."""
    data = sys.stdin.buffer.read()
    point_count, cell_count = struct.unpack_from("<QQ", data)
    points = np.frombuffer(data, "<f8", 3 * point_count, 16).reshape(-1, 3)
    return points, np.frombuffer(data, "<u4", 8 * cell_count, 16 + points.nbytes).reshape(-1, 8)


class Minimum(ctypes.Structure):
    """hl_minimum: kind, id, point, position, value; exponent; is_exact."""

    _fields_ = [("head", ctypes.c_int * 2), ("place", ctypes.c_double * 6), ("value", ctypes.c_double), ("tail", ctypes.c_int * 2)]


def print_result(name, seconds, points, moved, cells):
    minimum_of = ctypes.CDLL(sys.argv[1]).hl_boundary_minimum
    minimum, invalid = Minimum(), 0
    for cell in cells:
        vertices = np.ascontiguousarray(moved[cell])
        minimum_of(vertices.ctypes.data_as(ctypes.c_void_p), 1, ctypes.byref(minimum))
        invalid += not minimum.value > 0
    at_boundary = ((points == 0) | (points == points.max(axis=0).round())).any(axis=1)
    farthest = np.linalg.norm((moved - points)[at_boundary], axis=1).max()
    print(f"{name}: {invalid} of {len(cells)} invalid, {seconds:.1f} s, boundary points moved by {farthest:.2g} at most")
