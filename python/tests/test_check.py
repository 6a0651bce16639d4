"""check and its command: JSON, exit statuses and outputs of the Node command on every file that is not refused by name."""

import csv
import json
import re
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import numpy as np
import pytest
from conftest import MESHES, lattice, node, python

import hexlens
from hexlens._numbers import js_number

FILES = sorted(
    str(path.relative_to(MESHES)) for path in MESHES.rglob("*") if path.is_file() and path.suffix not in (".json", ".md")
) if MESHES.exists() else []  # fmt: skip
REFUSED_BY_NAME = "npx hexlens check"
VTU = "made/vtk-raw-none.vtu"
#: Files that both read: of each format and coding one.
READ = [VTU, "made/pvtu/mesh.pvtu", "made/vtk-legacy51-bin.vtk", "real/matrix_fiber_rand.vtk", "malformed/vtk-type11-as-hex.vtk"]
needs_meshes = pytest.mark.skipif(not MESHES.exists(), reason="the meshes are not beside the repository")


def checked(runner: object, *arguments: str) -> tuple[int, dict]:
    done = runner("check", "--json", *arguments, cwd=MESHES)  # type: ignore[operator]
    assert done.stdout, done.stderr
    return done.returncode, json.loads(done.stdout)


@needs_meshes
@pytest.mark.node
def test_json_is_that_of_the_node_command() -> None:
    assert len(FILES) > 100
    exit_of_node, expected = checked(node, *FILES)
    exit_of_own, own = checked(python, *FILES)
    assert exit_of_own == exit_of_node == 2
    assert own["exit"] == expected["exit"]
    read = 0
    for a, b in zip(own["files"], expected["files"], strict=True):
        if "error" in a:
            # Files of formats that are refused by name, and damaged ones.
            assert REFUSED_BY_NAME in a["error"] or "error" in b, a
            continue
        assert "error" not in b, b
        a.pop("notes"), b.pop("notes")
        assert a == b
        read += 1
    assert read >= 30


@needs_meshes
@pytest.mark.node
@pytest.mark.parametrize(
    "options",
    [
        ["--worst", "all"],
        ["--worst=0"],
        ["--min-relative", "0.5"],
        ["--degenerate=skip"],
        ["--degenerate", "skip", "--min-relative=1e-3", "--worst", "3"],
        ["--allow-unchecked"],
        ["--format", "vtu"],
        ["--step", "last"],
        ["--step", "all", "--worst=0"],
        ["--step=3"],
    ],
)
def test_options_give_the_same_json(options: list[str]) -> None:
    files = [file for file in READ if file.endswith("vtu") or "--format" not in options]
    (exit_of_own, own), (exit_of_node, expected) = checked(python, *options, *files), checked(node, *options, *files)
    assert exit_of_own == exit_of_node
    for entry in (*own["files"], *expected["files"]):
        entry.pop("notes", None)
    assert own == expected


@needs_meshes
@pytest.mark.node
@pytest.mark.parametrize("kind", ["abaqus", "nastran", "plain"])
def test_ids_are_the_same_bytes(kind: str) -> None:
    arguments = ("check", "--ids", kind, *READ)
    assert python(*arguments, cwd=MESHES).stdout == node(*arguments, cwd=MESHES).stdout


@needs_meshes
@pytest.mark.node
def test_files_that_are_written_are_the_same_bytes(tmp_path: Path) -> None:
    for runner, name in ((python, "own"), (node, "node")):
        csv_file, junit_file = str(tmp_path / f"{name}.csv"), str(tmp_path / f"{name}.xml")
        runner("check", "--csv", csv_file, "--junit", junit_file, "--min-relative", "0.1", *READ, cwd=MESHES)
        for ending in ("vtu", "vtk", "msh", "inp"):
            runner("check", "--annotate", str(tmp_path / f"{name}.{ending}"), READ[0], cwd=MESHES)
    for ending in ("csv", "xml", "vtu", "vtk", "msh", "inp"):
        # Notes are sentences of readers.
        own, expected = (
            re.sub(rb"<system-out>.*?</system-out>\n", b"", (tmp_path / f"{name}.{ending}").read_bytes(), flags=re.DOTALL)
            for name in ("own", "node")
        )
        assert own == expected


@pytest.mark.parametrize(
    ("value", "text"),
    [(1e-6, "0.000001"), (1.25e-6, "0.00000125"), (9.5e-7, "9.5e-7"), (1e-7, "1e-7"), (1e20, "100000000000000000000"), (1e21, "1e+21")],
)
def test_numbers_are_written_as_javascript_writes_them(value: float, text: str) -> None:
    assert js_number(value) == text
    assert js_number(-value) == f"-{text}"


