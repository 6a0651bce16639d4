/** Faces in groups by their least points, each joined within a processor's second cache: for meshes in no order. */
import { FACES, LOOPS } from './face-loops'
import { leastOf, lesserOf, oppositeOf } from './face-points'

/** A group's lists of 2048 points, with some 12,000 faces. */
const BITS = 11
const POINTS = 1 << BITS
const CORNERS = 4

// A record as in waiting-faces.ts, with the number of its list.
const LENGTH = 8
const FACE = 3
const NEXT = 4
const LIST = 5
const NOTHING = 0

export class FaceGroups {
  readonly count: number
  /** Faces that have found their other side. */
  paired = 0
  readonly #cells: Int32Array
  /** Where each group ends in the list; before, the place of its next face; at first, its size. */
  readonly #ends: Uint32Array
  readonly #list: Int32Array
  readonly #heads = new Int32Array(POINTS)
  #records = new Int32Array(0)

  constructor(cells: Int32Array, pointCount: number) {
    this.#cells = cells
    this.count = (pointCount >>> BITS) + 1
    this.#ends = new Uint32Array(this.count)
    this.#list = new Int32Array((FACES * cells.length) / 8)
  }

  /** All cells are counted, then places are made, then all are placed, in order. */
  countCells(from: number, to: number): void {
    const ends = this.#ends
    const cells = this.#cells
    for (let cell = from; cell < to; ++cell)
      for (let face = 0; face < FACES; ++face) {
        const group = leastPoint(cells, 8 * cell, face) >>> BITS
        ends[group] = (ends[group] as number) + 1
      }
  }

  makePlaces(): void {
    let sum = 0
    for (const [group, size] of this.#ends.entries()) {
      this.#ends[group] = sum
      sum += size
    }
  }

  placeCells(from: number, to: number): void {
    const ends = this.#ends
    const list = this.#list
    const cells = this.#cells
    for (let cell = from; cell < to; ++cell)
      for (let face = 0; face < FACES; ++face) {
        const group = leastPoint(cells, 8 * cell, face) >>> BITS
        const place = ends[group] as number
        list[place] = FACES * cell + face
        ends[group] = place + 1
      }
  }

  /** Pairs are entered into `across`. */
  join(group: number, across: Int32Array): void {
    const from = group === 0 ? 0 : (this.#ends[group - 1] as number)
    const end = this.#recordAll(from, this.#ends[group] as number)
    const records = this.#records
    const heads = this.#heads.fill(NOTHING)
    for (let own = LENGTH; own < end; own += LENGTH) {
      const list = records[own + LIST] as number
      const opposite = records[own] as number
      const lesser = records[own + 1] as number
      const greater = records[own + 2] as number
      const head = heads[list] as number
      let before = NOTHING
      let other = head
      while (
        other !== NOTHING &&
        (records[other] !== opposite || records[other + 1] !== lesser || records[other + 2] !== greater)
      ) {
        before = other
        other = records[other + NEXT] as number
      }
      if (other === NOTHING) {
        records[own + NEXT] = head
        heads[list] = own
      } else {
        const next = records[other + NEXT] as number
        if (before === NOTHING) heads[list] = next
        else records[before + NEXT] = next
        const [face, otherFace] = [records[own + FACE] as number, records[other + FACE] as number]
        across[face] = otherFace
        across[otherFace] = face
        this.paired += 2
      }
    }
  }

  /** One record a face, before any is joined: so many cells from anywhere in memory are under way at once. Returns their end. */
  #recordAll(from: number, to: number): number {
    const cells = this.#cells
    const list = this.#list
    const end = LENGTH * (to - from + 1)
    if (this.#records.length < end) this.#records = new Int32Array(end)
    const records = this.#records
    for (let i = from, record = LENGTH; i < to; ++i, record += LENGTH) {
      const own = list[i] as number
      const cell = (own / FACES) | 0
      const loop = CORNERS * (own - FACES * cell)
      const a = cells[8 * cell + (LOOPS[loop] as number)] as number
      const b = cells[8 * cell + (LOOPS[loop + 1] as number)] as number
      const c = cells[8 * cell + (LOOPS[loop + 2] as number)] as number
      const d = cells[8 * cell + (LOOPS[loop + 3] as number)] as number
      const least = leastOf(a, b, c, d)
      const lesser = lesserOf(a, b, c, d)
      const opposite = oppositeOf(a, b, c, d)
      records[record] = opposite
      records[record + 1] = lesser
      records[record + 2] = a ^ b ^ c ^ d ^ least ^ lesser ^ opposite
      records[record + FACE] = own
      records[record + LIST] = least & (POINTS - 1)
    }
    return end
  }
}

function leastPoint(cells: Int32Array, first: number, face: number): number {
  const a = cells[first + (LOOPS[CORNERS * face] as number)] as number
  const b = cells[first + (LOOPS[CORNERS * face + 1] as number)] as number
  const c = cells[first + (LOOPS[CORNERS * face + 2] as number)] as number
  const d = cells[first + (LOOPS[CORNERS * face + 3] as number)] as number
  return leastOf(a, b, c, d)
}
