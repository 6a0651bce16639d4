"""The C library, by ctypes: its functions and structures as wasm/include/hexlens.h has them."""

import ctypes
import sys
from ctypes import POINTER, c_bool, c_char_p, c_double, c_int, c_size_t, c_uint8, c_void_p
from pathlib import Path
from typing import Final

from ._version import __version__

__all__ = [
    "CHECKS",
    "CLASSES",
    "KINDS",
    "SHAPES",
    "STATUSES",
    "Batch",
    "Candidate",
    "Cells",
    "FaceReport",
    "Minimum",
    "RawReport",
    "library",
    "vectors",
]

STATUSES: Final = {
    1: "a coordinate is not a finite number",
    4: "it names a point that does not exist",
}
CLASSES: Final = ("unanswered", "valid", "invalid", "inverted", "collapsed")
SHAPES: Final = (None, "wedge", "pyramid", "tetrahedron")
KINDS: Final = ("vertex", "edge", "face")
CHECKS: Final = (
    "corners",
    "corners-and-centre",
    "gauss-2",
    "gauss-3",
    "edges",
    "bernstein",
    "subdivision",
    "tangents",
)


class Cells(ctypes.Structure):
    """hl_cells."""

    _fields_ = [
        ("coordinates", c_void_p),
        ("coordinate_count", c_size_t),
        ("indices", c_void_p),
        ("index_count", c_size_t),
    ]


class Batch(ctypes.Structure):
    """hl_batch."""

    _fields_ = [
        ("verdicts", c_void_p),
        ("statuses", c_void_p),
        ("is_exact", c_void_p),
        ("classes", c_void_p),
        ("accepted_by", c_void_p),
        ("minima", c_void_p),
        ("minimizers", c_void_p),
        ("corner_minima", c_void_p),
        ("exponents", c_void_p),
        ("relative_minima", c_void_p),
        ("volumes", c_void_p),
        ("volume_exponents", c_void_p),
        ("valid", c_size_t),
        ("invalid", c_size_t),
        ("unanswered", c_size_t),
        ("exact", c_size_t),
        ("first_unanswered", c_size_t),
    ]


class Candidate(ctypes.Structure):
    """hl_candidate."""

    _fields_ = [
        ("kind", c_int),
        ("id", c_int),
        ("point", c_double * 3),
        ("position", c_double * 3),
        ("value", c_double),
    ]


class FaceRoot(ctypes.Structure):
    """hl_face_root."""

    _fields_ = [
        ("t", c_double),
        ("a", c_double),
        ("s", c_double),
        ("fate", c_int),
    ]


class FaceReport(ctypes.Structure):
    """hl_face_report."""

    _fields_ = [
        ("bernstein", c_double * 9),
        ("lower_bound", c_double),
        ("running_minimum", c_double),
        ("skipped_by_minimum_rule", c_bool),
        ("skipped_by_validity_rule", c_bool),
        ("quartic", c_double * 5),
        ("quartic_exponent", c_int),
        ("quartic_is_zero", c_bool),
        ("root_count", c_int),
        ("roots", FaceRoot * 4),
    ]


class VolumeMinimum(ctypes.Structure):
    """hl_volume_minimum."""

    _fields_ = [
        ("lower", c_double),
        ("upper", c_double),
        ("point", c_double * 3),
        ("position", c_double * 3),
    ]


class RawReport(ctypes.Structure):
    """hl_report."""

    _fields_ = [
        ("verdict", c_int),
        ("is_exact", c_bool),
        ("exponent", c_int),
        ("minimizer", Candidate),
        ("minimum_error", c_double),
        ("volume_minimum", VolumeMinimum),
        ("checks", c_double * 8),
        ("maximizer", Candidate),
        ("corner_minimum", c_double),
        ("edge_minimum", c_double),
        ("scaled_jacobian", c_double),
        ("bernstein", c_double * 27),
        ("faces", FaceReport * 6),
        ("candidate_count", c_int),
        ("candidates", Candidate * 44),
        ("element_class", c_int),
        ("shape", c_int),
        ("coincident", c_uint8 * 8),
        ("volume", c_double),
        ("volume_exponent", c_int),
        ("relative_minimum", c_double),
    ]


class Minimum(ctypes.Structure):
    """hl_minimum."""

    _fields_ = [("minimizer", Candidate), ("exponent", c_int), ("is_exact", c_bool)]


def _file_name() -> str:
    if sys.platform == "win32":
        return "hexlens.dll"
    return "libhexlens.dylib" if sys.platform == "darwin" else "libhexlens.so"


def _load() -> ctypes.CDLL:
    path = Path(__file__).with_name(_file_name())
    if not path.exists():
        raise ImportError(
            f"Hexlens lacks its C library, {path.name}: this folder holds its sources and is not installed. "
            "Install it with `pip install ./python`, and import it from elsewhere."
        )
    loaded = ctypes.CDLL(str(path))
    loaded.hl_version.restype = c_char_p
    loaded.hl_vectors.restype = c_char_p
    version = loaded.hl_version().decode()
    if version != __version__:
        raise ImportError(f"The C library beside hexlens {__version__} is {version}: install hexlens anew.")
    loaded.hl_classify.argtypes = [POINTER(Cells), POINTER(Batch)]
    loaded.hl_analyze.argtypes = [c_void_p, POINTER(RawReport)]
    loaded.hl_decide.argtypes = [c_void_p, POINTER(c_int)]
    loaded.hl_boundary_minimum.argtypes = [c_void_p, c_int, POINTER(Minimum)]
    return loaded


library: Final = _load()


def vectors() -> str:
    """What classify runs on here: "avx512", "avx2", "sse2" or "scalar"."""
    name: bytes = library.hl_vectors()
    return name.decode()
