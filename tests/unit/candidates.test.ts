/** Candidates for the worst cells have the worst ones among them, however the cells come. */
import { describe, expect, test } from 'vitest'
import { ABOUT, CandidateList, type Candidates } from '../../web/core/batch/candidates'
import { STATUSES } from '../../web/core/batch/lists'
import { CLASSES } from '../../web/core/unpack'
import { worstFirst } from '../../web/mesh/worst'
import { randomHexahedron, randomSource, unitCube } from './core-fixtures'
import { collapsedEdge, flat, invalidCorner, mirroredCube, notFinite } from './mesh-fixtures'
import { batchCores } from './node-workers'

/** All that is given, one after the other. */
function listOf(few: number, about: readonly number[], limit = Infinity): CandidateList {
  const list = new CandidateList({ few, limit })
  for (const [cell, own] of about.entries()) list.take(cell, own)
  return list
}

const cellsOf = (list: CandidateList) => list.candidates?.cells

describe('a list of candidates', () => {
  test('has a limit above the last of the few least by three bounds', () => {
    const list = listOf(3, [5, 1, 4, 2])
    expect(list.limit).toBe(4 + 3 * ABOUT * 4)
    expect(cellsOf(list)).toEqual([1, 2, 3])
    list.take(4, -3)
    expect(list.limit).toBe(2 + 3 * ABOUT * 2)
    expect(list.candidates).toEqual({ cells: [1, 3, 4], about: [1, 2, -3] })
    list.take(5, -2)
    expect(list.limit).toBe(1 + 3 * ABOUT)
  })

  test('has a limit above one that is negative, too, and 0 for zeros', () => {
    expect(listOf(2, [-1, -2]).limit).toBe(-1 + 3 * ABOUT)
    expect(listOf(2, [0, -2]).limit).toBe(0)
  })

  test('keeps what is at the limit and just below, not what is above', () => {
    const { limit } = listOf(2, [1, 2])
    const above = 2 + 4 * ABOUT * 2
    expect(cellsOf(listOf(2, [1, 2, limit, above, 2 - ABOUT, 2]))).toEqual([0, 1, 4, 5])
    expect(cellsOf(listOf(2, [1, 2, limit, above]))).toEqual([0, 1, 2])
  })

  test('keeps all that are alike', () => {
    expect(cellsOf(listOf(3, [7, 7, 7, 7, 7, 8]))).toEqual([0, 1, 2, 3, 4])
  })

  test('of fewer than few keeps all, up to the limit that it was given', () => {
    expect(cellsOf(listOf(5, [3, 9, 1]))).toEqual([0, 1, 2])
    expect(cellsOf(listOf(5, [3, 9, 1], 4))).toEqual([0, 2])
    expect(listOf(5, [3, 9, 1], 4).limit).toBe(4)
    expect(cellsOf(listOf(5, []))).toEqual([])
  })

  test('does not lower its limit by what may be anything, and keeps it', () => {
    const list = listOf(2, [-Infinity, -Infinity, -Infinity, 5])
    expect(list.limit).toBe(Infinity)
    expect(cellsOf(list)).toEqual([0, 1, 2, 3])
    list.take(4, 1)
    list.take(5, 2)
    expect(cellsOf(list)).toEqual([0, 1, 2, 4, 5])
  })

  test('is none where too many are alike, and is one where most fall behind', () => {
    expect(listOf(64, new Array(20_000).fill(1)).candidates?.cells.length).toBe(20_000)
    expect(listOf(64, new Array(20_001).fill(1)).candidates).toBeNull()
    expect(listOf(64, new Array(20_001).fill(-Infinity)).candidates).toBeNull()
    const falling = Array.from({ length: 50_000 }, (_, i) => 50_000 - i)
    expect(cellsOf(listOf(64, falling))).toEqual(Array.from({ length: 64 }, (_, i) => 49_936 + i))
    // Once they are too many, nothing brings them back.
    const many = listOf(2, new Array(20_001).fill(1))
    many.take(0, -1)
    many.take(1, -1)
    expect(many.candidates).toBeNull()
  })

  test('of parts is that of the whole; a part with too many has none', () => {
    const random = randomSource(31)
    const about = Array.from({ length: 3000 }, () => Math.round(1000 * (random() - 0.5)))
    const whole = listOf(64, about)
    const list = new CandidateList({ few: 64, limit: Infinity })
    for (const first of [2000, 0, 1000])
      list.takeAll(listOf(64, about.slice(first, first + 1000), list.limit).candidates, first)
    expect(list.limit).toBe(whole.limit)
    expect(cellsOf(list)?.toSorted((a, b) => a - b)).toEqual(cellsOf(whole))
    for (const [i, cell] of (cellsOf(list) ?? []).entries()) expect(list.candidates?.about[i]).toBe(about[cell])
    list.takeAll(null, 0)
    expect(list.candidates).toBeNull()
  })
})

