/** Faces in chunks, as the painter loads them, with a context that counts. */
import { expect, test } from 'vitest'
import { CHUNK_FACES, FaceChunks, faceIndices } from '../../web/mesh-scene/face-chunks'
import { LoadedFaces, NO_CONTENT } from '../../web/mesh-scene/loaded-faces'
import type { FaceList } from '../../web/survey/survey-jobs'

/** Keeps each buffer's bytes, as WebGL does. */
function countingContext() {
  const buffers = new Map<object, Uint8Array>()
  let bound: object | null = null
  const bytesOf = (view: ArrayBufferView) => new Uint8Array(view.buffer, view.byteOffset, view.byteLength).slice()
  const gl = {
    createBuffer() {
      const buffer = {}
      buffers.set(buffer, new Uint8Array(0))
      return buffer
    },
    bindBuffer: (_: number, buffer: object) => {
      bound = buffer
    },
    bufferData: (_: number, view: ArrayBufferView) => buffers.set(bound as object, bytesOf(view)),
    bufferSubData: (_: number, offset: number, view: ArrayBufferView) =>
      buffers.get(bound as object)?.set(bytesOf(view), offset),
    deleteBuffer: (buffer: object) => buffers.delete(buffer),
  }
  return { gl: gl as unknown as WebGL2RenderingContext, buffers }
}

function listOf(count: number): FaceList {
  const vertices = Float32Array.from({ length: 20 * count }, (_, i) => i)
  const cells = Uint32Array.from({ length: count }, (_, i) => i)
  return { vertices, middles: null, cells, origin: [0, 0, 0], shown: count, wanted: count }
}

test('triangles go round the middle of each face, and two bytes count their vertices', () => {
  const two = [...faceIndices(2)]
  expect(two.slice(0, 12)).toEqual([0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4])
  expect(two.slice(12)).toEqual(two.slice(0, 12).map(index => index + 5))
  expect(faceIndices(CHUNK_FACES).reduce((a, b) => Math.max(a, b), 0)).toBe(5 * CHUNK_FACES - 1)
  // The greatest index of two bytes begins another triangle in WebGL.
  expect(5 * CHUNK_FACES - 1).toBeLessThan(2 ** 16 - 1)
})

test('a list is loaded chunk by chunk, and all of it is given back', () => {
  const { gl, buffers } = countingContext()
  const faces = listOf(2 * CHUNK_FACES + 7)
  const chunks = new FaceChunks(faces)
  const steps: number[] = []
  while (!chunks.isLoaded) {
    chunks.load(gl)
    steps.push(chunks.geometries.length)
  }
  expect(steps).toEqual([1, 2, 3])
  expect(chunks.geometries.map(({ drawRange }) => drawRange.count)).toEqual(
    [CHUNK_FACES, CHUNK_FACES, 7].map(n => 12 * n),
  )
  const loaded = [...buffers.values()].map(bytes => new Float32Array(bytes.buffer))
  expect(loaded.map(({ length }) => length)).toEqual([CHUNK_FACES, CHUNK_FACES, 7].map(n => 20 * n))
  expect(loaded[2]?.[0]).toBe(faces.vertices[20 * 2 * CHUNK_FACES])

  const hidden = new Uint8Array(5 * faces.cells.length).fill(1, 5 * CHUNK_FACES, 5 * CHUNK_FACES + 5)
  chunks.hide(gl, hidden)
  const flags = () => [...buffers.values()].slice(3).map(bytes => bytes.reduce((sum, flag) => sum + flag, 0))
  expect(flags()).toEqual([0, 5, 0])
  chunks.hide(gl, null)
  expect(flags()).toEqual([0, 0, 0])
  chunks.dispose(gl)
  expect(buffers.size).toBe(0)
})

test('what was drawn stays until all of the next is loaded; a list that is the same is not loaded again', () => {
  const { gl, buffers } = countingContext()
  const faces = new LoadedFaces()
  const [boundary, small, large] = [listOf(10), listOf(1), listOf(9 * CHUNK_FACES)]
  faces.put({ ...NO_CONTENT, boundary, surface: small }, gl)
  expect(faces.load(gl)).toBe(true)
  expect(buffers.size).toBe(2)
  const kept = faces.lists.boundary
  faces.put({ ...NO_CONTENT, boundary, surface: large, opacity: 0.5 }, gl)
  expect(faces.load(gl)).toBe(false)
  expect([faces.content.opacity, faces.lists.surface?.faces, faces.isLoading]).toEqual([1, small, true])
  // Another content takes what is loaded already with it.
  faces.put({ ...NO_CONTENT, boundary, surface: large, opacity: 0.7 }, gl)
  expect(faces.load(gl)).toBe(true)
  expect([faces.content.opacity, faces.lists.surface?.faces, faces.isLoading]).toEqual([0.7, large, false])
  expect(faces.lists.boundary).toBe(kept)
  expect(buffers.size).toBe(1 + 9)

  faces.renew(gl)
  while (faces.isLoading) faces.load(gl)
  expect([faces.lists.surface?.faces, buffers.size]).toEqual([large, 10])
  faces.clear(gl)
  expect(buffers.size).toBe(0)
})
