"""Checks certificates of hexahedra: python3 check_certificates.py CERTIFICATES.json [ELEMENTS.json]

An element is the trilinear map F of [0,1]^3 with F(corner v) = vertex v, and J = det DF. Everything here is computed
from that definition, in exact rationals; a double is the rational that it is. Checked, and thereby proved, is:
"valid": false  J at the given point of [0,1]^3 is the given number and not positive, so J > 0 on the element is false.
"valid": true   On each face J = a(t) s^2 + b(t) s + c(t), s and t the two other coordinates in their order. On each of
                the intervals of t, which cover [0,1], J > 0 at s = 0 and s = 1 (c and a+b+c), and between by one of
                "b"       b >= 0, and "2a+b": 2a+b <= 0. Where a <= 0, J is concave in s; elsewhere it is monotone.
                "D"       D = 4ac - b^2 > 0. Where a <= 0, J is concave in s; elsewhere it is at least D/(4a).
                "middle"  c + b/2 > 0, and so the three Bernstein coefficients of J in s are positive.
                The signs are those of all Bernstein coefficients in t on the interval. So J > 0 on the six faces. That
                J > 0 on the element then is a theorem, the one thing taken from elsewhere: P. Zhang, Validating
                Hexahedra through their Boundaries (Knupp's conjecture).
"level": L      Wherever the vertex goes that "moving" names in each of the cells, while all others stay: there J <= 0 somewhere
                in a cell, or J <= L volume. J at a point is an affine function of its place, and so is the volume. Weights
                w > 0 of the holds make the sum of w (J - L volume), of w J for a hold "bySign", the same number at four
                places that are in no plane, and so everywhere; it is not positive. Without holds L is 1: volume is the mean of J.
With ELEMENTS.json, names, order and doubles must be those of its list (0 and -0 are the same number). Exit status 0 if
all hold; else 1, with a line for each certificate that does not, which says nothing about its element.
"""
import itertools, json, math, re, sys
from fractions import Fraction
CORNERS = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]  # VTK_HEXAHEDRON

def require(claim, otherwise):
    if not claim:
        raise ValueError(otherwise)

def member(entry, key, kind):
    require(isinstance(entry, dict) and key in entry, f'"{key}" is missing')
    require(type(entry[key]) is kind, f'"{key}" is not of the kind it has to be ({kind.__name__})')
    return entry[key]

def rational(text):
    is_rational = isinstance(text, str) and re.fullmatch("-?[0-9]+(/[1-9][0-9]*)?", text)
    require(is_rational and str(Fraction(text)) == text, 'a rational is not "p" or "p/q" in lowest terms')
    return Fraction(text)

def doubles(entry):
    points = member(entry, "vertices", list)
    require(len(points) == 8 and all(isinstance(p, list) and len(p) == 3 for p in points), "not 8 times 3 coordinates")
    require(all(type(x) is float and math.isfinite(x) for p in points for x in p), "a coordinate is no finite number")
    return points

def jacdet(vertices, point):
    columns = []
    for axis in range(3):  # the derivative of F by that coordinate
        factors = [[x if far else 1 - x for x, far in zip(point, corner)] for corner in CORNERS]
        for factor, corner in zip(factors, CORNERS):
            factor[axis] = 1 if corner[axis] else -1
        columns.append([sum(math.prod(f) * x for f, x in zip(factors, xs)) for xs in zip(*vertices)])
    (a, b, c), (d, e, f), (g, h, i) = columns
    return a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)

def quadratic(start, half, end):  # coefficients of 1, x, x^2 from the values at x = 0, 1/2, 1
    return [start, -3 * start + 4 * half - end, 2 * start - 4 * half + 2 * end]
def times(p, q):
    return [sum(x * q[m - i] for i, x in enumerate(p) if 0 <= m - i < len(q)) for m in range(len(p) + len(q) - 1)]
def combined(*terms):  # the sum of factor * polynomial over the terms (factor, polynomial), all of one length
    return [sum(column) for column in zip(*([factor * x for x in p] for factor, p in terms))]

def least(p, start, end):  # among the Bernstein coefficients on [start, end], each times a positive integer
    unit = math.lcm(start.denominator, end.denominator)
    line, power, result = [int(start * unit), int(end * unit)], [1], [p[-1]]
    for coefficient in reversed(p[:-1]):  # Horner's scheme for p at (start + end x) / (1 + x), without fractions
        power = times(power, [unit, unit])
        result = combined((1, times(result, line)), (coefficient, power))
    return min(result)

