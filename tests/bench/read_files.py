"""The same mesh of n x n x n shaken hexahedra in every format, for read.bench.ts: python read_files.py FOLDER N PART...; files whose names
have one of the parts.

Coordinates have five decimals in the small fields of Nastran; elsewhere they are a seventh of that, which takes 17 digits, so
that the cells are as valid in every file. In formats with ids both nodes and elements are numbered in a random order.
"""

import gzip
import shutil
import struct
import sys
from pathlib import Path

import h5py
import netCDF4
import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray

SHAKEN = 0.3
LINES_AT_ONCE = 20_000


class Mesh:
    def __init__(self, n):
        random = np.random.default_rng(20261)
        self.n = n
        axis = np.arange(n + 1)
        z, y, x = np.meshgrid(axis, axis, axis, indexing="ij")
        lattice = np.stack([x.ravel(), y.ravel(), z.ravel()], axis=1)
        shaken = lattice + SHAKEN * random.uniform(-1, 1, lattice.shape)
        # 0.3 to 99 for 100 cells: eight characters.
        self.short = np.round(0.98 * shaken + 0.6, 5)
        self.points = self.short / 7
        k, j, i = (a.ravel() for a in np.meshgrid(np.arange(n), np.arange(n), np.arange(n), indexing="ij"))
        row, layer = n + 1, (n + 1) ** 2
        first = i + row * j + layer * k
        corners = [0, 1, 1 + row, row]
        self.cells = np.stack([first + c for c in corners + [layer + c for c in corners]], axis=1)
        self.node_ids = 1 + random.permutation(len(self.points))
        self.cell_ids = 1 + random.permutation(len(self.cells))
        self.cells_by_id = self.node_ids[self.cells]


def write_lines(out, line, columns):
    """A line for each row of all columns, which are lists of numbers or tables."""
    tables = [np.asarray(c).reshape(len(c), -1) for c in columns]
    for start in range(0, len(tables[0]), LINES_AT_ONCE):
        parts = [t[start : start + LINES_AT_ONCE].astype(object) for t in tables]
        rows = np.concatenate(parts, axis=1)
        out.write(((line * len(rows)) % tuple(rows.ravel().tolist())).encode())


def numbers(count, form="%d"):
    return " ".join([form] * count) + "\n"


# VTK


def vtk_grid(mesh):
    points = vtk.vtkPoints()
    points.SetData(numpy_to_vtk(mesh.points, deep=True))
    cells = vtk.vtkCellArray()
    offsets = np.arange(0, 8 * len(mesh.cells) + 1, 8)
    cells.SetData(numpy_to_vtkIdTypeArray(offsets, deep=True), numpy_to_vtkIdTypeArray(mesh.cells.ravel(), deep=True))
    grid = vtk.vtkUnstructuredGrid()
    grid.SetPoints(points)
    grid.SetCells(vtk.VTK_HEXAHEDRON, cells)
    return grid


def vtu(mode, compressor="None"):
    def write(path, mesh):
        writer = vtk.vtkXMLUnstructuredGridWriter()
        writer.SetFileName(str(path))
        writer.SetInputData(vtk_grid(mesh))
        getattr(writer, f"SetDataModeTo{mode}")()
        getattr(writer, f"SetCompressorTypeTo{compressor}")()
        if mode == "Appended":
            writer.EncodeAppendedDataOff()
        writer.Write()

    return write


