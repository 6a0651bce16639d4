"""Verdicts and proofs of elements at the border beside an oracle of fractions."""

import numpy as np
from oracle import is_positive_on_faces

import hexlens

SEED = 20
#: The checker takes 45 ms for a proof at the border, the oracle 3.
CASES_FOR_A_CHECKED_PROOF = 20


def border_case(random: np.random.Generator) -> np.ndarray:
    """A last valid element or a first invalid one on the way between two, and some ulps beside."""
    cube = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]], dtype=float)
    start = cube + random.uniform(-0.1, 0.1, (8, 3))
    end = cube + random.uniform(-2, 2, (8, 3))
    scale = 2.0 ** random.integers(-60, 60, 3)
    low, high = 0.0, 1.0
    if hexlens.classify((end * scale)[None]).valid[0]:
        return end * scale
    while True:
        middle = (low + high) / 2
        if middle in (low, high):
            break
        if hexlens.classify(((start + middle * (end - start)) * scale)[None]).valid[0]:
            low = middle
        else:
            high = middle
    t = (low, high)[random.integers(2)]
    return (start + t * (end - start)) * scale


def check_border_cases(count: int) -> int:
    """How many were compared."""
    random = np.random.default_rng(SEED)
    cases = np.array([border_case(random) for _ in range(count)])
    result = hexlens.classify(cases, minima=True)
    for i, vertices in enumerate(cases):
        proof = hexlens.certify(vertices)
        is_valid = is_positive_on_faces(vertices.tolist())
        if is_valid != result.valid[i] or is_valid != proof["valid"]:
            raise AssertionError(f"border case {i} of seed {SEED}: {vertices.tolist()}")
        if i % CASES_FOR_A_CHECKED_PROOF == 0:
            hexlens.verify(proof, vertices)
    if not count // 5 < result.valid_count < 4 * count // 5:
        raise AssertionError(f"{result.valid_count} of {count} are valid: they are not at the border.")
    return count
