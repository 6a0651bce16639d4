/** Cells that are decided cut by cut by whoever is free: all at once, or as they become known while their file is read. */
import {
  type BatchCore,
  type Counts,
  NOTHING_COUNTED,
  type Piece,
  sumOfCounts,
  type WithCandidates,
} from '../core/batch/batch-core'
import { CandidateList, type CandidateOptions } from '../core/batch/candidates'
import {
  type Answers,
  answersOf,
  bytesPerCell,
  emptyLists,
  type Lists,
  listsIn,
  partOf,
  putLists,
  type Wanted,
} from '../core/batch/lists'
import { Recycled } from '../core/batch/pieces'
import { KNOWN_OF_PART, PART } from '../core/reading-interface'
import type { Pool } from '../core/workers'
import type { HelperJobs } from './helper'
import { turn } from './turn'

const CELLS_PER_CUT = 16384
/** Helpers take longer cuts while much is left, which are fewer messages: at most so many, and this share of what is left. */
const CELLS_PER_MESSAGE = 2 * CELLS_PER_CUT
const SHARE = 1 / 8
/** A helper has its next cut when it is done with one. */
const CUTS_AHEAD = 2
/** Fewer cells are no work for several. */
export const MANY = 4 * CELLS_PER_CUT

export type Helper = Pool<WebAssembly.Module, HelperJobs>

/** Whoever can decide, and whose points they hold. */
export interface Crew {
  readonly own: BatchCore
  readonly helpers: Set<Helper>
  readonly held: Map<BatchCore | Helper, Float64Array>
}

interface Cut {
  readonly first: number
  readonly count: number
}

export interface Known {
  readonly points: Float64Array
  readonly cells: Uint32Array
  /** What is known of each `PART` of the cells' indices, if anything is: as of LowHalves. */
  readonly parts: Int32Array | null
}

