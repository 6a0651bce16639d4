"""sos_minimum.py COUNT DEGREE...: reads vertices of hexahedra, 24 doubles each, and writes for each degree a line of JSON: the
lower bounds of jacdet on the cube by sums of squares, their status, and the solver's seconds.

The moment relaxation of Lasserre (2001), as Marschner, Palmer, Zhang and Solomon (2020) use it for hexahedra. On [-1, 1]^3 with
the constraints g_i = 1 - x_i^2: minimize the integral of jacdet over all y with y_0 = 1, where the moment matrix of order
d = DEGREE / 2 and those of g_i of order d - 1 are positive semidefinite. Its dual is the greatest c for which jacdet - c is a sum
of squares plus sums of squares times the g_i. Clarabel solves it, as it is, without a modelling layer's time.
"""

import itertools
import json
import sys
import time

import clarabel
import numpy as np
from scipy import sparse

# (x, y, z) of the vertices in VTK_HEXAHEDRON order, on [-1, 1]^3.
CORNERS = np.array([[-1, -1, -1], [1, -1, -1], [1, 1, -1], [-1, 1, -1], [-1, -1, 1], [1, -1, 1], [1, 1, 1], [-1, 1, 1]])


def product(a, b):
    """Of two polynomials whose coefficients are indexed by their exponents."""
    result = np.zeros([n + m - 1 for n, m in zip(a.shape, b.shape)])
    for at in zip(*np.nonzero(a)):
        result[tuple(slice(i, i + m) for i, m in zip(at, b.shape))] += a[at] * b
    return result


def jacdet(vertices):
    """Coefficients of the determinant of dF/d(xi, eta, zeta) on [0, 1]^3, in the variables of [-1, 1]^3."""
    shapes = [np.multiply.outer(np.multiply.outer([1, x], [1, y]), [1, z]) / 8 for x, y, z in CORNERS]
    position = [sum(vertices[v][axis] * shapes[v] for v in range(8)) for axis in range(3)]
    # d/dxi is twice d/dx.
    columns = [[2 * np.take(f, [1], axis=variable) for variable in range(3)] for f in position]
    total = np.zeros((3, 3, 3))
    for order, sign in [((0, 1, 2), 1), ((1, 2, 0), 1), ((2, 0, 1), 1), ((0, 2, 1), -1), ((1, 0, 2), -1), ((2, 1, 0), -1)]:
        term = product(product(columns[0][order[0]], columns[1][order[1]]), columns[2][order[2]])
        total[tuple(slice(0, n) for n in term.shape)] += sign * term
    # The coefficient of xyz is one vector in all three columns, so of each product one column at most has it: the degree is 4.
    total[np.indices(total.shape).sum(axis=0) > 4] = 0
    return total


class Relaxation:
    """The conic problem of a degree; only its objective differs from element to element."""

    def __init__(self, degree):
        order = degree // 2
        self.exponents = [e for e in itertools.product(range(degree + 1), repeat=3) if sum(e) <= degree]
        self.place = {e: i - 1 for i, e in enumerate(sorted(self.exponents))}  # -1 is y_0 = 1
        blocks = [(self.monomials(order), [((0, 0, 0), 1)])]
        for axis in range(3):
            square = tuple(2 * (i == axis) for i in range(3))
            blocks.append((self.monomials(order - 1), [((0, 0, 0), 1), (square, -1)]))
        rows, columns, values, constant, self.cones = [], [], [], [], []
        for monomials, factor in blocks:
            self.cones.append(clarabel.PSDTriangleConeT(len(monomials)))
            for j, b in enumerate(monomials):
                for a in monomials[: j + 1]:
                    scale = 1 if a == b else np.sqrt(2)
                    own = 0.0
                    for shift, weight in factor:
                        column = self.place[tuple(i + k + s for i, k, s in zip(a, b, shift))]
                        if column < 0:
                            own += scale * weight
                        else:
                            rows.append(len(constant))
                            columns.append(column)
                            values.append(-scale * weight)
                    constant.append(own)
        count = len(self.exponents) - 1
        self.constraints = sparse.csc_matrix((values, (rows, columns)), shape=(len(constant), count))
        self.constant = np.array(constant)
        self.quadratic = sparse.csc_matrix((count, count))
        self.settings = clarabel.DefaultSettings()
        self.settings.verbose = False

    def monomials(self, order):
        return [e for e in sorted(self.exponents) if sum(e) <= order]

    def minimum(self, polynomial):
        """A lower bound of the polynomial on the cube, and the solver's status."""
        objective = np.zeros(len(self.exponents) - 1)
        constant = 0.0
        for at in zip(*np.nonzero(polynomial)):
            place = self.place[tuple(int(i) for i in at)]
            if place < 0:
                constant = polynomial[at]
            else:
                objective[place] = polynomial[at]
        scale = np.abs(polynomial).max() or 1.0
        solver = clarabel.DefaultSolver(
            self.quadratic, objective / scale, self.constraints, self.constant, self.cones, self.settings
        )
        solution = solver.solve()
        return constant + scale * solution.obj_val_dual, str(solution.status)


def main():
    count = int(sys.argv[1])
    vertices = np.frombuffer(sys.stdin.buffer.read(), dtype=np.float64).reshape(count, 8, 3)
    for degree in map(int, sys.argv[2:]):
        relaxation = Relaxation(degree)
        bounds, statuses = [], []
        start = time.process_time()
        for element in vertices:
            # Products of three coordinates must neither overflow nor vanish.
            size = np.abs(element - element[0]).max()
            unit = (element - element[0]) / size if 0 < size < np.inf else element
            bound, status = relaxation.minimum(jacdet(unit))
            bounds.append(bound * size**3)
            statuses.append(status)
        seconds = time.process_time() - start
        json.dump({"degree": degree, "bounds": bounds, "statuses": statuses, "seconds": seconds}, sys.stdout)
        print(flush=True)


main()
