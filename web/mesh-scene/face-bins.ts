/** Some faces of a list in the bins of a grid, by their middles. Each bin has a box around its faces, so that a ray looks at few of them. */
import type { Ray } from '../scene/space/camera'
import { FACE_VERTICES, VERTEX_NUMBERS } from '../survey/face-list'
import type { FaceList } from '../survey/survey-jobs'

/** So many bins along an axis that those on a surface have some tens of the faces of a chunk. */
const BITS = 4
const SIDE = 1 << BITS
const CORNERS = 4
/** Numbers of a box: three least ones, three greatest ones. */
const BOX = 6

export class FaceBins {
  /** Faces of the list, bin after bin. */
  readonly #faces: Uint32Array
  /** Where each bin ends among them; none is empty. */
  readonly #ends: Uint32Array
  readonly #boxes: Float32Array
  /** The box around all of them. */
  readonly #box = new Float32Array(BOX)

  constructor(list: FaceList, first: number, count: number) {
    const bins = binsOf(list.vertices, first, count)
    const sizes = new Uint32Array(SIDE ** 3)
    for (let i = 0; i < count; ++i) {
      const bin = bins[i] as number
      sizes[bin] = (sizes[bin] as number) + 1
    }
    // The place of each bin's next face.
    const next = sizes
    const ends = new Uint32Array(sizes.length)
    let [end, found] = [0, 0]
    for (let bin = 0; bin < sizes.length; ++bin) {
      const size = sizes[bin] as number
      next[bin] = end
      end += size
      if (size > 0) ends[found++] = end
    }
    const faces = new Uint32Array(count)
    for (let i = 0; i < count; ++i) {
      const bin = bins[i] as number
      const at = next[bin] as number
      faces[at] = first + i
      next[bin] = at + 1
    }
    this.#faces = faces
    this.#ends = ends.slice(0, found)
    this.#boxes = new Float32Array(BOX * this.#ends.length)
    for (let axis = 0; axis < 3; ++axis) this.#bound(list, axis)
  }

  /** With the middles of the faces' cells, if these are drawn whole: they shrink towards them. */
  #bound({ vertices, middles }: FaceList, axis: number): void {
    const [faces, ends, boxes] = [this.#faces, this.#ends, this.#boxes]
    let [leastOfAll, greatestOfAll] = [Infinity, -Infinity]
    for (let bin = 0, i = 0; bin < ends.length; ++bin) {
      let [least, greatest] = [Infinity, -Infinity]
      for (const end = ends[bin] as number; i < end; ++i) {
        const face = faces[i] as number
        const at = FACE_VERTICES * VERTEX_NUMBERS * face + axis
        const a = vertices[at] as number
        const b = vertices[at + VERTEX_NUMBERS] as number
        const c = vertices[at + 2 * VERTEX_NUMBERS] as number
        const d = vertices[at + 3 * VERTEX_NUMBERS] as number
        const e = middles === null ? a : (middles[3 * FACE_VERTICES * face + axis] as number)
        least = Math.min(least, a, b, c, d, e)
        greatest = Math.max(greatest, a, b, c, d, e)
      }
      boxes[BOX * bin + axis] = least
      boxes[BOX * bin + axis + 3] = greatest
      leastOfAll = Math.min(leastOfAll, least)
      greatestOfAll = Math.max(greatestOfAll, greatest)
    }
    this.#box[axis] = leastOfAll
    this.#box[axis + 3] = greatestOfAll
  }

  /** Looks at each face that the ray may hit before it has gone so far, and at some others. A look returns how far it goes from then on. */
  meet(ray: Ray, most: number, look: (face: number) => number): void {
    let nearest = most
    if (!isMet(this.#box, 0, ray, nearest)) return
    for (let bin = 0, i = 0; bin < this.#ends.length; ++bin) {
      const end = this.#ends[bin] as number
      if (isMet(this.#boxes, BOX * bin, ray, nearest)) for (; i < end; ++i) nearest = look(this.#faces[i] as number)
      i = end
    }
  }
}

/** Of each face the bin of its middle, in a grid about all middles. */
function binsOf(vertices: Float32Array, first: number, count: number): Uint16Array {
  const bins = new Uint16Array(count)
  const step = FACE_VERTICES * VERTEX_NUMBERS
  for (let axis = 0; axis < 3; ++axis) {
    const from = step * first + CORNERS * VERTEX_NUMBERS + axis
    let [least, greatest] = [Infinity, -Infinity]
    for (let i = 0, at = from; i < count; ++i, at += step) {
      const value = vertices[at] as number
      if (value < least) least = value
      if (value > greatest) greatest = value
    }
    // NaN, where all are in one plane, is the first bin.
    const scale = SIDE / (greatest - least)
    for (let i = 0, at = from; i < count; ++i, at += step) {
      const bin = (((vertices[at] as number) - least) * scale) | 0
      bins[i] = ((bins[i] as number) << BITS) | Math.min(bin, SIDE - 1)
    }
  }
  return bins
}

/**
 * Where a ray enters or leaves a slab is a difference and a quotient, off by less than 2.01 u of itself, u = 2^-53: one beside the other is
 * off by less than 2^-50.
 */
const SLACK = 1 + 2 ** -50

/** Whether a ray is in the box before it has gone so far. */
function isMet(boxes: Float32Array, box: number, { origin, direction }: Ray, most: number): boolean {
  let [enters, leaves] = [0, most]
  for (let axis = 0; axis < 3; ++axis) {
    const from = origin[axis as 0]
    const along = direction[axis as 0]
    const lower = (boxes[box + axis] as number) - from
    const upper = (boxes[box + axis + 3] as number) - from
    if (along === 0) {
      if (lower > 0 || upper < 0) return false
      continue
    }
    const near = (along > 0 ? lower : upper) / along
    const far = (along > 0 ? upper : lower) / along
    if (near > enters) enters = near
    if (far < leaves) leaves = far
  }
  return enters <= leaves * SLACK
}
