"""Verdict's scaled Jacobian of hexahedra, 24 doubles each on standard input; doubles on standard output."""
import array
import sys

from vtkmodules.vtkCommonDataModel import vtkHexahedron
from vtkmodules.vtkFiltersVerdict import vtkMeshQuality

coordinates = array.array("d", sys.stdin.buffer.read())
cell, numbers = vtkHexahedron(), array.array("d")
for first in range(0, len(coordinates), 24):
    for vertex in range(8):
        cell.GetPoints().SetPoint(vertex, coordinates[first + 3 * vertex : first + 3 * vertex + 3])
    numbers.append(vtkMeshQuality.HexScaledJacobian(cell))
sys.stdout.buffer.write(numbers.tobytes())
