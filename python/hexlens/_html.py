"""A check as HTML: for notebooks, and as one document to keep. The sentence, the notes, the histogram of relative minima, and the
worst ten in numbers; in the document they are drawn, too."""

import math
from collections.abc import Iterator, Sequence
from typing import Final

import numpy as np
from numpy.typing import NDArray

from ._check import INVALID, Cell, MeshCheck
from ._histogram import BINS, EDGES
from ._native import CHECKS
from ._numbers import js_number, speak_jacdet, speak_number, spoken_point
from ._outputs import FileResult, markup, without_controls
from ._pieces import PieceCell, PiecesCheck
from ._report import Report

__all__ = ["HtmlOutput", "mesh_markup", "pieces_markup"]

#: Colours are the text's own where they can be: notebooks are light or dark. Signs have a colour and a pattern.
_STYLES: Final = """
.hexlens{--negative:#c4314b;--positive:#3b7fc4;max-width:60rem;font-variant-numeric:tabular-nums}
.hexlens .headline{margin:0;font-size:1.2em;line-height:1.3;font-weight:650}
.hexlens .part{margin:1.25em 0 .4em;font-size:1em;font-weight:650}
.hexlens p,.hexlens ul{margin:.2em 0}
.hexlens .name,.hexlens .beside{opacity:.75;overflow-wrap:anywhere}
.hexlens svg{display:block;width:100%;max-width:48rem;height:auto;overflow:visible}
.hexlens svg text{fill:currentColor;font-size:11px}
.hexlens .bar{fill:var(--positive)}
.hexlens .negative .bar{fill:var(--negative)}
.hexlens .stripes{fill:url(#hexlens-hatch)}
.hexlens .axis{fill:none;stroke:currentColor;stroke-opacity:.6}
.hexlens .grid{fill:none;stroke:currentColor;stroke-opacity:.15}
.hexlens .zero{fill:none;stroke:currentColor;stroke-width:1.5}
.hexlens .rows{overflow-x:auto}
.hexlens table{border-collapse:collapse;font-size:inherit}
.hexlens th,.hexlens td{padding:.2em 1.2em .2em 0;text-align:left;vertical-align:top;white-space:nowrap}
.hexlens td:last-child{white-space:normal;min-width:14em}
.hexlens thead th{font-weight:400;opacity:.75}
.hexlens tbody tr{border-top:1px solid #8884}
.hexlens .cells{display:grid;grid-template-columns:repeat(auto-fill,minmax(min(100%,26rem),1fr));gap:0 2rem}
.hexlens .cell{display:grid;grid-template-columns:11rem minmax(0,1fr);gap:0 1rem;border-top:1px solid #8884;padding:.75rem 0}
.hexlens .cell{break-inside:avoid}
.hexlens .cell>:is(h3,h4,.why,details){grid-column:1/-1;margin:0;font-size:1em;font-weight:650;overflow-wrap:anywhere}
.hexlens .cell>:is(.why,details){font-weight:400}
.hexlens dl{margin:0}
.hexlens dt{opacity:.75;font-size:.8125em}
.hexlens dd{margin:0 0 .25rem;overflow-wrap:anywhere}
.hexlens summary{cursor:pointer;opacity:.75;font-size:.8125em}
.hexlens details td,.hexlens details th{text-align:right;font-weight:400;min-width:0}
.hexlens .sign{color:var(--negative);font-weight:650}
@media (prefers-color-scheme:dark){.hexlens{--negative:#f4787a;--positive:#6cb2ff}}
"""
_PAGE: Final = """
:root{color-scheme:light dark}
body{max-width:60rem;margin:0 auto;padding:2.5rem 1.5rem;font:15px/1.45 system-ui,-apple-system,"Segoe UI",Roboto,Arial,sans-serif}
.hexlens+.hexlens,footer{margin-top:3rem;border-top:1px solid #8886;padding-top:1.5rem}
footer{max-width:60rem;opacity:.75}
@media (max-width:30rem){body{padding:1rem}.hexlens>svg text{font-size:18px}.hexlens .cell{grid-template-columns:8rem auto}}
@media print{body{max-width:none;padding:0}.hexlens .cells{grid-template-columns:1fr 1fr}.hexlens .cell{grid-template-columns:8rem auto}}
"""
_HATCH: Final = (
    '<svg width="0" height="0" aria-hidden="true" style="position:absolute"><defs>'
    '<pattern id="hexlens-hatch" patternUnits="userSpaceOnUse" width="6" height="6" patternTransform="rotate(-45)">'
    '<path d="M0 0V6" stroke="#fff" stroke-opacity=".55" stroke-width="3"/></pattern></defs></svg>'
)
_FOOT: Final = (
    "<footer>Written by Hexlens. Every verdict is exact, by the boundary of the hexahedron. jacdet is that of the map from "
    "[0,1]³; a relative minimum is its minimum over |volume|, at most 1.</footer>\n"
)
_LISTED: Final = 10


