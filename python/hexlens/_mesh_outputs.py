"""`--annotate` in formats other than VTU: VTK 5.1, Gmsh 4.1 and Abaqus, the same bytes as web/outputs/meshes writes."""

from collections.abc import Callable, Iterator
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from ._check import INVALID, UNANSWERED, MeshCheck
from ._mesh import HEXAHEDRON
from ._numbers import js_number
from ._outputs import FileResult, Output, VtuOutput

__all__ = ["MESH_ENDINGS", "is_mesh_ending", "mesh_output"]

#: Rows and numbers are written in chunks of so many.
_PIECE: Final = 131_072
_GMSH_HEXAHEDRON: Final = 5
#: The largest numbers of elements.
_MOST_GMSH_TAG: Final = 2**31 - 1
_MOST_ABAQUS_NUMBER: Final = 999_999_999
#: Abaqus reads so many characters of a coordinate, and so many entries a line.
_MOST_CHARACTERS: Final = 20
_ABAQUS_A_LINE: Final = 16


def _pieces(values: NDArray[Any]) -> Iterator[bytes]:
    for begin in range(0, len(values), _PIECE):
        yield values[begin : begin + _PIECE].tobytes()


def _numbers(check: MeshCheck, most: int, said: list[str]) -> NDArray[np.int64]:
    """The mesh's own ids where these can be numbers of elements, else from 1 on; `said` gets why."""
    why = _why_not(check.mesh.ids, most)
    if why is None:
        return np.asarray(check.mesh.ids).astype(np.int64)
    said.append(f"{why}: elements are numbered from 1, in the file's order.")
    return np.arange(1, len(check.mesh.cells) + 1)


def _why_not(ids: Any, most: int) -> str | None:
    if ids is None:
        return "The mesh has no ids"
    numbers = np.asarray(ids)
    if numbers.dtype.kind not in "iuf":
        return "The ids are words"
    if not np.all((numbers == np.floor(numbers)) & (numbers > 0) & (numbers <= most)):
        return f"Not all ids are whole numbers from 1 to {most}"
    return None if len(np.unique(numbers)) == len(numbers) else "Several cells have one id"


class _MeshOutput:
    """`said` collects sentences for people."""

    def __init__(self, said: list[str]) -> None:
        self._said = said

    def file(self, result: FileResult) -> Iterator[bytes]:
        if result.check is not None:
            yield from self._chunks(result.check)

    def end(self, exit_: int) -> Iterator[str]:
        yield from ()

    def _chunks(self, check: MeshCheck) -> Iterator[bytes]:
        raise NotImplementedError


class _VtkOutput(_MeshOutput):
    def _chunks(self, check: MeshCheck) -> Iterator[bytes]:
        points, cells = check.mesh.points, check.mesh.cells
        count, arrays = len(cells), check.arrays()
        yield b"# vtk DataFile Version 5.1\nHexahedra, decided by Hexlens\nBINARY\nDATASET UNSTRUCTURED_GRID\n"
        yield f"POINTS {len(points)} double\n".encode()
        yield from _pieces(points.ravel().astype(">f8"))
        yield f"\nCELLS {count + 1} {cells.size}\nOFFSETS vtktypeint64\n".encode()
        yield from _pieces(np.arange(0, 8 * count + 8, 8, dtype=">i8"))
        yield b"\nCONNECTIVITY vtktypeint64\n"
        yield from _pieces(cells.ravel().astype(">i8"))
        yield f"\nCELL_TYPES {count}\n".encode()
        yield from _pieces(np.full(count, HEXAHEDRON, ">i4"))
        yield f"\nCELL_DATA {count}\nFIELD FieldData {len(arrays)}\n".encode()
        for name, values in arrays.items():
            yield f"{name} 1 {count} double\n".encode()
            yield from _pieces(values.astype(">f8"))
            yield b"\n"


