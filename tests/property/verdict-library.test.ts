/** The number of the check "Corners and centre" against that of the Verdict in VTK, degenerate elements among them. */
import { spawnSync } from 'node:child_process'
import { fileURLToPath } from 'node:url'
import { expect, it } from 'vitest'
import { exactScaledJacobian } from '../../web/core/exact/exact-numbers'
import { edgeVertices, type Vertices, vertexOf, vertexReference } from '../../web/model/hexahedron'
import { cases, core, entry, randomHexahedron, randomSource, unitCube } from '../unit/core-fixtures'
import { holdsFor, seed } from './replay'

const python = fileURLToPath(new URL('../../build/python/bin/python', import.meta.url))
const program = fileURLToPath(new URL('verdict_numbers.py', import.meta.url))

function numbersOfVerdict(list: readonly Vertices[]): number[] {
  const { error, status, stdout, stderr } = spawnSync(python, [program], {
    input: new Uint8Array(new Float64Array(list.flat()).buffer),
    maxBuffer: 2 ** 26,
  })
  if (error || status !== 0)
    throw new Error(`build/python has no VTK (npm run setup -- --for unit): ${error ?? stderr}`)
  return [...new Float64Array(stdout.buffer.slice(stdout.byteOffset, stdout.byteOffset + stdout.byteLength))]
}

/** Vertices that coincide: a wedge, a pyramid, a tetrahedron and others stored as hexahedra. */
const COINCIDENT = [
  [
    [4, 5],
    [7, 6],
  ],
  [
    [3, 2],
    [7, 6],
  ],
  [
    [4, 5],
    [4, 6],
    [4, 7],
  ],
  [
    [0, 1],
    [0, 2],
    [0, 3],
  ],
  [
    [2, 3],
    [4, 5],
    [4, 6],
    [4, 7],
  ],
  [[0, 1]],
  [[0, 6]],
  [
    [0, 1],
    [0, 2],
    [0, 3],
    [4, 5],
    [4, 6],
    [4, 7],
  ],
] as const

function collapsed(vertices: Vertices, pairs: readonly (readonly [number, number])[]): number[] {
  const moved = [...vertices]
  for (const [to, from] of pairs) moved.splice(3 * from, 3, ...vertexOf(vertices, to))
  return moved
}

function reordered(vertices: Vertices, order: readonly number[]): number[] {
  return order.flatMap(v => vertexOf(vertices, v))
}

function shuffled(random: () => number): number[] {
  return [...Array(8).keys()]
    .map(v => [random(), v] as const)
    .toSorted(([a], [b]) => a - b)
    .map(([, v]) => v)
}

function cells(): number[][] {
  const random = randomSource(seed)
  const list = cases.map(({ vertices }) => vertices.flat())
  for (let n = 0; n < 1000; ++n) {
    const element = randomHexahedron(random, 0.05 * (1 + (n % 20)))
    const size = 10 ** (Math.floor(random() * 60) - 30)
    list.push(element, collapsed(element, entry(COINCIDENT, n % COINCIDENT.length)))
    list.push(
      element.map(x => size * x),
      element.map((x, i) => x * 2 ** ((i % 3) * (n % 40))),
    )
    // Edges about as short as the shortest that Verdict takes for one.
    const short = 10 ** -(6 + 3 * random())
    list.push(
      element
        .with(3, entry(element, 0) + short)
        .with(4, entry(element, 1))
        .with(5, entry(element, 2)),
    )
    const far = 1000 * Math.floor(1000 * random())
    list.push(element.map(x => x + far))
    list.push(reordered(n % 2 ? element : unitCube, shuffled(random)))
    list.push(randomHexahedron(random, 1).map(Math.round))
  }
  for (const size of [0, 1e-300, 1e-15, 1e-14, 1e153, 1e154, 1e300]) list.push(unitCube.map(x => size * x))
  return list
}

const U = 2 ** -53

/**
 * Error bounds of Verdict's number and of ours. In units of the diagonal a point is off by 2u (less
 * the mean, over the diagonal, each rounded), an edge by 5u, the sum of four, with seven roundings
 * of sums of at most 4, by 8 * 2u + 28u = 44u. That over the length, once for the determinant, once
 * for the length, in each of three columns; 8.1u times the permanent, at most 3^1.5 products of
 * lengths, (8R); 6u for lengths, root and quotient. As much again for ours, whose edges are rounded
 * once.
 */