def check_face(vertices, axis, side, intervals, face):
    at = lambda s, t: jacdet(vertices, [s, t][:axis] + [side] + [s, t][axis:])
    grid = [Fraction(0), Fraction(1, 2), Fraction(1)]  # J has degree 2 in s and in t: these values are all of it
    parts = [quadratic(*values) for values in zip(*(quadratic(*(at(s, t) for s in grid)) for t in grid))]
    unit = math.lcm(*(x.denominator for p in parts for x in p))
    c, b, a = ([int(x * unit) for x in p] for p in parts)  # integers with the same signs
    conditions = {"b": (b, 0), "2a+b": (combined((-2, a), (-1, b)), 0), "middle": (combined((2, c), (1, b)), 1),
                  "D": (combined((4, times(a, c)), (-1, times(b, b))), 1)}  # a polynomial, the least integer allowed
    reached = Fraction(0)
    for interval in intervals:
        by, ends = member(interval, "by", str), [rational(x) for x in member(interval, "t", list)]
        require(len(ends) == 2 and ends[0] == reached < ends[1] <= 1, f"{face} is not covered interval by interval")
        reached, where = ends[1], f"{face}, t from {ends[0]} to {ends[1]}:"
        require(reached.denominator & (reached.denominator - 1) == 0, f"{where} an end is not dyadic")
        require(least(c, *ends) > 0, f"{where} J at s = 0 is not shown to be positive")
        require(least(combined((1, a), (1, b), (1, c)), *ends) > 0, f"{where} J at s = 1 is not shown to be positive")
        require(by in conditions and least(conditions[by][0], *ends) >= conditions[by][1], f"{where} not by {by!a}")
    require(reached == 1, f"{face} is not covered up to t = 1")

def volume(vertices):  # Simpson's rule along each axis, exact as J is quadratic in each coordinate
    weights = {Fraction(0): 1, Fraction(1, 2): 4, Fraction(1): 1}
    return sum(math.prod(weights[x] for x in p) * jacdet(vertices, p) for p in itertools.product(weights, repeat=3)) / 216

def index(value, count, otherwise):
    require(type(value) in (int, float) and value in range(count), otherwise)
    return int(value)

def check_place(entry):
    cells, holds, level = member(entry, "cells", list), member(entry, "holds", list), rational(member(entry, "level", str))
    require(cells and level >= 0, "there are no cells, or the level is negative")
    moving = [[index(v, 8, "what moves is no vertex") for v in member(cell, "moving", list)] for cell in cells]
    points = [doubles(cell) for cell in cells]
    require(all(moving), "in a cell nothing moves")
    require(len({tuple(ps[v]) for ps, vs in zip(points, moving) for v in vs}) == 1, "what moves is not at one place")
    terms = []
    for hold in holds:
        point, weight = [rational(x) for x in member(hold, "point", list)], rational(member(hold, "weight", str))
        cell = index(hold.get("cell"), len(cells), "a hold is in none of the cells")
        require(len(point) == 3 and all(0 <= x <= 1 for x in point), "a point is not in the closed cube")
        require(weight > 0, "a weight is not positive")
        terms.append((cell, point, weight, not ("bySign" in hold and member(hold, "bySign", bool))))
    sums = set()
    for place in [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]:
        moved = [[place if v in vs else list(map(Fraction, p)) for v, p in enumerate(ps)] for ps, vs in zip(points, moving)]
        bounds = [level and level * volume(vertices) for vertices in moved]
        sums.add(sum(w * (jacdet(moved[c], p) - bounds[c] * by_volume) for c, p, w, by_volume in terms))
    require(holds or level >= 1, "nothing holds")
    require(len(sums) == 1, "the weighted sum depends on the place")
    require(max(sums) <= 0, "the weighted sum is positive")

def check(entry):
    require(isinstance(entry, dict) and "error" not in entry, "it is not a certificate")
    if "level" in entry:
        return check_place(entry)
    vertices = [[Fraction(x) for x in point] for point in doubles(entry)]
    if member(entry, "valid", bool):
        faces = member(entry, "faces", list)
        require(len(faces) == 6 and all(isinstance(face, list) for face in faces), '"faces" is not six lists')
        for i, intervals in enumerate(faces):
            check_face(vertices, i // 2, i % 2, intervals, f"face {i}")
    else:
        point, stated = [rational(x) for x in member(entry, "point", list)], rational(member(entry, "jacdet", str))
        require(len(point) == 3 and all(0 <= x <= 1 for x in point), "the point is not in the closed cube")
        require(stated <= 0, "the stated jacdet is positive")
        require(jacdet(vertices, point) == stated, "jacdet at the point is another number")

def main(*files):
    getattr(sys, "set_int_max_str_digits", lambda _: None)(0)
    try:
        lists = [json.load(open(file, encoding="utf-8-sig"), parse_int=float) for file in files]  # numbers are doubles
    except (OSError, ValueError, RecursionError) as error:
        sys.exit(f"refused: a file cannot be read: {error}")
    if not all(isinstance(entries, list) and len(entries) == len(lists[0]) for entries in lists):
        sys.exit("refused: the files are not lists of the same length")
    refused = False
    for i, (entry, element) in enumerate(zip(lists[0], lists[-1])):
        try:
            check(entry)
            require(member(element, "name", str) == member(entry, "name", str), "the element has another name")
            require(element is entry or doubles(element) == doubles(entry), "the element has other vertices")
        except ValueError as why:
            refused, name = True, entry.get("name") if isinstance(entry, dict) else None
            print(f"refused: certificate {i} ({json.dumps(name)}): {why}")
    sys.exit(1) if refused else print(f"{len(lists[0])} certificates hold")

if __name__ == "__main__":
    main(*sys.argv[1:]) if len(sys.argv) in (2, 3) else sys.exit("Usage: check_certificates.py CERTIFICATES [ELEMENTS]")
