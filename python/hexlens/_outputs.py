"""What `check` prints and writes: the outputs of web/outputs, byte for byte where they hold no sentences of readers."""

import json
import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, Final, Protocol

import numpy as np

from ._arrays import HexlensError
from ._check import INVALID, UNANSWERED, Cell, MeshCheck, counted
from ._mesh import HEXAHEDRON
from ._native import CHECKS, CLASSES
from ._numbers import js_number, json_number, speak_jacdet, speak_number, spoken_point

__all__ = [
    "ID_KINDS",
    "CsvOutput",
    "FileResult",
    "IdsOutput",
    "JsonOutput",
    "JunitOutput",
    "Output",
    "TextOutput",
    "VtuOutput",
    "markup",
    "without_controls",
]


@dataclass
class FileResult:
    """A file with its check, or why there is none."""

    file: str
    exit: int
    check: MeshCheck | None = None
    error: str = ""


class Output(Protocol):
    """Turns results, file by file, into text or bytes."""

    def file(self, result: FileResult) -> Iterator[str | bytes]: ...
    def end(self, exit_: int) -> Iterator[str]: ...


#: Control characters and those that turn the text around, without a library of categories: Cc, Cf, U+2028 and U+2029.
_CONTROLS: Final = re.compile(
    "[\x00-\x1f\x7f-\x9f\xad\u0600-\u0605\u061c\u06dd\u070f\u0890\u0891\u08e2\u180e\u200b-\u200f\u2028-\u202e\u2060-\u2064"
    "\u2066-\u206f\ufeff\ufff9-\ufffb\U000110bd\U000110cd\U00013430-\U0001343f\U0001bca0-\U0001bca3\U0001d173-\U0001d17a"
    "\U000e0001\U000e0020-\U000e007f]"
)


def without_controls(text: str) -> str:
    return _CONTROLS.sub("", text)


def shown(word: str) -> str:
    plain = without_controls(word)
    return plain if len(plain) <= 40 else f"{plain[:40]}…"


def json_text(value: Any) -> str:
    """JSON on one line. Names stay whole, but control and bidirectional characters are escaped."""
    text = json.dumps(value, ensure_ascii=False, separators=(",", ":"), allow_nan=False)
    # A surrogate alone, from a name of a file that is no text, is escaped, too.
    return re.sub(f"{_CONTROLS.pattern}|[\ud800-\udfff]", lambda match: json.dumps(match[0])[1:-1], text)


class JsonOutput:
    """`--json`: docs/check.schema.json."""

    def __init__(self) -> None:
        self._count = 0

    def file(self, result: FileResult) -> Iterator[str]:
        yield ",\n" if self._count else '{"files":[\n'
        self._count += 1
        if result.check is None:
            yield json_text({"file": result.file, "error": result.error})
            return
        yield f'{json_text(result.check.head())[:-1]},"worst":['
        for i, index in enumerate(result.check.worst_indices.tolist()):
            yield f"{',' if i else ''}\n{json_text(result.check[index].to_dict())}"
        yield "]}"

    def end(self, exit_: int) -> Iterator[str]:
        yield "\n" if self._count else '{"files":['
        yield f'],"exit":{exit_}}}\n'


class TextOutput:
    """The output for people: a verdict, its basis, and the worst cells."""

    def __init__(self, lists_all: bool) -> None:
        self._lists_all = lists_all
        self._count = 0

    def file(self, result: FileResult) -> Iterator[str]:
        if self._count:
            yield "\n"
        self._count += 1
        file = without_controls(result.file)
        if result.check is None:
            yield f"{file}: not read.\n  {result.error}\n"
            return
        for line in self._lines(file, result.check):
            yield f"{line}\n"

    def end(self, exit_: int) -> Iterator[str]:
        yield from ()

    def _lines(self, file: str, check: MeshCheck) -> Iterator[str]:
        yield f"{file} ({check.format}): {check.headline()}"
        if check.min_relative is not None:
            yield f"  {check.below} with a relative minimum below {js_number(check.min_relative)}."
        for sentence in (*check.count_sentences(), *check.notes):
            yield f"  {sentence}"
        if not check.is_wholly_answered and check.invalid == 0 and check.below == 0:
            yield "  Not all could be answered: exit status 3, or 0 with --allow-unchecked."
        yield from self._worst_lines(check)

    def _worst_lines(self, check: MeshCheck) -> Iterator[str]:
        worst = check.worst_indices
        if not len(worst):
            return
        is_bad = (check.standing == INVALID) | check.is_below
        listed = worst if self._lists_all else worst[is_bad[worst]]
        what = "index" if check.mesh.ids is None else "id"
        if not len(listed):
            if check.is_answered[worst[0]]:
                name, _, relative, minimum, at, _ = _row(check[int(worst[0])])
                yield f"  Least: relative minimum {relative}, minimum {minimum}, {what} {name} at {at}."
            return
        yield "  Worst first, by the minimum of jacdet over |volume|:"
        header = [what, "block", "relative", "minimum", "at", "accepted by"]
        rows = [header] if len(listed) > _MOST_ALIGNED else [header, *(_row(check[int(i)]) for i in listed)]
        columns = [i for i in range(len(header)) if check.mesh.blocks or i != 1]
        # A row of why a cell is unanswered has no more fields than the others.
        widths = {i: max(6, *(len(row[i]) for row in rows)) for i in columns}

        def aligned(row: list[str]) -> str:
            return f"    {'  '.join(row[i].ljust(widths[i]) for i in columns)}".rstrip()

        yield from map(aligned, rows)
        if len(listed) > _MOST_ALIGNED:
            for index in listed:
                yield aligned(_row(check[int(index)]))


