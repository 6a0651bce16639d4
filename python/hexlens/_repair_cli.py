"""`python -m hexlens repair`: a mesh in, its hexahedra with points moved out as VTU; the exit status is that of `check` for them."""

import argparse
import dataclasses
import os
import re
import sys
from collections.abc import Sequence
from typing import Final, NoReturn

from ._arrays import HexlensError
from ._check import check_mesh
from ._cli import FileSink, path_of
from ._outputs import FileResult, TextOutput, VtuOutput, without_controls
from ._repair import Repair, repair
from ._sources import read_file

__all__ = ["REPAIR_USAGE", "repair_command"]

REPAIR_USAGE: Final = """Usage: python -m hexlens repair [OPTION...] FILE -o OUT.vtu

Reads a mesh, moves vertices so that hexahedra become valid, and writes the hexahedra to OUT as VTU. FILE stays as it is; "-" is
standard input. VTU, .pvtu and VTK legacy are read; npx hexlens repair has the same options, reads other formats, too, and writes
the format of FILE. Each move takes a vertex to the best place for the worst of its cells, and never makes that worse. It knows no
geometry but what stays, and a mesh whose topology forbids validity stays invalid: docs/repair.md.

  -o, --output OUT     the file to write
  --min-relative R     moves on until the least minimum of jacdet over |volume| is R, from 0 to 1; without, until all are valid
  --slide              vertices on planar parts of the boundary move in their plane, those on a straight edge of it along it
  --free-boundary D    vertices of the boundary move by D at most, in the unit of the coordinates; with --slide only in their
                       planes where they have one
  --format NAME        the file is in this format, whatever it looks like
  --step N|last        which time step is read of a file that has several (1)
  --allow-unchecked    exit status 0 in place of 3

Exit status: that of python -m hexlens check OUT, with the same R.
"""


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        raise HexlensError(f"repair: {message}. python -m hexlens repair --help says what there is.")


def _number_of(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = -1
    if 0 <= value < float("inf"):
        return value
    raise argparse.ArgumentTypeError(f"a number from 0 on is expected, not {text}")


def _step_of(text: str) -> int | str:
    if text == "last" or re.fullmatch(r"[1-9][0-9]{0,8}", text):
        return text if text == "last" else int(text)
    raise argparse.ArgumentTypeError(f"a number from 1 on or last is expected, not {text}")


def _parser() -> _Parser:
    parser = _Parser(prog="repair", add_help=False, allow_abbrev=False)
    parser.add_argument("file")
    parser.add_argument("-o", "--output", required=True)
    parser.add_argument("--min-relative", type=_number_of)
    parser.add_argument("--free-boundary", type=_number_of, default=0.0)
    parser.add_argument("--slide", action="store_true")
    parser.add_argument("--format")
    parser.add_argument("--step", type=_step_of, default=1)
    parser.add_argument("--allow-unchecked", action="store_true")
    return parser


def repair_command(arguments: Sequence[str]) -> int:
    """The exit status."""
    wanted = _parser().parse_args(list(arguments))
    if wanted.file != "-" and os.path.realpath(wanted.file) == os.path.realpath(wanted.output):
        raise HexlensError(f"repair: {wanted.output} is what is read, and stays as it is: name another file to write.")
    sink = FileSink(wanted.output)
    try:
        with path_of(wanted.file) as path:
            mesh = read_file(path, wanted.format, wanted.step)
        done = repair(
            mesh.points,
            mesh.cells,
            min_relative=wanted.min_relative or 0.0,
            slide=wanted.slide,
            free_boundary=wanted.free_boundary,
        )
        moved = dataclasses.replace(mesh, points=done.points)
        check = check_mesh(moved, wanted.output, worst=10, min_relative=wanted.min_relative, skip_degenerate=False)
        status = 0 if check.exit == 3 and wanted.allow_unchecked else check.exit
        result = FileResult(wanted.output, status, check)
        for chunk in VtuOutput().file(result):
            sink.write(chunk)
        sink.close()
        for line in _lines(wanted.file, wanted.output, done, wanted.min_relative or 0.0):
            sys.stdout.write(f"{line}\n")
        for text in TextOutput(False).file(result):
            sys.stdout.write(text if isinstance(text, str) else text.decode())
        sys.stdout.flush()
        return int(status)
    finally:
        sink.discard()


def _lines(source: str, target: str, done: Repair, margin: float) -> list[str]:
    below = f", {done.below_before - done.below_after} of {done.below_before} below {margin:g}" if margin > 0 else ""
    lines = [
        f"{without_controls(source)} is written to {without_controls(target)}, its hexahedra alone, as VTU.",
        f"  Repaired: {done.invalid_before - done.invalid_after} of {done.invalid_before} invalid hexahedra{below}.",
        f"  Points moved: {done.moved_count}, by {done.greatest_distance:.5g} at most and {done.mean_distance:.5g} on average.",
    ]
    if len(done.held) > 0:
        lines.append(f"  What is left is held at points that may move: {len(done.held)}, of which none helps by a move of its own.")
    return lines
