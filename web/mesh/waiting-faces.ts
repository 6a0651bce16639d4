/** Faces that wait for their other side, in a list for each point that is the least of theirs; face-points.ts has the order of the other three. */
import { FACES, LOOPS } from './face-loops'
import { leastOf, lesserOf, oppositeOf } from './face-points'

// A record: opposite, lesser, greater, the face, the next record of its list. A record is named by the place of its first number.
const LENGTH = 8
const FACE = 3
const NEXT = 4
/** The first record stays free: it ends the lists. */
const NOTHING = 0

export class WaitingFaces {
  /** Faces that have found their other side. */
  paired = 0
  /** The first record of each list. */
  readonly #heads: Int32Array
  #records = new Int32Array(LENGTH * 4096)
  /** Records that were in use, as a list, and where those begin that were not. */
  #free = NOTHING
  #unused = LENGTH

  constructor(pointCount: number) {
    this.#heads = new Int32Array(pointCount)
  }

  /** The most that have waited at once. */
  get most(): number {
    return this.#unused / LENGTH - 1
  }

  /** Joins the faces of some cells with each other and with those that wait, in order. Pairs are entered into `across`. */
  join(cells: Int32Array, from: number, to: number, across: Int32Array): void {
    const heads = this.#heads
    const records = this.#roomFor(FACES * (to - from))
    let free = this.#free
    let unused = this.#unused
    let pairs = 0
    for (let cell = from; cell < to; ++cell) {
      const first = 8 * cell
      for (let face = 0; face < FACES; ++face) {
        const a = cells[first + (LOOPS[4 * face] as number)] as number
        const b = cells[first + (LOOPS[4 * face + 1] as number)] as number
        const c = cells[first + (LOOPS[4 * face + 2] as number)] as number
        const d = cells[first + (LOOPS[4 * face + 3] as number)] as number
        const least = leastOf(a, b, c, d)
        const lesser = lesserOf(a, b, c, d)
        const opposite = oppositeOf(a, b, c, d)
        const greater = a ^ b ^ c ^ d ^ least ^ lesser ^ opposite
        const own = FACES * cell + face
        const head = heads[least] as number
        let before = NOTHING
        let record = head
        while (
          record !== NOTHING &&
          (records[record] !== opposite || records[record + 1] !== lesser || records[record + 2] !== greater)
        ) {
          before = record
          record = records[record + NEXT] as number
        }
        if (record !== NOTHING) {
          const next = records[record + NEXT] as number
          if (before === NOTHING) heads[least] = next
          else records[before + NEXT] = next
          records[record + NEXT] = free
          free = record
          const other = records[record + FACE] as number
          across[own] = other
          across[other] = own
          pairs++
          continue
        }
        if (free === NOTHING) {
          record = unused
          unused += LENGTH
        } else {
          record = free
          free = records[free + NEXT] as number
        }
        records[record] = opposite
        records[record + 1] = lesser
        records[record + 2] = greater
        records[record + FACE] = own
        records[record + NEXT] = head
        heads[least] = record
      }
    }
    this.#free = free
    this.#unused = unused
    this.paired += 2 * pairs
  }

  /** The records, with room for so many more. */
  #roomFor(count: number): Int32Array {
    const wanted = this.#unused + LENGTH * count
    if (wanted > this.#records.length) {
      const more = new Int32Array(Math.max(wanted, 2 * this.#records.length))
      more.set(this.#records)
      this.#records = more
    }
    return this.#records
  }
}