#: Columns are as wide as what is in them where rows are few.
_MOST_ALIGNED: Final = 1000


def _row(cell: Cell) -> list[str]:
    name = [shown(cell.id if cell.id is not None else str(cell.index)), shown(cell.block or "-")]
    report = cell.report
    if report is None:
        return [*name, "-", "-", "-", cell.error or ""]
    at = report.minimizer
    accepting = report.accepted_by
    return [
        *name,
        "none" if report.relative_min is None else speak_number(report.relative_min),
        speak_jacdet(at.value, report.exponent),
        f"{at.kind} {at.id}{'' if at.kind == 'vertex' else f' {spoken_point(at.point)}'}",
        "none" if not accepting else "all" if len(accepting) == len(CHECKS) else ", ".join(accepting),
    ]


ID_KINDS: Final = ("abaqus", "nastran", "plain")
_COMMENTS: Final = {"abaqus": "**", "nastran": "$", "plain": "#"}
#: Elements of Abaqus and Nastran are numbered from 1, as in the meshes that are written for them.
_FIRST: Final = {"abaqus": 1, "nastran": 1, "plain": 0}
#: Abaqus reads 16 entries of a line at most; Nastran's lines have 72 columns for a set.
_ABAQUS_A_LINE, _NASTRAN_COLUMNS = 16, 72


class IdsOutput:
    """`--ids`: the invalid hexahedra by their ids. `said` collects sentences for people."""

    def __init__(self, kind: str, file_count: int, said: list[str]) -> None:
        self._kind, self._file_count, self._said = kind, file_count, said
        self._sets = 0

    def file(self, result: FileResult) -> Iterator[str]:
        check, name = result.check, without_controls(result.file)
        if check is None:
            return
        first, is_numbered = _FIRST[self._kind], check.mesh.ids is None
        numbers = "indices" if first == 0 else "numbers"
        numbered = f"{name} has no ids: these are {numbers} from {first}, in the file's order."
        cells = [int(i) for i in np.flatnonzero(check.standing == INVALID)]
        ids = [str(first + i) if is_numbered else without_controls(check.name_of(i)) for i in cells]
        if ids and is_numbered:
            self._said.append(numbered)
        foreign = next((i for i in ids if not re.fullmatch(r"\d+", i)), None) if self._kind == "nastran" else None
        if foreign is not None:
            raise HexlensError(f"{name}: Nastran has no id such as “{shown(foreign)}”.")
        if self._file_count > 1:
            yield f"{_COMMENTS[self._kind]} {name}: {len(ids)} invalid\n"
        if not ids:
            return
        if is_numbered and first > 0:
            yield f"{_COMMENTS[self._kind]} {numbered}\n"
        self._sets += 1
        if self._kind == "abaqus":
            yield f"*ELSET, ELSET=HEXLENS_INVALID{'' if self._sets == 1 else f'_{self._sets}'}\n"
            for i in range(0, len(ids), _ABAQUS_A_LINE):
                yield f"{', '.join(ids[i : i + _ABAQUS_A_LINE])}\n"
        elif self._kind == "plain":
            for own in ids:
                yield f"{own}\n"
        else:
            yield from self._nastran(ids)

    def _nastran(self, ids: list[str]) -> Iterator[str]:
        line = f"SET {self._sets} = "
        for entry in [*(f"{own}," for own in ids[:-1]), ids[-1]]:
            if len(line) + len(entry) > _NASTRAN_COLUMNS:
                yield f"{line}\n"
                line = "  "
            line += entry
        yield f"{line}\n"

    def end(self, exit_: int) -> Iterator[str]:
        yield from ()


