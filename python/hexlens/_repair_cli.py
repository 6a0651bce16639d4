"""`python -m hexlens repair`: a mesh in, its hexahedra with points moved out as VTU; the exit status is that of `check` for them."""

import argparse
import dataclasses
import os
import re
import sys
from collections.abc import Sequence
from typing import Any, Final, NoReturn

from numpy.typing import NDArray

from ._arrays import HexlensError
from ._check import check_mesh
from ._cli import FileSink, path_of
from ._numbers import whole_or_double
from ._outputs import FileResult, TextOutput, VtuOutput, json_text, without_controls
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
  --reorder            writes nodes 0 to 3 and 4 to 7 of mirrored cells exchanged; without, a sentence says so, and the order stays
  --certificates FILE  writes for each vertex that holds what is left the proof that no place of it helps, as a JSON list that
                       hexlens.verify checks: docs/certificates.md, section 5
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
    parser.add_argument("--reorder", action="store_true")
    parser.add_argument("--certificates")
    parser.add_argument("--format")
    parser.add_argument("--step", type=_step_of, default=1)
    parser.add_argument("--allow-unchecked", action="store_true")
    return parser


def repair_command(arguments: Sequence[str]) -> int:
    """The exit status."""
    wanted = _parser().parse_args(list(arguments))
    if wanted.file != "-" and os.path.realpath(wanted.file) == os.path.realpath(wanted.output):
        raise HexlensError(f"repair: {wanted.output} is what is read, and stays as it is: name another file to write.")
    if wanted.certificates is not None and os.path.realpath(wanted.certificates) in map(os.path.realpath, (wanted.file, wanted.output)):
        raise HexlensError(f"repair: the certificates need a file of their own, not {wanted.certificates}.")
    sink = FileSink(wanted.output)
    proofs = None if wanted.certificates is None else FileSink(wanted.certificates)
    try:
        with path_of(wanted.file) as path:
            mesh = read_file(path, wanted.format, wanted.step)
        # Counted without what is written as it was: what moves have done.
        done = repair(
            mesh.points,
            mesh.cells,
            min_relative=wanted.min_relative or 0.0,
            slide=wanted.slide,
            free_boundary=wanted.free_boundary,
            reorder=True,
        )
        written = dataclasses.replace(done, cells=done.cells if wanted.reorder else mesh.cells)
        moved = dataclasses.replace(mesh, points=done.points, cells=written.cells)
        check = check_mesh(moved, wanted.output, worst=10, min_relative=wanted.min_relative, skip_degenerate=False)
        status = 0 if check.exit == 3 and wanted.allow_unchecked else check.exit
        result = FileResult(wanted.output, status, check)
        for chunk in VtuOutput().file(result):
            sink.write(chunk)
        sink.close()
        certificates = None if proofs is None else _write_certificates(proofs, written, mesh.ids)
        for line in _lines(wanted, written, certificates):
            sys.stdout.write(f"{line}\n")
        for text in TextOutput(False).file(result):
            sys.stdout.write(text if isinstance(text, str) else text.decode())
        sys.stdout.flush()
        return int(status)
    finally:
        sink.discard()
        if proofs is not None:
            proofs.discard()


def _write_certificates(sink: FileSink, done: Repair, ids: Sequence[object] | NDArray[Any] | None) -> int:
    """How many there are."""
    entries = done.certificates(ids if ids is None or isinstance(ids, Sequence) else ids.tolist())
    for i, entry in enumerate(entries):
        sink.write(f"{',' if i else '['}\n{json_text(_as_json(entry))}")
    sink.write("\n]\n" if entries else "[]\n")
    sink.close()
    return len(entries)


def _as_json(value: Any) -> Any:
    """Doubles as whole numbers where they are such, as the Node command writes them."""
    if isinstance(value, float):
        return whole_or_double(value)
    if isinstance(value, list):
        return [_as_json(item) for item in value]
    return {key: _as_json(item) for key, item in value.items()} if isinstance(value, dict) else value


def _lines(wanted: argparse.Namespace, done: Repair, certificates: int | None) -> list[str]:
    margin = wanted.min_relative or 0.0
    below = f", {done.below_before - done.below_after} of {done.below_before} below {margin:g}" if margin > 0 else ""
    lines = [f"{without_controls(wanted.file)} is written to {without_controls(wanted.output)}, its hexahedra alone, as VTU."]
    if len(done.reversed_cells) > 0:
        lines.append(_order_line(len(done.reversed_cells), wanted.reorder))
    if done.below_before > 0:
        lines.append(f"  Repaired: {done.invalid_before - done.invalid_after} of {done.invalid_before} invalid hexahedra{below}.")
    else:
        lines.append("  There was nothing else to repair." if len(done.reversed_cells) > 0 else "  There was nothing to repair.")
    lines.append(f"  Points moved: {done.moved_count}, by {done.greatest_distance:.5g} at most and {done.mean_distance:.5g} on average.")
    if len(done.held) > 0:
        lines.append(f"  What is left is held at points that may move: {len(done.held)}, of which none helps by a move of its own.")
        if certificates is not None:
            lines.append(f"  {without_controls(wanted.certificates)} has certificates of {certificates} of these {len(done.held)} points.")
    elif done.below_after > 0:
        is_fixed = not wanted.slide and wanted.free_boundary == 0
        frees = "; --slide or --free-boundary D frees those of the boundary" if is_fixed else ""
        lines.append(f"  What is left has no point that may move{frees}.")
    return lines


def _order_line(count: int, is_reordered: bool) -> str:
    mirrored = "1 hexahedron" if count == 1 else f"{count} hexahedra"
    if is_reordered:
        return f"  {mirrored} {'was' if count == 1 else 'were'} mirrored: nodes 0 to 3 and 4 to 7 are exchanged."
    are, their, they, were = ("is", "its", "it is", "it was") if count == 1 else ("are", "their", "they are", "they were")
    return (
        f"  {mirrored} {are} mirrored, {their} nodes are numbered the other way round: {they} repaired as if they were not, "
        f"and written as {were}; --reorder writes the hexahedra so."
    )