class HtmlOutput:
    """`--html`: one document that needs nothing else. It is XML, too."""

    def __init__(self, file_count: int) -> None:
        self._file_count = file_count
        self._is_begun = False

    def file(self, result: FileResult) -> Iterator[str]:
        level = 1 if self._file_count == 1 else 2
        if not self._is_begun:
            yield self._head(result.file if self._file_count == 1 else f"{self._file_count} meshes")
            if self._file_count > 1:
                yield f"<h1>{self._file_count} meshes</h1>\n"
        self._is_begun = True
        if result.check is None:
            yield (
                f'<section class="hexlens"><p class="name">{markup(result.file)}</p>\n'
                f'<h{level} class="headline">The file was not read.</h{level}>\n<p>{markup(result.error)}</p></section>\n'
            )
        else:
            yield mesh_markup(result.check, level, stands_alone=True)

    def _head(self, title: str) -> str:
        return (
            '<!DOCTYPE html>\n<html lang="en" xmlns="http://www.w3.org/1999/xhtml">\n<head>\n<meta charset="utf-8"/>\n'
            '<meta name="viewport" content="width=device-width"/>\n'
            f"<title>{markup(title)}: checked by Hexlens</title>\n<style>{_STYLES}{_PAGE}</style>\n</head>\n<body>\n{_HATCH}\n<main>\n"
        )

    def end(self, exit_: int) -> Iterator[str]:
        yield f"</main>\n{_FOOT}</body>\n</html>\n"


def mesh_markup(check: MeshCheck, level: int, *, stands_alone: bool) -> str:
    """A section; with its own styles unless it stands in a document that has them."""
    styles = "" if stands_alone else f"<style>{_STYLES}</style>{_HATCH}"
    name = f"{without_controls(check.file)} ({check.format})" if check.file != check.format else check.format
    sentences = [*check.count_sentences(), *check.notes]
    if check.min_relative is not None:
        sentences.insert(0, f"{_grouped(check.below)} with a relative minimum below {speak_number(check.min_relative)}.")
    if check.hexahedra > 0 and check.invalid == 0 and not check.is_wholly_answered:
        sentences.append("Not all could be answered.")
    notes = "".join(f"<li>{markup(sentence)}</li>\n" for sentence in sentences)
    return (
        f'{styles}<section class="hexlens">\n<p class="name">{markup(name)}</p>\n'
        f'<h{level} class="headline">{markup(headline_of(check))}</h{level}>\n'
        f"{f'<ul>{notes}</ul>' if notes else ''}"
        f"{_histogram(check, level + 1)}{(_drawn if stands_alone else _worst)(check, level + 1)}</section>\n"
    )


