"""Polynomials with integer coefficients, `p[i]` that of t^i, without leading zeros (the zero polynomial is empty), and their
roots in (0,1), counted by Sturm's theorem and enclosed in dyadic rationals. The same steps as in
web/core/exact/integer-polynomial.ts, so that certificates are the same; nothing rounds."""

from collections.abc import Sequence
from typing import NamedTuple

__all__ = [
    "ONE",
    "ZERO",
    "Dyadic",
    "Polynomial",
    "Root",
    "add",
    "common_divisor",
    "derivative",
    "is_negative_beside",
    "midpoint",
    "multiply",
    "points_between",
    "refined_to",
    "roots_in_unit_interval",
    "sign",
    "sign_at",
    "sign_at_root",
    "square_free",
    "trimmed",
]

Polynomial = tuple[int, ...]


class Dyadic(NamedTuple):
    """numerator / 2^shift."""

    numerator: int
    shift: int


class Root(NamedTuple):
    """The one root in (low, high]; both are the same for a root that is this very number."""

    low: Dyadic
    high: Dyadic


ZERO, ONE = Dyadic(0, 0), Dyadic(1, 0)


def sign(value: int) -> int:
    return (value > 0) - (value < 0)


def trimmed(coefficients: Sequence[int]) -> Polynomial:
    length = len(coefficients)
    while length > 0 and coefficients[length - 1] == 0:
        length -= 1
    return tuple(coefficients[:length])


def add(p: Polynomial, q: Polynomial, factor: int = 1) -> Polynomial:
    """p + factor * q."""
    length = max(len(p), len(q))
    wide_p, wide_q = (list(r) + [0] * (length - len(r)) for r in (p, q))
    return trimmed([a + factor * b for a, b in zip(wide_p, wide_q, strict=True)])


def multiply(p: Polynomial, q: Polynomial) -> Polynomial:
    if not p or not q:
        return ()
    coefficients = [0] * (len(p) + len(q) - 1)
    for i, a in enumerate(p):
        for j, b in enumerate(q):
            coefficients[i + j] += a * b
    return trimmed(coefficients)


def derivative(p: Polynomial) -> Polynomial:
    return tuple(a * i for i, a in enumerate(p))[1:]


def _scaled_value(p: Polynomial, at: Dyadic) -> int:
    """p(t) * 2^(shift * degree): an integer of the value's sign."""
    value, power = 0, 0
    for coefficient in reversed(p):
        value = value * at.numerator + (coefficient << power)
        power += at.shift
    return value


def sign_at(p: Polynomial, at: Dyadic) -> int:
    return sign(_scaled_value(p, at))


def midpoint(a: Dyadic, b: Dyadic) -> Dyadic:
    shift = max(a.shift, b.shift)
    return Dyadic((a.numerator << (shift - a.shift)) + (b.numerator << (shift - b.shift)), shift + 1)


def _is_below(a: Dyadic, b: Dyadic) -> bool:
    return a.numerator << b.shift < b.numerator << a.shift


def _pseudo_remainder(p: Polynomial, q: Polynomial) -> Polynomial:
    """p times |leading(q)|^(degrees' difference + 1), a positive factor, less a multiple of q."""
    lead, size = q[-1], abs(q[-1])
    rest = p
    for steps in range(len(p) - len(q) + 1, 0, -1):
        if len(rest) == len(q) + steps - 1:
            factor = -rest[-1] if lead < 0 else rest[-1]
            # The leading coefficients cancel.
            rest = trimmed([a * size - (q[i - steps + 1] if i >= steps - 1 else 0) * factor for i, a in enumerate(rest[:-1])])
        else:
            rest = tuple(a * size for a in rest)
    return rest


