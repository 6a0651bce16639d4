/** Grids that may be hexahedra and nothing else are read as others are, whether it is known beforehand or looked for. */
import { describe, expect, test } from 'vitest'
import { VtkMesh } from '../../web/mesh/formats/vtk-mesh'
import type { KnownIndices } from '../../web/mesh/source'
import { unitCube } from './core-fixtures'

const HEXAHEDRON = 12
const TETRAHEDRON = 10
const POLYGON = 7
const POINTS = 40

interface Grid {
  readonly types: Uint8Array
  readonly ends: Uint32Array
  readonly connectivity: Uint32Array
}

/** Hexahedra of some of 40 points; their types begin at such a place in memory. */
function hexahedra(count: number, from = 0): Grid {
  return {
    types: new Uint8Array(from + count + 3)
      .fill(7)
      .fill(HEXAHEDRON, from, from + count)
      .subarray(from, from + count),
    ends: Uint32Array.from({ length: count }, (_, i) => 8 * (i + 1)),
    connectivity: Uint32Array.from({ length: 8 * count }, (_, i) => (3 * Math.floor(i / 8) + i) % POINTS),
  }
}

/** One cell is a polygon of eight points, so that nothing but its type tells. */
function withPolygon(count: number, from: number, at: number): Grid {
  const grid = hexahedra(count, from)
  grid.types[at] = POLYGON
  return grid
}

/** One cell is a tetrahedron, of four points. */
function withTetrahedron(count: number, from: number, at: number): Grid {
  const { types, ends, connectivity } = hexahedra(count, from)
  types[at] = TETRAHEDRON
  return {
    types,
    ends: ends.map((end, i) => (i < at ? end : end - 4)),
    connectivity: connectivity.filter((_, i) => i < 8 * at || i >= 8 * at + 4),
  }
}

/** As a reader of a large file knows it. */
function knownOf(list: Uint32Array): KnownIndices {
  const steps = new Set(Array.from(list.subarray(1), (own, i) => own - (list[i] as number)))
  return {
    list,
    greatest: list.reduce((a, b) => Math.max(a, b), 0),
    step: steps.size === 1 ? ([...steps][0] as number) : 0,
  }
}

function read({ types, ends, connectivity }: Grid, isKnown: boolean, declaredCells = types.length) {
  const mesh = new VtkMesh('VTU', what => {
    throw new Error(what)
  })
  const own = connectivity.slice()
  const known = { connectivity: knownOf(own), ends: knownOf(ends) }
  mesh.add({
    points: Float64Array.from({ length: 3 * POINTS }, (_, i) => (unitCube[i % 24] as number) + Math.floor(i / 24)),
    declaredPoints: POINTS,
    connectivity: own,
    ...(isKnown ? { known } : {}),
    ends,
    types,
    declaredCells,
    hasFaceStreams: false,
    precision: { isFloat32: false, digits: 0 },
    cellData: null,
  })
  return mesh.mesh()
}

describe.each([
  { way: 'looked for', isKnown: false },
  { way: 'known beforehand', isKnown: true },
])('$way', ({ isKnown }) => {
  const counts = [1, 2, 3, 4, 5, 6, 7, 8, 9, 8191, 8193, 32_769]

  test('hexahedra alone are as they are in the file', () => {
    for (const count of counts)
      for (const from of [0, 1, 2, 3]) {
        const grid = hexahedra(count, from)
        const mesh = read(grid, isKnown)
        expect(
          Buffer.compare(new Uint8Array(mesh.cells.slice().buffer), new Uint8Array(grid.connectivity.buffer)),
        ).toBe(0)
        expect(mesh.notes).toEqual([])
      }
  })

  test('one other cell is found in each of the last places and of the first', () => {
    for (const count of counts)
      for (const at of new Set([0, 1, 2, 3, count - 9, count - 5, count - 4, count - 3, count - 2, count - 1])) {
        if (at < 0 || at >= count) continue
        const { connectivity } = hexahedra(count)
        const expected = connectivity.filter((_, i) => i < 8 * at || i >= 8 * (at + 1))
        for (const other of [withPolygon, withTetrahedron])
          for (const from of [0, 1]) {
            const { cells } = read(other(count, from, at), isKnown)
            expect([count, at, cells.length]).toEqual([count, at, expected.length])
            expect(Buffer.compare(new Uint8Array(cells.slice().buffer), new Uint8Array(expected.buffer))).toBe(0)
          }
      }
  })

  test('one end that is another is refused', () => {
    for (const count of counts)
      for (const at of new Set([0, 1, count - 2, count - 1])) {
        if (at < 0 || at >= count) continue
        const grid = hexahedra(count)
        grid.ends[at] = 8 * (at + 1) - 1
        expect(() => read(grid, isKnown), `end ${at} of ${count}`).toThrow(
          /has 7 points; it must have 8|cells name \d+ points/,
        )
      }
  })

  test('ends in steps of eight that do not begin at eight are refused', () => {
    const grid = hexahedra(5)
    expect(() => read({ ...grid, ends: grid.ends.map(end => end + 8) }, isKnown)).toThrow('has 16 points')
    expect(() => read({ ...grid, ends: grid.ends.map(end => end - 1) }, isKnown)).toThrow('has 7 points')
  })

  test('a point that does not exist is refused wherever it is', () => {
    for (const count of [1, 5, 8193])
      for (const at of [0, 8 * count - 1]) {
        const grid = hexahedra(count)
        grid.connectivity[at] = POINTS
        expect(() => read(grid, isKnown)).toThrow(`cell ${Math.floor(at / 8)} names point ${POINTS}`)
      }
  })

  test('cells that are missing are told of', () => {
    const mesh = read(hexahedra(6), isKnown, 7)
    expect(mesh.cells.length).toBe(48)
    expect(mesh.notes.join()).not.toBe('')
  })

  test('no cells are no hexahedra', () => {
    expect(read(hexahedra(0), isKnown).cells.length).toBe(0)
  })
})