class _GmshOutput(_MeshOutput):
    def _chunks(self, check: MeshCheck) -> Iterator[bytes]:
        points, cells = check.mesh.points, check.mesh.cells
        tags = _numbers(check, _MOST_GMSH_TAG, self._said)

        def longs(*values: int) -> bytes:
            return np.array(values, "<i8").tobytes()

        def ints(*values: int) -> bytes:
            return np.array(values, "<i4").tobytes()

        yield b"$MeshFormat\n4.1 1 8\n" + ints(1) + b"\n$EndMeshFormat\n$Nodes\n"
        yield longs(min(1, len(points)), len(points), min(1, len(points)), len(points))
        if len(points) > 0:
            yield ints(3, 1, 0) + longs(len(points))
            yield from _pieces(np.arange(1, len(points) + 1, dtype="<i8"))
            yield from _pieces(points.ravel().astype("<f8"))
        yield b"\n$EndNodes\n$Elements\n"
        yield longs(min(1, len(cells)), len(cells), *((int(tags.min()), int(tags.max())) if len(cells) else (0, 0)))
        if len(cells) > 0:
            yield ints(3, 1, _GMSH_HEXAHEDRON) + longs(len(cells))
            yield from _pieces(np.column_stack([tags, cells.astype(np.int64) + 1]).astype("<i8"))
        yield b"\n$EndElements\n"
        for name, values in check.arrays().items():
            yield f'$ElementData\n1\n"{name}"\n1\n0\n3\n0\n1\n{len(cells)}\n'.encode()
            rows = np.empty(len(cells), np.dtype([("tag", "<i4"), ("value", "<f8")]))
            rows["tag"], rows["value"] = tags, values
            yield from _pieces(rows)
            yield b"\n$EndElementData\n"


class _AbaqusOutput(_MeshOutput):
    def _chunks(self, check: MeshCheck) -> Iterator[bytes]:
        points, cells = check.mesh.points, check.mesh.cells
        said: list[str] = []
        numbers = _numbers(check, _MOST_ABAQUS_NUMBER, said)
        longest = 0
        yield b"** Hexahedra, decided by Hexlens\n*NODE\n"
        for begin in range(0, len(points), _PIECE):
            lines = []
            for node, row in enumerate(points[begin : begin + _PIECE].tolist(), begin + 1):
                texts = ["-0" if str(value) == "-0.0" else js_number(value) for value in row]
                longest = max(longest, *map(len, texts))
                lines.append(f"{node}, {', '.join(texts)}\n")
            yield "".join(lines).encode()
        yield b"*ELEMENT, TYPE=C3D8\n"
        for begin in range(0, len(cells), _PIECE):
            rows = np.column_stack([numbers[begin : begin + _PIECE], cells[begin : begin + _PIECE].astype(np.int64) + 1])
            yield "".join(f"{', '.join(map(str, row))}\n" for row in rows.tolist()).encode()
        for name, standing in (("HEXLENS_INVALID", INVALID), ("HEXLENS_UNANSWERED", UNANSWERED)):
            chosen = numbers[check.standing == standing].tolist()
            if chosen:
                yield f"*ELSET, ELSET={name}\n".encode()
            for i in range(0, len(chosen), _ABAQUS_A_LINE):
                yield f"{', '.join(map(str, chosen[i : i + _ABAQUS_A_LINE]))}\n".encode()
        if not np.isfinite(points).all():
            said.append("Coordinates that are not finite are NaN or Infinity, which Abaqus has not.")
        if longest > _MOST_CHARACTERS:
            said.append(
                f"Some coordinates have more than {_MOST_CHARACTERS} characters, of which Abaqus and CalculiX read no more: "
                "others get the same doubles."
            )
        for sentence in said:
            self._said.append(sentence)
            yield f"** {sentence}\n".encode()


_OUTPUTS: Final[dict[str, Callable[[list[str]], Output]]] = {
    "vtu": lambda _: VtuOutput(),
    "vtk": _VtkOutput,
    "msh": _GmshOutput,
    "inp": _AbaqusOutput,
}
MESH_ENDINGS: Final = ", ".join(f".{ending}" for ending in _OUTPUTS)


def is_mesh_ending(path: str) -> bool:
    """True if a name ends in one of these, or has no ending, as a pipe's has none."""
    return _ending(path) in _OUTPUTS


def mesh_output(path: str, said: list[str]) -> Output:
    """In the format that the name ends in: VTU for a name without an ending."""
    return _OUTPUTS[_ending(path)](said)


def _ending(path: str) -> str:
    stem, point, ending = path.replace("\\", "/").rpartition("/")[2].rpartition(".")
    return ending.lower() if point and stem else "vtu"