def _remainder_chain(p: Polynomial, q: Polynomial) -> list[Polynomial]:
    """p, q, and on with negated remainders, up to positive factors, until one is zero; kept small by the exact divisors of the
    subresultant algorithm (Knuth, The Art of Computer Programming 2, 4.6.1, algorithm C)."""
    chain = [p]
    before, last = p, q
    g, h = 1, 1
    while last:
        chain.append(last)
        difference = len(before) - len(last)
        divisor = g * h**difference
        following = tuple(-a // divisor for a in _pseudo_remainder(before, last))
        g = abs(last[-1])
        if difference > 0:
            h = g**difference // h ** (difference - 1)
        before, last = last, following
    return chain


def _sturm_chain(p: Polynomial) -> list[Polynomial]:
    return _remainder_chain(p, derivative(p)) if p else []


def common_divisor(p: Polynomial, q: Polynomial) -> Polynomial:
    """The greatest one, up to a factor."""
    longer, shorter = (p, q) if len(p) >= len(q) else (q, p)
    return _remainder_chain(longer, shorter)[-1] if longer else ()


def _quotient(p: Polynomial, q: Polynomial) -> Polynomial:
    """Of an exact division, up to a positive factor."""
    lead = abs(q[-1])
    rest: Polynomial = p
    result: Polynomial = ()
    while len(rest) >= len(q):
        factor = -rest[-1] if q[-1] < 0 else rest[-1]
        shift = (0,) * (len(rest) - len(q))
        result = add(tuple(a * lead for a in result), (*shift, factor))
        rest = add(tuple(a * lead for a in rest), (*shift, *(a * factor for a in q)), -1)
    return result


def square_free(p: Polynomial) -> Polynomial:
    """The polynomial with the same roots, each once."""
    chain = _sturm_chain(p)
    common = chain[-1] if chain else ()
    return _quotient(p, common) if len(common) > 1 else p


def _sign_changes(chain: list[Polynomial], at: Dyadic) -> int:
    changes, last = 0, 0
    for p in chain:
        now = sign_at(p, at)
        if now == 0:
            continue
        changes += last != 0 and now != last
        last = now
    return changes


def _count_roots(p: Polynomial, low: Dyadic, high: Dyadic) -> int:
    """Of a square-free polynomial in (low, high]."""
    if len(p) <= 1:
        return 0
    chain = _sturm_chain(p)
    return _sign_changes(chain, low) - _sign_changes(chain, high)


def roots_in_unit_interval(p: Polynomial) -> list[Root]:
    """The roots in (0,1) of a square-free polynomial, ascending, in disjoint intervals whose ends are no roots of it."""
    if len(p) <= 1:
        return []
    chain = _sturm_chain(p)
    roots: list[Root] = []
    # A list, not a recursion: roots can be nearer to each other than a stack is deep.
    intervals = [(ZERO, ONE, _sign_changes(chain, ZERO), _sign_changes(chain, ONE))]
    while intervals:
        low, high, below, above = intervals.pop()
        if below == above:
            continue
        if below - above == 1:
            root = _separated(p, low, high)
            if _is_below(root.low, ONE):
                roots.append(root)
            continue
        middle = midpoint(low, high)
        changes = _sign_changes(chain, middle)
        intervals += [(middle, high, changes, above), (low, middle, below, changes)]
    return roots


def _separated(p: Polynomial, low: Dyadic, high: Dyadic) -> Root:
    """The one root in (low, high], with both ends moved off roots: off `low`, which may be another root, and off itself."""
    if sign_at(p, high) == 0:
        return Root(high, high)
    while sign_at(p, low) == 0:
        middle = midpoint(low, high)
        now = sign_at(p, middle)
        if now == 0:
            return Root(middle, middle)
        # The sign just above the root at `low` is the one opposite to that at `high`, for one root lies between.
        if now == sign_at(p, high):
            high = middle
        else:
            low = middle
    return Root(low, high)


def _refined(p: Polynomial, root: Root) -> Root:
    """The same root in half the interval."""
    low, high = root
    if low == high:
        return root
    middle = midpoint(low, high)
    now = sign_at(p, middle)
    if now == 0:
        return Root(middle, middle)
    return Root(low, middle) if now == sign_at(p, high) else Root(middle, high)


def refined_to(p: Polynomial, root: Root, bits: int) -> Root:
    """The same root in an interval of width 2^-bits or less: quadratic interval refinement (Abbott), bisection where the chord
    does not tell the part of the interval that has the root."""
    step = 1
    while root.low != root.high and _is_wider(root, bits):
        narrowed = _narrowed_by_chord(p, root, step) if step > 1 else None
        root = narrowed or _refined(p, root)
        step = 2 * step if narrowed or step == 1 else step >> 1
    return root


def _is_wider(root: Root, bits: int) -> bool:
    low, high = root
    width = (high.numerator << low.shift) - (low.numerator << high.shift)
    return width << bits > 1 << (low.shift + high.shift)


def _narrowed_by_chord(p: Polynomial, root: Root, step: int) -> Root | None:
    """The 2^step-th part of the interval where the chord of p is zero, if it has the root."""
    own = max(root.low.shift, root.high.shift)
    start, end = (at.numerator << (own - at.shift) for at in root)
    at_start, at_end = (abs(_scaled_value(p, Dyadic(at, own))) for at in (start, end))
    first = (start << step) + (end - start) * ((at_start << step) // (at_start + at_end))
    low, high = Dyadic(first, own + step), Dyadic(first + end - start, own + step)
    below, above = sign_at(p, low), sign_at(p, high)
    if below == 0:
        return Root(low, low)
    if above == 0:
        return Root(high, high)
    return None if below == above else Root(low, high)


def sign_at_root(q: Polynomial, p: Polynomial, root: Root) -> int:
    """The sign of q at a root of the square-free p."""
    if not q:
        return 0
    if root.low == root.high:
        return sign_at(q, root.low)
    common = common_divisor(p, q)
    if _count_roots(square_free(common), root.low, root.high) > 0:
        return 0
    simple = square_free(q)
    while root.low != root.high and (_count_roots(simple, root.low, root.high) > 0 or sign_at(q, root.low) == 0):
        root = refined_to(p, root, 2 * max(root.low.shift, root.high.shift) + 2)
    return sign_at(q, root.high)


def points_between(p: Polynomial, roots: list[Root]) -> list[Dyadic]:
    """Points of (0,1), one between every two neighbours among 0, the roots in it, and 1."""
    intervals = []
    for root in roots:
        while not (_is_below(ZERO, root.low) and _is_below(root.high, ONE)):
            root = _refined(p, root)
        intervals.append(root)
    above = [ZERO, *(root.high for root in intervals)]
    below = [*(root.low for root in intervals), ONE]
    return [midpoint(a, b) for a, b in zip(above, below, strict=True)]


def is_negative_beside(p: Polynomial, root: Root) -> bool:
    """True if p is negative on either side of its root, next to it."""
    if root.low != root.high:
        return sign_at(p, root.low) < 0 or sign_at(p, root.high) < 0
    multiplicity, derived = 1, derivative(p)
    while sign_at(derived, root.low) == 0:
        derived = derivative(derived)
        multiplicity += 1
    return multiplicity % 2 == 1 or sign_at(derived, root.low) < 0
