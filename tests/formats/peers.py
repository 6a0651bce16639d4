"""What VTK, meshio and Gmsh make of files: python peers.py PEER FILE..., one process for each file, for some end in a crash.

Prints JSON: the peer's version, and for each file the counts of its cells, the 24 coordinates of each hexahedron and the numbers of each
cell array, or why there are none. What is not finite is null.
"""

import contextlib
import json
import os
import select
import signal
import sys

import numpy as np

#: Longer reading is taken for an endless one.
MOST_SECONDS = 60
#: VTK's numbers of cell types, by the names that the documents use.
VTK_TYPES = {
    1: "vertex", 3: "line", 5: "triangle", 9: "quadrilateral", 10: "tetrahedron", 11: "voxel", 12: "hexahedron", 13: "wedge",
    14: "pyramid", 25: "hexahedron of 20 nodes", 29: "hexahedron of 27 nodes", 42: "polyhedron", 72: "Lagrange hexahedron",
}
MESHIO_TYPES = {
    "quad": "quadrilateral", "tetra": "tetrahedron", "hexahedron20": "hexahedron of 20 nodes", "hexahedron27": "hexahedron of 27 nodes",
    "VTK_LAGRANGE_HEXAHEDRON": "Lagrange hexahedron",
}
GMSH_TYPES = {
    1: "line", 2: "triangle", 3: "quadrilateral", 4: "tetrahedron", 5: "hexahedron", 6: "wedge", 7: "pyramid", 12: "hexahedron of 27 nodes",
    15: "vertex", 17: "hexahedron of 20 nodes",
}
#: The corners of a voxel in the order of a hexahedron.
VOXEL = [0, 1, 3, 2, 4, 5, 7, 6]


class NoReader(Exception):
    """The peer does not know the format."""


def plain(numbers):
    return [value if np.isfinite(value) else None for value in np.asarray(numbers, dtype=float).ravel().tolist()]


def counted(names):
    return {name: names.count(name) for name in sorted(set(names))}


class Vtk:
    def __init__(self):
        import vtk

        self.vtk = vtk
        self.version = vtk.vtkVersion().GetVTKVersion()

    def _reader(self, path):
        vtk = self.vtk
        if path.endswith("/faces"):
            # The reader takes an empty file in the folder of the case.
            return vtk.vtkOpenFOAMReader(), os.path.join(os.path.dirname(path), "..", "..", "case.foam")
        makers = {
            "vtu": "vtkXMLUnstructuredGridReader", "pvtu": "vtkXMLPUnstructuredGridReader", "vtk": "vtkDataSetReader",
            "vtkhdf": "vtkHDFReader", "e": "vtkExodusIIReader", "exo": "vtkExodusIIReader", "cgns": "vtkCGNSReader",
            "xdmf": "vtkXdmfReader", "ansys.msh": "vtkFLUENTReader", "tec.dat": "vtkTecplotReader",
        }
        name = next((maker for ending, maker in makers.items() if path.endswith(("." + ending, "-" + ending))), None)
        if name is None or not hasattr(vtk, name):
            raise NoReader
        return getattr(vtk, name)(), path

    def read(self, path):
        from vtkmodules.util.numpy_support import vtk_to_numpy

        reader, path = self._reader(path)
        reader.SetFileName(path)
        for all_of in ("ReadAllFieldsOn", "ReadAllScalarsOn"):
            getattr(reader, all_of, lambda: None)()
        errors = []
        reader.AddObserver("ErrorEvent", lambda *_: errors.append("VTK reports an error"))
        reader.Update()
        grids = list(self._grids(reader.GetOutputDataObject(0)))
        if not grids or not any(grid.GetNumberOfCells() for grid in grids):
            raise ValueError(errors[0] if errors else "no cells")
        types, corners, arrays = [], [], {}
        for grid in grids:
            points = vtk_to_numpy(grid.GetPoints().GetData()).astype(float) if grid.GetPoints() else np.zeros((0, 3))
            for cell in range(grid.GetNumberOfCells()):
                kind = grid.GetCellType(cell)
                types.append(VTK_TYPES.get(kind, f"type {kind}"))
                if kind not in (11, 12):
                    continue
                ids = [grid.GetCell(cell).GetPointId(i) for i in range(8)]
                corners.append(points[[ids[i] for i in VOXEL] if kind == 11 else ids])
            data = grid.GetCellData()
            for i in range(data.GetNumberOfArrays()):
                if data.GetArray(i) is not None and data.GetArray(i).GetNumberOfComponents() == 1:
                    arrays.setdefault(data.GetArrayName(i), []).append(vtk_to_numpy(data.GetArray(i)))
        return types, corners, {name: np.concatenate(parts) for name, parts in arrays.items()}

    def _grids(self, data):
        if not hasattr(data, "NewIterator"):
            if data is not None and hasattr(data, "GetCellType"):
                yield data
            return
        iterator = data.NewIterator()
        iterator.InitTraversal()
        while not iterator.IsDoneWithTraversal():
            yield from self._grids(iterator.GetCurrentDataObject())
            iterator.GoToNextItem()


