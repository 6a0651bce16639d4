/** Faces as vertices and triangles for one draw call. */
import { expect, test } from 'vitest'
import { eachVertex, faceIndices, facePoints, vertexColours } from '../../web/mesh-scene/face-vertices'

const SQUARE = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0]
const BENT = [0, 0, 1, 2, 0, 0, 2, 2, 1, 0, 2, 0]

test('a face has its corners, and the middle of its bilinear surface', () => {
  const points = facePoints(Float32Array.from([...SQUARE, ...BENT]))
  expect([...points]).toEqual([...SQUARE, 0.5, 0.5, 0, ...BENT, 1, 1, 0.5])
})

test('what a face has, its five vertices have', () => {
  expect([...eachVertex(Float32Array.of(1, 2, 3, 4, 5, 6))]).toEqual(
    [1, 2, 3, 4, 5, 6].flatMap((_, i, all) =>
      i % 3 === 0
        ? Array(5)
            .fill(all.slice(i, i + 3))
            .flat()
        : [],
    ),
  )
  const colours = vertexColours(Uint8Array.of(1, 2, 3, 250, 251, 252))
  expect(colours.length).toBe(2 * 5 * 4)
  for (let vertex = 0; vertex < 10; ++vertex)
    expect([...colours.subarray(4 * vertex, 4 * vertex + 3)]).toEqual(vertex < 5 ? [1, 2, 3] : [250, 251, 252])
})

test('triangles go round the middle, and are those of fewer faces at first', () => {
  const few = [...faceIndices(2)]
  expect(few.slice(0, 12)).toEqual([0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4])
  expect(few.slice(12)).toEqual(few.slice(0, 12).map(index => index + 5))
  expect(faceIndices(1000).length).toBe(12_000)
  expect([...faceIndices(2)]).toEqual(few)
  expect(faceIndices(1000).at(-1)).toBe(5 * 999 + 4)
})
