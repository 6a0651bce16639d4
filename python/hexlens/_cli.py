"""`python -m hexlens check` and `hexlens-check`: meshes in, verdicts out, file by file; the exit status is the gravest. Options,
exit statuses and JSON are those of `npx hexlens check`."""

import contextlib
import os
import re
import signal
import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import IO, Any, Final

from ._arrays import HexlensError
from ._check import check_mesh
from ._mesh_outputs import MESH_ENDINGS, is_mesh_ending, mesh_output
from ._outputs import (
    ID_KINDS,
    CsvOutput,
    FileResult,
    IdsOutput,
    JsonOutput,
    JunitOutput,
    Output,
    TextOutput,
    without_controls,
)
from ._sources import read_file
from ._version import __version__

__all__ = ["check_command", "main"]

USAGE: Final = """Usage: python -m hexlens check [OPTION...] FILE...
       hexlens-check [OPTION...] FILE...
       python -m hexlens repair FILE -o OUT.vtu: its own --help
       python -m hexlens --version

Reads meshes, decides for every hexahedron of eight nodes whether jacdet > 0 in all of it, exactly, and says which are the
worst: those with the least minimum of jacdet over |volume|. "-" is standard input. VTU, .pvtu and VTK legacy are read; for
other formats use npx hexlens check FILE, which has the same options.

  --json               prints one JSON object: docs/check.schema.json
  --worst N|all        how many of the worst are listed (10)
  --min-relative R     counts cells with a minimum over |volume| below R in "below"
  --degenerate=skip    counts cells with coincident vertices in "degenerate" alone
  --allow-unchecked    exit status 0 in place of 3
  --format NAME        the files are in this format, whatever they look like
  --step N|last|all    which time step is read of a file that has several; those that are read here have one
  --ids abaqus|nastran|plain
                       prints the ids of the invalid hexahedra: an element set, a SET, or one on a line
  --csv FILE           writes a line for each hexahedron
  --junit FILE         writes a JUnit report, a suite for each file
  --html FILE          writes one document to keep, which needs nothing else: the sentence, the notes, the histogram, and the
                       first ten of the worst, drawn and in numbers
  --annotate FILE.vtu|.vtk|.msh|.inp
                       writes the hexahedra with the cell arrays valid, boundary_min, relative_min, volume; valid is
                       255 where a cell is unanswered. VTK 5.1, Gmsh 4.1; Abaqus has sets in place of arrays. For one input

Exit status: of each file
  0  all hexahedra are valid
  1  some are invalid, or below R
  2  the file cannot be read, or the call is wrong
  3  none is invalid, but not all could be answered: cells of 20 or 27 nodes and Lagrange cells, coordinates that are not
     finite, an order of nodes that is not stated and decides, a file that is cut off, or no hexahedra at all
and of several files 2 before 1 before 3 before 0. Cells of other types never change it.
"""
_OK, _REFUSED = 0, 2
#: Worst cells that are listed unless --worst says how many.
_WORST: Final = 10


@dataclass
class Arguments:
    """The arguments of `check`."""

    files: list[str] = field(default_factory=list)
    format: str | None = None
    json: bool = False
    #: None where it is not said; -1 for all.
    worst: int | None = None
    min_relative: float | None = None
    skip_degenerate: bool = False
    allows_unchecked: bool = False
    csv: str | None = None
    junit: str | None = None
    annotate: str | None = None
    html: str | None = None
    ids: str | None = None
    step: int | str = 1


class _WrongCallError(HexlensError):
    def __init__(self, what: str) -> None:
        super().__init__(f"check: {what}. hexlens-check --help says what there is.")


def _worst(text: str) -> int:
    if text == "all":
        return -1
    if re.fullmatch(r"[0-9]{1,15}", text):
        return int(text)
    raise _WrongCallError(f"--worst wants a count or all, not {text}")


def _relative(text: str) -> float:
    if re.fullmatch(r"[-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][-+]?[0-9]+)?", text):
        value = float(text)
        if abs(value) != float("inf"):
            return value
    raise _WrongCallError(f"--min-relative wants a number, not {text}")


def _degenerate(text: str) -> bool:
    if text == "skip":
        return True
    raise _WrongCallError(f"--degenerate wants skip, not {text}")


def _annotate(text: str) -> str:
    if is_mesh_ending(text):
        return text
    raise _WrongCallError(f"--annotate wants a file that ends in one of {MESH_ENDINGS}, not {text}")


def _ids(text: str) -> str:
    if text in ID_KINDS:
        return text
    raise _WrongCallError(f"--ids wants {', '.join(ID_KINDS)}, not {text}")


def _step(text: str) -> int | str:
    if text in ("last", "all"):
        return text
    if re.fullmatch(r"[1-9][0-9]{0,8}", text):
        return int(text)
    raise _WrongCallError(f"--step wants a number from 1 on, last or all, not {text}")