def headline_of(check: MeshCheck) -> str:
    """ "12 of 88,432 hexahedra are invalid. The eight corners would accept 7 of them, VTK’s scaled Jacobian 9." """
    hexahedra, invalid, unanswered = check.hexahedra, check.invalid, check.unanswered
    if hexahedra == 0:
        return "There are no hexahedra of eight nodes."
    rest = f" {_grouped(unanswered)} {'is' if unanswered == 1 else 'are'} unanswered." if unanswered else ""
    if invalid == 0:
        if unanswered == hexahedra:
            return rest.strip()
        if check.valid < hexahedra:
            return f"None of {_grouped(hexahedra)} hexahedra is known to be invalid.{rest}"
        return "The hexahedron is valid." if hexahedra == 1 else f"All {_grouped(hexahedra)} hexahedra are valid."
    are, them = ("is", "it") if invalid == 1 else ("are", "them")
    which = "The hexahedron is" if hexahedra == 1 else f"{_grouped(invalid)} of {_grouped(hexahedra)} hexahedra {are}"
    accepted = _accepted_invalid(check)
    corners, vtk = (int(np.count_nonzero((accepted >> CHECKS.index(name)) & 1)) for name in ("corners", "corners-and-centre"))
    if corners + vtk == 0:
        others = f"The eight corners and VTK’s scaled Jacobian reject {them}, too."
    elif invalid == 1:
        others = _one_accepted(corners == 1, vtk == 1)
    else:
        others = f"The eight corners would accept {_some(corners)} of them, VTK’s scaled Jacobian {_some(vtk)}."
    return f"{which} invalid. {others}{rest}"


def _one_accepted(by_corners: bool, by_vtk: bool) -> str:
    if by_corners and by_vtk:
        return "The eight corners and VTK’s scaled Jacobian would accept it."
    corners, vtk = "would accept" if by_corners else "reject", "would accept" if by_vtk else "rejects"
    return f"The eight corners {corners} it, VTK’s scaled Jacobian {vtk} it."


def _some(count: int) -> str:
    return "none" if count == 0 else _grouped(count)


def _accepted_invalid(check: MeshCheck) -> NDArray[np.uint16]:
    """Which checks accept the invalid cells: asked for these alone, as it takes longest."""
    from ._classify import Classification

    cells = check.mesh.cells[check.standing == INVALID]
    return Classification(check.mesh.points, cells, None, (("accepted_by",),)).accepted_by


def _grouped(count: int) -> str:
    return f"{count:,}"


_WIDTH, _HEIGHT = 720, 190
_LEFT, _BELOW, _ABOVE, _RIGHT = 56, 24, 14, 12


