"""What a mesh in pieces costs, piece by piece: docs/dask.md. Processor time, one thread, medians; then two workers by the clock.

    build/package-python/bin/python python/bench/pieces.py [PIECES]

Beyond the measured pieces, times are products: so many pieces times what one costs.
"""

import os
import resource
import statistics
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import distributed
import numpy as np
import pyvista

import hexlens
import hexlens.dask
from bench import hexlens_vtu
from hexlens._sources import read_file

#: Cells along the axes of a piece: 500,000.
SIDES = (100, 100, 50)
BILLION = 10**9


def box() -> tuple[np.ndarray, np.ndarray]:
    """Cells that share points, moved by 0.1 of a side at random: sigma of docs/benchmarks.md."""
    counts = [side + 1 for side in SIDES]
    points = np.stack(np.meshgrid(*[np.arange(float(count)) for count in counts], indexing="ij"), axis=-1)
    points += np.random.default_rng(1).normal(0, 0.1, points.shape)
    places = np.meshgrid(*[np.arange(side) for side in SIDES], indexing="ij")
    corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    cells = [np.ravel_multi_index([place + step for place, step in zip(places, corner, strict=True)], counts) for corner in corners]
    return points.reshape(-1, 3), np.stack(cells, axis=-1).reshape(-1, 8).astype(np.int32)


def seconds(work: Callable[[], object], rounds: int = 5) -> float:
    times = []
    for _ in range(rounds):
        start = time.process_time()
        work()
        times.append(time.process_time() - start)
    return statistics.median(times)


def peak() -> int:
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * (1 if sys.platform == "darwin" else 1024)


def main() -> None:
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 16
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        points, cells = box()
        raw = str(folder / "raw.vtu")
        hexlens_vtu(raw, points, cells)
        packed = str(folder / "zlib.vtu")
        pyvista.UnstructuredGrid({pyvista.CellType.HEXAHEDRON: cells}, points).save(packed)
        print(f"{len(cells)} cells a piece, {os.path.getsize(raw) / 1e6:.0f} MB raw, {os.path.getsize(packed) / 1e6:.0f} MB packed")
        for what, file in (("raw", raw), ("packed by zlib", packed)):
            reading = seconds(lambda file=file: read_file(file))  # type: ignore[misc]
            whole = seconds(lambda file=file: hexlens.check(file, threads=1))  # type: ignore[misc]
            hours = whole * BILLION / len(cells) / 3600
            print(f"{what}: {reading:.3f} s to read, {whole:.3f} s in all; a billion cells {hours:.2f} hours of one core")
        pieces = folder / "pieces"
        pieces.mkdir()
        for number in range(count):
            os.link(raw, pieces / f"piece-{number}.vtu")
        with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=":0") as cluster, cluster.get_client() as client:
            hexlens.dask.check([raw])
            before = client.run(peak)
            start = time.perf_counter()
            result = hexlens.dask.check(pieces)
            spent = time.perf_counter() - start
            growth = max(bytes_ - before[worker] for worker, bytes_ in client.run(peak).items())
        print(f"two workers: {result.hexahedra} cells in {count} pieces, {spent:.2f} s by the clock, {spent / count:.3f} s a piece")
        print(f"a worker had {max(before.values()) / 1e6:.0f} MB after its first piece, and {growth / 1e6:.0f} MB more in the end")


if __name__ == "__main__":
    main()