#: Name in Arguments, a description of the value (None for an option that has none), and what reads it.
_OPTIONS: Final[dict[str, tuple[str, str | None, Callable[[str], Any]]]] = {
    "--json": ("json", None, lambda _: True),
    "--allow-unchecked": ("allows_unchecked", None, lambda _: True),
    "--format": ("format", "the name of a format", str),
    "--step": ("step", "a number from 1 on, last or all", _step),
    "--csv": ("csv", "a file", str),
    "--junit": ("junit", "a file", str),
    "--annotate": ("annotate", "a file", _annotate),
    "--html": ("html", "a file", str),
    "--worst": ("worst", "a count or all", _worst),
    "--min-relative": ("min_relative", "a number", _relative),
    "--degenerate": ("skip_degenerate", "skip", _degenerate),
    "--ids": ("ids", ", ".join(ID_KINDS), _ids),
}


def read_arguments(arguments: Sequence[str]) -> Arguments:
    """A value follows its option, as the next argument or after "="."""
    values = Arguments()
    seen = set()
    left = iter(arguments)
    for argument in left:
        if argument == "--":
            values.files += left
            break
        if argument == "-" or not argument.startswith("-"):
            values.files.append(argument)
            continue
        name, equals, text = argument.partition("=")
        if name not in _OPTIONS:
            raise _WrongCallError(f"there is no option {name}")
        if name in seen:
            raise _WrongCallError(f"{name} is given twice")
        seen.add(name)
        place, what, read = _OPTIONS[name]
        if what is None and equals:
            raise _WrongCallError(f"{name} has no value")
        if what is not None and not equals:
            text = next(left, "")
        if what is not None and text == "":
            raise _WrongCallError(f"{name} wants {what}")
        setattr(values, place, read(text))
    _refuse_contradictions(values)
    return values


def _refuse_contradictions(values: Arguments) -> None:
    if not values.files:
        raise _WrongCallError("it wants a file")
    if values.files.count("-") > 1:
        raise _WrongCallError("standard input can be read but once")
    if values.json and values.ids is not None:
        raise _WrongCallError("either --json or --ids can be printed")
    if values.annotate is not None and len(values.files) > 1:
        raise _WrongCallError("--annotate is for one file")


def _refuse_overwriting(values: Arguments) -> None:
    """A file that is read, or written for another purpose."""
    taken = {os.path.realpath(file): f"{file}, which is read" for file in values.files if file != "-"}
    for option in ("csv", "junit", "annotate", "html"):
        path = getattr(values, option)
        if path is None:
            continue
        real = os.path.realpath(path)
        if real in taken:
            raise HexlensError(f"check: --{option} would overwrite {taken[real]}.")
        taken[real] = f"{path}, which is written"


class FileSink:
    """Writes to a file beside the one that is meant, which takes its place in the end, so that whoever looks never sees a part; what
    is no plain file, such as a pipe, is written as it is."""

    def __init__(self, path: str) -> None:
        self._path = path
        self._is_replaced = not Path(path).exists() or Path(path).is_file()
        self._partial = f"{path}.{os.getpid()}.part" if self._is_replaced else path
        self._file: IO[bytes] | None = None
        folder = os.path.dirname(path) or "."
        if not os.path.isdir(folder):
            raise self._refusal(NotADirectoryError("there is no such folder"))
        if os.path.isdir(path) or not os.access(folder if self._is_replaced else path, os.W_OK):
            raise self._refusal(PermissionError("permission is denied" if not os.path.isdir(path) else "it is a folder"))

    def _refusal(self, error: OSError) -> HexlensError:
        return HexlensError(f"{without_controls(self._path)} cannot be written: {(error.strerror or str(error)).lower()}.")

    def write(self, chunk: str | bytes) -> None:
        try:
            if self._file is None:
                self._file = open(self._partial, "wb")  # noqa: SIM115 - it is closed by close or discard
            self._file.write(_bytes(chunk))
        except OSError as error:
            raise self._refusal(error) from None

    def close(self) -> None:
        try:
            self.write(b"")
            if self._file is not None:
                self._file.close()
            if self._is_replaced:
                os.replace(self._partial, self._path)
        except OSError as error:
            raise self._refusal(error) from None
        self._file = None

    def discard(self) -> None:
        if self._file is None:
            return
        with contextlib.suppress(OSError):
            self._file.close()
            if self._is_replaced:
                os.unlink(self._partial)
        self._file = None


class _Printed:
    def write(self, chunk: str | bytes) -> None:
        sys.stdout.buffer.write(_bytes(chunk))

    def close(self) -> None:
        sys.stdout.buffer.flush()

    def discard(self) -> None:
        pass


def _bytes(chunk: str | bytes) -> bytes:
    # A name of a file may be no text: its bytes are what they were.
    return chunk if isinstance(chunk, bytes) else chunk.encode("utf-8", "surrogateescape")