def _histogram(check: MeshCheck, level: int) -> str:
    relative = check.answers.relative_min
    known = np.sort(relative[~np.isnan(relative)])
    if not len(known):
        return ""
    shares: list[str] = []
    for percent in (1, 10, 50, 90, 99):
        value = float(known[max(0, -(-percent * len(known) // 100) - 1)])
        shares.append(f"{speak_number(value)} in {percent} %{'' if shares else ' of them'}")
    return f'{_bars(check.histogram(), check.hexahedra, float(known[0]), level)}<p class="beside">At most {", ".join(shares)}.</p>\n'


def _bars(counts: NDArray[np.int64], hexahedra: int, least: float | None, level: int) -> str:
    """The bars, with what they are; the first if all up to -1 is from `least`."""
    known = int(counts.sum())
    words = f"Relative minima of {_grouped(known)} {'hexahedron' if known == 1 else 'hexahedra'}"
    beside = hexahedra - known
    others = f" {_grouped(beside)} {'has' if beside == 1 else 'have'} none: the volume is 0, or there is no answer." if beside else ""
    first = int(np.flatnonzero(counts)[0])
    if first == 0 and least is not None:
        others = f" The first bar is all up to -1, from {speak_number(least)}.{others}"
    # The bin of all up to -1 is drawn as wide as the others.
    edges = np.array([EDGES[1] - 1 / BINS, *EDGES[1:]])
    return (
        f'<h{level} class="part">{words}</h{level}>\n'
        f'<p class="beside">Counts are logarithmic, negative values red and hatched.{others}</p>\n'
        f"{_histogram_svg(edges[first:], counts[first:], words)}\n"
    )


def _histogram_svg(edges: NDArray[np.float64], counts: NDArray[np.int64], words: str) -> str:
    start, end = float(edges[0]), float(edges[-1])
    bottom = _HEIGHT - _BELOW
    decades = max(1, int(np.ceil(np.log10(counts.max() + 1))))

    def x(value: float) -> float:
        return _LEFT + (value - start) / (end - start) * (_WIDTH - _LEFT - _RIGHT)

    def y(count: int) -> float:
        # One cell has to be seen: a count of 0 is half a decade below it.
        return bottom - (math.log10(count) + 0.5) / (decades + 0.5) * (bottom - _ABOVE)

    parts = []
    for count in (10**decade for decade in range(decades + 1)):
        parts.append(f'<path class="grid" d="M{_LEFT} {y(count):.1f}H{_WIDTH - _RIGHT}"/>')
        parts.append(f'<text x="{_LEFT - 8}" y="{y(count) + 4:.1f}" text-anchor="end">{_grouped(count)}</text>')
    for i, count in enumerate(counts.tolist()):
        if count == 0:
            continue
        low, high = float(edges[i]), float(edges[i + 1])
        left, top = x(low), y(count)
        box = f'x="{left:.1f}" y="{top:.1f}" width="{max(1.0, x(high) - left - 1):.1f}" height="{bottom - top:.1f}"'
        title = f"<title>{_grouped(count)} from {speak_number(low)} to {speak_number(high)}</title>"
        bar = f'<rect class="bar" {box}/>'
        if high <= 0:
            parts.append(f'<g class="negative">{title}{bar}<rect class="stripes" {box}/></g>')
        else:
            parts.append(f"<g>{title}{bar}</g>")
    if start < 0 < end:
        parts.append(f'<path class="zero" d="M{x(0):.1f} {_ABOVE}V{bottom}"/>')
    parts.append(f'<path class="axis" d="M{_LEFT} {bottom}H{_WIDTH - _RIGHT}"/>')
    for tick in np.arange(-1, 1.25, 0.25).tolist():
        if start <= tick <= end:
            parts.append(f'<path class="axis" d="M{x(tick):.1f} {bottom}v4"/>')
            parts.append(f'<text x="{x(tick):.1f}" y="{bottom + 17}" text-anchor="middle">{speak_number(tick)}</text>')
    label = f"{words}, from {speak_number(start)} to {speak_number(end)}"
    return f'<svg viewBox="0 0 {_WIDTH} {_HEIGHT}" role="img" aria-label="{label}">{"".join(parts)}</svg>'


def _drawn(check: MeshCheck, level: int) -> str:
    """The worst as drawings with their numbers beside them."""
    cells = [check[int(index)] for index in check.worst_indices[:_LISTED]]
    if not cells:
        return ""
    drawings = "".join(_drawn_cell(cell, level + 1) for cell in cells)
    return f'<h{level} class="part">{_worst_title(cells)}</h{level}>\n<div class="cells">\n{drawings}</div>\n'


def _drawn_cell(cell: Cell, level: int) -> str:
    from ._picture import picture

    name = f"Index {cell.index}" if cell.id is None else f"Cell {cell.id}"
    head = f'<section class="cell">\n<h{level}>{markup(name if cell.block is None else f"{name}, block {cell.block}")}</h{level}>\n'
    report = cell.report
    if report is None:
        return f'{head}<p class="why">Unanswered. {markup(cell.error or "")}</p>\n</section>\n'
    kind = report.class_ if report.shape is None else f"{report.class_}, {report.shape}"
    relative, minimum, place, accepted = _numbers(report)
    sign = "" if report.valid else ' class="sign"'
    entries = (
        ("Relative minimum", f"<span{sign}>{relative}</span>"),
        ("Minimum", f"<span{sign}>{minimum}</span> at {place}"),
        ("Volume", speak_jacdet(report.volume_mantissa, report.volume_exponent)),
        ("Class", f"<span{sign}>{kind}</span>"),
        ("Accepted by", accepted),
    )
    terms = "".join(f"<dt>{term}</dt><dd>{text}</dd>" for term, text in entries)
    rows = "".join(
        f'<tr><th scope="row">{v}</th>{"".join(f"<td>{js_number(x)}</td>" for x in vertex)}</tr>'
        for v, vertex in enumerate(report.vertices)
    )
    vertices = f"<details><summary>Its vertices</summary><table>{rows}</table></details>"
    return f"{head}{picture(report)}\n<dl>{terms}</dl>\n{vertices}\n</section>\n"


def _numbers(report: Report) -> tuple[str, str, str, str]:
    """The relative minimum, the minimum, where it is, and the checks that accept the cell."""
    at = report.minimizer
    return (
        "none, the volume is 0" if report.relative_min is None else speak_number(report.relative_min),
        speak_jacdet(at.value, report.exponent),
        f"{at.kind} {at.id}{'' if at.kind == 'vertex' else f' {spoken_point(at.point)}'}",
        "none" if not report.accepted_by else "all" if len(report.accepted_by) == len(CHECKS) else ", ".join(report.accepted_by),
    )


def _worst_title(cells: Sequence[Cell]) -> str:
    return "The worst cell" if len(cells) == 1 else f"The worst {len(cells)} cells, worst first"


def _worst(check: MeshCheck, level: int) -> str:
    return _worst_rows([check[int(index)] for index in check.worst_indices[:_LISTED]], level)


def _worst_rows(cells: Sequence[Cell], level: int) -> str:
    if not cells:
        return ""
    title = _worst_title(cells)
    pieces = any(isinstance(cell, PieceCell) for cell in cells)
    blocks = any(cell.block is not None for cell in cells)
    name = "index" if all(cell.id is None for cell in cells) else "id"
    columns = [*(["piece"] if pieces else []), name, *(["block"] if blocks else []), "relative minimum", "minimum", "at", "accepted by"]
    head = "".join(f'<th scope="col">{column}</th>' for column in columns)
    rows = "".join(f"<tr>{_row(cell, blocks)}</tr>\n" for cell in cells)
    return (
        f'<h{level} class="part">{title}</h{level}>\n<div class="rows" tabindex="0" role="region" aria-label="{title}">'
        f"<table><thead><tr>{head}</tr></thead>\n<tbody>\n{rows}</tbody></table></div>\n"
    )


def _row(cell: Cell, has_block: bool) -> str:
    piece = f"<td>{markup(without_controls(cell.piece))}</td>" if isinstance(cell, PieceCell) else ""
    name = f'{piece}<th scope="row">{markup(cell.id if cell.id is not None else str(cell.index))}</th>'
    block = f"<td>{markup(cell.block or '')}</td>" if has_block else ""
    report = cell.report
    if report is None:
        return f'{name}{block}<td colspan="4">{markup(cell.error or "")}</td>'
    sign = "" if report.valid else ' class="sign"'
    relative, minimum, place, accepted = _numbers(report)
    return f"{name}{block}<td{sign}>{relative}</td><td{sign}>{minimum}</td><td>{place}</td><td>{accepted}</td>"


def pieces_markup(check: PiecesCheck, level: int) -> str:
    """Of a mesh in pieces, for notebooks: the sentence, the pieces that failed, the histogram, the worst ten."""
    sentences = [f"{piece.name}: {piece.error}" for piece in check.failed[:_LISTED]]
    if len(check.failed) > _LISTED:
        sentences.append(f"{len(check.failed) - _LISTED} more failed.")
    if check.min_relative is not None:
        sentences.insert(0, f"{_grouped(check.below)} with a relative minimum below {speak_number(check.min_relative)}.")
    notes = "".join(f"<li>{markup(without_controls(sentence))}</li>\n" for sentence in sentences)
    bars = _bars(check.histogram, check.hexahedra, check.least, level + 1) if check.histogram.any() else ""
    return (
        f'<style>{_STYLES}</style>{_HATCH}<section class="hexlens">\n'
        f'<h{level} class="headline">{markup(check.headline())}</h{level}>\n'
        f"{f'<ul>{notes}</ul>' if notes else ''}{bars}"
        f"{_worst_rows(list(check.worst[:_LISTED]), level + 1)}</section>\n"
    )
