"""Meshes for mesh.bench.ts, the same at every call: python mesh_files.py FOLDER. Prints their names; those that are there are not written again.

A lattice of unit cubes whose coordinates have normal noise.
"""

import sys
from pathlib import Path

import numpy as np
import pyvista
import vtk

NOISE = 0.15
MUCH_NOISE = 0.3


def grid(sides, noise, shuffled=False):
    """Of so many cells along x, y and z."""
    random = np.random.default_rng(20261130)
    z, y, x = np.meshgrid(*(np.arange(n + 1.0) for n in reversed(sides)), indexing="ij")
    points = np.stack([x.ravel(), y.ravel(), z.ravel()], axis=1)
    points += noise * random.standard_normal(points.shape)
    k, j, i = (a.ravel() for a in np.meshgrid(*(np.arange(n) for n in reversed(sides)), indexing="ij"))
    row, layer = sides[0] + 1, (sides[0] + 1) * (sides[1] + 1)
    first = i + row * j + layer * k
    corners = [0, 1, 1 + row, row]
    cells = np.stack([first + c for c in corners + [layer + c for c in corners]], axis=1)
    if shuffled:
        place = random.permutation(len(points))
        moved = np.empty_like(points)
        moved[place] = points
        points, cells = moved, place[cells][random.permutation(len(cells))]
    return pyvista.UnstructuredGrid({vtk.VTK_HEXAHEDRON: cells}, points)


def raw(path, mesh):
    """Appended, neither encoded nor packed, headers and indices of 64 bits."""
    writer = vtk.vtkXMLUnstructuredGridWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(mesh)
    writer.SetDataModeToAppended()
    writer.EncodeAppendedDataOff()
    writer.SetCompressorTypeToNone()
    writer.SetHeaderTypeToUInt64()
    writer.Write()


MILLION = (100, 100, 100)
FILES = {
    "raw.vtu": lambda path: raw(path, grid(MILLION, NOISE)),
    "invalid.vtu": lambda path: raw(path, grid(MILLION, MUCH_NOISE)),
    "shuffled.vtu": lambda path: raw(path, grid(MILLION, NOISE, shuffled=True)),
    "saved.vtu": lambda path: grid(MILLION, NOISE).save(path),
    "five.vtu": lambda path: raw(path, grid((200, 200, 125), NOISE)),
}


def main():
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for name, write in FILES.items():
        path = folder / name
        if not path.exists():
            partial = folder / f"partial-{name}"
            write(partial)
            partial.rename(path)
        print(name)


main()