def _check(arguments: Sequence[str]) -> int:
    wanted = read_arguments(arguments)
    _refuse_overwriting(wanted)
    said: list[str] = []
    outputs = _outputs(wanted, said)
    exits = []
    try:
        for file in wanted.files:
            result = _result(file, wanted)
            exits.append(result.exit)
            if result.check is None and wanted.ids is not None:
                said.append(result.error)
            for output, sink in outputs:
                for chunk in output.file(result):
                    sink.write(chunk)
            for sentence in said:
                sys.stderr.write(f"hexlens: {sentence}\n")
            said.clear()
        gravest = next((status for status in (2, 1, 3) if status in exits), 0)
        for output, sink in outputs:
            for chunk in output.end(gravest):
                sink.write(chunk)
            sink.close()
        return gravest
    finally:
        for _, sink in outputs:
            sink.discard()


def _outputs(wanted: Arguments, said: list[str]) -> list[tuple[Output, Any]]:
    """The last is printed."""
    count = len(wanted.files)
    outputs: list[tuple[Output, Any]] = []
    if wanted.csv is not None:
        outputs.append((CsvOutput(), FileSink(wanted.csv)))
    if wanted.junit is not None:
        outputs.append((JunitOutput(wanted.allows_unchecked), FileSink(wanted.junit)))
    if wanted.annotate is not None:
        outputs.append((mesh_output(wanted.annotate, said), FileSink(wanted.annotate)))
    if wanted.html is not None:
        from ._html import HtmlOutput

        outputs.append((HtmlOutput(count), FileSink(wanted.html)))
    main_output: Output
    if wanted.json:
        main_output = JsonOutput()
    elif wanted.ids is not None:
        main_output = IdsOutput(wanted.ids, count, said)
    else:
        main_output = TextOutput(wanted.worst is not None)
    return [*outputs, (main_output, _Printed())]


def _result(file: str, wanted: Arguments) -> FileResult:
    worst = _WORST if wanted.worst is None else None if wanted.worst < 0 else wanted.worst
    try:
        with path_of(file) as path:
            mesh = read_file(path, wanted.format, wanted.step)
            check = check_mesh(mesh, file, worst=worst, min_relative=wanted.min_relative, skip_degenerate=wanted.skip_degenerate)
    except HexlensError as error:
        return FileResult(file, 2, error=without_controls(str(error)))
    except MemoryError:
        return FileResult(file, 2, error=f"{without_controls(file)} needs more memory than there is.")
    status = check.exit
    return FileResult(file, 0 if status == 3 and wanted.allows_unchecked else status, check)


@contextlib.contextmanager
def path_of(file: str) -> Any:
    """Standard input and pipes cannot be read from anywhere, so they become files."""
    if file != "-" and (not os.path.exists(file) or os.path.isfile(file) or os.path.isdir(file)):
        yield file
        return
    # It takes a while to be imported, and most calls do without it.
    import tempfile

    name = "standard input" if file == "-" else os.path.basename(file)
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, name)
        with contextlib.ExitStack() as stack:
            source = sys.stdin.buffer if file == "-" else stack.enter_context(open(file, "rb"))
            target = stack.enter_context(open(path, "wb"))
            while chunk := source.read(1 << 20):
                target.write(chunk)
        yield path


def main(arguments: Sequence[str] | None = None) -> int:
    """`python -m hexlens`: the exit status."""
    own = list(sys.argv[1:] if arguments is None else arguments)
    if own[:1] == ["check"]:
        return _run(own[1:])
    if own[:1] == ["repair"]:
        from ._repair_cli import REPAIR_USAGE, repair_command

        return _run(own[1:], repair_command, REPAIR_USAGE)
    if own[:1] in (["--help"], ["-h"]):
        sys.stdout.write(USAGE)
        return _OK
    if own[:1] == ["--version"]:
        sys.stdout.write(f"{__version__}\n")
        return _OK
    sys.stderr.write(USAGE)
    return _REFUSED


def check_command() -> None:
    """`hexlens-check`."""
    sys.exit(_run(sys.argv[1:]))


def _run(arguments: Sequence[str], command: Callable[[Sequence[str]], int] = _check, usage: str = USAGE) -> int:
    if any(argument in ("--help", "-h") for argument in arguments):
        sys.stdout.write(usage)
        return _OK
    try:
        return command(arguments)
    except HexlensError as error:
        sys.stderr.write(f"hexlens: {without_controls(str(error))}\n")
        return _REFUSED
    except BrokenPipeError:
        # Whoever read it has closed it; Python's own flush at the end must not fail, too.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        sys.stderr.write("hexlens: Standard output cannot be written: whoever read it has closed it.\n")
        return _REFUSED
    except KeyboardInterrupt:
        return 128 + signal.SIGINT
