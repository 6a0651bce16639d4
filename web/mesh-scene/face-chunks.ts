/**
 * A list of faces in the painter's memory, in chunks: vertices as they have come go there chunk by chunk, so that no list holds up the page
 * however long it is, and all chunks share one list of triangles. Buffers are WebGL's own, as three.js loads all of a list when it is drawn.
 */
import { BufferAttribute, BufferGeometry, GLBufferAttribute } from 'three'
import { FACE_VERTICES, VERTEX_NUMBERS } from '../survey/face-list'
import type { FaceList } from '../survey/survey-jobs'
import { FaceBins } from './face-bins'

/** Indices of a face's triangles. */
const FACE_INDICES = 12
const TRIANGLES = [0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4]

/** Vertices that two bytes count: a megabyte of numbers. */
export const CHUNK_FACES = Math.floor(2 ** 16 / FACE_VERTICES)

/** Faces that a frame has the time for: some eight megabytes, ten milliseconds for a slow machine. */
export const FACES_AT_ONCE = 8 * CHUNK_FACES

/** The triangles of so many faces. */
export function faceIndices(count: number): Uint16Array {
  const indices = new Uint16Array(FACE_INDICES * count)
  for (let face = 0, at = 0; face < count; ++face)
    for (const vertex of TRIANGLES) indices[at++] = FACE_VERTICES * face + vertex
  return indices
}

let triangles: BufferAttribute | null = null

/** The same for all chunks of all pictures. */
function sharedTriangles(): BufferAttribute {
  triangles ??= new BufferAttribute(faceIndices(CHUNK_FACES), 1)
  return triangles
}

interface Chunk {
  readonly geometry: BufferGeometry
  readonly first: number
  readonly count: number
  readonly buffers: WebGLBuffer[]
  hidden: WebGLBuffer | null
}

type Context = WebGL2RenderingContext

export class FaceChunks {
  readonly faces: FaceList
  readonly #chunks: Chunk[] = []
  readonly #bins: FaceBins[] = []
  #loaded = 0

  constructor(faces: FaceList) {
    this.faces = faces
  }

  get geometries(): readonly BufferGeometry[] {
    return this.#chunks.map(({ geometry }) => geometry)
  }

  get isLoaded(): boolean {
    return this.#loaded === this.faces.cells.length
  }

  /** Where the faces are. */
  get bins(): readonly FaceBins[] {
    while (this.find());
    return this.#bins
  }

  /** Finds where the faces of the next chunk are. False if it is known of all that are loaded. */
  find(): boolean {
    const chunk = this.#chunks[this.#bins.length]
    if (!chunk) return false
    this.#bins.push(new FaceBins(this.faces, chunk.first, chunk.count))
    return true
  }

  /** Loads the next chunk. */
  load(gl: Context): void {
    const { vertices, middles, cells } = this.faces
    const first = this.#loaded
    const count = Math.min(CHUNK_FACES, cells.length - first)
    const geometry = new BufferGeometry()
    const buffers: WebGLBuffer[] = []
    const put = (name: string, numbers: Float32Array, size: number) => {
      const each = FACE_VERTICES * size
      const buffer = bufferOf(gl, numbers.subarray(each * first, each * (first + count)))
      buffers.push(buffer)
      const attribute = new GLBufferAttribute(buffer, gl.FLOAT, size, 4, FACE_VERTICES * count)
      setAttribute(geometry, name, attribute)
    }
    geometry.setIndex(sharedTriangles())
    geometry.setDrawRange(0, FACE_INDICES * count)
    put('vertex', vertices, VERTEX_NUMBERS)
    if (middles) put('middle', middles, 3)
    this.#chunks.push({ geometry, first, count, buffers, hidden: null })
    this.#loaded += count
    // Of so many faces nobody can wait for it when the picture is pointed at; others come and go, and are seldom pointed at.
    if (cells.length > FACES_AT_ONCE) this.find()
  }

  /** 1 for each vertex of a face that is hidden, or null; all are loaded by now. */
  hide(gl: Context, hidden: Uint8Array | null): void {
    for (const chunk of this.#chunks) {
      const [from, to] = [FACE_VERTICES * chunk.first, FACE_VERTICES * (chunk.first + chunk.count)]
      if (!hidden && !chunk.hidden) continue
      const own = hidden?.subarray(from, to) ?? new Uint8Array(to - from)
      if (chunk.hidden) {
        gl.bindBuffer(gl.ARRAY_BUFFER, chunk.hidden)
        gl.bufferSubData(gl.ARRAY_BUFFER, 0, own)
        continue
      }
      chunk.hidden = bufferOf(gl, own)
      chunk.buffers.push(chunk.hidden)
      const attribute = new GLBufferAttribute(chunk.hidden, gl.UNSIGNED_BYTE, 1, 1, own.length)
      setAttribute(chunk.geometry, 'hidden', attribute)
    }
  }

  dispose(gl: Context): void {
    for (const { geometry, buffers } of this.#chunks) {
      // The triangles are others', too.
      geometry.setIndex(null)
      geometry.dispose()
      for (const buffer of buffers) gl.deleteBuffer(buffer)
    }
    this.#chunks.length = 0
    this.#bins.length = 0
  }
}

/** three.js takes both kinds, which its types do not say. */
function setAttribute(geometry: BufferGeometry, name: string, attribute: GLBufferAttribute): void {
  geometry.setAttribute(name, attribute as unknown as BufferAttribute)
}

function bufferOf(gl: Context, numbers: Float32Array | Uint8Array): WebGLBuffer {
  const buffer = gl.createBuffer()
  if (!buffer) throw new Error('The painter has no more memory.')
  gl.bindBuffer(gl.ARRAY_BUFFER, buffer)
  gl.bufferData(gl.ARRAY_BUFFER, numbers, gl.DYNAMIC_DRAW)
  return buffer
}
