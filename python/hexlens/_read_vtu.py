"""VTU, the XML file of VTK's unstructured grids, and .pvtu, which names the pieces of one.

VTK's own reader is not used: it takes 6.5 for an index and a text for numbers, and stops at a NaN that no cell has. What is not
as it is declared is refused here; numbers that lie raw in the file are mapped, not copied.
"""

import base64
import binascii
import os
import re
import xml.etree.ElementTree as ElementTree
import zlib
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final, NoReturn

import numpy as np
from numpy.typing import NDArray

from ._arrays import HexlensError
from ._mesh import VOXEL, CellArrays, Grid, Mesh, MeshMaker, cell_data_rank

__all__ = ["read_vtu", "sources_of"]

_GRID, _PARALLEL = "UnstructuredGrid", "PUnstructuredGrid"
_TYPES: Final = {
    **{f"Int{bits}": f"i{bits // 8}" for bits in (8, 16, 32, 64)},
    **{f"UInt{bits}": f"u{bits // 8}" for bits in (8, 16, 32, 64)},
    "Float32": "f4",
    "Float64": "f8",
}
_COMPRESSORS: Final = {"": None, "vtkZLibDataCompressor": "zlib", "vtkLZMADataCompressor": "LZMA"}
#: A header with its XML is in the first part of a file; what is appended is not searched.
_HEAD_CHUNK: Final = 1 << 20


def read_vtu(path: str, name: str) -> Mesh:
    """HexlensError for what is no VTU, or damaged."""
    document = _Document(Path(path).read_bytes() if _is_packed(path) else _mapped(path, name), name, is_packed=_is_packed(path))
    maker = MeshMaker("VTU", document.refusal)
    if document.type == _PARALLEL:
        for source in _sources(document):
            _add_source(maker, document, Path(path).parent, source)
    elif document.type == _GRID:
        _add_pieces(maker, document, None)
    else:
        document.refuse(f"its type is {document.type!r}; {_GRID} and {_PARALLEL} are read here. `npx hexlens check FILE` reads time steps.")
    if not document.is_complete:
        maker.is_cut_off = True
    return maker.mesh()


def sources_of(path: str) -> list[str]:
    """The files that a .pvtu names, whether they are there or not."""
    name = Path(path).name
    try:
        document = _Document(_mapped(path, name), name, is_packed=False)
    except OSError as error:
        raise HexlensError(f"{name} cannot be read: {(error.strerror or str(error)).lower()}.") from None
    if document.type != _PARALLEL:
        document.refuse(f"its type is {document.type!r}; {_PARALLEL} was expected.")
    folder = Path(path).parent
    return [_beside(folder, source) or str(folder / source) for source in _sources(document)]


def _sources(document: "_Document") -> list[str]:
    sources = [piece.get("Source", "") for piece in document.pieces]
    if not sources:
        document.refuse("it names no piece.")
    return sources


def _beside(folder: Path, source: str) -> str | None:
    spellings = (folder / source, folder / source.replace("\\", "/"))
    return next((str(beside) for beside in spellings if beside.is_file()), None)


def _add_source(maker: MeshMaker, document: "_Document", folder: Path, source: str) -> None:
    beside = _beside(folder, source)
    if beside is None:
        document.refuse(f"it needs “{source}” beside it.")
    inner = _Document(_mapped(beside, source), source, is_packed=False)
    if inner.type != _GRID:
        inner.refuse(f"a piece of type {inner.type!r} stands where one of type {_GRID} was expected.")
    if not inner.is_complete:
        inner.refuse("the file is cut off: there is no </VTKFile>.")
    _add_pieces(maker, inner, source)


def _is_packed(path: str) -> bool:
    with open(path, "rb") as file:
        return file.read(2) == b"\x1f\x8b"


def _mapped(path: str, name: str) -> Any:
    if os.path.getsize(path) == 0:
        raise HexlensError(f"{name}: the file is empty.")
    return np.memmap(path, np.uint8, mode="r")


@dataclass
class _Piece:
    points: int
    cells: int
    element: ElementTree.Element


