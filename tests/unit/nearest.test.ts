import { describe, expect, it } from 'vitest'
import type { Vertices } from '../../web/model/hexahedron'
import { presets, presetVertices } from '../../web/model/presets'
import { elementAt } from '../../web/model/way'
import { leastVector } from '../../web/panels/nearest/search/least-distance'
import {
  type Nearest,
  type NearestAnswer,
  type NearestMove,
  searchNearest,
} from '../../web/panels/nearest/search/nearest'
import { caseVertices, core, entry, randomHexahedron, randomSource, unitCube } from './core-fixtures'

function nearestOf(vertices: Vertices, share = 0): Nearest {
  const search = searchNearest(core, vertices, share)
  for (;;) {
    const { done, value } = search.next()
    if (done) return value
  }
}

function isValid(vertices: Vertices): boolean {
  const result = core.isValid(vertices)
  if (!result.ok) throw new Error(result.error.message)
  return result.value
}

function preset(id: string): Vertices {
  return presetVertices(
    entry(
      presets,
      presets.findIndex(candidate => candidate.id === id),
    ),
  )
}

function moveOf(answer: NearestAnswer | undefined): NearestMove {
  if (answer === null || answer === undefined || answer === 'impossible') throw new Error('No move was found.')
  return answer
}

function movesOf({ ofVertex, ofAll }: Nearest): NearestMove[] {
  return [...ofVertex, ofAll ?? null].filter(answer => answer !== null && answer !== 'impossible')
}

const mirrored = unitCube.map((x, i) => (i % 3 === 0 ? -x : x))
const pushed = unitCube.with(0, 0.5).with(1, 0.5).with(2, 0.5)

