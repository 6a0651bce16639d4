import { describe, expect, test } from 'vitest'
import { faceLoops } from '../../web/mesh/face-loops'
import { Joining, type Neighbours, neighboursOf } from '../../web/mesh/neighbours'
import { randomSource } from './random'

/** A block of nx by ny by nz cells. */
function blockOf(nx: number, ny: number, nz: number): { readonly cells: Uint32Array; readonly points: number } {
  const id = (i: number, j: number, k: number) => i + (nx + 1) * (j + (ny + 1) * k)
  const cells: number[] = []
  for (let k = 0; k < nz; ++k)
    for (let j = 0; j < ny; ++j)
      for (let i = 0; i < nx; ++i)
        for (const z of [k, k + 1]) cells.push(id(i, j, z), id(i + 1, j, z), id(i + 1, j + 1, z), id(i, j + 1, z))
  return { cells: Uint32Array.from(cells), points: (nx + 1) * (ny + 1) * (nz + 1) }
}

/** Pairs by the definition: every face with every other. */
function pairsByDefinition(cells: Uint32Array): Map<string, number[]> {
  const found = new Map<string, number[]>()
  for (let cell = 0; cell < cells.length / 8; ++cell)
    for (const [face, loop] of faceLoops.entries()) {
      const points = loop.map(vertex => cells[8 * cell + vertex] as number)
      const turns = [points, points.toReversed()].flatMap(way =>
        way.map((_, i) => [...way.slice(i), ...way.slice(0, i)].join()),
      )
      const name = turns.sort()[0] as string
      found.set(name, [...(found.get(name) ?? []), 6 * cell + face])
    }
  return found
}

function expectDefinition(cells: Uint32Array, points: number): void {
  const { across, boundary } = neighboursOf(cells, points)
  const alone: number[] = []
  for (const group of pairsByDefinition(cells).values()) {
    const partners = group.filter(face => across[face] !== -1)
    for (const face of partners) {
      expect(group).toContain(across[face])
      expect(across[across[face] as number]).toBe(face)
    }
    expect(partners.length).toBe(group.length - (group.length % 2))
    alone.push(...group.filter(face => across[face] === -1))
  }
  expect([...boundary]).toEqual(alone.sort((a, b) => a - b))
}

test('a block has its outer faces as the boundary, and each inner face on both sides', () => {
  const { cells, points } = blockOf(4, 3, 2)
  const { across, boundary } = neighboursOf(cells, points)
  expect(boundary.length).toBe(2 * (4 * 3 + 3 * 2 + 2 * 4))
  // The first cell has the next one behind its +xi face.
  expect(across[1]).toBe(6)
  expectDefinition(cells, points)
})

test('whatever the order of points, cells and vertices', () => {
  const next = randomSource(1)
  const { cells, points } = blockOf(5, 4, 3)
  const names = Array.from({ length: points }, (_, i) => i).sort(() => next() - 0.5)
  const turned = [0, 1, 2, 3, 4, 5, 6, 7]
  for (let round = 0; round < 20; ++round) {
    const shuffled = cells.map(point => names[point] as number)
    for (let cell = 0; cell < cells.length / 8; ++cell) {
      // A quarter of a turn about zeta, so many times.
      const by = Math.floor(4 * next())
      const own = turned.map(v => shuffled[8 * cell + ((v + by) & 3) + (v & 4)] as number)
      shuffled.set(own, 8 * cell)
    }
    expectDefinition(shuffled, points)
  }
})

test('collapsed faces and repeated points follow the definition', () => {
  const next = randomSource(2)
  for (let round = 0; round < 200; ++round) {
    const cells = Uint32Array.from({ length: 8 * 4 }, () => Math.floor(6 * next()))
    expectDefinition(cells, 6)
  }
})

test('the same four points in another cyclic order are another face', () => {
  const cube = [0, 1, 2, 3, 4, 5, 6, 7]
  const above = [4, 5, 6, 7, 8, 9, 10, 11]
  const crossed = [4, 5, 7, 6, 8, 9, 10, 11]
  expect(neighboursOf(Uint32Array.from([...cube, ...above]), 12).boundary.length).toBe(10)
  expect(neighboursOf(Uint32Array.from([...cube, ...crossed]), 12).boundary.length).toBe(12)
})

