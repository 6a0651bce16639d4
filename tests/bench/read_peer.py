"""One file read by VTK, meshio or Gmsh, in a process of its own: python read_peer.py PEER FILE.

Prints as JSON the time without imports, the memory beyond what the imports take, and how many hexahedra were read.
"""

import json
import os
import re
import sys
import time


def memory(name):
    """In kilobytes, as Linux knows them."""
    with open("/proc/self/status") as status:
        return int(re.search(name + r":\s*(\d+)", status.read())[1])


def vtk_reader(path):
    import vtk

    readers = {
        "vtu": vtk.vtkXMLUnstructuredGridReader,
        "pvtu": vtk.vtkXMLPUnstructuredGridReader,
        "vtkhdf": vtk.vtkHDFReader,
        "exo": vtk.vtkExodusIIReader,
        "cgns": vtk.vtkCGNSReader,
    }
    make = vtk.vtkOpenFOAMReader if os.path.isdir(path) else readers.get(path.rsplit(".", 1)[1], vtk.vtkDataSetReader)

    def read():
        reader = make()
        reader.SetFileName(f"{path}/a.foam" if os.path.isdir(path) else path)
        reader.Update()
        return reader.GetOutputDataObject(0).GetNumberOfCells()

    return read


def meshio_reader(path):
    import meshio

    def read():
        return sum(len(block.data) for block in meshio.read(path).cells if block.type == "hexahedron")

    return read


def gmsh_reader(path):
    import gmsh

    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)

    def read():
        gmsh.open(path)
        types, tags, _ = gmsh.model.mesh.getElements(3)
        return sum(len(own) for kind, own in zip(types, tags) if kind == 5)

    return read


READERS = {"VTK": vtk_reader, "meshio": meshio_reader, "Gmsh": gmsh_reader}


def main():
    read = READERS[sys.argv[1]](sys.argv[2])
    before = memory("VmRSS")
    begun = time.perf_counter()
    hexahedra = read()
    milliseconds = 1000 * (time.perf_counter() - begun)
    megabytes = (memory("VmHWM") - before) / 1024
    print(json.dumps({"milliseconds": milliseconds, "megabytes": megabytes, "hexahedra": hexahedra}))


main()
