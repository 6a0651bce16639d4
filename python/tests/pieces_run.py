"""A run of hexlens.dask on a LocalCluster of two processes, for test_dask: it is ended from outside. Workers wait with a piece in hand
where they are told to, so that what ends them comes in the middle.

    python pieces_run.py PIECES RECORD WATCH [ANNOTATE]

In the folder WATCH: NAME.gate says at which file the piece NAME waits; NAME.pid is written by the worker that has it; result.json is
the result.
"""

import json
import os
import resource
import sys
import time
from pathlib import Path
from typing import Any

import distributed

import hexlens.dask

WAIT_S = 0.005


class Gates(distributed.WorkerPlugin):
    """Workers that are started anew have it, too."""

    def __init__(self, watch: str) -> None:
        self.watch = watch

    def setup(self, worker: Any) -> None:
        read = hexlens.dask.read_file
        watch = Path(self.watch)

        def read_and_wait(path: str, format_: str | None) -> Any:
            mesh = read(path, format_)
            name = Path(path).stem
            (watch / f"{name}.pid").write_text(str(os.getpid()))
            gate = watch / f"{name}.gate"
            while gate.exists() and not (watch / gate.read_text()).exists():
                time.sleep(WAIT_S)
            return mesh

        hexlens.dask.read_file = read_and_wait


def peak() -> int:
    """Bytes that the process had at most."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * (1 if sys.platform == "darwin" else 1024)


def main() -> None:
    pieces, record, watch, *annotate = sys.argv[1:]
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=":0") as cluster, cluster.get_client() as client:
        client.register_plugin(Gates(watch))
        before = client.run(peak)
        start = time.perf_counter()
        result = hexlens.dask.check(pieces, record=record, annotate=annotate[0] if annotate else None)
        seconds = time.perf_counter() - start
        growth = {worker: bytes_ - before[worker] for worker, bytes_ in client.run(peak).items() if worker in before}
    said = {**result.to_dict(), "headline": result.headline(), "seconds": seconds, "growth": max(growth.values(), default=0)}
    Path(watch, "result.json").write_text(json.dumps(said))


if __name__ == "__main__":
    main()
