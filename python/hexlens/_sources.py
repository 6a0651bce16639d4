"""Meshes from what people have: arrays, files, and the objects of meshio, PyVista and Gmsh. None of these is imported before it is
needed."""

import os
import re
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

import numpy as np
from numpy.typing import NDArray

from ._arrays import HexlensError, cells_of, points_of
from ._mesh import CellArrays, Grid, Mesh, MeshMaker, cell_names
from ._read_vtu import read_vtu

if TYPE_CHECKING:
    from ._check import MeshCheck

__all__ = ["mesh_of", "put_cell_arrays", "read_file", "shown_name"]


def mesh_of(source: Any, format_: str | None = None) -> Mesh:
    """HexlensError for what is none of them."""
    if isinstance(source, (str, os.PathLike)):
        return read_file(os.fspath(source), format_)
    if format_ is not None:
        raise HexlensError("A format belongs to a file.")
    if isinstance(source, tuple) and len(source) == 2:
        return Mesh("arrays", points_of(source[0]), cells_of(source[1]))
    # A PyVista grid has a cells_dict, too.
    if hasattr(source, "celltypes") and hasattr(source, "cell_connectivity"):
        return _from_vtk(source, "PyVista")
    if _is_meshio(source):
        return _from_meshio(source)
    if hasattr(source, "cast_to_unstructured_grid"):
        return _from_vtk(source.cast_to_unstructured_grid(), "PyVista")
    if hasattr(source, "GetCellTypes") and hasattr(source, "GetPoints"):
        wrapped = _import("pyvista").wrap(source)
        return _from_vtk(wrapped if hasattr(wrapped, "celltypes") else wrapped.cast_to_unstructured_grid(), "VTK")
    model = getattr(source, "model", source)
    if hasattr(model, "mesh") and hasattr(model.mesh, "getNodes"):
        return _from_gmsh(model)
    raise HexlensError(
        f"A {type(source).__name__} is none of: (points, cells), the path of a file, a meshio.Mesh, a pyvista.UnstructuredGrid, gmsh.model."
    )


def _is_meshio(source: Any) -> bool:
    return hasattr(source, "cell_sets") and hasattr(source, "cells") and hasattr(source, "point_data")


def _import(name: str) -> Any:
    try:
        return __import__(name)
    except ImportError:
        raise HexlensError(f"This needs {name}, which is not installed: pip install 'hexlens[files]'.") from None


#: What `npx hexlens check` reads and this does not, by the beginnings of files and by their names.
_BY_HEAD: Final = (
    (rb"\s*\$MeshFormat|\s*\$NOD|\s*\$Comments", "Gmsh file"),
    (rb"\x89HDF", "HDF5 file"),
    (rb"CDF", "netCDF file"),
    (rb"MFEM mesh", "MFEM file"),
    (rb"(?:\s*#[^\n]*\n)*\s*MeshVersion", "Medit file"),
    (rb"\s*OVM", "OpenVolumeMesh file"),
)
_BY_NAME: Final = {
    ".inp": "Abaqus file", ".bdf": "Nastran file", ".nas": "Nastran file", ".dat": "Nastran or Tecplot file",
    ".msh": "Gmsh file", ".mesh": "Medit file", ".meshb": "Medit file", ".cdb": "Ansys file", ".k": "LS-DYNA file",
    ".key": "LS-DYNA file", ".unv": "UNV file", ".avs": "UCD file", ".ovm": "OpenVolumeMesh file", ".mdpa": "Kratos file",
    ".e": "Exodus file", ".exo": "Exodus file", ".g": "Exodus file", ".cgns": "CGNS file", ".med": "MED file",
    ".xdmf": "XDMF file", ".vtkhdf": "VTKHDF file", ".pvd": ".pvd file", ".m": "MATLAB text", ".obj": "OBJ file",
    ".xda": "libMesh file", ".rea": "Nek5000 file",
    ".re2": "Nek5000 file", ".foam": "OpenFOAM case",
}  # fmt: skip
_FORMATS: Final = {"vtu": "VTU", "vtk": "VTK"}
_HEAD: Final = 4096


def shown_name(path: str) -> str:
    """A file's name for people: without control characters, cut if it is too long."""
    plain = re.sub(r"[\x00-\x1f\x7f-\x9f\u2028\u2029\u200b-\u200f\u202a-\u202e\u2060-\u2069\ufeff]", "", Path(path).name)
    return plain if len(plain) <= 60 else f"{plain[:39]}…{plain[-20:]}"


