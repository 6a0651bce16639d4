"""What the Python package costs beside the C library and PyVista: one process, in turns, medians. `npm run bench -- python` runs it.

--quick   100,000 cells and 1,000,000 in place of 1,000,000 and 10,000,000
"""

import json
import os
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from ctypes import byref
from pathlib import Path

import numpy as np

import hexlens
from hexlens import _native

ROUNDS = 7


def lattice(n: int) -> tuple[np.ndarray, np.ndarray]:
    """n^3 cells that share points, moved by 0.1 of a side at random: sigma of docs/benchmarks.md."""
    points = np.stack(np.meshgrid(*[np.arange(n + 1.0)] * 3, indexing="ij"), axis=-1)
    points += np.random.default_rng(1).normal(0, 0.1, points.shape)
    i, j, k = np.meshgrid(*[np.arange(n)] * 3, indexing="ij")
    corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    cells = np.stack([((i + a) * (n + 1) + j + b) * (n + 1) + k + c for a, b, c in corners], axis=-1)
    return np.ascontiguousarray(points.reshape(-1, 3)), cells.reshape(-1, 8).astype(np.int32)


def medians(
    ways: dict[str, Callable[[], object]], rounds: int = ROUNDS, clock: Callable[[], float] = time.process_time
) -> dict[str, float]:
    """Seconds of the processor, so that other programs count less; each goes first in turn."""
    times: dict[str, list[float]] = {name: [] for name in ways}
    names = list(ways)
    for way in ways.values():
        way()
    for turn in range(rounds):
        for i in range(len(names)):
            name = names[(i + turn) % len(names)]
            start = clock()
            ways[name]()
            times[name].append(clock() - start)
    return {name: statistics.median(own) for name, own in times.items()}


def of_c(points: np.ndarray, cells: np.ndarray, minima: bool) -> Callable[[], None]:
    """hl_classify in one call, with lists that are there already."""
    count = len(cells)
    lists = {"verdicts": np.empty(count, np.uint8), "statuses": np.empty(count, np.uint8)}
    if minima:
        lists |= {"minima": np.empty(count), "minimizers": np.empty(3 * count), "exponents": np.empty(count, np.int16)}
        lists |= {"is_exact": np.empty(count, np.uint8), "classes": np.empty(count, np.uint8)}

    def run() -> None:
        batch = _native.Batch(**{name: array.ctypes.data for name, array in lists.items()})
        _native.library.hl_classify(byref(_native.Cells(points.ctypes.data, points.size, cells.ctypes.data, cells.size)), byref(batch))

    return run


def shares(points: np.ndarray, cells: np.ndarray) -> dict[str, float]:
    """Seconds of the processor on one thread; on two, in the calling thread and in those that share the work. Other programs do not
    make them more, so they say what two free cores would do: the first part, and half of the second."""
    one, calling, helping = [], [], []
    for _ in range(5):
        start = time.process_time()
        hexlens.classify(points, cells, threads=1)
        one.append(time.process_time() - start)
        start, own = time.process_time(), time.thread_time()
        hexlens.classify(points, cells, threads=2)
        calling.append(time.thread_time() - own)
        helping.append(time.process_time() - start - calling[-1])
    return {"one": statistics.median(one), "calling": statistics.median(calling), "helping": statistics.median(helping)}


def in_process(*words: str) -> Callable[[], None]:
    return lambda: subprocess.run([sys.executable, *words], check=False, stdout=subprocess.DEVNULL) and None


def import_time() -> float:
    """Seconds of the processor in a new process that has NumPy already."""
    program = "import numpy, time; start = time.process_time(); import hexlens; print(time.process_time() - start)"
    return float(subprocess.run([sys.executable, "-c", program], check=True, capture_output=True).stdout)


def of_children() -> float:
    """Seconds of the processor, of all threads, in processes that have ended."""
    spent = os.times()
    return spent.children_user + spent.children_system


def main() -> None:
    import pyvista

    quick = "--quick" in sys.argv
    points, cells = lattice(46 if quick else 100)
    wide = cells.astype(np.int64)
    grid = pyvista.UnstructuredGrid({pyvista.CellType.HEXAHEDRON: cells}, points)
    many, many_cells = lattice(100 if quick else 215)
    folder = tempfile.TemporaryDirectory()
    file = str(Path(folder.name) / "mesh.vtu")
    hexlens_vtu(file, points, cells)
    one = medians(
        {
            "hl_classify": of_c(points, cells, False),
            "classify": lambda: hexlens.classify(points, cells, threads=1),
            "classify, 64-bit indices": lambda: hexlens.classify(points, wide, threads=1),
            "hl_classify with minima": of_c(points, cells, True),
            "classify with minima": lambda: hexlens.classify(points, cells, minima=True, threads=1),
            "PyVista scaled Jacobian": lambda: grid.cell_quality("scaled_jacobian"),
        }
    )
    threads = medians(
        {f"{n} threads": (lambda n=n: hexlens.classify(many, many_cells, threads=n)) for n in (1, 2)},  # type: ignore[misc]
        5,
        time.perf_counter,
    )
    read = f"import pyvista; pyvista.read({file!r}).cell_quality('scaled_jacobian')"
    ways = {"python -m hexlens check": in_process("-m", "hexlens", "check", file), "PyVista": in_process("-c", read)}
    command = medians(ways, 5, of_children)
    imports = {"hexlens, beyond NumPy": statistics.median(import_time() for _ in range(9))}
    cube = points[cells[0]]
    raw = _native.RawReport()
    calls = medians(
        {
            "hl_decide": lambda: [_native.library.hl_decide(cube.ctypes.data, byref(raw_verdict)) for _ in range(1000)],
            "hl_analyze": lambda: [_native.library.hl_analyze(cube.ctypes.data, byref(raw)) for _ in range(1000)],
            "analyze": lambda: [hexlens.analyze(cube) for _ in range(1000)],
        }
    )
    print(
        json.dumps(
            {
                "cells": len(cells),
                "many": len(many_cells),
                "vectors": hexlens.vectors(),
                "cores": len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count(),
                "one": one,
                "threads": threads,
                "shares": shares(many, many_cells),
                "command": command,
                "imports": imports,
                "calls": calls,
            }
        )
    )


raw_verdict = _native.c_int()


def hexlens_vtu(file: str, points: np.ndarray, cells: np.ndarray) -> None:
    """The mesh as a raw VTU."""
    from hexlens._outputs import FileResult, VtuOutput

    with open(file, "wb") as target:
        target.writelines(VtuOutput().file(FileResult(file, 0, hexlens.check((points, cells)))))


if __name__ == "__main__":
    main()
