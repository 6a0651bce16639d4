"""Exact verdicts on trilinear hexahedra: whether jacdet > 0 in the whole cell, and where it is least."""

from importlib import import_module
from typing import TYPE_CHECKING, Any

from ._arrays import HexlensError
from ._classify import Classification, classify
from ._histogram import EDGES as HISTOGRAM_EDGES
from ._native import CHECKS, CLASSES, STATUSES, vectors
from ._version import __version__

if TYPE_CHECKING:
    from ._certificates import certify, verify
    from ._check import Cell, MeshCheck, check
    from ._repair import Reason, Repair, repair
    from ._report import Candidate, Check, Face, FaceRoot, Report, VolumeMinimum, analyze
    from .widget import HexLens

__all__ = [
    "CHECKS",
    "CLASSES",
    "HISTOGRAM_EDGES",
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
    "Reason",
    "Repair",
    "Report",
    "VolumeMinimum",
    "__version__",
    "analyze",
    "certify",
    "check",
    "classify",
    "repair",
    "vectors",
    "verify",
]

# Modules that classify does without: each is loaded when one of its names is first asked for.
_LATER = {
    **dict.fromkeys(("certify", "verify"), "_certificates"),
    **dict.fromkeys(("Cell", "MeshCheck", "check"), "_check"),
    **dict.fromkeys(("Reason", "Repair", "repair"), "_repair"),
    **dict.fromkeys(("Candidate", "Check", "Face", "FaceRoot", "Report", "VolumeMinimum", "analyze"), "_report"),
    "HexLens": "widget",
}


def __getattr__(name: str) -> Any:
    if name not in _LATER:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = getattr(import_module(f".{_LATER[name]}", __name__), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return __all__