const FEW = 64
const LISTS = { minima: true, relativeMinima: true, classes: true, statuses: true } as const
const next = randomSource(32)
const random = (count: number, sigma: number) => Array.from({ length: count }, () => randomHexahedron(next, sigma))
const scaled = (elements: readonly (readonly number[])[], by: number) => elements.map(own => own.map(x => x * by))
const odd = [notFinite, flat, mirroredCube, collapsedEdge, invalidCorner, flat, unitCube.map(x => 1e9 + 1e-3 * x)]

const meshes: Readonly<Record<string, readonly (readonly number[])[]>> = {
  'all valid': random(3000, 0.02),
  'hardly any invalid': [...random(1500, 0.03), ...odd, ...random(1500, 0.03)],
  'half invalid': random(3000, 0.2),
  'nearly all invalid': random(3000, 0.6),
  'the worst ones last': [...random(2500, 0.02), ...random(500, 0.5)],
  'of all sizes': [...scaled(random(900, 0.3), 1e-110), ...random(900, 0.3), ...scaled(random(900, 0.3), 2 ** 300)],
  'many collapsed': [...Array.from({ length: 2000 }, () => flat), ...random(100, 0.02), ...odd],
  fewer: [...random(40, 0.3), notFinite],
}

describe.each(Object.entries(meshes))('of cells, %s, seed 32', (name, hexahedra) => {
  const points = new Float64Array(hexahedra.flat())
  const piece = { points, cells: null, firstPoint: 0 }
  const all = batchCores.vectors.classify(piece, LISTS)
  const isUnanswered = (cell: number) => STATUSES[all.statuses[cell] as number] !== undefined
  const isCollapsed = (cell: number) => CLASSES[all.classes[cell] as number] === 'collapsed'
  const severity = { relativeMinima: all.relativeMinima, isCollapsed, isUnanswered }
  const answered = hexahedra.length - all.unansweredCount
  const worst = worstFirst(hexahedra.length, severity, Math.min(FEW, answered), () => true)

  function expectTheWorst({ cells, about }: Candidates): void {
    expect(new Set(cells).size).toBe(cells.length)
    expect([...worst].filter(cell => !cells.includes(cell))).toEqual([])
    for (const [i, cell] of cells.entries()) {
      expect(isUnanswered(cell)).toBe(false)
      const own = about[i] as number
      if (own === -Infinity) continue
      const relative = isCollapsed(cell) ? 0 : (all.relativeMinima[cell] as number)
      expect(Math.abs(own - relative)).toBeLessThanOrEqual(ABOUT * Math.abs(relative))
    }
  }

  test.each(Object.entries(batchCores))('at once, %s', (way, core) => {
    const { candidates } = core.classify(piece, { minima: true }, { worst: { few: FEW, limit: Infinity } })
    expectTheWorst(candidates as Candidates)
    // Without vectors nothing is known about any.
    const isKnown = way === 'vectors' && ['half invalid', 'nearly all invalid', 'all valid'].includes(name)
    if (isKnown) expect(candidates?.cells.length).toBeLessThan(200)
    expect(core.classify(piece, { minima: true }).candidates).toBeNull()
  })

  test.each(Object.entries(batchCores))('in pieces with a falling limit, %s', (_, core) => {
    const list = new CandidateList({ few: FEW, limit: Infinity })
    // Not in their order: others decide, too.
    const firsts = Array.from({ length: Math.ceil(hexahedra.length / 600) }, (_, i) => 600 * i)
    for (const first of [...firsts.slice(2), ...firsts.slice(0, 2)]) {
      const own = { points: points.subarray(24 * first, 24 * (first + 600)), cells: null, firstPoint: 0 }
      const before = list.limit
      const found = core.classify(own, { minima: true }, { worst: { few: FEW, limit: before } })
      list.takeAll(found.candidates, first)
      expect(list.limit).toBeLessThanOrEqual(before)
    }
    expectTheWorst(list.candidates as Candidates)
  })
})