def read_file(path: str, format_: str | None = None, step: int | str = 1) -> Mesh:
    """VTU, .pvtu (gzipped or not) and VTK legacy; everything else is refused by name. A file of these has one time step."""
    name = shown_name(path)
    try:
        if Path(path).stat().st_size == 0:
            raise HexlensError(f"{name}: the file is empty.")
        with open(path, "rb") as file:
            head = file.read(_HEAD)
    except OSError as error:
        raise HexlensError(f"{name} cannot be read: {_reason(error)}.") from None
    known = _format_of(path, name, head) if format_ is None else _FORMATS.get(format_.lower())
    if known is not None:
        mesh = read_vtu(path, name) if known == "VTU" else _read_legacy(path, name)
        if step not in (1, "last", "all"):
            raise HexlensError(f"{name}: it has one time step, and step {step} was asked for.")
        return mesh
    raise HexlensError(f"{name}: {format_} is not read here; {' and '.join(_FORMATS.values())} are. This does it: npx hexlens check {path}")


def _reason(error: OSError) -> str:
    return {
        "FileNotFoundError": "it is not there",
        "IsADirectoryError": "it is a folder",
        "NotADirectoryError": "there is no such folder",
        "PermissionError": "permission is denied",
    }.get(type(error).__name__, (error.strerror or str(error)).lower())


def _format_of(path: str, name: str, head: bytes) -> str:
    if head.startswith(b"\x1f\x8b"):
        plain = name.lower().removesuffix(".gz")
        if plain.endswith((".vtu", ".pvtu")):
            return "VTU"
    elif re.match(rb"(?:\xef\xbb\xbf)?\s*<", head) and b"<VTKFile" in head:
        return "VTU"
    elif re.match(rb"\s*# vtk DataFile", head):
        return "VTK"
    elif name.lower().endswith((".vtu", ".pvtu")):
        return "VTU"
    what = next((kind for pattern, kind in _BY_HEAD if re.match(pattern, head)), None)
    what = what or _BY_NAME.get(Path(name.lower().removesuffix(".gz")).suffix, "file of a format that is not known here")
    article = "an" if what[:1] in "AEHUOX" and not what.startswith("U") else "a"
    raise HexlensError(
        f"{name}: this is {article} {what}, which is not read here: VTU and VTK legacy are. "
        f"This does it, or names the program that converts it: npx hexlens check {path}"
    )


def _read_legacy(path: str, name: str) -> Mesh:
    """By VTK, which PyVista brings; its silence about lists of different lengths and ends that are missing is not shared."""
    try:
        from vtkmodules.vtkCommonCore import vtkLogger, vtkOutputWindow, vtkStringOutputWindow
        from vtkmodules.vtkIOLegacy import vtkUnstructuredGridReader
    except ImportError:
        raise HexlensError(
            f"{name}: VTK legacy files are read by VTK, which is not installed: pip install 'hexlens[files]'. "
            f"Without it: npx hexlens check {path}"
        ) from None
    text = Path(path).read_bytes()
    _check_legacy(text, path, name)
    reader = vtkUnstructuredGridReader()
    reader.SetFileName(path)
    reader.ReadAllScalarsOn()
    reader.ReadAllFieldsOn()
    # VTK only prints that something is wrong.
    before, said = vtkOutputWindow.GetInstance(), vtkStringOutputWindow()
    verbosity = vtkLogger.GetCurrentVerbosityCutoff()
    vtkOutputWindow.SetInstance(said)
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
    try:
        reader.Update()
    finally:
        vtkOutputWindow.SetInstance(before)
        vtkLogger.SetStderrVerbosity(verbosity)
    if said.GetOutput() or reader.GetErrorCode() != 0:
        raise HexlensError(f"{name}: it is damaged or cut off, VTK cannot read it. This says where: npx hexlens check {path}")
    mesh = _from_vtk(reader.GetOutput(), "VTK", lambda what: HexlensError(f"{name}: {what}"))
    if _is_ascii(text) and len(mesh.points):
        # VTK rounds what is printed to the type that the file names.
        mesh.points = _printed_points(text, name, len(mesh.points))
    return mesh


