/**
 * Vertices of bilinear faces for one draw call: the four corners in cyclic order and the middle, about which four triangles lie. Those
 * of a bent face meet there, so that it looks the same from both sides. An instance for each face would be less to upload, but software
 * draws instances one by one, and takes several times as long.
 */

/** Vertices of a face. */
export const FACE_VERTICES = 5
/** Indices of its triangles. */
export const FACE_INDICES = 12

const TRIANGLES = [0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4]

/** Three numbers a vertex, of twelve a face. */
export function facePoints(corners: Float32Array): Float32Array {
  const count = corners.length / 12
  const points = new Float32Array(3 * FACE_VERTICES * count)
  for (let from = 0, to = 0; from < corners.length; from += 12, to += 15) {
    for (let i = 0; i < 12; ++i) points[to + i] = corners[from + i] as number
    for (let axis = 0; axis < 3; ++axis) {
      const at = from + axis
      const sum =
        (corners[at] as number) +
        (corners[at + 3] as number) +
        (corners[at + 6] as number) +
        (corners[at + 9] as number)
      points[to + 12 + axis] = sum / 4
    }
  }
  return points
}

/** Three numbers a vertex, of three a face. */
export function eachVertex(values: Float32Array): Float32Array {
  const all = new Float32Array(FACE_VERTICES * values.length)
  for (let from = 0, to = 0; from < values.length; from += 3)
    for (let vertex = 0; vertex < FACE_VERTICES; ++vertex)
      for (let axis = 0; axis < 3; ++axis) all[to++] = values[from + axis] as number
  return all
}

/** Four bytes a vertex, which processors like better than three, of three a face. */
export function vertexColours(colours: Uint8Array): Uint8Array {
  const count = colours.length / 3
  const all = new Uint8Array(4 * FACE_VERTICES * count)
  // Whole colours are copied, whatever the order of bytes in a word.
  const words = new Uint32Array(all.buffer)
  for (let face = 0; face < count; ++face) {
    const first = FACE_VERTICES * face
    for (let channel = 0; channel < 3; ++channel) all[4 * first + channel] = colours[3 * face + channel] as number
    words.fill(words[first] as number, first + 1, first + FACE_VERTICES)
  }
  return all
}

let indices = new Uint32Array(0)

/** The triangles of so many faces; the same memory for all who ask. */
export function faceIndices(count: number): Uint32Array {
  const before = indices.length / FACE_INDICES
  if (before < count) {
    const room = Math.max(count, 2 * before)
    indices = new Uint32Array(FACE_INDICES * room)
    for (let face = 0, at = 0; face < room; ++face)
      for (let i = 0; i < FACE_INDICES; ++i) indices[at++] = FACE_VERTICES * face + (TRIANGLES[i] as number)
  }
  return indices.subarray(0, FACE_INDICES * count)
}
