"""Exact verdicts on trilinear hexahedra: whether jacdet > 0 in the whole cell, and where it is least."""

from typing import TYPE_CHECKING, Any

from ._arrays import HexlensError
from ._certificates import certify, verify
from ._check import Cell, MeshCheck, check
from ._classify import Classification, classify
from ._native import CHECKS, CLASSES, STATUSES, vectors
from ._report import Candidate, Check, Face, FaceRoot, Report, VolumeMinimum, analyze
from ._version import __version__

if TYPE_CHECKING:
    from .widget import HexLens

__all__ = [
    "CHECKS",
    "CLASSES",
    "STATUSES",
    "Candidate",
    "Cell",
    "Check",
    "Classification",
    "Face",
    "FaceRoot",
    "HexLens",
    "HexlensError",
    "MeshCheck",
    "Report",
    "VolumeMinimum",
    "__version__",
    "analyze",
    "certify",
    "check",
    "classify",
    "vectors",
    "verify",
]


def __getattr__(name: str) -> Any:
    if name == "HexLens":
        from .widget import HexLens

        return HexLens
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
