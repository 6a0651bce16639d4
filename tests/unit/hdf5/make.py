"""Writes the HDF5 files of hdf5.test.ts beside this script: python make.py, with h5py, netCDF4 and gmsh.

Files of two or three boxes along x, each a unit high and as long as its number says, so that their volumes tell them apart.
"""
from pathlib import Path

import gmsh
import h5py
import netCDF4
import numpy as np

HERE = Path(__file__).parent


def boxes(lengths, height=1.0):
    """Points and nodes (from 0) of boxes side by side."""
    xs = np.concatenate([[0.0], np.cumsum(lengths)])
    w = len(xs)
    points = [(x, y, z) for z in (0.0, height) for y in (0.0, 1.0) for x in xs]
    bottom = [[i, i + 1, i + 1 + w, i + w] for i in range(len(lengths))]
    return np.array(points), np.array([b + [n + 2 * w for n in b] for b in bottom])


def quadratic(points, nodes):
    """Further nodes at the middles of edges, in VTK's order."""
    edges = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)]
    more = np.array([[(points[row[a]] + points[row[b]]) / 2 for a, b in edges] for row in nodes])
    ids = len(points) + np.arange(12 * len(nodes)).reshape(len(nodes), 12)
    return np.concatenate([points, more.reshape(-1, 3)]), np.hstack([nodes, ids])


def file(name):
    return h5py.File(HERE / name, "w", libver=("earliest", "v110"))


def vtk_grid(group, steps):
    """Parts of (points, nodes) for each step, as VTK's own writer lays them out."""
    group.attrs["Version"] = [2, 0]
    group.attrs.create("Type", b"UnstructuredGrid", dtype="S16")
    parts = [part for step in steps for part in step]
    group["Points"] = np.concatenate([p for p, _ in parts])
    group["Connectivity"] = np.concatenate([c.ravel() for _, c in parts])
    group["Offsets"] = np.concatenate([np.arange(0, 8 * len(c) + 1, 8) for _, c in parts])
    group["Types"] = np.concatenate([np.full(len(c), 12, np.uint8) for _, c in parts])
    group["NumberOfPoints"] = [len(p) for p, _ in parts]
    group["NumberOfCells"] = [len(c) for _, c in parts]
    group["NumberOfConnectivityIds"] = [c.size for _, c in parts]
    data = group.create_group("CellData")
    data["MaterialIds"] = np.concatenate([np.arange(len(c)) for _, c in parts])
    if len(steps) == 1:
        return
    counts = [(len(s), sum(len(p) for p, _ in s), sum(len(c) for _, c in s)) for s in steps]
    before = np.concatenate([[[0, 0, 0]], np.cumsum(counts, axis=0)])[:-1]
    own = group.create_group("Steps")
    own.attrs["NSteps"] = len(steps)
    own["Values"] = np.arange(len(steps)) * 0.5
    own["NumberOfParts"] = [n for n, _, _ in counts]
    own["PartOffsets"] = before[:, 0]
    own["PointOffsets"] = before[:, 1]
    own["CellOffsets"] = before[:, 2:]
    own["ConnectivityIdOffsets"] = 8 * before[:, 2:]
    own.create_group("CellDataOffsets")["MaterialIds"] = before[:, 2]


with file("parts.vtkhdf") as h:
    vtk_grid(h.create_group("VTKHDF"), [[boxes([1, 2]), boxes([3])]])
with file("steps.vtkhdf") as h:
    vtk_grid(h.create_group("VTKHDF"), [[boxes([1, 2])], [boxes([1, 2], 1.5), boxes([3])], [boxes([4])]])
with file("collection.vtkhdf") as h:
    root = h.create_group("VTKHDF", track_order=True)
    root.attrs["Version"] = [2, 1]
    root.attrs["Type"] = "PartitionedDataSetCollection"  # of any length
    for index, (name, lengths) in enumerate({"left": [1, 2], "right": [3]}.items()):
        vtk_grid(root.create_group(name), [[boxes(lengths)]])
        root[name].attrs["Index"] = index
    assembly = root.create_group("Assembly", track_order=True)
    for name in ("left", "right"):
        assembly[name] = h5py.SoftLink(f"/VTKHDF/{name}")
with file("linked.vtkhdf") as h:
    root = h.create_group("VTKHDF")
    root.attrs["Version"] = [2, 1]
    root.attrs["Type"] = "PartitionedDataSetCollection"
    vtk_grid(root.create_group("left"), [[boxes([1])]])
    root["right"] = h5py.ExternalLink("right.vtkhdf", "/VTKHDF")


def cgns(parent, name, label, data=None):
    group = parent.create_group(name)
    kind = {None: b"MT", "float64": b"R8", "float32": b"R4", "int32": b"I4", "int64": b"I8", "int8": b"C1"}
    group.attrs.create("name", name.encode(), dtype="S33")
    group.attrs.create("label", label.encode(), dtype="S33")
    group.attrs.create("type", kind[None if data is None else str(data.dtype)], dtype="S3")
    if data is not None:
        group[" data"] = data
    return group


