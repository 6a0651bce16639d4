import { expect, test } from 'vitest'
import { faceLoops, neighboursOf } from '../../web/mesh/neighbours'
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
