"""classify: one batch is its cells one by one, whatever the arrays and the threads; bad input ends in a sentence."""

import os
import threading
import time
import tracemalloc

import numpy as np
import pytest
from conftest import hard_cases, lattice
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

import hexlens
from hexlens._numbers import scaled

NAMES = ("valid", "status", "boundary_min", "relative_min", "volume", "minimizer", "class_", "accepted_by", "exact")


def answers(result: hexlens.Classification) -> dict[str, bytes]:
    return {name: getattr(result, name).tobytes() for name in NAMES}


def test_hard_cases_are_what_analyze_says_bit_for_bit() -> None:
    vertices = np.array([case["vertices"] for case in hard_cases()], dtype=float)
    result = hexlens.classify(vertices, minima=True, checks=True)
    minima, exponents = result.boundary_min_parts
    volumes, volume_exponents = result.volume_parts
    assert len(result) > 100
    for i, element in enumerate(vertices):
        report = hexlens.analyze(element)
        assert result.valid[i] == report.valid
        assert hexlens.CLASSES[result.class_[i]] == report.class_
        assert scaled(minima[i], int(exponents[i])) == report.boundary_min
        assert tuple(result.minimizer[i]) == report.minimizer.point
        assert scaled(volumes[i], int(volume_exponents[i])) == report.volume
        relative = np.nan if report.relative_min is None else report.relative_min
        assert np.array_equal(result.relative_min[i], relative, equal_nan=True)
        accepted = {name for c, name in enumerate(hexlens.CHECKS) if result.accepted_by[i] >> c & 1}
        assert accepted == set(report.accepted_by)


@pytest.mark.parametrize("dtype", ["i4", "u4", "i8", "u8", "i2", "u2", ">i4", ">i8"])
def test_indices_of_any_size_give_the_same(dtype: str) -> None:
    points, cells = lattice(12, 0.4)
    expected = answers(hexlens.classify(points, cells, minima=True))
    assert answers(hexlens.classify(points, cells.astype(dtype), minima=True)) == expected
    assert answers(hexlens.classify(points, np.asfortranarray(cells.astype(dtype)), minima=True)) == expected
    assert answers(hexlens.classify(points, np.repeat(cells.astype(dtype), 2, axis=0)[::2], minima=True)) == expected


def test_points_in_any_layout_give_the_same() -> None:
    points, cells = lattice(8, 0.4)
    points = points.astype(np.float32).astype(np.float64)
    expected = answers(hexlens.classify(points, cells))
    for other in (np.asfortranarray(points), points.astype(">f8"), points.astype(np.float32), np.hstack([points, points])[:, :3]):
        assert answers(hexlens.classify(other, cells)) == expected
    assert answers(hexlens.classify(points[cells])) == expected
    assert answers(hexlens.classify(points[cells].reshape(-1, 24))) == expected
    assert answers(hexlens.classify(points.tolist(), cells.tolist())) == expected


def test_threads_give_the_same() -> None:
    points, cells = lattice(70, 0.4)
    cells = cells[:300_000]
    one = hexlens.classify(points, cells, minima=True, threads=1)
    for threads in (2, 3, 8):
        assert answers(hexlens.classify(points, cells.astype(np.int64), minima=True, threads=threads)) == answers(one)
    assert 0 < one.invalid_count < len(one)


def test_what_is_asked_for_first_or_later_is_the_same() -> None:
    points, cells = lattice(6, 0.45)
    assert answers(hexlens.classify(points, cells)) == answers(hexlens.classify(points, cells, minima=True, checks=True))


def test_points_that_changed_in_between_are_noticed() -> None:
    points, cells = lattice(4, 0.1)
    result = hexlens.classify(points, cells)
    points[cells[0, 0]] = points[cells[0, 6]] + 5
    with pytest.raises(RuntimeError, match="have changed since"):
        _ = result.volume


def test_a_bad_cell_has_a_status_and_stops_no_other(cube: np.ndarray) -> None:
    points = np.vstack([cube, [[np.nan, 0, 0]]])
    good, wide = [0, 1, 2, 3, 4, 5, 6, 7], np.array([[0, 1, 2, 3, 4, 5, 6, x] for x in (7, 8, 9, -1, 2**31, 2**32 + 7, -(2**40))])
    result = hexlens.classify(points, wide, minima=True, checks=True)
    assert result.status.tolist() == [0, 1, 4, 4, 4, 4, 4]
    assert result.valid.tolist() == [True] + [False] * 6
    assert result.class_.tolist() == [1] + [0] * 6
    assert np.isnan(result.boundary_min[1:]).all()
    assert result.unanswered_count == 6
    assert hexlens.classify(points, np.array([good, [*good[:7], -1]], np.int32)).status.tolist() == [0, 4]
    assert hexlens.classify(points, np.array([[*good[:7], 2**64 - 1]], np.uint64)).status.tolist() == [4]


def test_nothing_is_copied() -> None:
    points, cells = lattice(60, 0.1)
    hexlens.classify(points[:8], [[0] * 8])
    tracemalloc.start()
    result = hexlens.classify(points, cells, threads=1)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    # Two bytes a cell for the answers, one for the counts, and a little; the indices alone are 32.
    assert peak < 4 * len(result) + 100_000
    assert result._points is points
    assert np.shares_memory(result._cells, cells)


def test_wide_indices_are_narrowed_in_pieces() -> None:
    points, cells = lattice(60, 0.1)
    wide = cells.astype(np.int64)
    tracemalloc.start()
    result = hexlens.classify(points, wide, threads=1)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 4 * len(result) + 100_000 + 2 * 32 * 32_768