def _printed_points(text: bytes, name: str, count: int) -> NDArray[np.float64]:
    found = re.search(rb"^POINTS[^\n]*\n", text, re.MULTILINE)
    # A coordinate and a blank are 26 bytes at most: 17 digits, signs, a point and an exponent.
    words = [] if found is None else text[found.end() : found.end() + 100 * count].split(None, 3 * count)[: 3 * count]
    try:
        return np.array([float(word) for word in words]).reshape(count, 3)
    except ValueError as error:
        raise HexlensError(f"{name}: a coordinate is no number: {error}.") from None


_SECTIONS: Final = re.compile(rb"^(DATASET|POINTS|CELLS|CELL_TYPES)[ \t]+(\S+)", re.MULTILINE)


def _check_legacy(text: bytes, path: str, name: str) -> None:
    sections = {match[1]: match[2] for match in reversed(list(_SECTIONS.finditer(text)))}
    if sections.get(b"DATASET") != b"UNSTRUCTURED_GRID":
        what = sections.get(b"DATASET", b"nothing").decode("ascii", "replace")
        raise HexlensError(f"{name}: it holds {what}; unstructured grids are read here. This does it: npx hexlens check {path}")
    points, cells, types = (_count(sections.get(key)) for key in (b"POINTS", b"CELLS", b"CELL_TYPES"))
    version = re.search(rb"Version\s+(\d+)", text[:256])
    ends = cells - 1 if version is not None and int(version[1]) >= 5 and cells > 0 else cells
    if None in (points, cells, types) and (cells or types):
        raise HexlensError(f"{name}: a count is no whole number: it is damaged.")
    if types != ends:
        raise HexlensError(f"{name}: CELL_TYPES has {types}, CELLS has {ends} cells.")
    if max(points, cells) > len(text):
        raise HexlensError(f"{name}: it says that it has {max(points, cells)} points or cells, more than it has bytes.")
    if not _is_ascii(text):
        return
    _check_numbers(text, name)


def _count(word: bytes | None) -> int:
    return int(word) if word is not None and re.fullmatch(rb"\d{1,15}", word) else 0 if word is None else -1


def _is_ascii(text: bytes) -> bool:
    return re.match(rb"[^\n]*\n[^\n]*\n\s*ASCII", text) is not None


def _check_numbers(text: bytes, name: str) -> None:
    """Indices that VTK would round and words that it would skip."""
    found = re.search(rb"^CELLS[^\n]*\n(.*?)(?=^[A-Z_]{4,}\s)", text + b"\nTHE_END ", re.MULTILINE | re.DOTALL)
    body = re.sub(rb"^(?:OFFSETS|CONNECTIVITY)[^\n]*$", b"", found[1], flags=re.MULTILINE) if found else b""
    wrong = re.search(rb"[^\d\s]\S*|\d+[^\d\s]\S*", body)
    if wrong is not None:
        raise HexlensError(
            f"{name}: “{wrong[0][:40].decode('ascii', 'replace')}” in CELLS stands where an index, a whole number from 0 on, was expected."
        )


def _from_vtk(grid: Any, format_: str, refuse: Any = None) -> Mesh:
    """Of a pyvista.UnstructuredGrid or a vtkUnstructuredGrid."""
    from vtkmodules.util.numpy_support import vtk_to_numpy

    def array(of: Any) -> NDArray[Any]:
        return np.asarray(vtk_to_numpy(of))

    maker = MeshMaker(format_, refuse or (lambda what: HexlensError(f"The grid: {what}")))
    count = grid.GetNumberOfCells()
    points = array(grid.GetPoints().GetData()) if grid.GetPoints() else np.empty((0, 3))
    cells = grid.GetCells()
    is_float32 = points.dtype == np.float32
    data, own = grid.GetCellData(), {}
    for i in range(data.GetNumberOfArrays()):
        values = data.GetArray(i)
        if values is not None and values.GetNumberOfComponents() == 1:
            own[values.GetName() or ""] = array(values)
    global_ids = data.GetGlobalIds()
    maker.add(
        Grid(
            points_of(points),
            # Its name before VTK 9.6 is GetCellTypesArray; pyvista.UnstructuredGrid has either.
            array(grid.GetCellTypesArray() if _is_old_vtk() else grid.GetCellTypes()) if count else np.empty(0, np.uint8),
            array(cells.GetOffsetsArray())[1:] if count else np.empty(0, np.int64),
            array(cells.GetConnectivityArray()) if count else np.empty(0, np.int64),
            CellArrays(own, None if global_ids is None else global_ids.GetName()),
            8 * 2.0 ** (-24 if is_float32 else -52),
        )
    )
    return maker.mesh()


