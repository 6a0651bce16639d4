"""Writes the files of steps-in-one-file.test.ts beside this script: python make.py, with netCDF4, h5py, meshio and VTK.

Two unit cubes side by side at four times. Vertex 6 of the second moves along the diagonal, to 1, 0.8, 0.6 and 0.3 of its place in
the cube: its jacdet there is 3 times that less 2, so that the cube is invalid from the third time on.
"""
from pathlib import Path

import meshio
import netCDF4
import numpy as np
import vtk

HERE = Path(__file__).parent
TIMES = [0.0, 0.25, 0.5, 1.0]
PLACES = [1.0, 0.8, 0.6, 0.3]

points = np.array([(x, y, z) for z in (0.0, 1.0) for y in (0.0, 1.0) for x in (0.0, 1.0, 2.0)])
cells = np.array([[i, i + 1, i + 4, i + 3, i + 6, i + 7, i + 10, i + 9] for i in (0, 1)])
moving = cells[1][6]


def displacements(step):
    moved = np.zeros_like(points)
    moved[moving] = PLACES[step] - 1
    return moved


def names(words):
    return netCDF4.stringtochar(np.array(words, "S33"))


def exodus(name, form, results, is_together=False, kind="f8"):
    """`results` are names of results in nodes; those that end in x, y, z are displacements, others zero. In old files
    the axes are together, and so are the results."""
    with netCDF4.Dataset(HERE / name, "w", format=form) as out:
        sizes = {"len_name": 33, "time_step": None, "num_dim": 3, "num_nodes": len(points), "num_elem": 2,
                 "num_el_blk": 1, "num_el_in_blk1": 2, "num_nod_per_el1": 8, "num_nod_var": len(results)}
        for dimension, size in sizes.items():
            out.createDimension(dimension, size)
        out.setncatts({"api_version": np.float32(8.11), "version": np.float32(8.11), "title": "cubes",
                       "floating_point_word_size": np.int32(8), "file_size": np.int32(not is_together)})
        out.createVariable("eb_status", "i4", ("num_el_blk",))[:] = 1
        blocks = out.createVariable("eb_prop1", "i4", ("num_el_blk",))
        blocks.setncattr("name", "ID")
        blocks[:] = 10
        if is_together:
            out.createVariable("coord", "f8", ("num_dim", "num_nodes"))[:] = points.T
        else:
            for axis, values in zip("xyz", points.T):
                out.createVariable(f"coord{axis}", "f8", ("num_nodes",))[:] = values
        out.createVariable("elem_num_map", "i4", ("num_elem",))[:] = [7, 9]
        connect = out.createVariable("connect1", "i4", ("num_el_in_blk1", "num_nod_per_el1"))
        connect.elem_type = "HEX8"
        connect[:] = cells + 1
        out.createVariable("name_nod_var", "S1", ("num_nod_var", "len_name"))[:] = names(results)
        out.createVariable("time_whole", "f8", ("time_step",))[:] = TIMES
        if is_together:
            together = out.createVariable("vals_nod_var", kind, ("time_step", "num_nod_var", "num_nodes"))
        for index, result in enumerate(results):
            own = None if is_together else out.createVariable(f"vals_nod_var{index + 1}", kind, ("time_step", "num_nodes"))
            axis = "xyz".find(result[-1].lower())
            for step in range(len(TIMES)):
                values = displacements(step)[:, axis] if axis >= 0 else np.zeros(len(points))
                if is_together:
                    together[step, index] = values
                else:
                    own[step] = values


exodus("classic.e", "NETCDF3_CLASSIC", ["temperature", "disp_x", "disp_y", "disp_z"])
exodus("together.e", "NETCDF3_64BIT_OFFSET", ["DISPLX", "DISPLY", "DISPLZ", "VELX"], is_together=True)
exodus("netcdf4.exo", "NETCDF4", ["displacement_x", "displacement_y", "displacement_z"], kind="f4")
exodus("results.e", "NETCDF3_CLASSIC", ["temperature", "velx", "vely", "velz", "disp_x", "disp_y"])

# The same by VTK, which reads the displacements itself.
reader = vtk.vtkExodusIIReader()
reader.SetFileName(str(HERE / "classic.e"))
reader.UpdateInformation()
reader.SetAllArrayStatus(vtk.vtkExodusIIReader.NODAL, 1)
hdf = vtk.vtkHDFWriter()
hdf.SetInputConnection(reader.GetOutputPort())
hdf.SetFileName(str(HERE / "moving.vtkhdf"))
hdf.SetWriteAllTimeSteps(True)
hdf.SetChunkSize(100)
hdf.Write()
xdmf = vtk.vtkXdmfWriter()
xdmf.SetInputConnection(reader.GetOutputPort())
xdmf.SetFileName(str(HERE / "moving.xmf"))
xdmf.SetWriteAllTimeSteps(1)
xdmf.SetLightDataLimit(1_000_000)
xdmf.Write()

with meshio.xdmf.TimeSeriesWriter(HERE / "results.xdmf", data_format="XML") as series:
    series.write_points_cells(points, [("hexahedron", cells)])
    for step, time in enumerate(TIMES):
        series.write_data(time, point_data={"u": displacements(step)})