export class Deciding {
  readonly points: Float64Array
  /** All of them; those from `known` on are not there yet. */
  readonly cells: Uint32Array
  readonly wanted: Wanted
  onProgress: (done: number, total: number) => void = () => {}
  readonly answers: Promise<Answers & Counts & WithCandidates>
  readonly #crew: Crew
  readonly #parts: Int32Array | null
  readonly #total: number
  readonly #lists: Lists
  readonly #memory = new Recycled()
  /** Cuts of helpers that have failed. */
  readonly #left: Cut[] = []
  #known = 0
  #knowAll: () => void = () => {}
  readonly #all = new Promise<void>(resolve => {
    this.#knowAll = resolve
  })
  #wake: () => void = () => {}
  #more: Promise<void> | null = null
  #next = 0
  #done = 0
  #counts: Counts = NOTHING_COUNTED
  readonly #candidates: CandidateList | null

  constructor(crew: Crew, { points, cells, parts }: Known, wanted: Wanted) {
    this.#crew = crew
    this.#parts = parts
    this.points = points
    this.cells = cells
    this.wanted = wanted
    this.#total = cells.length / 8
    this.#lists = emptyLists(this.#total, wanted)
    this.#candidates = wanted.worst ? new CandidateList({ few: wanted.worst, limit: Infinity }) : null
    this.answers = this.#run()
    this.answers.catch(() => {})
  }

  /** So many cells are there. */
  know(count: number): void {
    this.#known = count
    if (count === this.#total) this.#knowAll()
    this.#wake()
    this.#more = null
  }

  async #run(): Promise<Answers & Counts & WithCandidates> {
    const others = [...this.#crew.helpers].flatMap(helper =>
      Array.from({ length: CUTS_AHEAD }, () => this.#decideThere(helper)),
    )
    // Whoever hands out the cuts may have the file to read.
    if (others.length > 0) await this.#all
    await this.#decideHere()
    await Promise.all(others)
    await this.#decideHere()
    return { ...answersOf(this.#lists), ...this.#counts, candidates: this.#candidates?.candidates ?? null }
  }

  /** Waits until there is a cut; null when there is none left. */
  async #take(mostOf: (left: number) => number): Promise<Cut | null> {
    for (;;) {
      const again = this.#left.pop()
      if (again || this.#next >= this.#total) return again ?? null
      const first = this.#next
      const most = Math.min(mostOf(this.#total - first), this.#known - first)
      if (most >= CELLS_PER_CUT || (most > 0 && this.#known === this.#total)) {
        this.#next = first + most
        return { first, count: most }
      }
      this.#more ??= new Promise(resolve => {
        this.#wake = resolve
      })
      await this.#more
    }
  }

  /** A cut with the points between its least and its greatest index; without, where those are far apart. */
  #pieceOf({ first, count }: Cut): OwnPiece {
    const cells = this.cells.subarray(8 * first, 8 * (first + count))
    const [least, greatest] = this.#rangeOf(8 * first, 8 * (first + count)) ?? rangeOf(cells)
    if (least < 0 || greatest - least >= 8 * Math.max(count, CELLS_PER_CUT))
      return { points: null, cells, firstPoint: 0 }
    return { points: this.points.subarray(3 * least, 3 * (greatest + 1)), cells, firstPoint: least }
  }

  #worstNow(): CandidateOptions | null {
    return this.#candidates && { few: this.wanted.worst ?? 0, limit: this.#candidates.limit }
  }

  /** Of indices that are whole parts; null where nothing is known of these. */
  #rangeOf(from: number, to: number): readonly [number, number] | null {
    const isWhole = from % PART === 0 && (to % PART === 0 || to === this.cells.length)
    if (!this.#parts || !isWhole) return null
    let [least, greatest] = [Infinity, -Infinity]
    for (let at = KNOWN_OF_PART * (from / PART); at < KNOWN_OF_PART * Math.ceil(to / PART); at += KNOWN_OF_PART) {
      least = Math.min(least, this.#parts[at] as number)
      greatest = Math.max(greatest, this.#parts[at + 1] as number)
    }
    return [least, greatest]
  }

  #count(cut: Cut, own: Counts & WithCandidates): void {
    this.#candidates?.takeAll(own.candidates, cut.first)
    this.#counts = sumOfCounts(this.#counts, own, cut.first)
    this.#done += cut.count
    this.onProgress(this.#done, this.#total)
  }

  async #decideHere(): Promise<void> {
    const { own, held } = this.#crew
    const takeShort = () => this.#take(() => CELLS_PER_CUT)
    for (let cut = await takeShort(); cut; cut = await takeShort()) {
      const piece = this.#pieceOf(cut)
      if (piece.points === null && held.get(own) !== this.points) {
        own.hold(this.points)
        held.set(own, this.points)
      }
      const part = partOf(this.#lists, cut.first, cut.count)
      this.#count(cut, own.classify(piece, this.wanted, { into: () => part, worst: this.#worstNow() }))
      await turn()
    }
  }

  async #decideThere(helper: Helper): Promise<void> {
    const { helpers, held } = this.#crew
    const each = bytesPerCell(this.wanted)
    const takeLong = () =>
      this.#take(left => {
        const share = CELLS_PER_CUT * Math.floor((SHARE * left) / CELLS_PER_CUT)
        return Math.min(CELLS_PER_MESSAGE, Math.max(CELLS_PER_CUT, share))
      })
    for (let cut = await takeLong(); cut; cut = await takeLong())
      try {
        const own = this.#pieceOf(cut)
        if (own.points === null && held.get(helper) !== this.points) {
          held.set(helper, this.points)
          void helper.run('hold', this.points.slice()).catch(() => {})
        }
        const { piece, block } = inBlock(own, this.#memory, cut.count * each)
        const back = await helper.run('classify', { piece, block, wanted: this.wanted, worst: this.#worstNow() })
        putLists(listsIn(back.block, cut.count, this.wanted), this.#lists, cut.first)
        this.#memory.give(back.block)
        this.#count(cut, { ...back.counts, candidates: back.candidates })
      } catch {
        // It is done here instead.
        this.#left.push(cut)
        helpers.delete(helper)
        return
      }
  }
}

/** The least and the greatest index in some cells. */
function rangeOf(cells: Uint32Array): readonly [number, number] {
  // Integers with a sign are faster, and no list has 2^31 points.
  const indices = new Int32Array(cells.buffer, cells.byteOffset, cells.length)
  let least = indices[0] as number
  let greatest = least
  for (let i = 1; i < indices.length; ++i) {
    const index = indices[i] as number
    if (index < least) least = index
    if (index > greatest) greatest = index
  }
  return [least, greatest]
}

interface OwnPiece extends Piece {
  readonly cells: Uint32Array
}

/** A copy in one block of memory, with room for the answers to it. */
function inBlock({ points, cells, firstPoint }: OwnPiece, memory: Recycled, answers: number) {
  const count = points?.length ?? 0
  const block = memory.take(Math.max(8 * count + 4 * cells.length, answers))
  const indices = new Uint32Array(block, 8 * count, cells.length)
  indices.set(cells)
  if (points) new Float64Array(block, 0, count).set(points)
  return { piece: { points: points && new Float64Array(block, 0, count), cells: indices, firstPoint }, block }
}
