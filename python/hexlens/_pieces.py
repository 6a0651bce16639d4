"""Meshes in pieces, without what computes them: the answer of a piece as plain data, records of answers in a folder, and what all
pieces come to."""

import hashlib
import json
import os
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from functools import cached_property
from pathlib import Path
from typing import Any, Final, Literal

import numpy as np
from numpy.typing import NDArray

from ._arrays import HexlensError
from ._check import Cell, MeshCheck, counted, sentence_of_counts
from ._classify import sort_keys
from ._histogram import EDGES
from ._report import analyze
from ._version import __version__

__all__ = ["Answer", "Options", "Piece", "PieceCell", "PiecesCheck", "Records", "answer_of", "written_file"]

#: What is said of a piece: JSON, so that it can be sent and kept. Without "error", all of COUNTS is in it.
Answer = dict[str, Any]

_COUNTS: Final = ("hexahedra", "valid", "invalid", "unanswered", "degenerate", "below")


@dataclass(frozen=True)
class Options:
    """What is asked of each piece: another question has other records."""

    worst: int
    min_relative: float | None
    skip_degenerate: bool
    format: str | None
    annotate: str | None


def answer_of(check: MeshCheck) -> Answer:
    """What the sum needs of a piece: counts, the histogram, the worst cells with what they are sorted by."""
    answers, worst = check.answers, check.worst_indices
    keys = sort_keys(answers.relative_min[worst], answers.class_[worst], ~check.is_answered[worst])
    relative = answers.relative_min
    known = relative[~np.isnan(relative)]
    return {
        **{name: getattr(check, name) for name in _COUNTS},
        "format": check.format,
        "exit": check.exit,
        "not_trilinear": dict(check.not_trilinear),
        "other": dict(check.other),
        "notes": list(check.notes),
        "histogram": check.histogram().tolist(),
        "least": float(known.min()) if len(known) else None,
        "worst": [_listed(check[int(index)], float(key)) for index, key in zip(worst, keys, strict=True)],
    }


def _listed(cell: Cell, key: float) -> dict[str, Any]:
    return {
        "key": key,
        "id": cell.id,
        "index": cell.index,
        "block": cell.block,
        "vertices": cell.vertices.tolist(),
        "error": cell.error,
    }


class Records:
    """A folder with a file for each piece that is answered, so that a run that was cut off goes on where it stopped.

    A file is written under another name and then renamed: whoever finds it finds all of it. It names the piece, what was asked, and
    the piece's identity; whether that is still the same is for the reader to say.
    """

    _FORM: Final = 1

    def __init__(self, folder: str, options: Options) -> None:
        self._folder = Path(folder)
        self._asked = {"form": self._FORM, "hexlens": __version__, "options": asdict(options)}
        try:
            self._folder.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise HexlensError(f"{folder} cannot hold records: {(error.strerror or str(error)).lower()}.") from None

    def find(self, piece: str) -> dict[str, Any] | None:
        """ "identity" and "answer" of a piece that was asked the same."""
        try:
            record = json.loads(self._path(piece).read_bytes())
        except (OSError, ValueError):
            return None
        asked = {**self._asked, "piece": piece}
        is_same = isinstance(record, dict) and {name: record.get(name) for name in asked} == asked
        return record if is_same else None

    def keep(self, piece: str, identity: Any, answer: Answer) -> None:
        path = self._path(piece)
        # One name for what is being written: a run that was ended here leaves nothing that stays.
        partial = path.with_suffix(".part")
        text = json.dumps({**self._asked, "piece": piece, "identity": identity, "answer": answer})
        try:
            with open(partial, "w", encoding="utf-8") as file:
                file.write(text)
                file.flush()
                os.fsync(file.fileno())
            os.replace(partial, path)
        except OSError as error:
            raise HexlensError(f"{path} cannot be written: {(error.strerror or str(error)).lower()}.") from None

    def _path(self, piece: str) -> Path:
        return self._folder / f"{_digest({**self._asked, 'piece': piece})}.json"


def written_file(folder: str, piece: str) -> str:
    """Where the cell arrays of a piece go: a name that it has in every run and shares with no other."""
    stem = Path(piece).name.removesuffix(".gz").rsplit(".", 1)[0]
    plain = "".join(letter if letter.isalnum() or letter in "-_" else "-" for letter in stem)[:40]
    return os.path.join(folder, f"{plain}-{_digest(piece)[:12]}.vtu")


def _digest(value: Any) -> str:
    return hashlib.sha256(json.dumps(value, sort_keys=True).encode("utf-8", "surrogateescape")).hexdigest()[:32]


@dataclass(frozen=True)
class Piece:
    """A piece of the mesh, and what was said of it. One that failed has an `error` and no hexahedra."""

    name: str
    hexahedra: int
    valid: int
    invalid: int
    unanswered: int
    degenerate: int
    below: int
    #: As `MeshCheck.notes`.
    notes: tuple[str, ...]
    #: The VTU with its cell arrays.
    annotated: str | None
    #: True if an earlier run answered it.
    is_from_record: bool
    error: str | None