def test_memory_maps_that_cannot_be_written_are_read(tmp_path: object) -> None:
    points, cells = lattice(5, 0.1)
    np.save(f"{tmp_path}/points.npy", points)
    np.save(f"{tmp_path}/cells.npy", cells)
    mapped = [np.load(f"{tmp_path}/{name}.npy", mmap_mode="r") for name in ("points", "cells")]
    assert answers(hexlens.classify(*mapped)) == answers(hexlens.classify(points, cells))


def test_other_threads_of_python_run_meanwhile() -> None:
    # Cells that take integers: seconds without a break.
    hard = np.array([case["vertices"] for case in hard_cases()], dtype=float)
    many = np.tile(hard, (40, 1, 1))
    done = threading.Event()
    seen = 0

    def count() -> None:
        nonlocal seen
        while not done.is_set():
            seen += 1
            time.sleep(0)

    watcher = threading.Thread(target=count)
    watcher.start()
    hexlens.classify(many, minima=True, threads=1)
    done.set()
    watcher.join()
    assert seen > 2


@pytest.mark.parametrize(
    ("points", "cells", "message"),
    [
        (np.zeros((8, 2)), [[0] * 8], "two coordinates"),
        (np.zeros((8, 4)), [[0] * 8], "shape 8 x 4; n x 3"),
        (np.zeros(24), [[0] * 8], "shape 24; n x 3"),
        (np.zeros((8, 3)), None, "Without cells"),
        (np.zeros((8, 3)), [[0] * 4], "shape 1 x 4; n x 8"),
        (np.zeros((8, 3)), [0] * 8, "shape 8; n x 8"),
        (np.zeros((8, 3)), [[0.5] * 8], "whole numbers"),
        (np.zeros((8, 3)), [["a"] * 8], "whole numbers"),
        (np.zeros((8, 3), complex), [[0] * 8], "complex128"),
        (np.zeros((8, 3), bool), [[0] * 8], "bool"),
        (np.array([["0"] * 3] * 8), [[0] * 8], "not that of real numbers"),
        (np.full((8, 3), 2**53 + 1), [[0] * 8], "hold numbers that are no doubles"),
        (np.full((8, 3), 2**63 - 1), [[0] * 8], "hold numbers that are no doubles"),
        (np.ma.masked_equal(np.eye(8, 3), 1), [[0] * 8], "masked"),
        ([[0, 0], [1]], [[0] * 8], "no array of numbers"),
        (np.broadcast_to(np.zeros(3), (2**31, 3)), [[0] * 8], "2147483648 points; at most 2\\^31 - 1"),
        (np.broadcast_to(np.zeros(3, np.float32), (2**31, 3)), [[0] * 8], "at most 2\\^31 - 1"),
    ],
)
def test_wrong_arrays_end_in_a_sentence(points: object, cells: object, message: str) -> None:
    with pytest.raises(hexlens.HexlensError, match=message):
        hexlens.classify(points, cells)  # type: ignore[arg-type]


@pytest.mark.parametrize("threads", [0, -1, 1.5, True, "2"])
def test_a_wrong_number_of_threads_ends_in_a_sentence(threads: object) -> None:
    with pytest.raises(hexlens.HexlensError, match="a whole number from 1 on"):
        hexlens.classify(np.zeros((0, 8, 3)), threads=threads)  # type: ignore[arg-type]


def test_no_cells_are_no_answers() -> None:
    for empty in ([], np.empty((0, 8), np.int32), np.empty((0, 8), np.int64)):
        result = hexlens.classify(np.zeros((8, 3)), empty, minima=True, checks=True)
        assert len(result) == 0
        assert result.worst().tolist() == []
        assert result.minimizer.shape == (0, 3)
    assert len(hexlens.classify(np.empty((0, 3)), np.empty((0, 8), int))) == 0
    assert len(hexlens.classify(np.empty((0, 8, 3)))) == 0


def test_worst_first_is_the_order_of_the_header() -> None:
    points, cells = lattice(9, 0.5)
    points[5] = np.inf
    result = hexlens.classify(points, cells, minima=True)
    relative, classes = result.relative_min, result.class_

    def key(i: int) -> tuple[float, int]:
        if result.status[i]:
            return (np.inf, i)
        if np.isnan(relative[i]):
            return (0.0 if hexlens.CLASSES[classes[i]] == "collapsed" else -np.inf, i)
        return (relative[i], i)

    order = sorted(range(len(result)), key=key)
    assert result.worst(None).tolist() == order
    for n in (0, 1, 10, 728, 729, 5000):
        assert result.worst(n).tolist() == order[:n]


@settings(max_examples=60)
@given(hnp.arrays(np.float64, st.tuples(st.integers(0, 20), st.just(8), st.just(3)), elements=st.floats(width=64)))
def test_any_doubles_are_answered_as_one_by_one(vertices: np.ndarray) -> None:
    result = hexlens.classify(vertices, minima=True)
    for i, element in enumerate(vertices):
        if np.isfinite(element).all():
            assert result.status[i] == 0
            assert result.valid[i] == hexlens.analyze(element).valid
        else:
            assert result.status[i] == 1
            assert not result.valid[i]


@settings(max_examples=40)
@given(hnp.arrays(np.int64, st.tuples(st.integers(0, 30), st.just(8)), elements=st.integers(-(2**63), 2**63 - 1) | st.integers(0, 30)))
def test_any_indices_are_answered(cells: np.ndarray) -> None:
    points, _ = lattice(2)
    result = hexlens.classify(points, cells)
    is_there = ((cells >= 0) & (cells < len(points))).all(axis=1)
    assert (result.status == np.where(is_there, 0, 4)).all()


def test_the_machine_says_what_it_runs_on() -> None:
    assert hexlens.vectors() in ("avx512", "avx2", "sse2", "scalar")
    assert os.path.basename(hexlens.__file__) == "__init__.py"