@needs_meshes
@pytest.mark.node
def test_text_is_the_same_but_for_notes() -> None:
    own, expected = (runner("check", *READ, cwd=MESHES).stdout for runner in (python, node))

    def beside_notes(text: str) -> list[str]:
        return [line for line in text.split("\n") if not re.match(r"  (?! )(?!Worst|Least|Not )", line)]

    assert beside_notes(own) == beside_notes(expected)


@needs_meshes
@pytest.mark.node
@pytest.mark.parametrize(
    "arguments",
    [
        [],
        ["--jsn", VTU],
        ["--json", "--json", VTU],
        ["--json=1", VTU],
        ["--worst", "-1", VTU],
        ["--worst"],
        ["--min-relative", "x", VTU],
        ["--degenerate=no", VTU],
        ["--ids", "x", VTU],
        ["--step", "0", VTU],
        ["--json", "--ids", "plain", VTU],
        ["--annotate", "a.vtu", VTU, VTU],
        ["--annotate", "a.cgns", VTU],
        ["-", "-"],
        ["--csv", VTU, VTU],
        ["--csv", "/tmp/no such folder/a.csv", VTU],
        ["nothing.vtu"],
        ["made"],
    ],
)
def test_wrong_calls_have_the_same_status(arguments: list[str]) -> None:
    own, expected = (runner("check", *arguments, cwd=MESHES) for runner in (python, node))
    assert own.returncode == expected.returncode == 2
    assert own.stderr.replace("hexlens-check --help", "hexlens check --help") == expected.stderr


@needs_meshes
def test_standard_input_is_read() -> None:
    text = (MESHES / "made/vtk-ascii.vtu").read_text()
    done = python("check", "--json", "-", text=text)
    assert done.returncode == 1
    assert json.loads(done.stdout)["files"][0]["hexahedra"] == 16


@needs_meshes
@pytest.mark.parametrize("name", ["vtk-raw-none.vtu", "vtk-legacy51-bin.vtk", "vtk-polyhedra-ascii.vtu", "vtk-lagrange2.vtu"])
def test_a_pyvista_grid_is_checked_as_its_file(name: str) -> None:
    pyvista = pytest.importorskip("pyvista")
    grid = pyvista.read(MESHES / "made" / name)
    expected, own = hexlens.check(MESHES / "made" / name).to_dict(), hexlens.check(grid)
    skipped = ("file", "format", "notes")
    assert {k: v for k, v in own.to_dict().items() if k not in skipped} == {k: v for k, v in expected.items() if k not in skipped}
    annotated = own.annotate(grid)
    assert annotated is grid
    hexahedra = annotated.cell_data["valid"][np.isin(grid.celltypes, [11, 12])]
    assert hexahedra.tolist() == own.arrays()["valid"].tolist()


@needs_meshes
def test_a_meshio_mesh_is_checked_as_its_file(tmp_path: Path) -> None:
    meshio = pytest.importorskip("meshio")
    mesh = meshio.read(MESHES / "made/meshio-none.vtu")
    expected, own = hexlens.check(MESHES / "made/meshio-none.vtu").to_dict(), hexlens.check(mesh)
    skipped = ("file", "format", "notes")
    assert {k: v for k, v in own.to_dict().items() if k not in skipped} == {k: v for k, v in expected.items() if k not in skipped}
    own.annotate(mesh).write(tmp_path / "annotated.vtu")
    back = meshio.read(tmp_path / "annotated.vtu")
    assert np.concatenate(back.cell_data["valid"])[: len(own)].tolist() == own.arrays()["valid"].tolist()
    flat = meshio.Mesh(np.zeros((4, 2)), [("quad", [[0, 1, 2, 3]])])
    with pytest.raises(hexlens.HexlensError, match="two coordinates"):
        hexlens.check(flat)