class Meshio:
    def __init__(self):
        import meshio

        self.meshio = meshio
        self.version = meshio.__version__

    def read(self, path):
        meshio = self.meshio
        formats = {"-tec.dat": "tecplot", ".ansys.msh": "ansys"}
        name = next((name for ending, name in formats.items() if path.endswith(ending)), None)
        ending = os.path.basename(path)[os.path.basename(path).rfind(".") :]
        if name is None and ending not in meshio.extension_to_filetypes:
            raise NoReader
        mesh = meshio.read(path, file_format=name)
        types, corners = [], []
        for block in mesh.cells:
            types += [MESHIO_TYPES.get(block.type, block.type)] * len(block.data)
            if block.type in ("hexahedron", "voxel"):
                order = VOXEL if block.type == "voxel" else slice(None)
                corners += list(np.asarray(mesh.points, dtype=float)[np.asarray(block.data)[:, order]])
        arrays = {name: np.concatenate(values) for name, values in mesh.cell_data.items() if all(np.ndim(v) == 1 for v in values)}
        return types, corners, arrays


class Gmsh:
    #: Other names are taken for scripts.
    ENDINGS = ("msh", "unv", "bdf", "vtk", "cgns", "med", "mesh", "diff")

    def __init__(self):
        import gmsh

        self.gmsh = gmsh
        self.version = gmsh.__version__

    def read(self, path):
        gmsh = self.gmsh
        if not path.endswith(self.ENDINGS) or path.endswith("ansys.msh"):
            raise NoReader
        gmsh.initialize(interruptible=False)
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.open(path)
        node_tags, coordinates, _ = gmsh.model.mesh.getNodes()
        places = {int(tag): i for i, tag in enumerate(node_tags)}
        points = coordinates.reshape(-1, 3)
        types, corners, order = [], [], []
        # Lists of elements by type leave out those of a second order beside others.
        for tag in range(1, int(gmsh.model.mesh.getMaxElementTag()) + 1):
            try:
                kind, nodes, _, _ = gmsh.model.mesh.getElement(tag)
            except Exception:
                continue
            types.append(GMSH_TYPES.get(int(kind), f"type {kind}"))
            order.append(tag)
            if kind == 5:
                corners.append(points[[places[int(node)] for node in nodes]])
        arrays = {}
        for view in gmsh.view.getTags():
            name = gmsh.view.option.getString(view, "Name")
            _, tags, data, _, _ = gmsh.view.getModelData(view, 0)
            values = {int(tag): value[0] for tag, value in zip(tags, data, strict=True)}
            arrays[name] = [values[tag] for tag in order]
        if not types:
            raise ValueError("no cells")
        return types, corners, arrays


PEERS = {"VTK": Vtk, "meshio": Meshio, "Gmsh": Gmsh}


def answer(peer, path):
    try:
        with open(os.devnull, "w") as nothing, contextlib.redirect_stdout(nothing), contextlib.redirect_stderr(nothing):
            types, corners, arrays = peer.read(path)
    except NoReader:
        return None
    except (Exception, SystemExit) as error:
        return {"refused": type(error).__name__}
    return {
        "counts": counted(types),
        "hexahedra": [plain(cell) for cell in corners],
        "arrays": {name: plain(values) for name, values in arrays.items()},
    }


def apart(peer, path):
    """The answer of a process that may crash."""
    reading, writing = os.pipe()
    child = os.fork()
    if child == 0:
        silent = os.open(os.devnull, os.O_WRONLY)
        os.dup2(silent, 1)
        os.dup2(silent, 2)
        with os.fdopen(writing, "w") as pipe:
            json.dump(answer(peer, path), pipe)
        os._exit(0)
    os.close(writing)
    is_there = select.select([reading], [], [], MOST_SECONDS)[0]
    with os.fdopen(reading) as pipe:
        if not is_there:
            os.kill(child, signal.SIGKILL)
        text = pipe.read() if is_there else ""
    os.waitpid(child, 0)
    return json.loads(text) if text else {"refused": "crash" if is_there else "no end"}


peer = PEERS[sys.argv[1]]()
json.dump({"version": peer.version, "files": {path: apart(peer, path) for path in sys.argv[2:]}}, sys.stdout)
