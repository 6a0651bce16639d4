/**
 * The two identities on which the paper rests, proved: a face's P has degree at most four, and the product identity of
 * determinants with a common column. Also what they are used for, and that a face's polynomial has the form they begin with.
 *
 * The argument. Both sides of each are polynomials with integer coefficients in indeterminates, and here they are expanded into
 * monomials, with BigInt coefficients: nothing is rounded and nothing is sampled. Monomials are linearly independent, so the two
 * sides are the same polynomial if and only if every coefficient of their difference is zero. An equation of polynomials
 * holds for whatever is put in for the indeterminates: for every hexahedron, degenerate or not, since nothing is divided by.
 */
import { describe, expect, it } from 'vitest'
import { type FaceTopology, faces, vertexReference } from '../../web/model/hexahedron'

/** The coefficients that are not zero, by monomials; a monomial is its factors in alphabetical order: "a0 t t". */
type Polynomial = ReadonlyMap<string, bigint>

function collected(terms: Iterable<readonly [string, bigint]>): Polynomial {
  const sums = new Map<string, bigint>()
  for (const [monomial, coefficient] of terms) sums.set(monomial, (sums.get(monomial) ?? 0n) + coefficient)
  for (const [monomial, coefficient] of sums) if (coefficient === 0n) sums.delete(monomial)
  return sums
}

const factorsOf = (monomial: string) => (monomial === '' ? [] : monomial.split(' '))
const monomialOf = (factors: readonly string[]) => factors.toSorted().join(' ')

const constant = (value: number): Polynomial => collected([['', BigInt(value)]])
const indeterminate = (name: string): Polynomial => new Map([[name, 1n]])

function sum(...polynomials: readonly Polynomial[]): Polynomial {
  return collected(polynomials.flatMap(polynomial => [...polynomial]))
}

function productOfTwo(p: Polynomial, q: Polynomial): Polynomial {
  const right = [...q].map(([monomial, coefficient]) => [factorsOf(monomial), coefficient] as const)
  return collected(
    [...p].flatMap(([monomial, coefficient]) => {
      const left = factorsOf(monomial)
      return right.map(([factors, other]) => [monomialOf([...left, ...factors]), coefficient * other] as const)
    }),
  )
}

const product = (...polynomials: readonly Polynomial[]) =>
  polynomials.reduce((all, factor) => productOfTwo(all, factor))

const times = (factor: number, ...polynomials: readonly Polynomial[]) => product(constant(factor), ...polynomials)
const difference = (p: Polynomial, q: Polynomial) => sum(p, times(-1, q))
const exponent = (monomial: string, name: string) => factorsOf(monomial).filter(factor => factor === name).length

function degree(polynomial: Polynomial, name: string): number {
  return Math.max(...[...polynomial.keys()].map(monomial => exponent(monomial, name)))
}

/** The coefficient of name^power. */
function coefficientOf(polynomial: Polynomial, name: string, power: number): Polynomial {
  return collected(
    [...polynomial]
      .filter(([monomial]) => exponent(monomial, name) === power)
      .map(([monomial, coefficient]) => [
        monomialOf(factorsOf(monomial).filter(factor => factor !== name)),
        coefficient,
      ]),
  )
}

function derivative(polynomial: Polynomial, name: string): Polynomial {
  return collected(
    [...polynomial].flatMap(([monomial, coefficient]) => {
      const factors = factorsOf(monomial)
      const at = factors.indexOf(name)
      return at < 0 ? [] : [[monomialOf(factors.toSpliced(at, 1)), coefficient * BigInt(exponent(monomial, name))]]
    }),
  )
}

/** The polynomial with 0 or 1 for an indeterminate. */
function at(polynomial: Polynomial, name: string, value: 0 | 1): Polynomial {
  const powers = Array.from({ length: degree(polynomial, name) + 1 }, (_, power) => power)
  return value === 0
    ? coefficientOf(polynomial, name, 0)
    : sum(...powers.map(power => coefficientOf(polynomial, name, power)))
}

const ZERO: Polynomial = new Map()

type Column = readonly [Polynomial, Polynomial, Polynomial]

function determinant(u: Column, v: Column, w: Column): Polynomial {
  const signs = [
    [0, 1, 2, 1],
    [1, 2, 0, 1],
    [2, 0, 1, 1],
    [2, 1, 0, -1],
    [1, 0, 2, -1],
    [0, 2, 1, -1],
  ] as const
  return sum(...signs.map(([i, j, k, sign]) => times(sign, u[i], v[j], w[k])))
}

it('expands, and tells what is zero from what is not', () => {
  const [x, y] = [indeterminate('x'), indeterminate('y')]
  const squares = difference(product(x, x), product(y, y))
  expect(product(sum(x, y), difference(x, y))).toEqual(squares)
  expect(product(sum(x, y), sum(x, y))).not.toEqual(squares)
  expect(difference(x, x)).toEqual(ZERO)
  expect(derivative(product(x, x, x, y), 'x')).toEqual(times(3, x, x, y))
  expect(at(sum(squares, x), 'x', 1)).toEqual(sum(constant(2), times(-1, y, y)))
})

const AXES = ['xi', 'eta', 'zeta'] as const

/** det DF of the trilinear map, from its definition, in the 24 coordinates p0x to p7z and xi, eta, zeta: 27 indeterminates. */
function jacdet(): Polynomial {
  const F = ['x', 'y', 'z'].map(coordinate =>
    sum(
      ...vertexReference.map((reference, vertex) =>
        product(
          indeterminate(`p${vertex}${coordinate}`),
          ...reference.map((end, axis) => {
            const x = indeterminate(AXES[axis] as string)
            return end === 1 ? x : difference(constant(1), x)
          }),
        ),
      ),
    ),
  )
  const [U, V, W] = AXES.map(axis => F.map(component => derivative(component, axis)) as unknown as Column)
  return determinant(U as Column, V as Column, W as Column)
}