class _Document:
    """The XML of a file, and where its appended data begin."""

    def __init__(self, data: Any, name: str, *, is_packed: bool) -> None:
        self.name = name
        if is_packed:
            # Modules that few files need are imported with these.
            import gzip

            try:
                data = gzip.decompress(data)
            except (EOFError, OSError, zlib.error) as error:
                self.refuse(f"the gzip file is damaged or cut off: {error}.")
        self._data = memoryview(data)
        text, self._appended_from = self._split()
        self._root = self._parsed(text)
        root = self._root
        self.type = root.get("type", "")
        order, header = root.get("byte_order", "LittleEndian"), root.get("header_type", "UInt32")
        if order not in ("LittleEndian", "BigEndian"):
            self.refuse(f"the byte order is “{order}”: LittleEndian or BigEndian was expected.")
        if header not in ("UInt32", "UInt64"):
            self.refuse(f"the header type is “{header}”: UInt32 or UInt64 was expected.")
        self._order = "<" if order == "LittleEndian" else ">"
        self._header = np.dtype(f"{self._order}{_TYPES[header]}")
        compressor = root.get("compressor", "")
        if compressor == "vtkLZ4DataCompressor":
            self.refuse("it is packed with LZ4, which is not read here: `npx hexlens check FILE` reads it.")
        if compressor not in _COMPRESSORS:
            self.refuse(f"the compressor is “{compressor}”, which VTK does not have.")
        self._packing = _COMPRESSORS[compressor]
        grid = root.find(self.type) if re.fullmatch(r"\w+", self.type) else None
        self.pieces = [] if grid is None else grid.findall("Piece")

    def refusal(self, what: str) -> HexlensError:
        return HexlensError(f"{self.name}: {what}")

    def refuse(self, what: str) -> NoReturn:
        raise self.refusal(what)

    def _split(self) -> tuple[bytes, int]:
        """The XML without the appended data, and the byte behind their underscore."""
        data = self._data
        size = len(data)
        reach = 0
        head = b""
        while reach < size and b"<AppendedData" not in head:
            reach = min(size, max(_HEAD_CHUNK, 2 * reach))
            head = bytes(data[:reach])
        at = head.find(b"<AppendedData")
        self.is_complete = bytes(data[max(0, size - 4096) :]).rstrip().endswith(b"</VTKFile>")
        self._is_base64 = False
        if at < 0:
            return head, size
        close = head.find(b">", at)
        underscore = head.find(b"_", close)
        if close < 0 or underscore < 0:
            head = bytes(data[: underscore if underscore > 0 else min(size, reach + _HEAD_CHUNK)])
            close = head.find(b">", at)
            underscore = head.find(b"_", close)
            if close < 0 or underscore < 0:
                self.refuse("the file is cut off at the beginning of its appended data.")
        encoding = re.search(rb'encoding\s*=\s*["\'](\w*)["\']', head[at:close])
        self._is_base64 = encoding is not None and encoding[1] == b"base64"
        return head[:at] + b"</VTKFile>", underscore + 1

    def _parsed(self, text: bytes) -> ElementTree.Element:
        if re.search(rb"<!(?:DOCTYPE|ENTITY)", text):
            self.refuse("a document type or an entity is not read: a mesh needs none.")
        try:
            root = ElementTree.fromstring(text)
        except ElementTree.ParseError as error:
            if self.is_complete or b"<VTKFile" not in text:
                self.refuse(f"this is no VTU: {error}.")
            self.refuse("the file is cut off: there is no </VTKFile>.")
        if root.tag != "VTKFile":
            self.refuse("this is no VTU: there is no <VTKFile> in it.")
        return root

    def array(self, element: ElementTree.Element, name: str, count: int) -> NDArray[Any]:
        """So many numbers, of the array's own type."""
        type_ = element.get("type", "")
        if type_ not in _TYPES:
            self.refuse(f"“{name}” has type “{type_}”, where one like Float64 or Int64 was expected.")
        own = np.dtype(f"{self._order}{_TYPES[type_]}")
        format_ = element.get("format", "ascii")
        if format_ == "ascii":
            return self._text(element, name, own, count)
        if format_ == "binary":
            source: Any = self._base64((element.text or "").encode(), name)
        elif format_ == "appended":
            offset = element.get("offset", "").strip()
            if not re.fullmatch(r"\d{1,15}", offset):
                self.refuse(f"the offset of “{name}” is “{offset}”, where a count of bytes was expected.")
            start = self._appended_from + int(offset)
            if start >= len(self._data):
                self.refuse(f"“{name}” lies at byte {start}, the file ends at byte {len(self._data)}: it is cut off.")
            source = self._data[start:]
            if self._is_base64:
                source = self._base64_at(bytes(source), name)
        else:
            self.refuse(f"“{name}” has format “{format_}”: ascii, binary or appended was expected.")
        if count == 0:
            return np.empty(0, own)
        raw = self._plain(source, name, own, count) if self._packing is None else self._blocks(source, name, own, count)
        return raw if raw.dtype.isnative else raw.astype(own.newbyteorder("="))

    def _text(self, element: ElementTree.Element, name: str, own: np.dtype[Any], count: int) -> NDArray[Any]:
        words = (element.text or "").split()
        if len(words) != count:
            more = "more than" if len(words) > count else "not"
            self.refuse(f"“{name}” has {len(words)} numbers, {more} the {count} that are declared.")
        is_real = own.kind == "f"
        # Whatever else Python would take for a number, such as 1_000, has a character that is none of these.
        strange = re.compile(r"[^-+.\deEnaifty\s]" if is_real else r"[^-+\d\s]", re.ASCII | re.IGNORECASE)
        if strange.search(element.text or "") is not None:
            word = next(word for word in words if strange.search(word))
            self.refuse(f"“{word[:40]}” in “{name}” stands where a number of type {element.get('type')} was expected.")
        try:
            return np.array(list(map(float if is_real else int, words)), np.float64 if is_real else own.newbyteorder("="))
        except (ValueError, OverflowError) as error:
            raise self.refusal(f"“{name}” has a number that is none of type {element.get('type')}: {error}.") from None

    def _base64(self, text: bytes, name: str) -> bytes:
        """Base64 of several runs, each with its own padding."""
        return self._base64_at(b"".join(text.split()), name)

    def _base64_at(self, text: bytes, name: str) -> bytes:
        end = re.match(rb"[A-Za-z0-9+/=\s]*", text)
        text = b"".join((end[0] if end else b"").split())
        parts, at = [], 0
        try:
            while at < len(text):
                padding = text.find(b"=", at)
                stop = len(text) if padding < 0 else padding + (2 if text[padding : padding + 2] == b"==" else 1)
                parts.append(base64.b64decode(text[at:stop], validate=True))
                at = stop
        except binascii.Error:
            # Digits behind those of the array may end in the middle of a group of four.
            parts.append(base64.b64decode(text[at : at + (len(text) - at) // 4 * 4]))
        return b"".join(parts)

    def _headers(self, source: Any, name: str, at: int, count: int) -> list[int]:
        size = self._header.itemsize
        if len(source) < at + size * count:
            self.refuse(f"“{name}” needs {at + size * count} bytes, and the file has {len(source)}: it is cut off.")
        return [int(x) for x in np.frombuffer(source[at : at + size * count], self._header)]

    def _check_length(self, name: str, length: int, own: np.dtype[Any], count: int) -> None:
        if length != count * own.itemsize:
            self.refuse(f"“{name}” says that it has {length} bytes; {count} numbers of {own.itemsize} bytes were expected.")

    def _plain(self, source: Any, name: str, own: np.dtype[Any], count: int) -> NDArray[Any]:
        (length,) = self._headers(source, name, 0, 1)
        self._check_length(name, length, own, count)
        begin = self._header.itemsize
        if len(source) < begin + length:
            self.refuse(f"“{name}” needs {length} bytes, and the file has {len(source) - begin}: it is cut off.")
        return np.frombuffer(source[begin : begin + length], own)

    def _blocks(self, source: Any, name: str, own: np.dtype[Any], count: int) -> NDArray[Any]:
        blocks, size, last = self._headers(source, name, 0, 3)
        whole = blocks if last == 0 else blocks - 1
        self._check_length(name, whole * size + last if blocks else 0, own, count)
        packed = self._headers(source, name, 3 * self._header.itemsize, blocks)
        at = (3 + blocks) * self._header.itemsize
        values = np.empty(count, own)
        room: Any = values.view(np.uint8)
        filled = 0
        for i, length in enumerate(packed):
            if len(source) < at + length:
                self.refuse(f"“{name}” needs {length} more bytes, and the file has {len(source) - at}: it is cut off.")
            expected = size if i < whole else last
            block = self._unpacked(bytes(source[at : at + length]), name, expected)
            room[filled : filled + expected] = np.frombuffer(block, np.uint8)
            filled += expected
            at += length
        return values

    def _unpacked(self, packed: bytes, name: str, expected: int) -> bytes:
        # No more than is declared is ever unpacked.
        if self._packing == "zlib":
            try:
                block = zlib.decompressobj().decompress(packed, expected + 1)
            except zlib.error as error:
                self.refuse(f"“{name}” is damaged: {error}.")
        else:
            import lzma

            try:
                block = lzma.LZMADecompressor().decompress(packed, expected + 1)
            except (lzma.LZMAError, EOFError) as error:
                self.refuse(f"“{name}” is damaged: {error}.")
        if len(block) != expected:
            self.refuse(f"“{name}” has a block that is not of the {expected} bytes that are declared.")
        return block


def _add_pieces(maker: MeshMaker, document: _Document, block: str | None) -> None:
    if not document.pieces:
        document.refuse("it has no <Piece>.")
    ghosts = 0
    for element in document.pieces:
        maker.add(_grid(document, element), block)
        ghosts += _ghost_count(document, element)
    if ghosts:
        maker.notes.append(f"{ghosts} cells are ghosts, copies of cells of another piece; they are counted in both.")


#: vtkDataSetAttributes::DUPLICATECELL
_IS_COPY: Final = 1


def _ghost_count(document: _Document, element: ElementTree.Element) -> int:
    """How many cells are copies of cells of other pieces."""
    array = next((array for array in element.findall("CellData/DataArray") if array.get("Name") == "vtkGhostType"), None)
    if array is None:
        return 0
    return int(np.count_nonzero(document.array(array, "vtkGhostType", int(element.get("NumberOfCells", "0"))) & _IS_COPY))


def _grid(document: _Document, element: ElementTree.Element) -> Grid:
    def count_of(name: str) -> int:
        text = element.get(name, "").strip()
        if not re.fullmatch(r"\d{1,15}", text):
            document.refuse(f"{name} is “{text}”, where a count was expected.")
        return int(text)

    points, cells = count_of("NumberOfPoints"), count_of("NumberOfCells")
    arrays = {array.get("Name", ""): array for array in element.findall("Cells/DataArray")}
    places = element.findall("Points/DataArray")

    def array_of(name: str, count: int) -> NDArray[Any]:
        found = arrays.get(name)
        if found is None:
            if count == 0:
                return np.empty(0, np.int64)
            document.refuse(f"a <Piece> has no array “{name}”.")
        return document.array(found, name, count)

    if points > 0 and not places:
        document.refuse("a <Piece> has no array “Points”.")
    if places and places[0].get("NumberOfComponents", "3").strip() != "3":
        document.refuse("the points do not have 3 components.")
    coordinates = document.array(places[0], "Points", 3 * points) if points else np.empty(0)
    is_text = bool(places) and places[0].get("format", "ascii") == "ascii"
    types = array_of("types", cells).astype(np.uint8)
    ends = array_of("offsets", cells).astype(np.int64, copy=False)
    falling = np.flatnonzero(ends[1:] < ends[:-1])
    if len(falling):
        at = int(falling[0]) + 1
        document.refuse(f"the offset of cell {at} is {ends[at]}, less than {ends[at - 1]}, that of the cell before.")
    connectivity = array_of("connectivity", int(ends[-1]) if cells else 0)
    if connectivity.dtype.kind == "f":
        document.refuse("the indices of “connectivity” are no whole numbers.")
    return Grid(
        np.ascontiguousarray(coordinates, np.float64).reshape(-1, 3),
        types,
        ends,
        connectivity,
        _cell_arrays(document, element, cells),
        # Voxels alone are looked at so closely.
        _tolerance(is_text, places[0] if places else None) if (types == VOXEL).any() else 0.0,
    )


def _cell_arrays(document: _Document, element: ElementTree.Element, cells: int) -> CellArrays:
    data = element.find("CellData")
    if data is None:
        return CellArrays()
    global_ids = data.get("GlobalIds")
    arrays = {}
    for array in data.findall("DataArray"):
        name = array.get("Name", "")
        is_one = array.get("NumberOfComponents", "1").strip() == "1" and array.get("type") in _TYPES
        if is_one and (name == global_ids or cell_data_rank(name) >= 0):
            arrays[name] = document.array(array, name, cells)
    return CellArrays(arrays, global_ids)


def _tolerance(is_text: bool, element: ElementTree.Element | None) -> float:
    """The effect of rounding on a middle of coordinates of size 1: a sum of eight and a division, after each was rounded when it was
    stored, as a Float32 or with so many digits. Fewer than six digits were typed, not rounded."""
    digits = 0
    if is_text and element is not None:
        digits = max((len(re.sub(r"[eE].*|[-+.]", "", word).lstrip("0")) for word in (element.text or "").split()), default=0)
    is_float32 = element is not None and element.get("type") == "Float32" and (not is_text or digits >= 9)
    printed = 10.0 ** (1 - digits) if 6 <= digits < 17 else 0.0
    return max(8 * 2.0**-52, 8 * 2.0**-24 if is_float32 else 0.0, printed)