def _is_old_vtk() -> bool:
    from vtkmodules.vtkCommonCore import vtkVersion

    return (vtkVersion.GetVTKMajorVersion(), vtkVersion.GetVTKMinorVersion()) < (9, 6)


_MESHIO_KINDS: Final = (
    (r"hexahedron", "hexahedron"), (r"hexahedron\d+|VTK_(?:LAGRANGE|BEZIER)_HEXAHEDRON|hexahedron_.*", "-"),
    (r"tetra.*|VTK_.*_TETRAHEDRON", "tetrahedron"), (r"wedge.*|VTK_.*_WEDGE", "wedge"),
    (r"pyramid.*|VTK_.*_PYRAMID", "pyramid"), (r"quad.*|VTK_.*_QUADRILATERAL|pixel", "quadrilateral"),
    (r"triangle.*|VTK_.*_TRIANGLE", "triangle"), (r"line.*|VTK_.*_CURVE", "line"), (r"vertex|poly_vertex", "vertex"),
    (r"polygon.*", "polygon"), (r"polyhedron.*", "polyhedron"), (r"voxel", "voxel"),
)  # fmt: skip


def _from_meshio(source: Any) -> Mesh:
    cells: list[NDArray[Any]] = []
    corners: list[NDArray[Any]] = []
    places: list[NDArray[np.int64]] = []
    other: dict[str, int] = {}
    at = 0
    for block in source.cells:
        kind = next((kind for pattern, kind in _MESHIO_KINDS if re.fullmatch(pattern, block.type)), "other")
        data = np.asarray(block.data) if kind in ("hexahedron", "voxel", "-") else block.data
        if kind in ("hexahedron", "voxel"):
            own = cells_of(data)
            cells.append(own if kind == "hexahedron" else own[:, [0, 1, 3, 2, 4, 5, 7, 6]])
            places.append(np.arange(at, at + len(data)))
        elif kind == "-":
            corners.append(data[:, :8].astype(np.int64))
        elif len(data):
            other[kind] = other.get(kind, 0) + len(data)
        at += len(data)
    mesh = Mesh(
        "meshio",
        points_of(source.points),
        np.concatenate(cells) if cells else np.empty((0, 8), np.int64),
        np.concatenate(places) if places else np.empty(0, np.int64),
        at,
        corners=np.concatenate(corners) if corners else np.empty((0, 8), np.int64),
        other=other,
    )
    whole = {name: np.concatenate([np.asarray(part) for part in parts]) for name, parts in source.cell_data.items() if _are_flat(parts)}
    _add_blocks(mesh, source.cell_sets, [len(block.data) for block in source.cells], whole)
    return mesh


def _are_flat(parts: Sequence[Any]) -> bool:
    return len(parts) > 0 and all(np.ndim(part) == 1 and np.asarray(part).dtype.kind in "iuf" for part in parts)


def _add_blocks(mesh: Mesh, sets: Mapping[str, Any], sizes: Sequence[int], data: Mapping[str, NDArray[Any]]) -> None:
    """Named sets first, then the array that puts cells into blocks."""
    index = np.full(mesh.source_count, -1)
    index[mesh.places] = np.arange(len(mesh.cells))
    starts = np.concatenate([[0], np.cumsum(sizes)])
    for name, members in sets.items():
        own = [start + np.asarray(part, np.int64) for start, part in zip(starts, members, strict=False) if part is not None and len(part)]
        found = index[np.concatenate(own)] if own else np.empty(0, np.int64)
        if (found >= 0).any():
            mesh.blocks.append((str(name), np.sort(found[found >= 0])))
    arrays = {name: values for name, values in data.items() if len(values) == mesh.source_count}
    ids, block = cell_names(arrays, None)
    if ids is not None and len(mesh.cells):
        mesh.ids = arrays[ids][mesh.places]
    if block is not None:
        values = arrays[block][mesh.places]
        distinct, first = np.unique(values, return_index=True)
        mesh.blocks += [(f"{block} {int(value)}", np.flatnonzero(values == value)) for value in distinct[np.argsort(first)]]