describe('a face’s polynomial and its P', () => {
  const J = jacdet()

  it.each(faces)(
    'on face $name jacdet is a s^2 + b s + c, with a linear, b and c quadratic in t',
    (face: FaceTopology) => {
      const f = at(J, AXES[face.axis], face.side)
      const [s, t] = [AXES[face.s], AXES[face.t]]
      expect(degree(f, s)).toBe(2)
      expect([2, 1, 0].map(power => degree(coefficientOf(f, s, power), t))).toEqual([1, 2, 2])
    },
  )

  // Any face is this one with polynomials in the coordinates put in for a0 to c2.
  const [a0, a1] = [indeterminate('a0'), indeterminate('a1')]
  const [b0, b1, b2] = [indeterminate('b0'), indeterminate('b1'), indeterminate('b2')]
  const [c0, c1, c2] = [indeterminate('c0'), indeterminate('c1'), indeterminate('c2')]
  const [s, t] = [indeterminate('s'), indeterminate('t')]
  const a = sum(a0, product(a1, t))
  const b = sum(b0, product(b1, t), product(b2, t, t))
  const c = sum(c0, product(c1, t), product(c2, t, t))
  const [da, db, dc] = [derivative(a, 't'), derivative(b, 't'), derivative(c, 't')]
  const P = sum(times(4, a, a, dc), times(-2, a, b, db), product(da, b, b))

  it('P has degree four, with the coefficients of the paper', () => {
    expect(degree(P, 't')).toBe(4)
    expect([0, 1, 2, 3, 4].map(power => coefficientOf(P, 't', power))).toEqual([
      sum(product(a1, b0, b0), times(-2, a0, b0, b1), times(4, a0, a0, c1)),
      sum(times(8, a0, a0, c2), times(8, a0, a1, c1), times(-4, a0, b0, b2), times(-2, a0, b1, b1)),
      sum(
        times(16, a0, a1, c2),
        times(-6, a0, b1, b2),
        times(4, a1, a1, c1),
        times(-2, a1, b0, b2),
        times(-1, a1, b1, b1),
      ),
      sum(times(8, a1, a1, c2), times(-4, a0, b2, b2), times(-4, a1, b1, b2)),
      times(-3, a1, b2, b2),
    ])
  })

  it('only because a is linear: with a t^2 in it P would have degree five', () => {
    const quadratic = sum(a, product(indeterminate('a2'), t, t))
    const ofQuadratic = sum(
      times(4, quadratic, quadratic, dc),
      times(-2, quadratic, b, db),
      product(derivative(quadratic, 't'), b, b),
    )
    expect(degree(ofQuadratic, 't')).toBe(5)
  })

  it('where 2 a s + b = 0, 4 a^2 times the derivative of f in t is P', () => {
    const f = sum(product(a, s, s), product(b, s), c)
    const stationary = sum(times(2, a, s), b)
    const rest = sum(times(2, a, da, s), times(2, a, db), times(-1, da, b))
    expect(difference(times(4, a, a, derivative(f, 't')), P)).toEqual(product(stationary, rest))
  })

  it('the value there, c - b^2 / (4 a), has the derivative P / (4 a^2)', () => {
    const numerator = difference(times(4, a, c), product(b, b))
    const quotientRule = difference(times(4, a, derivative(numerator, 't')), times(4, da, numerator))
    expect(quotientRule).toEqual(times(4, P)) // over 16 a^2
  })
})

describe('determinants with a common column', () => {
  const column = (name: string) => [1, 2, 3].map(row => indeterminate(`${name}${row}`)) as unknown as Column
  const det = determinant

  it('det(u v w) det(u a b) = det(u a w) det(u v b) - det(u v a) det(u b w), in all 15 coordinates', () => {
    const [u, v, w] = [column('u'), column('v'), column('w')]
    const [a, b] = [column('a'), column('b')]
    const left = product(det(u, v, w), det(u, a, b))
    const [first, second] = [product(det(u, a, w), det(u, v, b)), product(det(u, v, a), det(u, b, w))]
    expect(left.size).toBeGreaterThan(0)
    expect(difference(left, difference(first, second))).toEqual(ZERO)
    expect(difference(left, sum(first, second))).not.toEqual(ZERO)
  })

  // dJ/dx = d + e. Where it vanishes, J q = -d^2 - (a product of two of three determinants).
  const [U, V, W] = [column('U'), column('V'), column('W')]
  const [A, B, C] = [column('A'), column('B'), column('C')]
  const J = det(U, V, W)
  const [s1, s2, s3] = [det(U, V, A), det(U, B, W), det(C, V, W)]
  it.each([
    { axis: 'x', q: det(U, A, B), d: det(U, A, W), e: det(U, V, B), others: product(s1, s2) },
    { axis: 'y', q: det(A, V, C), d: det(A, V, W), e: det(U, V, C), others: product(s1, s3) },
    { axis: 'z', q: det(B, C, W), d: det(B, V, W), e: det(U, C, W), others: product(s2, s3) },
  ])('along $axis: J q = d (d + e) - d^2 - the product of the others', ({ q, d, e, others }) => {
    expect(product(J, q)).toEqual(difference(difference(product(d, sum(d, e)), product(d, d)), others))
  })
})