GMSH_MODEL = """
import json, sys
import gmsh, hexlens
gmsh.initialize(interruptible=False)
gmsh.option.setNumber("General.Terminal", 0)
if len(sys.argv) > 2:
    gmsh.open(sys.argv[2])
else:
    for x in (0, 1):
        box = gmsh.model.occ.addBox(x, 0, 0, 1, 1, 1)
    gmsh.model.occ.fragment([(3, 1)], [(3, 2)])
    gmsh.model.occ.synchronize()
    gmsh.model.addPhysicalGroup(3, [2], name="right")
    for curve in gmsh.model.getEntities(1):
        gmsh.model.mesh.setTransfiniteCurve(curve[1], 4)
    for surface in gmsh.model.getEntities(2):
        gmsh.model.mesh.setTransfiniteSurface(surface[1])
        gmsh.model.mesh.setRecombine(2, surface[1])
    for volume in gmsh.model.getEntities(3):
        gmsh.model.mesh.setTransfiniteVolume(volume[1])
    gmsh.model.mesh.generate(3)
    tags, coordinates, _ = gmsh.model.mesh.getNodes(3)
    gmsh.model.mesh.setNode(int(tags[0]), [0.9, 0.9, 0.9], [])
    gmsh.option.setNumber("Mesh.SaveAll", 1)
    # Texts have 16 digits of each coordinate.
    gmsh.option.setNumber("Mesh.Binary", 1)
    gmsh.write(sys.argv[1])
try:
    print(json.dumps(hexlens.check(gmsh.model, worst=None).to_dict()))
except hexlens.HexlensError as error:
    print(json.dumps({"error": str(error)}))
"""


def gmsh_model(*arguments: str) -> dict:
    """In a process of its own: Gmsh has one model, and can end the process."""
    done = subprocess.run([sys.executable, "-c", GMSH_MODEL, *arguments], capture_output=True, encoding="utf-8", check=False)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout.splitlines()[-1])


@pytest.mark.node
def test_gmsh_s_model_is_checked_as_the_file_that_it_writes(tmp_path: Path) -> None:
    pytest.importorskip("gmsh")
    file = tmp_path / "model.msh"
    own = gmsh_model(str(file))
    expected = json.loads(node("check", "--json", "--worst", "all", str(file)).stdout)["files"][0]
    assert own["hexahedra"] == 54
    assert own["invalid"] > 0
    for key in ("format", "hexahedra", "valid", "invalid", "unanswered", "degenerate", "not_trilinear", "other"):
        assert own[key] == expected[key]
    names = ("id", "valid", "class", "boundary_min", "relative_min", "volume", "minimizer")
    by_id = {cell["id"]: [cell[name] for name in names] for cell in expected["worst"]}
    assert {cell["id"]: [cell[name] for name in names] for cell in own["worst"]} == by_id
    assert {cell["block"] for cell in own["worst"]} == {"right", "volume 1"}


@needs_meshes
def test_cells_that_gmsh_does_not_list_are_not_left_out_silently() -> None:
    pytest.importorskip("gmsh")
    own = gmsh_model("", str(MESHES / "made/gmsh-4.1-ascii.msh"))
    assert "Gmsh counts 18 hexahedra in its model and lists 15" in own["error"]


def test_arrays_are_checked() -> None:
    points, cells = lattice(5, 0.4)
    result = hexlens.check((points, cells), worst=3)
    assert len(result) == result.hexahedra == 125
    assert result.valid + result.invalid == 125
    assert [cell.index for cell in result.worst] == hexlens.classify(points, cells).worst(3).tolist()
    assert result[-1].index == 124
    assert result.exit == (1 if result.invalid else 0)
    with pytest.raises(IndexError):
        _ = result[125]
    with pytest.raises(hexlens.HexlensError, match="two coordinates"):
        hexlens.check((points[:, :2], cells))
    with pytest.raises(hexlens.HexlensError, match="none of: "):
        hexlens.check(5)
    with pytest.raises(hexlens.HexlensError, match="it is not there"):
        hexlens.check("nothing.vtu")


def test_flat_meshes_have_no_hexahedra() -> None:
    pyvista = pytest.importorskip("pyvista")
    vtk_filters = pytest.importorskip("vtkmodules.vtkFiltersSources")
    plane = vtk_filters.vtkPlaneSource()
    plane.Update()
    for mesh in (pyvista.Plane(), pyvista.Plane().cast_to_unstructured_grid(), plane.GetOutput()):
        result = hexlens.check(mesh)
        assert result.headline() == "no hexahedra of eight nodes."
        assert re.fullmatch(r"Not checked: \d+ quadrilaterals?\.", result.count_sentences()[0])
        assert result.exit == 3


def test_points_that_do_not_exist_leave_their_cells_unanswered(cube: np.ndarray) -> None:
    good = [0, 1, 2, 3, 4, 5, 6, 7]
    result = hexlens.check((cube, [good, [0, 1, 2, 3, 4, 5, 6, 99], [-1, 1, 2, 3, 4, 5, 6, 7]]))
    assert result.headline() == "3 hexahedra, 1 valid, 2 unanswered."
    assert result.notes == ["2 hexahedra are unanswered, first with index 1: it names point 99, which does not exist."]
    assert [cell.error for cell in result.worst] == [
        None,
        "It names point 99, which does not exist.",
        "It names point -1, which does not exist.",
    ]
    assert np.isnan(result[2].vertices[0]).all()


