"""Reads a VTU or a legacy file with VTK's own reader and writes what it holds as JSON: for tests of the files that the page writes."""

import json
import sys

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOLegacy import vtkUnstructuredGridReader
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

reader = vtkUnstructuredGridReader() if sys.argv[1].endswith(".vtk") else vtkXMLUnstructuredGridReader()
reader.SetFileName(sys.argv[1])
if isinstance(reader, vtkUnstructuredGridReader):
    reader.ReadAllFieldsOn()
reader.Update()
grid = reader.GetOutput()
data = grid.GetCellData()
arrays = {data.GetArrayName(i): vtk_to_numpy(data.GetArray(i)).tolist() for i in range(data.GetNumberOfArrays())}
types = sorted({grid.GetCellType(i) for i in range(grid.GetNumberOfCells())})
# NaN is none of JSON's numbers.
cells = {name: [None if value != value else value for value in values] for name, values in arrays.items()}
json.dump({"points": grid.GetNumberOfPoints(), "cells": grid.GetNumberOfCells(), "types": types, "arrays": cells}, sys.stdout)
