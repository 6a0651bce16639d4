"""Reads VTU and legacy files with VTK's own readers and writes a list of what they hold as JSON: for tests of the files that the page writes."""

import json
import sys

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOLegacy import vtkUnstructuredGridReader
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader


def held(file: str) -> dict:
    reader = vtkUnstructuredGridReader() if file.endswith(".vtk") else vtkXMLUnstructuredGridReader()
    reader.SetFileName(file)
    if isinstance(reader, vtkUnstructuredGridReader):
        reader.ReadAllFieldsOn()
    reader.Update()
    grid = reader.GetOutput()
    data = grid.GetCellData()
    arrays = {data.GetArrayName(i): vtk_to_numpy(data.GetArray(i)).tolist() for i in range(data.GetNumberOfArrays())}
    types = sorted({grid.GetCellType(i) for i in range(grid.GetNumberOfCells())})
    # NaN is none of JSON's numbers.
    cells = {name: [None if value != value else value for value in values] for name, values in arrays.items()}
    return {"points": grid.GetNumberOfPoints(), "cells": grid.GetNumberOfCells(), "types": types, "arrays": cells}


json.dump([held(file) for file in sys.argv[1:]], sys.stdout)