def text(words):
    return np.frombuffer(words.encode(), np.int8)


def zone(base, name, kind, sizes, points, dtype=np.float64):
    own = cgns(base, name, "Zone_t", np.array(sizes, np.int32))
    cgns(own, "ZoneType", "ZoneType_t", text(kind))
    grid = cgns(own, "GridCoordinates", "GridCoordinates_t")
    for axis, values in zip("XYZ", points.T):
        shape = sizes[0][::-1] if kind == "Structured" else -1
        cgns(grid, f"Coordinate{axis}", "DataArray_t", values.astype(dtype).reshape(shape))
    return own


def section(own, name, number, first, count, nodes):
    group = cgns(own, name, "Elements_t", np.array([number, 0], np.int32))
    cgns(group, "ElementRange", "IndexRange_t", np.array([first, first + count - 1], np.int32))
    cgns(group, "ElementConnectivity", "DataArray_t", np.array(nodes, np.int32).ravel())


with file("zones.cgns") as h:
    for key, words, size in (("name", "HDF5 MotherNode", 33), ("label", "Root Node of HDF5 File", 33), ("type", "MT", 3)):
        h.attrs.create(key, words.encode(), dtype=f"S{size}")
    h[" format"] = text("IEEE_LITTLE_32\0")
    h[" hdf5version"] = text("HDF5 Version 1.10.0".ljust(33, "\0"))
    cgns(h, "CGNSLibraryVersion", "CGNSLibraryVersion_t", np.array([3.3], np.float32))
    base = cgns(h, "Base", "CGNSBase_t", np.array([3, 3], np.int32))
    points, nodes = boxes([1, 2, 3])
    points, nodes20 = quadratic(points, nodes[2:])
    one = zone(base, "mixed", "Unstructured", [[len(points)], [4], [0]], points)
    mixed = [17, *(nodes[0] + 1), 10, 1, 2, 5, 9, 18, *(nodes20[0] + 1)]
    section(one, "some", 20, 5, 3, mixed)
    section(one, "plain", 17, 8, 1, nodes[1] + 1)
    x, y, z = np.meshgrid([0, 1, 3], [0, 1], [0, 1, 2], indexing="ij")
    lattice = np.stack([a.transpose(2, 1, 0).ravel() for a in (x, y, z)], axis=1)
    zone(base, "lattice", "Structured", [[3, 2, 3], [2, 1, 2], [0, 0, 0]], lattice, np.float32)

with file("elements.h5m") as h:
    points, nodes = boxes([1, 2])
    root = h.create_group("tstt")
    coordinates = root.create_group("nodes").create_dataset("coordinates", data=points, compression="gzip")
    coordinates.attrs["start_id"] = 1
    group = root.create_group("elements").create_group("Hex8")
    group.create_dataset("connectivity", data=nodes + 1, compression="gzip").attrs["start_id"] = len(points) + 1

with netCDF4.Dataset(HERE / "named.exo", "w") as n:
    points, nodes = boxes([1, 2])
    for name, size in {"len_name": 33, "num_dim": 3, "num_nodes": len(points), "num_elem": 2, "num_el_blk": 1,
                       "num_el_in_blk1": 2, "num_nod_per_el1": 8, "time_step": None}.items():
        n.createDimension(name, size)
    n.createVariable("coord", "f4", ("num_dim", "num_nodes"), zlib=True)[:] = points.T
    names = n.createVariable("eb_names", "S1", ("num_el_blk", "len_name"))
    names[:] = netCDF4.stringtochar(np.array(["core"], "S33"))
    connect = n.createVariable("connect1", ">i8", ("num_el_in_blk1", "num_nod_per_el1"), zlib=True, endian="big")
    connect.elem_type = "HEX8"
    connect[:] = nodes + 1
    n.createVariable("time_whole", "f8", ("time_step",))[:] = [0.5, 1.5]

gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0)
gmsh.model.occ.addBox(0, 0, 0, 1, 1, 1)
gmsh.model.occ.synchronize()
for dimension, tag in gmsh.model.getEntities():
    if dimension == 1:
        gmsh.model.mesh.setTransfiniteCurve(tag, 3)
    elif dimension == 2:
        gmsh.model.mesh.setTransfiniteSurface(tag)
        gmsh.model.mesh.setRecombine(2, tag)
    elif dimension == 3:
        gmsh.model.mesh.setTransfiniteVolume(tag)
gmsh.model.addPhysicalGroup(3, [1], 5)
gmsh.model.setPhysicalName(3, 5, "core")
gmsh.model.mesh.generate(3)
gmsh.write(str(HERE / "groups.med"))
gmsh.finalize()

with file("bare.h5") as h:
    h["numbers"] = np.arange(24.0).reshape(8, 3)
    h.create_dataset("packed", data=np.arange(24.0), compression="lzf")

for name, attribute in (("structured.med", "TYP"), ("cylindrical.med", "REP")):
    with file(name) as h:
        h.create_group("ENS_MAA/mesh").attrs.create(attribute, 1, dtype=np.int32)
