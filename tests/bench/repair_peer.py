"""Gmsh's untangler on a grid that tests/bench/untangle.c has written to standard input: prints its version, the seconds, and how many of
its hexahedra are invalid by the library (argument 1), the least relative minimum, and how far a boundary point has moved at most."""

import ctypes
import struct
import sys
import time

import gmsh
import numpy as np

data = sys.stdin.buffer.read()
point_count, cell_count = struct.unpack_from("<QQ", data)
points = np.frombuffer(data, "<f8", 3 * point_count, 16).reshape(-1, 3)
cells = np.frombuffer(data, "<u4", 8 * cell_count, 16 + points.nbytes).reshape(-1, 8)

gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0)
gmsh.model.addDiscreteEntity(3, 1)
gmsh.model.mesh.addNodes(3, 1, np.arange(1, point_count + 1), points.ravel())
gmsh.model.mesh.addElementsByType(1, 5, np.arange(1, cell_count + 1), cells.ravel().astype(np.int64) + 1)
start = time.perf_counter()
gmsh.model.mesh.optimize("UntangleMeshGeometry")
seconds = time.perf_counter() - start
tags, coordinates, _ = gmsh.model.mesh.getNodes()
moved = np.empty_like(points)
moved[np.asarray(tags, np.int64) - 1] = coordinates.reshape(-1, 3)
at_boundary = ((points == 0) | (points == points.max(axis=0).round())).any(axis=1)
farthest = np.linalg.norm((moved - points)[at_boundary], axis=1).max()

library = ctypes.CDLL(sys.argv[1])
minimum_of = library.hl_boundary_minimum


class Minimum(ctypes.Structure):
    """hl_minimum: kind, id, point, position, value; exponent; is_exact."""

    _fields_ = [("head", ctypes.c_int * 2), ("place", ctypes.c_double * 6), ("value", ctypes.c_double), ("tail", ctypes.c_int * 2)]


invalid = 0
minimum = Minimum()
for cell in cells:
    vertices = np.ascontiguousarray(moved[cell])
    minimum_of(vertices.ctypes.data_as(ctypes.c_void_p), 1, ctypes.byref(minimum))
    invalid += not minimum.value > 0
print(f"Gmsh {gmsh.__version__}, UntangleMeshGeometry: {invalid} invalid, {seconds:.1f} s, boundary points moved by {farthest:.2g} at most")