def pvtu(path, mesh):
    """Four slabs."""
    pieces = []
    per_layer = mesh.n**2
    for piece in range(4):
        first, last = (piece * mesh.n // 4, (piece + 1) * mesh.n // 4)
        part = Mesh.__new__(Mesh)
        base = first * (mesh.n + 1) ** 2
        part.points = mesh.points[base : (last + 1) * (mesh.n + 1) ** 2]
        part.cells = mesh.cells[first * per_layer : last * per_layer] - base
        name = f"{path.stem}_{piece}.vtu"
        vtu("Appended")(path.with_name(name), part)
        pieces.append(f'<Piece Source="{name}"/>')
    path.write_text(
        '<VTKFile type="PUnstructuredGrid" version="1.0" byte_order="LittleEndian"><PUnstructuredGrid GhostLevel="0">'
        '<PPoints><PDataArray type="Float64" Name="Points" NumberOfComponents="3"/></PPoints>'
        + "".join(pieces)
        + "</PUnstructuredGrid></VTKFile>\n"
    )


def vtk_binary(version):
    def write(path, mesh):
        writer = vtk.vtkUnstructuredGridWriter()
        writer.SetFileName(str(path))
        writer.SetInputData(vtk_grid(mesh))
        writer.SetFileVersion(version)
        writer.SetFileTypeToBinary()
        writer.Write()

    return write


def vtk_ascii(version):
    def write(path, mesh):
        count = len(mesh.cells)
        with open(path, "wb") as out:
            out.write(f"# vtk DataFile Version {version}\nshaken\nASCII\nDATASET UNSTRUCTURED_GRID\n".encode())
            out.write(f"POINTS {len(mesh.points)} double\n".encode())
            write_lines(out, numbers(3, "%.17g"), [mesh.points])
            if version == "2.0":
                out.write(f"CELLS {count} {9 * count}\n".encode())
                write_lines(out, "8 " + numbers(8), [mesh.cells])
            else:
                out.write(f"CELLS {count + 1} {8 * count}\nOFFSETS vtktypeint64\n".encode())
                write_lines(out, "%d\n", [np.arange(0, 8 * count + 1, 8)])
                out.write(b"CONNECTIVITY vtktypeint64\n")
                write_lines(out, numbers(8), [mesh.cells])
            out.write(f"CELL_TYPES {count}\n".encode() + b"12\n" * count)

    return write


def vtk_structured(is_binary):
    def write(path, mesh):
        kind = "BINARY" if is_binary else "ASCII"
        with open(path, "wb") as out:
            sizes = numbers(3) % ((mesh.n + 1,) * 3)
            out.write(f"# vtk DataFile Version 3.0\nshaken\n{kind}\nDATASET STRUCTURED_GRID\nDIMENSIONS {sizes}".encode())
            out.write(f"POINTS {len(mesh.points)} double\n".encode())
            if is_binary:
                out.write(mesh.points.astype(">f8").tobytes())
            else:
                write_lines(out, numbers(3, "%.17g"), [mesh.points])

    return write


def vtk_rectilinear(path, mesh):
    axis = (np.arange(mesh.n + 1) / 7).astype(">f8").tobytes()
    with open(path, "wb") as out:
        sizes = numbers(3) % ((mesh.n + 1,) * 3)
        out.write(f"# vtk DataFile Version 3.0\nboxes\nBINARY\nDATASET RECTILINEAR_GRID\nDIMENSIONS {sizes}".encode())
        for name in "XYZ":
            out.write(f"{name}_COORDINATES {mesh.n + 1} double\n".encode() + axis + b"\n")


# Gmsh


def msh1(path, mesh):
    count = len(mesh.cells)
    with open(path, "wb") as out:
        out.write(f"$NOD\n{len(mesh.points)}\n".encode())
        write_lines(out, "%d " + numbers(3, "%.17g"), [mesh.node_ids, mesh.points])
        out.write(f"$ENDNOD\n$ELM\n{count}\n".encode())
        write_lines(out, "%d 5 1 1 8 " + numbers(8), [mesh.cell_ids, mesh.cells_by_id])
        out.write(b"$ENDELM\n")


def msh2(path, mesh):
    count = len(mesh.cells)
    with open(path, "wb") as out:
        out.write(f"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{len(mesh.points)}\n".encode())
        write_lines(out, "%d " + numbers(3, "%.17g"), [mesh.node_ids, mesh.points])
        out.write(f"$EndNodes\n$Elements\n{count}\n".encode())
        write_lines(out, "%d 5 2 1 1 " + numbers(8), [mesh.cell_ids, mesh.cells_by_id])
        out.write(b"$EndElements\n")


def msh2_binary(path, mesh):
    count = len(mesh.cells)
    nodes = np.zeros(len(mesh.points), dtype=[("id", "<i4"), ("x", "<f8", 3)])
    nodes["id"], nodes["x"] = mesh.node_ids, mesh.points
    cells = np.zeros(count, dtype=[("id", "<i4"), ("tags", "<i4", 2), ("nodes", "<i4", 8)])
    cells["id"], cells["tags"], cells["nodes"] = mesh.cell_ids, 1, mesh.cells_by_id
    with open(path, "wb") as out:
        out.write(b"$MeshFormat\n2.2 1 8\n" + struct.pack("<i", 1) + b"\n$EndMeshFormat\n")
        out.write(f"$Nodes\n{len(nodes)}\n".encode() + nodes.tobytes() + b"\n$EndNodes\n")
        out.write(f"$Elements\n{count}\n".encode() + struct.pack("<3i", 5, count, 2) + cells.tobytes())
        out.write(b"\n$EndElements\n")


BOX = "0 0 0 15 15 15"


def msh40(path, mesh):
    points, count = len(mesh.points), len(mesh.cells)
    with open(path, "wb") as out:
        out.write(f"$MeshFormat\n4 0 8\n$EndMeshFormat\n$Entities\n0 0 0 1\n1 {BOX} 0 0\n$EndEntities\n".encode())
        out.write(f"$Nodes\n1 {points}\n1 3 0 {points}\n".encode())
        write_lines(out, "%d " + numbers(3, "%.17g"), [mesh.node_ids, mesh.points])
        out.write(f"$EndNodes\n$Elements\n1 {count}\n1 3 5 {count}\n".encode())
        write_lines(out, numbers(9), [mesh.cell_ids, mesh.cells_by_id])
        out.write(b"$EndElements\n")


def msh40_binary(path, mesh):
    points, count = len(mesh.points), len(mesh.cells)
    nodes = np.zeros(points, dtype=[("id", "<i4"), ("x", "<f8", 3)])
    nodes["id"], nodes["x"] = mesh.node_ids, mesh.points
    cells = np.column_stack([mesh.cell_ids, mesh.cells_by_id]).astype("<i4")
    with open(path, "wb") as out:
        out.write(b"$MeshFormat\n4 1 8\n" + struct.pack("<i", 1) + b"\n$EndMeshFormat\n$Entities\n")
        out.write(struct.pack("<4Qi6d2Q", 0, 0, 0, 1, 1, *map(float, BOX.split()), 0, 0) + b"\n$EndEntities\n$Nodes\n")
        out.write(struct.pack("<2Q3iQ", 1, points, 1, 3, 0, points) + nodes.tobytes() + b"\n$EndNodes\n$Elements\n")
        out.write(struct.pack("<2Q3iQ", 1, count, 1, 3, 5, count) + cells.tobytes() + b"\n$EndElements\n")


def msh41(path, mesh):
    points, count = len(mesh.points), len(mesh.cells)
    with open(path, "wb") as out:
        out.write(f"$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 0 0 1\n1 {BOX} 0 0\n$EndEntities\n".encode())
        out.write(f"$Nodes\n1 {points} 1 {points}\n3 1 0 {points}\n".encode())
        write_lines(out, "%d\n", [mesh.node_ids])
        write_lines(out, numbers(3, "%.17g"), [mesh.points])
        out.write(f"$EndNodes\n$Elements\n1 {count} 1 {count}\n3 1 5 {count}\n".encode())
        write_lines(out, numbers(9), [mesh.cell_ids, mesh.cells_by_id])
        out.write(b"$EndElements\n")


def msh41_binary(path, mesh):
    points, count = len(mesh.points), len(mesh.cells)
    cells = np.column_stack([mesh.cell_ids, mesh.cells_by_id]).astype("<u8")
    with open(path, "wb") as out:
        out.write(b"$MeshFormat\n4.1 1 8\n" + struct.pack("<i", 1) + b"\n$EndMeshFormat\n$Entities\n")
        out.write(struct.pack("<4Qi6d2Q", 0, 0, 0, 1, 1, *map(float, BOX.split()), 0, 0) + b"\n$EndEntities\n$Nodes\n")
        out.write(struct.pack("<4Q3iQ", 1, points, 1, points, 3, 1, 0, points))
        out.write(mesh.node_ids.astype("<u8").tobytes() + mesh.points.tobytes() + b"\n$EndNodes\n$Elements\n")
        out.write(struct.pack("<4Q3iQ", 1, count, 1, count, 3, 1, 5, count) + cells.tobytes() + b"\n$EndElements\n")


# Medit, MFEM


def medit(path, mesh):
    with open(path, "wb") as out:
        out.write(f"MeshVersionFormatted 2\nDimension 3\nVertices\n{len(mesh.points)}\n".encode())
        write_lines(out, numbers(3, "%.17g")[:-1] + " 0\n", [mesh.points])
        out.write(f"Hexahedra\n{len(mesh.cells)}\n".encode())
        write_lines(out, numbers(8)[:-1] + " 1\n", [mesh.cells + 1])
        out.write(b"End\n")


def medit_binary(path, mesh):
    points, count = len(mesh.points), len(mesh.cells)
    vertices = np.zeros(points, dtype=[("x", "<f8", 3), ("reference", "<i4")])
    vertices["x"] = mesh.points
    cells = np.column_stack([mesh.cells + 1, np.ones(count)]).astype("<i4")
    with open(path, "wb") as out:
        out.write(struct.pack("<4ii", 1, 2, 3, 20, 3))
        out.write(struct.pack("<3i", 4, out.tell() + 12 + 28 * points, points) + vertices.tobytes())
        out.write(struct.pack("<3i", 10, out.tell() + 12 + 36 * count, count) + cells.tobytes())
        out.write(struct.pack("<2i", 54, 0))


def mfem(path, mesh):
    with open(path, "wb") as out:
        out.write(f"MFEM mesh v1.0\n\ndimension\n3\n\nelements\n{len(mesh.cells)}\n".encode())
        write_lines(out, "1 5 " + numbers(8), [mesh.cells])
        out.write(f"\nboundary\n0\n\nvertices\n{len(mesh.points)}\n3\n".encode())
        write_lines(out, numbers(3, "%.17g"), [mesh.points])


# Finite element codes


def abaqus(path, mesh):
    with open(path, "wb") as out:
        out.write(b"*HEADING\nshaken\n*NODE\n")
        write_lines(out, "%d, %.17g, %.17g, %.17g\n", [mesh.node_ids, mesh.points])
        out.write(b"*ELEMENT, TYPE=C3D8, ELSET=ALL\n")
        write_lines(out, ", ".join(["%d"] * 9) + "\n", [mesh.cell_ids, mesh.cells_by_id])


def nastran(grid, hexahedron, is_short=False):
    def write(path, mesh):
        with open(path, "wb") as out:
            out.write(b"BEGIN BULK\n")
            write_lines(out, grid, [mesh.node_ids, mesh.short if is_short else mesh.points])
            write_lines(out, hexahedron, [mesh.cell_ids, mesh.cells_by_id])
            out.write(b"ENDDATA\n")

    return write


SMALL = ("GRID    %8d        %8.5f%8.5f%8.5f\n", "CHEXA   %8d       1%8d%8d%8d%8d%8d%8d\n        %8d%8d\n")
# 16 columns hold 13 decimals.
LARGE = (
    "GRID*   %16d                %16.13f%16.13f\n*       %16.13f\n",
    "CHEXA*  %16d               1%16d%16d\n*       %16d%16d%16d%16d\n*       %16d%16d\n",
)
FREE = ("GRID,%d,,%.17g,%.17g,%.17g\n", "CHEXA,%d,1,%d,%d,%d,%d,%d,%d\n,%d,%d\n")


def cdb(path, mesh):
    points, count = len(mesh.points), len(mesh.cells)
    with open(path, "wb") as out:
        out.write(f"/PREP7\nET,1,185\nNBLOCK,6,SOLID,{points},{points}\n(3i9,6e21.13e3)\n".encode())
        write_lines(out, "%9d        0        0%21.13E%21.13E%21.13E\n", [mesh.node_ids, mesh.points])
        out.write(f"N,R5.3,LOC,-1,\nEBLOCK,19,SOLID,{count},{count}\n(19i9)\n".encode())
        head = "        1        1        1        1        0        0        0        0        8        0"
        write_lines(out, head + "%9d" * 9 + "\n", [mesh.cell_ids, mesh.cells_by_id])
        out.write(b"       -1\nFINISH\n")


def ls_dyna(path, mesh):
    with open(path, "wb") as out:
        out.write(b"*KEYWORD\n*NODE\n")
        write_lines(out, "%8d%16.13f%16.13f%16.13f\n", [mesh.node_ids, mesh.points])
        out.write(b"*ELEMENT_SOLID\n")
        write_lines(out, "%8d       1" + "%8d" * 8 + "\n", [mesh.cell_ids, mesh.cells_by_id])
        out.write(b"*END\n")


# HDF5


def exodus(form):
    def write(path, mesh):
        with netCDF4.Dataset(path, "w", format=form) as out:
            version = np.float32(8.11)
            out.setncatts({"api_version": version, "version": version, "floating_point_word_size": np.int32(8)})
            out.setncatts({"file_size": np.int32(1), "title": "shaken"})
            sizes = {"num_dim": 3, "num_nodes": len(mesh.points), "num_elem": len(mesh.cells), "num_el_blk": 1}
            sizes |= {"len_string": 33, "num_el_in_blk1": len(mesh.cells), "num_nod_per_el1": 8, "time_step": None}
            for name, size in sizes.items():
                out.createDimension(name, size)
            out.createVariable("time_whole", "f8", ("time_step",))
            out.createVariable("eb_status", "i4", ("num_el_blk",))[:] = 1
            blocks = out.createVariable("eb_prop1", "i4", ("num_el_blk",))
            blocks.setncattr("name", "ID")
            blocks[:] = 1
            for axis, values in zip("xyz", mesh.points.T):
                out.createVariable(f"coord{axis}", "f8", ("num_nodes",))[:] = values
            out.createVariable("elem_num_map", "i4", ("num_elem",))[:] = mesh.cell_ids
            connect = out.createVariable("connect1", "i4", ("num_el_in_blk1", "num_nod_per_el1"))
            connect.elem_type = "HEX8"
            connect[:] = mesh.cells + 1

    return write


def cgns_node(parent, name, label, values=None, kind="MT"):
    node = parent.create_group(name)
    for key, words, size in (("name", name, 33), ("label", label, 33), ("type", kind, 3)):
        node.attrs.create(key, words.encode(), dtype=f"S{size}")
    node.attrs["flags"] = np.array([1], np.int32)
    if values is not None:
        node[" data"] = values
    return node


def text(words):
    return np.frombuffer(words.encode(), np.int8)


def cgns(path, mesh):
    with h5py.File(path, "w") as out:
        for key, words, size in (("name", "HDF5 MotherNode", 33), ("label", "Root Node of HDF5 File", 33), ("type", "MT", 3)):
            out.attrs.create(key, words.encode(), dtype=f"S{size}")
        out[" format"] = text("IEEE_LITTLE_32\0")
        out[" hdf5version"] = text("HDF5 Version 1.10.0".ljust(33, "\0"))
        cgns_node(out, "CGNSLibraryVersion", "CGNSLibraryVersion_t", np.array([3.3], np.float32), "R4")
        base = cgns_node(out, "Base", "CGNSBase_t", np.array([3, 3], np.int32), "I4")
        sizes = np.array([[len(mesh.points)], [len(mesh.cells)], [0]], np.int32)
        zone = cgns_node(base, "Zone", "Zone_t", sizes, "I4")
        cgns_node(zone, "ZoneType", "ZoneType_t", text("Unstructured"), "C1")
        grid = cgns_node(zone, "GridCoordinates", "GridCoordinates_t")
        for axis, values in zip("XYZ", mesh.points.T):
            cgns_node(grid, f"Coordinate{axis}", "DataArray_t", values, "R8")
        section = cgns_node(zone, "Hexahedra", "Elements_t", np.array([17, 0], np.int32), "I4")
        cgns_node(section, "ElementRange", "IndexRange_t", np.array([1, len(mesh.cells)], np.int32), "I4")
        nodes = (mesh.cells + 1).astype(np.int32).ravel()
        cgns_node(section, "ElementConnectivity", "DataArray_t", nodes, "I4")


def vtkhdf(path, mesh):
    writer = vtk.vtkHDFWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(vtk_grid(mesh))
    writer.Write()


def med(path, mesh):
    import meshio

    meshio.Mesh(mesh.points, [("hexahedron", mesh.cells)]).write(path, file_format="med")


# Others


def foam_header(kind, name):
    return f"FoamFile\n{{\n    version 2.0;\n    format ascii;\n    class {kind};\n    object {name};\n}}\n\n".encode()


def foam(path, mesh):
    """Inner faces by their owner, then the boundary's; all look out of their owner."""
    own = path / "constant" / "polyMesh"
    own.mkdir(parents=True, exist_ok=True)
    (path / "a.foam").touch()
    (path / "system").mkdir(exist_ok=True)
    (path / "system" / "controlDict").write_bytes(foam_header("dictionary", "controlDict"))
    n = mesh.n
    cells = np.arange(n**3)
    place = [cells % n, cells // n % n, cells // n**2]
    sides = [((1, 2, 6, 5), (0, 4, 7, 3)), ((3, 7, 6, 2), (0, 1, 5, 4)), ((4, 5, 6, 7), (0, 3, 2, 1))]
    inner = [place[axis] < n - 1 for axis in range(3)]
    owner = np.stack([cells] * 3, axis=1)[np.stack(inner, axis=1)]
    step = np.stack([np.full(n**3, n**axis) for axis in range(3)], axis=1)[np.stack(inner, axis=1)]
    corners = np.stack([mesh.cells[:, sides[axis][0]] for axis in range(3)], axis=1)[np.stack(inner, axis=1)]
    outer = [(mesh.cells[at][:, side], cells[at]) for axis in range(3) for side, at in (
        (sides[axis][0], place[axis] == n - 1), (sides[axis][1], place[axis] == 0))]
    faces = np.concatenate([corners] + [f for f, _ in outer])
    owners = np.concatenate([owner] + [o for _, o in outer])
    lists = [("points", "vectorField", "(" + numbers(3, "%.17g")[:-1] + ")\n", [mesh.points]),
             ("faces", "faceList", "4(" + numbers(4)[:-1] + ")\n", [faces]),
             ("owner", "labelList", "%d\n", [owners]),
             ("neighbour", "labelList", "%d\n", [owner + step])]
    for name, kind, line, columns in lists:
        with open(own / name, "wb") as out:
            out.write(foam_header(kind, name) + f"{len(columns[0])}\n(\n".encode())
            write_lines(out, line, columns)
            out.write(b")\n")
    patch = f"1\n(\nwall\n{{\n    type wall;\n    nFaces {6 * n * n};\n    startFace {len(owner)};\n}}\n)\n"
    (own / "boundary").write_bytes(foam_header("polyBoundaryMesh", "boundary") + patch.encode())


def aster(path, mesh):
    with open(path, "wb") as out:
        out.write(b"TITRE\nshaken\nFINSF\nCOOR_3D\n")
        write_lines(out, "N%d " + numbers(3, "%.17g"), [mesh.node_ids, mesh.points])
        out.write(b"FINSF\nHEXA8\n")
        write_lines(out, "M%d " + " ".join(["N%d"] * 8) + "\n", [mesh.cell_ids, mesh.cells_by_id])
        out.write(b"FINSF\nFIN\n")


def gzipped(other):
    def write(path, _):
        with open(path.with_name(other), "rb") as plain, gzip.open(path, "wb", compresslevel=6) as out:
            shutil.copyfileobj(plain, out)

    return write


FILES = {
    "raw.vtu": vtu("Appended"),
    "zlib.vtu": vtu("Appended", "ZLib"),
    "lz4.vtu": vtu("Appended", "LZ4"),
    "lzma.vtu": vtu("Appended", "LZMA"),
    "base64.vtu": vtu("Binary"),
    "ascii.vtu": vtu("Ascii"),
    "pieces.pvtu": pvtu,
    "binary-2.vtk": vtk_binary(42),
    "binary-5.1.vtk": vtk_binary(51),
    "ascii-2.vtk": vtk_ascii("2.0"),
    "ascii-5.1.vtk": vtk_ascii("5.1"),
    "structured-binary.vtk": vtk_structured(True),
    "structured-ascii.vtk": vtk_structured(False),
    "rectilinear.vtk": vtk_rectilinear,
    "ascii-1.msh": msh1,
    "ascii-2.2.msh": msh2,
    "binary-2.2.msh": msh2_binary,
    "ascii-4.0.msh": msh40,
    "binary-4.0.msh": msh40_binary,
    "ascii-4.1.msh": msh41,
    "binary-4.1.msh": msh41_binary,
    "ascii.mesh": medit,
    "binary.meshb": medit_binary,
    "mfem.mesh": mfem,
    "abaqus.inp": abaqus,
    "small.bdf": nastran(*SMALL, is_short=True),
    "large.bdf": nastran(*LARGE),
    "free.bdf": nastran(*FREE),
    "ansys.cdb": cdb,
    "ls-dyna.k": ls_dyna,
    "classic.exo": exodus("NETCDF3_64BIT_OFFSET"),
    "netcdf4.exo": exodus("NETCDF4"),
    "hdf5.cgns": cgns,
    "hdf5.vtkhdf": vtkhdf,
    "meshio.med": med,
    "foam": foam,
    "aster.mail": aster,
    "abaqus.inp.gz": gzipped("abaqus.inp"),
    "binary-5.1.vtk.gz": gzipped("binary-5.1.vtk"),
}


def main():
    folder, n, wanted = Path(sys.argv[1]), int(sys.argv[2]), sys.argv[3:]
    folder.mkdir(parents=True, exist_ok=True)
    mesh = None
    for name, write in FILES.items():
        if not any(part in name for part in wanted):
            continue
        path = folder / name
        if not path.exists():
            mesh = mesh or Mesh(n)
            # Nobody takes half a file for a whole one.
            partial = folder / f"partial-{name}" if name != "pieces.pvtu" else path
            write(partial, mesh)
            partial.rename(path)
        print(name, flush=True)


main()