_COLUMNS: Final = (
    "file", "index", "id", "block", "valid", "class", "boundary_min", "relative_min", "volume", "xi", "eta", "zeta",
    "decided_by", "accepted_by",
)  # fmt: skip


class CsvOutput:
    """`--csv`: one line for each hexahedron, in the file's order; RFC 4180. What there is not is empty."""

    def __init__(self) -> None:
        self._is_begun = False

    def file(self, result: FileResult) -> Iterator[str]:
        if not self._is_begun:
            yield _csv_line(_COLUMNS)
        self._is_begun = True
        if result.check is not None:
            yield from self._rows(result.file, result.check)

    def end(self, exit_: int) -> Iterator[str]:
        if not self._is_begun:
            yield _csv_line(_COLUMNS)

    def _rows(self, file: str, check: MeshCheck) -> Iterator[str]:
        answers = check.answers
        minima, exponents = answers.boundary_min_parts
        volumes, volume_exponents = answers.volume_parts
        valid, relative, classes = answers.valid, answers.relative_min, answers.class_
        minimizers, accepted, exact = answers.minimizer, answers.accepted_by, answers.exact
        for i in range(check.hexahedra):
            name = [file, str(i), "" if check.mesh.ids is None else check.name_of(i), check.block_of(i) or ""]
            if not check.is_answered[i]:
                yield _csv_line((*name, *[""] * (len(_COLUMNS) - 4)))
                continue
            yield _csv_line(
                (
                    *name,
                    "true" if valid[i] else "false",
                    CLASSES[classes[i]],
                    _csv_number(float(minima[i]), int(exponents[i])),
                    "" if np.isnan(relative[i]) else js_number(float(relative[i])),
                    _csv_number(float(volumes[i]), int(volume_exponents[i])),
                    *(js_number(float(x)) for x in minimizers[i]),
                    "exact" if exact[i] else "filter",
                    " ".join(check for c, check in enumerate(CHECKS) if accepted[i] >> c & 1),
                )
            )


def _csv_number(mantissa: float, exponent: int) -> str:
    value = json_number(mantissa, exponent)
    return value if isinstance(value, str) else js_number(float(value))


def _csv_line(fields: tuple[str, ...]) -> str:
    plain = map(without_controls, fields)
    return ",".join(_quoted(text) if '"' in text or "," in text else text for text in plain) + "\r\n"


def _quoted(text: str) -> str:
    doubled = text.replace('"', '""')
    return f'"{doubled}"'


_ENTITIES: Final = {"&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;"}


def markup(text: str) -> str:
    """For XML and HTML: without characters that XML forbids or that turn the text around."""
    plain = "\n".join(without_controls(line) for line in text.split("\n"))
    plain = re.sub("[\ud800-\udfff\ufffe\uffff]", "", plain)
    return re.sub('[&<>"]', lambda match: _ENTITIES[match[0]], plain)


#: A report is read in a page, and `--worst all` may be a million.
_MOST_DETAILS: Final = 1000


class JunitOutput:
    """`--junit`: a suite for each file, with a case for the reading, for validity, for the bound and for what is unanswered."""

    def __init__(self, allows_unchecked: bool) -> None:
        self._allows_unchecked = allows_unchecked
        self._is_begun = False

    _HEAD: Final = '<?xml version="1.0" encoding="UTF-8"?>\n<testsuites name="hexlens check">\n'

    def file(self, result: FileResult) -> Iterator[str]:
        if not self._is_begun:
            yield self._HEAD
        self._is_begun = True
        check = result.check
        cases = [("the file is read", "error", result.error, "")] if check is None else list(self._cases(check))
        number = {outcome: sum(case[1] == outcome for case in cases) for outcome in ("failure", "error", "skipped")}
        counts = f'tests="{len(cases)}" failures="{number["failure"]}" errors="{number["error"]}" skipped="{number["skipped"]}"'
        yield f'<testsuite name="{markup(result.file)}" {counts}>\n'
        for name, outcome, message, details in cases:
            head = f'<testcase classname="{markup(result.file)}" name="{markup(name)}"'
            if outcome == "passed":
                yield f"{head}/>\n"
            else:
                yield f'{head}><{outcome} message="{markup(message)}">{markup(details)}</{outcome}></testcase>\n'
        if check is not None and check.notes:
            yield f"<system-out>{markup(chr(10).join(check.notes))}</system-out>\n"
        yield "</testsuite>\n"

    def end(self, exit_: int) -> Iterator[str]:
        yield f"{'' if self._is_begun else self._HEAD}</testsuites>\n"

    def _cases(self, check: MeshCheck) -> Iterator[tuple[str, str, str, str]]:
        hexahedra = counted(check.hexahedra, "hexahedron", "hexahedra")
        yield "the file is read", "passed", "", ""
        name = "no hexahedron is invalid"
        if check.invalid:
            yield name, "failure", f"{check.invalid} of {hexahedra} invalid", _details(check, check.standing == INVALID)
        else:
            yield name, "passed", "", ""
        if check.min_relative is not None:
            name = f"no relative minimum is below {js_number(check.min_relative)}"
            if check.below:
                is_meant = check.is_below & (check.standing != UNANSWERED)
                yield name, "failure", f"{check.below} of {hexahedra} below", _details(check, is_meant)
            else:
                yield name, "passed", "", ""
        name = "every hexahedron is answered"
        if check.is_wholly_answered:
            yield name, "passed", "", ""
        else:
            message = f"{hexahedra}, {check.unanswered} unanswered, {check.not_trilinear['count']} not trilinear"
            yield name, "skipped" if self._allows_unchecked else "failure", message, ""