#: Element types of Gmsh by its own property "Hexahedron" and so on: numbers of nodes tell hexahedra from those of more nodes.
_GMSH_FAMILIES: Final = {
    "Point": "vertex", "Line": "line", "Triangle": "triangle", "Quadrilateral": "quadrilateral", "Tetrahedron": "tetrahedron",
    "Prism": "wedge", "Pyramid": "pyramid", "Hexahedron": "hexahedron",
}  # fmt: skip


def _from_gmsh(model: Any) -> Mesh:
    """The mesh of Gmsh's current model, with its element tags; the physical groups are blocks, and the volumes."""
    tags, coordinates, _ = model.mesh.getNodes()
    order = np.argsort(tags)
    sorted_tags = np.asarray(tags)[order]

    def indices(nodes: NDArray[Any]) -> NDArray[np.int64]:
        found: NDArray[np.int64] = order[np.minimum(np.searchsorted(sorted_tags, nodes), max(len(order) - 1, 0))]
        return found

    cells: list[NDArray[np.int64]] = []
    ids: list[NDArray[Any]] = []
    corners: list[NDArray[np.int64]] = []
    other: dict[str, int] = {}
    blocks: dict[str, list[int]] = {}
    count = 0
    for dimension, tag in model.getEntities():
        for kind, elements, nodes in zip(*model.mesh.getElements(dimension, tag), strict=True):
            name, _, _, size, _, _ = model.mesh.getElementProperties(kind)
            family = _GMSH_FAMILIES.get(name.split(" ")[0], "other")
            if family != "hexahedron":
                other[family] = other.get(family, 0) + len(elements)
            elif size == 8:
                cells.append(indices(np.asarray(nodes)).reshape(-1, 8))
                ids.append(np.asarray(elements, np.int64))
                groups = model.getPhysicalGroupsForEntity(dimension, tag)
                names = [model.getPhysicalName(dimension, group) or f"physical {group}" for group in groups]
                for block in (*names, f"volume {tag}"):
                    blocks.setdefault(block, []).extend(range(count, count + len(elements)))
                count += len(elements)
            else:
                corners.append(indices(np.asarray(nodes)).reshape(-1, size)[:, :8])
    _check_gmsh_s_count(count + sum(map(len, corners)))
    return Mesh(
        "Gmsh",
        np.asarray(coordinates, np.float64).reshape(-1, 3),
        np.concatenate(cells) if cells else np.empty((0, 8), np.int64),
        ids=np.concatenate(ids) if ids else None,
        blocks=[(name, np.array(own)) for name, own in blocks.items()],
        corners=np.concatenate(corners) if corners else np.empty((0, 8), np.int64),
        other=other,
    )


def _check_gmsh_s_count(listed: int) -> None:
    """Gmsh does not list cells of 20 nodes that stand beside linear ones, but it counts them."""
    gmsh = sys.modules.get("gmsh")
    if gmsh is None:
        return
    counted = int(gmsh.option.getNumber("Mesh.NbHexahedra"))
    if counted != listed:
        raise HexlensError(
            f"Gmsh counts {counted} hexahedra in its model and lists {listed}, so not all can be checked: "
            "write it by gmsh.write('model.msh'). This reads it whole: npx hexlens check model.msh"
        )


def put_cell_arrays(result: "MeshCheck", mesh: Any) -> Any:
    """Into `cell_data` of a meshio.Mesh or a PyVista grid."""
    sizes = [len(block.data) for block in mesh.cells] if _is_meshio(mesh) else None
    count = sum(sizes) if sizes is not None else getattr(mesh, "n_cells", None)
    if count is None or not hasattr(mesh, "cell_data"):
        raise HexlensError(
            f"A {type(mesh).__name__} has no cell data to put answers into: a meshio.Mesh or a pyvista grid is expected; "
            "`arrays()` gives them."
        )
    places = result.mesh.places
    expected = result.hexahedra if places is None else result.mesh.source_count
    if count != expected:
        raise HexlensError(f"The mesh has {count} cells, and {expected} were checked: it is another one.")
    for name, values in result.arrays().items():
        whole = values
        if places is not None:
            whole = np.full(count, 255 if values.dtype == np.uint8 else np.nan, values.dtype)
            whole[places] = values
        mesh.cell_data[name] = whole if sizes is None else np.split(whole, np.cumsum(sizes)[:-1])
    return mesh