describe('the nearest element of the other verdict', () => {
  it('of the unit cube is where arithmetic says', () => {
    // jacdet at vertex 0 is 1 - x - y - z of its position: the plane is 1/sqrt(3) away. With all of
    // them moved it is a half: there G^T G = I + (1,1,1)(1,1,1)^T, whose greatest eigenvalue is 4.
    const { isMet, ofVertex, ofOne, ofAll } = nearestOf(unitCube)
    expect(isMet).toBe(true)
    for (const answer of ofVertex) {
      expect(moveOf(answer).length).toBeCloseTo(1 / Math.sqrt(3), 12)
      expect(moveOf(answer).claim).toBe('least')
    }
    expect(ofVertex).toContain(ofOne)
    for (const x of moveOf(ofVertex[0]).vertices.slice(0, 3)) expect(x).toBeCloseTo(1 / 3, 12)
    expect(moveOf(ofVertex[0]).vertices.slice(3)).toEqual(unitCube.slice(3))
    expect(moveOf(ofAll).length).toBeCloseTo(1 / 2, 12)
    expect(moveOf(ofAll).longest).toBeCloseTo(Math.sqrt(3) / 4, 12)
    expect(moveOf(ofAll).claim).toBe('least')
  })

  it('of a cube with a vertex pushed through is behind the same plane', () => {
    const { isMet, ofVertex, ofAll } = nearestOf(pushed)
    expect(isMet).toBe(false)
    expect(moveOf(ofVertex[0]).length).toBeCloseTo(1 / 2 / Math.sqrt(3), 6)
    expect(moveOf(ofVertex[0]).claim).toBe('least')
    expect(ofVertex[6]).toBe('impossible') // jacdet at vertex 0 does not know where vertex 6 is
    expect(moveOf(ofAll).length).toBeLessThan(moveOf(ofVertex[0]).length)
  })

  it('has the other verdict, and one double before the element’s own; what is shorter than the bound has it too', () => {
    const random = randomSource(20260714)
    let tried = 0
    for (const sigma of [0.2, 0.3, 0.4]) {
      const vertices = randomHexahedron(random, sigma)
      const nearest = nearestOf(vertices)
      for (const { vertex, vertices: found, before, length, bound, claim } of movesOf(nearest)) {
        expect([isValid(found), isValid(before)]).toEqual([!nearest.isMet, nearest.isMet])
        const moved = found.filter((x, i) => vertex !== null && Math.floor(i / 3) !== vertex && x !== vertices[i])
        expect(moved).toEqual([])
        expect(bound).toBeLessThanOrEqual(length)
        expect(length * (1 - 2 ** -20) <= bound).toBe(claim === 'least')
        if (nearest.isMet) expect(claim).toBe('least')
        if (claim === 'least') expect(isValid(elementAt(vertices, found, 0.5))).toBe(nearest.isMet)
        for (let n = 0; n < 50; n++) {
          const way = vertices.map((_, i) => (vertex === null || Math.floor(i / 3) === vertex ? 2 * random() - 1 : 0))
          const factor = (0.999 * bound) / Math.hypot(...way)
          expect(isValid(vertices.map((x, i) => x + factor * entry(way, i)))).toBe(nearest.isMet)
          tried++
        }
      }
    }
    expect(tried).toBeGreaterThan(1000)
  })

  it('is no farther than what a search about it comes upon', () => {
    const random = randomSource(20260715)
    for (const id of ['edge-negative', 'cube', 'looks-fine']) {
      const vertices = preset(id)
      const nearest = nearestOf(vertices)
      for (const { vertex, vertices: found, length } of movesOf(nearest)) {
        for (let n = 0; n < 80; n++) {
          const noise = length * random() ** 3
          const way = vertices.map((x, i) =>
            vertex === null || Math.floor(i / 3) === vertex ? entry(found, i) - x + noise * (2 * random() - 1) : 0,
          )
          const factor = (0.9999 * length) / Math.hypot(...way)
          expect(isValid(vertices.map((x, i) => x + factor * entry(way, i)))).toBe(nearest.isMet)
        }
      }
    }
  })

  it('scales with the element, moves with it, and is the same again', () => {
    for (const id of ['looks-fine', 'cube']) {
      const vertices = preset(id)
      const nearest = nearestOf(vertices)
      expect(nearestOf(vertices)).toEqual(nearest)
      for (const factor of [2 ** 40, 2 ** -300]) {
        const scaled = nearestOf(vertices.map(x => x * factor))
        expect(movesOf(scaled).map(({ vertices: found }) => found.map(x => x / factor))).toEqual(
          movesOf(nearest).map(({ vertices: found }) => found),
        )
        expect(movesOf(scaled).map(({ length }) => length / factor)).toEqual(
          movesOf(nearest).map(({ length }) => length),
        )
      }
      const moved = movesOf(nearestOf(vertices.map(x => x + 8)))
      for (const [i, { length }] of movesOf(nearest).entries()) expect(entry(moved, i).length).toBeCloseTo(length, 6)
    }
  })

  it('is out of reach for one vertex of a mirrored cube, and there for all of them', () => {
    const { ofVertex, ofOne, ofAll } = nearestOf(mirrored)
    expect(new Set(ofVertex)).toEqual(new Set(['impossible']))
    expect(ofOne).toBeNull()
    expect(isValid(moveOf(ofAll).vertices)).toBe(true)
    // At the centre G^T G is half the identity and DF has singular values 1: no move shorter than sqrt(2) makes it singular.
    expect(moveOf(ofAll).length).toBeCloseTo(Math.SQRT2, 6)
    expect(moveOf(ofAll).claim).toBe('least')
  })

  it('is no local optimum where the grid of doubles has a say in it', () => {
    // With a grid of 1/8 vertex 0 may go to (3/8, 3/8, 1/4), which is nearer than (3/8, 3/8, 3/8) and on the plane.
    const far = nearestOf(unitCube.map(x => x + 1e15))
    expect(isValid(far.vertices.map((x, i) => x + ([0.375, 0.375, 0.25][i] ?? 0)))).toBe(false)
    // A flat one is valid after any move upwards, so none is the shortest.
    const flat = nearestOf(unitCube.map((x, i) => (i % 3 === 2 ? 0 : x)))
    for (const nearest of [far, flat])
      expect(new Set(movesOf(nearest).map(({ claim }) => claim))).toEqual(new Set(['found']))
  })

  it('of all eight is never longer than of one vertex', () => {
    let vertices = preset('looks-fine')
    for (let n = 0; n < 4; n++) {
      const { ofOne, ofAll } = nearestOf(vertices)
      expect(moveOf(ofAll).length).toBeLessThanOrEqual(moveOf(ofOne).length)
      vertices = moveOf(n % 2 === 0 ? ofOne : ofAll).vertices
    }
    const { ofOne, ofAll } = nearestOf(caseVertices('pub/mixed/some_1e300_0'))
    expect(moveOf(ofAll).length).toBeLessThanOrEqual(moveOf(ofOne).length)
  })

  it('of an element that touches zero is the next double', () => {
    const { ofOne, ofAll } = nearestOf(preset('touching'))
    expect(moveOf(ofOne).length).toBeLessThan(2 ** -50)
    expect(moveOf(ofAll).length).toBeLessThan(2 ** -50)
  })

  it.each([
    'pub/touch_face/0_zero',
    'pub/degenerate/line',
    'pub/degenerate/wedge2',
    'pub/scale/1e+150_0',
    'pub/denormal/1e-310_0',
  ])('of %s is one, too', name => {
    const vertices = caseVertices(name)
    const nearest = nearestOf(vertices)
    const moves = movesOf(nearest)
    expect(moves).not.toEqual([])
    for (const { vertices: found, before, length, bound } of moves) {
      expect([isValid(found), isValid(before)]).toEqual([!nearest.isMet, nearest.isMet])
      expect(length).toBeGreaterThan(0)
      expect(bound).toBeLessThanOrEqual(length)
    }
  })

  it('is not looked for where there is no size, nor beyond the doubles', () => {
    const point = nearestOf(Array(24).fill(3))
    expect([point.isMet, point.ofOne, point.ofAll]).toEqual([false, null, null])
    const huge = nearestOf(unitCube.map(x => (2 * x - 1) * Number.MAX_VALUE))
    for (const { vertices, before } of movesOf(huge))
      expect([isValid(vertices), isValid(before)]).toEqual([false, true])
    for (const element of [mirrored, pushed]) {
      const { ofVertex, ofAll } = nearestOf(element.map(x => x * 2 ** 1023 - 2 ** 1022))
      expect([ofVertex.length, ofAll === undefined]).toEqual([8, false])
    }
  })

  it('says what it knows at every pause, and pauses often', () => {
    const search = searchNearest(core, preset('looks-fine'))
    const known: Nearest[] = []
    for (let step = search.next(); !step.done; step = search.next()) known.push(step.value)
    expect(known.length).toBeGreaterThan(50)
    const counts = known.map(({ ofVertex }) => ofVertex.length)
    expect(counts).toEqual(counts.toSorted((a, b) => a - b))
    expect(new Set(counts)).toEqual(new Set([1, 2, 3, 4, 5, 6, 7, 8]))
  })
})

