"""Best places by SciPy's Nelder-Mead and SLSQP, with the library's own minima as what they maximize.

Reads stars as tests/bench/place.c does; writes for each and for each of the two seconds and value, by volume if all cells are valid
there, else by scale. The argument is the shared library. SLSQP has the least value as a variable of its own and a constraint a cell.
"""

import ctypes
import sys
import time

import numpy as np
from scipy.optimize import minimize

CELLS = 8
EDGES = np.array([(0, 1), (1, 2), (3, 2), (0, 3), (4, 5), (5, 6), (7, 6), (4, 7), (0, 4), (1, 5), (3, 7), (2, 6)])


class Cells(ctypes.Structure):
    _fields_ = [
        ("coordinates", ctypes.c_void_p),
        ("coordinate_count", ctypes.c_size_t),
        ("indices", ctypes.c_void_p),
        ("index_count", ctypes.c_size_t),
    ]


LISTS = (
    "verdicts statuses is_exact classes accepted_by minima minimizers corner_minima exponents relative_minima volumes volume_exponents"
)
COUNTS = "valid invalid unanswered exact first_unanswered"


class Batch(ctypes.Structure):
    _fields_ = [(name, ctypes.c_void_p) for name in LISTS.split()] + [
        (name, ctypes.c_size_t) for name in COUNTS.split()
    ]


class Star:
    """Values of the cells around a vertex, by one call of hl_classify."""

    def __init__(self, library, blocks):
        self.library = library
        self.blocks = blocks.reshape(CELLS, 8, 3).copy()
        self.start = self.blocks[0, 6].copy()
        self.moving = np.all(self.blocks == self.start, axis=2)
        self.scales = np.array([self.scale(c) for c in range(CELLS)])
        self.verdicts = np.zeros(CELLS, np.uint8)
        self.minima = np.zeros(CELLS)
        self.exponents = np.zeros(CELLS, np.int16)
        self.relative = np.zeros(CELLS)
        self.cells = Cells(self.blocks.ctypes.data, self.blocks.size, None, 0)
        self.batch = Batch(
            verdicts=self.verdicts.ctypes.data,
            minima=self.minima.ctypes.data,
            exponents=self.exponents.ctypes.data,
            relative_minima=self.relative.ctypes.data,
        )

    def scale(self, cell):
        ends = EDGES[~(self.moving[cell][EDGES[:, 0]] | self.moving[cell][EDGES[:, 1]])]
        edges = self.blocks[cell][ends[:, 1]] - self.blocks[cell][ends[:, 0]]
        return np.mean(np.sum(edges**2, axis=1)) ** 1.5

    def values(self, place):
        self.blocks[self.moving] = place
        self.library.hl_classify(ctypes.byref(self.cells), ctypes.byref(self.batch))
        return self.relative if self.minima.min() > 0 else self.minima / self.scales

    def value(self, place):
        return self.values(place).min()


def nelder_mead(star):
    options = {"xatol": 1e-10, "fatol": 1e-12, "maxiter": 5000, "maxfev": 5000}
    return minimize(lambda p: -star.value(p), star.start, method="Nelder-Mead", options=options).x


def slsqp(star):
    start = np.append(star.start, star.value(star.start))
    constraint = {"type": "ineq", "fun": lambda x: star.values(x[:3]) - x[3]}
    options = {"ftol": 1e-12, "maxiter": 500}
    return minimize(lambda x: -x[3], start, method="SLSQP", constraints=constraint, options=options).x[:3]


def main():
    library = ctypes.CDLL(sys.argv[1])
    stars = np.frombuffer(sys.stdin.buffer.read()).reshape(-1, CELLS * 24)
    answers = []
    for blocks in stars:
        for method in (nelder_mead, slsqp):
            star = Star(library, blocks)
            begin = time.perf_counter()
            place = method(star)
            seconds = time.perf_counter() - begin
            answers += [seconds, star.value(place)]
    sys.stdout.buffer.write(np.array(answers).tobytes())


main()