def test_two_to_the_31_points_are_refused() -> None:
    points = np.broadcast_to(np.zeros(3), (2**31, 3))
    with pytest.raises(hexlens.HexlensError, match="take the mesh in pieces"):
        hexlens.check((points, [[0] * 8]))


def test_names_in_files_cannot_act(tmp_path: Path) -> None:
    points, cells = lattice(1)
    grid = tmp_path / "a<b>\x1b[31m&\u202e.vtu"
    python("check", "--annotate", str(grid), "-", text=vtu_text(points, cells))
    result = hexlens.check(grid)
    assert "\x1b" not in result._repr_html_()
    assert "<b>" not in result._repr_html_()
    done = python("check", str(grid))
    assert "\x1b" not in done.stdout
    assert json.loads(python("check", "--json", str(grid)).stdout)["files"][0]["file"] == str(grid)


def vtu_text(points: np.ndarray, cells: np.ndarray) -> str:
    def array(name: str, kind: str, numbers: np.ndarray, shape: str = "") -> str:
        return f'<DataArray Name="{name}" type="{kind}"{shape} format="ascii">{" ".join(map(str, numbers.ravel().tolist()))}</DataArray>'

    return (
        f'<VTKFile type="UnstructuredGrid"><UnstructuredGrid><Piece NumberOfPoints="{len(points)}" NumberOfCells="{len(cells)}"><Points>'
        f"{array('Points', 'Float64', points, chr(32) + 'NumberOfComponents=' + chr(34) + '3' + chr(34))}</Points><Cells>"
        f"{array('connectivity', 'Int64', cells)}{array('offsets', 'Int64', 8 * np.arange(1, len(cells) + 1))}"
        f"{array('types', 'UInt8', np.full(len(cells), 12))}</Cells></Piece></UnstructuredGrid></VTKFile>"
    )


@needs_meshes
def test_html_is_xml_and_says_the_counts(tmp_path: Path) -> None:
    path = tmp_path / "report.html"
    done = python("check", "--html", str(path), "--csv", str(tmp_path / "cells.csv"), VTU, cwd=MESHES)
    assert done.returncode == 1
    root = ElementTree.fromstring(path.read_text().replace("<!DOCTYPE html>", ""))
    text = "".join(root.itertext())
    assert "10 of 16 hexahedra are invalid. The eight corners would accept 3 of them" in text
    names = [drawing.get("aria-label", "") for drawing in root.iter("{http://www.w3.org/2000/svg}svg")]
    assert len([name for name in names if name.startswith("Invalid hexahedron, least jacdet")]) == 10
    assert len(list(csv.reader((tmp_path / "cells.csv").open(newline="")))) == 17
    ElementTree.fromstring(f"<div>{hexlens.check(MESHES / VTU)._repr_html_()}</div>".replace("\xa0", " "))


def test_a_table_has_all_of_it() -> None:
    pandas = pytest.importorskip("pandas")
    points, cells = lattice(3, 0.5)
    table = hexlens.classify(points, cells).to_pandas()
    assert isinstance(table, pandas.DataFrame)
    assert len(table) == 27
    assert set(table["class"].unique()) <= set(hexlens.CLASSES)
    assert {"valid", "boundary_min", "relative_min", "volume", "xi", "accepted by corners"} <= set(table.columns)


@needs_meshes
def test_what_reads_nothing_imports_nothing() -> None:
    program = (
        "import sys, hexlens\n"
        f"hexlens.check({str(MESHES / VTU)!r})\n"
        "print([m for m in ('meshio', 'pyvista', 'vtkmodules', 'pandas', 'anywidget', 'gmsh') if m in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, encoding="utf-8", check=True)
    assert done.stdout == "[]\n"


def test_cells_have_a_lens() -> None:
    pytest.importorskip("anywidget")
    points, cells = lattice(2, 0.4)
    lens = hexlens.check((points, cells))[3].lens(views="scene verdict")
    assert np.array_equal(lens.vertices, points[cells[3]])
    bundle = lens._repr_mimebundle_()
    data = bundle[0] if isinstance(bundle, tuple) else bundle
    assert "application/vnd.jupyter.widget-view+json" in data
    root = ElementTree.fromstring(data["text/html"])
    assert root.get("aria-label", "").endswith(tuple("01234567)"))