test('of a face in three cells two are a pair', () => {
  const cells = Uint32Array.from([0, 1, 2, 3, 4, 5, 6, 7, 4, 5, 6, 7, 8, 9, 10, 11, 4, 5, 6, 7, 12, 13, 14, 15])
  const { across } = neighboursOf(cells, 16)
  expect([across[5], across[6 + 4], across[12 + 4]]).toEqual([10, 5, -1])
})

test('no cells have no faces', () => {
  expect(neighboursOf(new Uint32Array(0), 0).boundary.length).toBe(0)
})

describe('a mesh in no order', () => {
  const { cells, points } = oddBlock(40)
  const mixed = shuffledBlock(cells, points)

  test('has the pairs that go by the order of its faces, as one in order has', () => {
    for (const order of [cells, mixed]) expectSame(neighboursOf(order, points), neighboursOneByOne(order))
  })

  test('goes on in steps, and tells how far it is', () => {
    const joining = new Joining(mixed, points)
    const parts = [joining.run(0)]
    while (!joining.neighbours) parts.push(joining.run(0))
    // Counted, placed, joined and looked through: in order there are two steps for a thousand cells.
    expect(parts.length).toBeGreaterThan(3 * 64)
    expect(parts).toEqual(parts.toSorted((a, b) => a - b))
    expect([parts.at(-1), joining.run(0)]).toEqual([1, 1])
    expectSame(joining.neighbours, neighboursOf(mixed, points))
  })
})

/** A block in which some cells are there twice, and some have collapsed. */
function oddBlock(n: number): { readonly cells: Uint32Array; readonly points: number } {
  const { cells, points } = blockOf(n, n, n)
  for (let cell = 50; cell < cells.length / 8; cell += 50) cells.copyWithin(8 * cell, 8 * cell - 8, 8 * cell)
  for (let cell = 0; cell < cells.length / 8; cell += 70) cells.copyWithin(8 * cell + 1, 8 * cell, 8 * cell + 2)
  return { cells, points }
}

function shuffledBlock(cells: Uint32Array, points: number): Uint32Array {
  const next = randomSource(3)
  const names = shuffled(points, next)
  const places = shuffled(cells.length / 8, next)
  return Uint32Array.from(cells, (_, i) => names[cells[8 * (places[i >> 3] as number) + (i & 7)] as number] as number)
}

function shuffled(count: number, next: () => number): number[] {
  const list = Array.from({ length: count }, (_, i) => i)
  for (let i = count - 1; i > 0; --i) {
    const other = Math.floor((i + 1) * next())
    ;[list[i], list[other]] = [list[other] as number, list[i] as number]
  }
  return list
}

/** Each face, in order, with the one of the same points that waits. */
function neighboursOneByOne(cells: Uint32Array): Neighbours {
  const across = new Int32Array((6 * cells.length) / 8).fill(-1)
  const waiting = new Map<string, number>()
  for (let face = 0; face < across.length; ++face) {
    const [a, b, c, d] = (faceLoops[face % 6] ?? []).map(v => cells[8 * Math.floor(face / 6) + v]) as number[]
    const diagonals = [
      [a, c],
      [b, d],
    ].map(pair => pair.sort().join())
    const name = diagonals.sort().join(';')
    const other = waiting.get(name)
    if (other === undefined) waiting.set(name, face)
    else {
      waiting.delete(name)
      across[face] = other
      across[other] = face
    }
  }
  return { across, boundary: Uint32Array.from(waiting.values()).sort() }
}

function expectSame(one: Neighbours | null, other: Neighbours): void {
  expect([one?.across.length, one?.boundary.length]).toEqual([other.across.length, other.boundary.length])
  expect(one?.across.findIndex((face, i) => face !== other.across[i])).toBe(-1)
  expect(one?.boundary.findIndex((face, i) => face !== other.boundary[i])).toBe(-1)
}