function tolerance(vertices: Vertices): number {
  const box = [0, 1, 2].map(axis => {
    const x = vertices.filter((_, i) => i % 3 === axis)
    return Math.max(...x) - Math.min(...x)
  })
  const diagonal = Math.hypot(...box)
  const lengthOf = (terms: readonly (readonly [number, number])[]) =>
    Math.hypot(
      ...[0, 1, 2].map(axis =>
        terms.reduce((sum, [v, sign]) => sum + sign * ((vertices[3 * v + axis] as number) / diagonal), 0),
      ),
    )
  const edges = edgeVertices.map(([from, to]) =>
    lengthOf([
      [to, 1],
      [from, -1],
    ]),
  )
  const axes = [0, 1, 2].map(axis => lengthOf(vertexReference.map((point, v) => [v, point[axis] ? 1 : -1] as const)))
  const columns = Math.max((3 * 2 * 5) / Math.min(...edges), (3 * 2 * 44) / Math.min(...axes))
  return 2 * U * (columns + 8.1 * 3 ** 1.5 + 6)
}

it('is that of Verdict, 1e30 where Verdict has it, and of its sign where that is not within rounding of zero', () => {
  const list = cells()
  const numbers = numbersOfVerdict(list)
  expect(numbers).toHaveLength(list.length)
  let [without, exact, compared] = [0, 0, 0]
  for (const [n, vertices] of list.entries())
    holdsFor(vertices, () => {
      const report = core.analyze(vertices)
      if (!report.ok) throw new Error(report.error.message)
      const { value, passes } = report.value.checks.find(({ id }) => id === 'corners-and-centre') ?? {
        value: Number.NaN,
        passes: false,
      }
      const theirs = numbers[n] as number
      if (theirs === 1e30 || value === 1e30) {
        expect([value, passes]).toEqual([theirs, true])
        ++without
        return
      }
      const most = tolerance(vertices)
      expect(Math.abs(value - theirs)).toBeLessThanOrEqual(most)
      if (report.value.decidedBy === 'exact') ++exact
      if (Math.abs(value) > most) expect(passes).toBe(theirs > 0)
      if (Math.abs(value) > most) ++compared
      expect(Math.abs(report.value.scaledJacobian)).toBeLessThanOrEqual(1 + 2 ** -48)
    })
  expect(without).toBeGreaterThan(1000)
  expect(exact).toBeGreaterThan(20)
  expect(compared).toBeGreaterThan(5000)
})

it('says 1e30 of wedges, pyramids and tetrahedra as hexahedra, whose scaled Jacobian of the conditions is 0', () => {
  for (const pairs of COINCIDENT.filter(([[a, b]]) => isEdge(a, b))) {
    const vertices = collapsed(unitCube, pairs)
    const report = core.analyze(vertices)
    if (!report.ok) throw new Error(report.error.message)
    expect(report.value.checks.find(({ id }) => id === 'corners-and-centre')).toMatchObject({
      value: 1e30,
      passes: true,
    })
    expect(report.value.valid).toBe(false)
    expect(report.value.scaledJacobian).toBeLessThanOrEqual(0)
    expect(exactScaledJacobian(vertices).upper.numerator <= 0n).toBe(true)
  }
})

it('is 1e30 for 21 of the 51 classes of wrong orders of a cube’s vertices, its symmetries aside', () => {
  const orders = ordersOfACube().map(order => reordered(unitCube, order))
  const numbers = numbersOfVerdict(orders)
  expect(numbers.filter(number => number === 1)).toHaveLength(1)
  expect(numbers.filter(number => number === 1e30)).toHaveLength(21)
  expect(numbers).toHaveLength(52)
  for (const [n, vertices] of orders.entries()) {
    const report = core.analyze(vertices)
    if (!report.ok) throw new Error(report.error.message)
    const check = report.value.checks.find(({ id }) => id === 'corners-and-centre')
    expect(check?.passes).toBe((numbers[n] as number) > 0)
  }
})

/** One order of each class, the first in lexicographic order. */
function ordersOfACube(): number[][] {
  const symmetries = permutations([...Array(8).keys()]).filter(order =>
    edgeVertices.every(([a, b]) => isEdge(order[a] as number, order[b] as number)),
  )
  expect(symmetries).toHaveLength(48)
  const seen = new Set<string>()
  return permutations([...Array(8).keys()]).filter(order => {
    if (seen.has(order.join(''))) return false
    for (const before of symmetries)
      for (const after of symmetries) seen.add(before.map(v => after[order[v] as number]).join(''))
    return true
  })
}

function isEdge(a: number, b: number): boolean {
  return edgeVertices.some(ends => ends.includes(a) && ends.includes(b))
}

function permutations(list: readonly number[]): number[][] {
  if (list.length === 0) return [[]]
  return list.flatMap(first => permutations(list.filter(v => v !== first)).map(rest => [first, ...rest]))
}