@dataclass(frozen=True)
class PieceCell(Cell):
    """A cell; id, index and block are those in its piece."""

    piece: str

    def to_dict(self) -> dict[str, Any]:
        return {"piece": self.piece, **super().to_dict()}


class PiecesCheck:
    """What all pieces come to. A piece that failed is in `failed`, and in no count."""

    def __init__(self, named: Sequence[tuple[str, Answer, bool]], options: Options) -> None:
        """Pieces in their order: the name, the answer, and whether that is from a record."""
        self.min_relative, self.skip_degenerate = options.min_relative, options.skip_degenerate
        self.pieces = [_piece(name, answer, is_kept) for name, answer, is_kept in named]
        whole = [(name, answer) for name, answer, _ in named if "error" not in answer]

        def total(name: str) -> int:
            return sum(answer[name] for _, answer in whole)

        self.hexahedra, self.valid, self.invalid = total("hexahedra"), total("valid"), total("invalid")
        self.unanswered, self.degenerate, self.below = total("unanswered"), total("degenerate"), total("below")
        self.not_trilinear = {name: sum(answer["not_trilinear"][name] for _, answer in whole) for name in ("count", "valid_by_corners")}
        self.other: dict[str, int] = {}
        for _, answer in whole:
            for kind, count in answer["other"].items():
                self.other[kind] = self.other.get(kind, 0) + count
        #: How many relative minima are in each bin: between places of `hexlens.HISTOGRAM_EDGES`.
        self.histogram: NDArray[np.int64] = np.sum([answer["histogram"] for _, answer in whole], axis=0, dtype=np.int64)
        if not whole:
            self.histogram = np.zeros(len(EDGES) - 1, np.int64)
        #: The least relative minimum; None where there is none.
        self.least: float | None = min((answer["least"] for _, answer in whole if answer["least"] is not None), default=None)
        self._exits = {answer["exit"] for _, answer in whole}
        listed = [(cell, name, i) for i, (name, answer) in enumerate(whole) for cell in answer["worst"]]
        listed.sort(key=lambda entry: (entry[0]["key"], entry[2], entry[0]["index"]))
        self._listed = [(cell, name) for cell, name, _ in listed[: options.worst]]

    @cached_property
    def worst(self) -> list[PieceCell]:
        """The worst hexahedra of all pieces, worst first; ties in the order of the pieces."""
        return [_cell(listed, name) for listed, name in self._listed]

    @property
    def failed(self) -> list[Piece]:
        """Pieces without an answer: `error` says why."""
        return [piece for piece in self.pieces if piece.error is not None]

    @property
    def exit(self) -> Literal[0, 1, 2, 3]:
        """As the command's for files: 2 if a piece failed, else 1, 3 or 0, the gravest of the pieces."""
        if self.failed or not self.pieces:
            return 2
        return 1 if 1 in self._exits else 3 if 3 in self._exits else 0

    def headline(self) -> str:
        """ "20000000 hexahedra, 3 INVALID, 19999997 valid. 1 of 40 pieces failed." """
        skipped = self.degenerate if self.skip_degenerate else 0
        sentence = sentence_of_counts(self.hexahedra, self.valid, self.invalid, self.unanswered, skipped)
        failed = f" {len(self.failed)} of {counted(len(self.pieces), 'piece', 'pieces')} failed." if self.failed else ""
        return f"{sentence}{failed}"

    def to_dict(self) -> dict[str, Any]:
        """Everything as JSON has it; an entry for each piece."""
        return {
            **{name: getattr(self, name) for name in _COUNTS},
            "not_trilinear": dict(self.not_trilinear),
            "other": dict(self.other),
            "histogram": self.histogram.tolist(),
            "exit": self.exit,
            "pieces": [asdict(piece) for piece in self.pieces],
            "worst": [cell.to_dict() for cell in self.worst],
        }

    def __repr__(self) -> str:
        return f"<PiecesCheck of {counted(len(self.pieces), 'piece', 'pieces')}: {self.headline()}>"

    def _repr_html_(self) -> str:
        from ._html import pieces_markup

        return pieces_markup(self, 3)


def _piece(name: str, answer: Answer, is_kept: bool) -> Piece:
    counts = {count: answer.get(count, 0) for count in _COUNTS}
    annotated = answer.get("annotated")
    return Piece(
        name,
        **counts,
        notes=tuple(answer.get("notes", ())),
        annotated=annotated[0] if annotated else None,
        is_from_record=is_kept,
        error=answer.get("error"),
    )


def _cell(listed: dict[str, Any], piece: str) -> PieceCell:
    vertices = np.array(listed["vertices"], np.float64)
    report = analyze(vertices) if listed["error"] is None else None
    return PieceCell(listed["id"], listed["index"], listed["block"], vertices, report, listed["error"], piece)
