"""Gmsh's untangler on a grid: prints the seconds, and what moved_grid.py says of the result."""

import time

import gmsh
import moved_grid
import numpy as np

points, cells = moved_grid.read()
gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0)
gmsh.model.addDiscreteEntity(3, 1)
gmsh.model.mesh.addNodes(3, 1, np.arange(1, len(points) + 1), points.ravel())
gmsh.model.mesh.addElementsByType(1, 5, np.arange(1, len(cells) + 1), cells.ravel().astype(np.int64) + 1)
start = time.process_time()
gmsh.model.mesh.optimize("UntangleMeshGeometry")
seconds = time.process_time() - start
tags, coordinates, _ = gmsh.model.mesh.getNodes()
moved = np.empty_like(points)
moved[np.asarray(tags, np.int64) - 1] = coordinates.reshape(-1, 3)
moved_grid.print_result(f"Gmsh {gmsh.__version__}, UntangleMeshGeometry", seconds, points, moved, cells)