def _details(check: MeshCheck, is_meant: Any) -> str:
    cells = [int(i) for i in check.worst_indices[:_MOST_DETAILS] if is_meant[i]]
    return "\n".join(_detail(check[i]) for i in cells)


def _detail(cell: Cell) -> str:
    name = f"index {cell.index}" if cell.id is None else f"id {cell.id}"
    name += "" if cell.block is None else f", block {cell.block}"
    report = cell.report
    if report is None:
        return f"{name}: {cell.error}"
    relative = "none" if report.relative_min is None else speak_number(report.relative_min)
    at = report.minimizer
    return f"{name}: relative minimum {relative}, minimum {speak_jacdet(at.value, report.exponent)} at {at.kind} {at.id}"


#: Numbers are written in chunks of so many.
_PIECE: Final = 131_072


class VtuOutput:
    """`--annotate`: the hexahedra as an uncompressed VTU with appended raw data, and as cell arrays what is said of each."""

    def file(self, result: FileResult) -> Iterator[bytes]:
        if result.check is not None:
            yield from self._parts(result.check)

    def end(self, exit_: int) -> Iterator[str]:
        yield from ()

    def _parts(self, check: MeshCheck) -> Iterator[bytes]:
        points, cells = check.mesh.points, check.mesh.cells
        count = len(cells)
        index = np.int32 if len(points) <= 2**31 and cells.size < 2**31 else np.int64
        arrays: list[tuple[str, str, Any, int]] = [("CellData", name, values, 0) for name, values in check.arrays().items()]
        arrays += [
            ("Points", "Points", points.ravel(), 3),
            ("Cells", "connectivity", cells.astype(index, copy=False).ravel(), 0),
            ("Cells", "offsets", np.arange(8, 8 * count + 8, 8, dtype=index), 0),
            ("Cells", "types", np.full(count, HEXAHEDRON, np.uint8), 0),
        ]
        offset = 0
        elements: dict[str, list[str]] = {}
        for section, name, values, components in arrays:
            kind = {"f": "Float", "i": "Int", "u": "UInt"}[values.dtype.kind] + str(8 * values.itemsize)
            shape = f' NumberOfComponents="{components}"' if components else ""
            elements.setdefault(section, []).append(f'<DataArray type="{kind}" Name="{name}"{shape} format="appended" offset="{offset}"/>')
            offset += 8 + values.nbytes
        sections = "".join(f"<{name}>\n{chr(10).join(lines)}\n</{name}>\n" for name, lines in elements.items())
        order = "LittleEndian" if np.little_endian else "BigEndian"
        yield (
            f'<?xml version="1.0"?>\n<VTKFile type="UnstructuredGrid" version="1.0" byte_order="{order}" header_type="UInt64">\n'
            f'<UnstructuredGrid>\n<Piece NumberOfPoints="{len(points)}" NumberOfCells="{count}">\n{sections}</Piece>\n'
            '</UnstructuredGrid>\n<AppendedData encoding="raw">\n_'
        ).encode()
        for _, _, values, _ in arrays:
            yield np.uint64(values.nbytes).tobytes()
            for begin in range(0, len(values), _PIECE):
                yield values[begin : begin + _PIECE].tobytes()
        yield b"\n</AppendedData>\n</VTKFile>\n"