describe('the nearest element with a relative minimum that is asked for', () => {
  const shareOf = (vertices: Vertices) => {
    const result = core.analyze(vertices)
    return result.ok && result.value.valid ? (result.value.relativeMinimum as number) : Number.NEGATIVE_INFINITY
  }

  it('is where arithmetic says, from an invalid element and from a valid one', () => {
    // With vertex 0 of the cube at (x, x, x) jacdet is 1 - 3 x there, its least, and the volume is
    // 1 - 3/4 x. So x is to be (1 - share) / (3 (1 - share/4)).
    for (const share of [0.125, 0.5, 0.875])
      for (const x of [0.5, 0.32]) {
        const { isMet, ofVertex, ofAll } = nearestOf([x, x, x, ...unitCube.slice(3)], share)
        expect(isMet).toBe(false)
        const move = moveOf(ofVertex[0])
        const wanted = (1 - share) / (3 * (1 - share / 4))
        expect(move.length).toBeCloseTo((x - wanted) * Math.sqrt(3), 6)
        expect(move.claim).toBe('least')
        expect(moveOf(ofAll).length).toBeLessThanOrEqual(move.length)
        for (const found of [move, moveOf(ofAll)]) {
          expect(shareOf(found.vertices)).toBeGreaterThanOrEqual(share)
          expect(shareOf(found.vertices)).toBeCloseTo(share, 6)
          expect(shareOf(found.before)).toBeLessThan(share + 2 ** -40)
        }
      }
  })

  it('has it, and what is shorter than the bound has not', () => {
    const random = randomSource(20260720)
    let tried = 0
    for (const [sigma, share] of [
      [0.15, 0.7],
      [0.3, 0.1],
    ] as const) {
      const vertices = randomHexahedron(random, sigma)
      const nearest = nearestOf(vertices, share)
      expect(nearest.isMet).toBe(false)
      for (const { vertex, vertices: found, length, bound } of movesOf(nearest)) {
        expect(shareOf(found)).toBeGreaterThanOrEqual(share)
        expect(bound).toBeLessThanOrEqual(length)
        for (let n = 0; n < 50; n++) {
          const way = vertices.map((_, i) => (vertex === null || Math.floor(i / 3) === vertex ? 2 * random() - 1 : 0))
          const factor = (0.999 * bound) / Math.hypot(...way)
          expect(shareOf(vertices.map((x, i) => x + factor * entry(way, i)))).toBeLessThan(share)
          tried++
        }
      }
    }
    expect(tried).toBeGreaterThan(50)
  })

  it('is an invalid one where it is there already', () => {
    expect(nearestOf(unitCube, 0.5).isMet).toBe(true)
    expect(nearestOf(unitCube, 0.5).ofVertex).toEqual(nearestOf(unitCube).ofVertex)
  })

  it('scales with the element', () => {
    const [one, other] = [1, 2 ** 40].map(factor =>
      movesOf(
        nearestOf(
          pushed.map(x => x * factor),
          0.5,
        ),
      ),
    )
    expect(other?.map(({ length }) => length / 2 ** 40)).toEqual(one?.map(({ length }) => length))
  })
})

describe('the shortest vector in half-spaces', () => {
  it('is their nearest point, and none where they have none in common', () => {
    const rows = [
      [1, 0],
      [0, 1],
      [Math.SQRT1_2, Math.SQRT1_2],
    ]
    const { vector, multipliers } = leastVector({ dimension: 2, rows, sides: [1, 2, 0.5] })
    expect(vector?.map(x => x.toFixed(12))).toEqual(['1.000000000000', '2.000000000000'])
    expect(multipliers[2]).toBe(0)
    expect(leastVector({ dimension: 2, rows, sides: [-1, -2, 0] }).vector).toEqual([0, 0])
    const apart = {
      dimension: 2,
      rows: [
        [1, 0],
        [-1, 0],
      ],
      sides: [1, -0.5],
    }
    expect(leastVector(apart).vector).toBeNull()
  })
})
