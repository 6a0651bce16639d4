"""Verdicts beside integers; proofs and reports: the same as the Node command's, proofs checked by the independent checker."""

import ctypes
import json
import os
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from border import check_border_cases
from conftest import hard_cases, node

import hexlens
from hexlens import _native

#: `npm run test:python -- --all` has 10,000.
BORDER_CASES = 10_000 if os.environ.get("HEXLENS_ALL") else 500


@pytest.fixture(scope="module")
def elements(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("elements") / "elements.json"
    path.write_text(json.dumps(hard_cases()))
    return path


@pytest.mark.node
def test_reports_are_those_of_the_command(elements: Path) -> None:
    expected = json.loads(node("analyze", str(elements)).stdout)
    own = [hexlens.analyze(case["vertices"]).to_dict(case["name"]) for case in hard_cases()]
    assert json.loads(json.dumps(own)) == expected


@pytest.mark.node
def test_proofs_are_those_of_the_command(elements: Path) -> None:
    expected = json.loads(node("certify", str(elements)).stdout)
    own = [hexlens.certify(case["vertices"], case["name"]) for case in hard_cases()]
    assert json.loads(json.dumps(own)) == expected
    hexlens.verify(own)


def test_border_cases_are_as_integers_say() -> None:
    assert check_border_cases(BORDER_CASES) == BORDER_CASES


def test_a_proof_that_is_changed_is_refused(cube: np.ndarray) -> None:
    proof = hexlens.certify(cube, "cube")
    hexlens.verify(proof)
    hexlens.verify(proof, cube)
    with pytest.raises(hexlens.HexlensError, match="about other vertices"):
        hexlens.verify(proof, cube + 1)
    with pytest.raises(hexlens.HexlensError, match="is refused"):
        hexlens.verify({**proof, "faces": proof["faces"][:5]})
    turned = hexlens.certify(cube[[1, 0, 3, 2, 5, 4, 7, 6]])
    assert not turned["valid"]
    assert Fraction(turned["jacdet"]) == -1
    with pytest.raises(hexlens.HexlensError, match="another number"):
        hexlens.verify({**turned, "jacdet": "-2"})
    with pytest.raises(hexlens.HexlensError, match="is refused"):
        hexlens.verify({**turned, "valid": True})


def test_a_proof_about_the_places_of_a_vertex_is_checked(cube: np.ndarray) -> None:
    """jacdet at vertex 0 is -1 wherever vertex 6 goes; as lists of integers, which are doubles all the same."""
    cube[1] = [-1, 0, 0]
    cell = {"name": "hexahedron", "vertices": cube.astype(int).tolist(), "moving": [6]}
    hold = {"cell": 0, "point": ["0", "0", "0"], "weight": "1"}
    proof = {"name": "vertex 6", "level": "0", "cells": [cell], "holds": [hold]}
    hexlens.verify(proof)
    with pytest.raises(hexlens.HexlensError, match="depends on the place"):
        hexlens.verify({**proof, "cells": [{**cell, "moving": [1]}]})
    with pytest.raises(hexlens.HexlensError, match="is not positive"):
        hexlens.verify({**proof, "holds": [{**hold, "weight": "-1"}]})
    with pytest.raises(hexlens.HexlensError, match="several elements"):
        hexlens.verify(proof, cube)


def test_the_checker_is_the_repository_s_own() -> None:
    root = Path(__file__).resolve().parents[2]
    installed = Path(hexlens.__file__).with_name("_checker.py")
    assert installed.read_text() == (root / "tests/certificates/check_certificates.py").read_text()


def test_a_coordinate_that_is_not_finite_ends_in_a_sentence(cube: np.ndarray) -> None:
    cube[6, 1] = np.nan
    for ask in (hexlens.analyze, hexlens.certify):
        with pytest.raises(hexlens.HexlensError, match=r"Vertex 6 y is not a finite number\."):
            ask(cube)
    with pytest.raises(hexlens.HexlensError, match="has 8 x 3 coordinates"):
        hexlens.analyze(np.zeros((8, 2)))


def test_the_structures_are_those_of_the_library() -> None:
    """hl_pack_report reads hl_report in C: what it writes is what is read here."""
    for case in hard_cases():
        vertices = np.array(case["vertices"], dtype=float)
        raw = _native.RawReport()
        assert _native.library.hl_analyze(vertices.ctypes.data, ctypes.byref(raw)) == 0
        packed = (ctypes.c_double * 2000)()
        _native.library.hl_pack_report.restype = ctypes.c_size_t
        count = _native.library.hl_pack_report(ctypes.byref(raw), packed)
        own = list(flattened(raw))
        assert np.array(own).tobytes() == np.array(packed[:count]).tobytes()


def flattened(raw: _native.RawReport) -> list[float]:
    def candidate(c: _native.Candidate) -> list[float]:
        return [c.kind, c.id, *c.point, *c.position, c.value]

    numbers = [raw.verdict, raw.is_exact, raw.exponent, *candidate(raw.minimizer), raw.minimum_error]
    numbers += [raw.volume_minimum.lower, raw.volume_minimum.upper, *raw.volume_minimum.point, *raw.volume_minimum.position]
    numbers += [*raw.checks, *candidate(raw.maximizer), raw.corner_minimum, raw.edge_minimum, raw.scaled_jacobian, *raw.bernstein]
    for face in raw.faces:
        numbers += [*face.bernstein, face.lower_bound, face.running_minimum, face.skipped_by_minimum_rule]
        numbers += [face.skipped_by_validity_rule, *face.quartic, face.quartic_exponent, face.quartic_is_zero, face.root_count]
        for root in face.roots[: face.root_count]:
            numbers += [root.t, root.a, root.s, root.fate]
    numbers += [raw.candidate_count]
    for c in raw.candidates[: raw.candidate_count]:
        numbers += candidate(c)
    # Numbers that a report lacks are packed as 0.
    relative = 0.0 if np.isnan(raw.relative_minimum) else raw.relative_minimum
    return [float(x) for x in (*numbers, raw.element_class, raw.shape, *raw.coincident, raw.volume, raw.volume_exponent, relative)]
