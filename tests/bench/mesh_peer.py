"""PyVista, started before the clock: python mesh_peer.py reads lines "list FILE" or "picture FILE" and answers each with milliseconds.

list: read, the scaled Jacobian of all cells, their order. picture: read, scaled Jacobian, surface, its picture off the screen.
"""

import sys
import time

import numpy as np
import pyvista

WORST = 10


def list_of(path):
    mesh = pyvista.read(path)
    quality = mesh.cell_quality("scaled_jacobian").cell_data["scaled_jacobian"]
    return np.argsort(quality)[:WORST]


def picture_of(path):
    mesh = pyvista.read(path).cell_quality("scaled_jacobian")
    surface = mesh.extract_surface(algorithm="dataset_surface")
    plotter = pyvista.Plotter(off_screen=True, window_size=[1280, 720])
    plotter.add_mesh(surface, scalars="scaled_jacobian", show_edges=True)
    image = plotter.screenshot(None)
    plotter.close()
    return image


JOBS = {"list": list_of, "picture": picture_of}


def main():
    pyvista.Sphere().cell_quality("scaled_jacobian")
    print("ready", flush=True)
    for line in sys.stdin:
        job, path = line.strip().split(" ", 1)
        begun = time.perf_counter()
        JOBS[job](path)
        print(1000 * (time.perf_counter() - begun), flush=True)


main()
