/**
 * The checks that accept each cell, and its minimizer, found in steps, as they take longer than all the rest: first of invalid cells, then of
 * the others.
 */
import type { Minima } from '../core/batch/lists'
import { cellsAt } from '../mesh/accepted-invalid'
import type { ClassifyCells } from '../mesh/check'
import type { MeshCheck } from '../mesh/mesh-check'

/** Enough for several workers; others are answered before and between. */
const CELLS_AT_ONCE = 65_536

export class Accepting {
  /** By cell; 0 for those that were not asked yet. */
  readonly lists: { readonly acceptedBy: Uint16Array; readonly minima: Minima }
  readonly #check: MeshCheck
  readonly #classify: ClassifyCells
  readonly #atOnce: number
  /** Cells in the order in which they are asked. */
  readonly #order: Uint32Array
  #done = 0
  #step: Promise<void> | null = null

  constructor(check: MeshCheck, classify: ClassifyCells, atOnce = CELLS_AT_ONCE) {
    this.#check = check
    this.#classify = classify
    this.#atOnce = atOnce
    const minima = check.answers.minima as Minima
    const minimizers = new Float64Array(3 * check.hexahedra).fill(Number.NaN)
    this.lists = { acceptedBy: new Uint16Array(check.hexahedra), minima: { ...minima, minimizers } }
    this.#order = new Uint32Array(check.hexahedra)
    const isInvalid = (cell: number) => check.standingOf(cell) === 'invalid'
    let [invalid, others] = [0, check.invalid]
    for (let cell = 0; cell < check.hexahedra; ++cell) this.#order[isInvalid(cell) ? invalid++ : others++] = cell
  }

  /** Goes on. Returns which part of these cells is done; whoever asks while a step is under way waits for that. */
  async run(cells: 'invalid' | 'all'): Promise<number> {
    const count = cells === 'invalid' ? this.#check.invalid : this.#order.length
    if (this.#done < count) {
      this.#step ??= this.#next().finally(() => {
        this.#step = null
      })
      await this.#step
    }
    return count === 0 ? 1 : Math.min(1, this.#done / count)
  }

  async #next(): Promise<void> {
    const { mesh } = this.#check
    const own = this.#order.subarray(this.#done, this.#done + this.#atOnce)
    const wanted = { acceptedBy: true, minima: true } as const
    const { acceptedBy, minima } = await this.#classify(mesh.points, cellsAt(mesh.cells, own), wanted)
    for (const [i, cell] of own.entries()) {
      this.lists.acceptedBy[cell] = acceptedBy[i] as number
      this.lists.minima.minimizers.set(minima.minimizers.subarray(3 * i, 3 * i + 3), 3 * cell)
    }
    this.#done += own.length
    // Messages come in.
    await new Promise(resolve => setTimeout(resolve))
  }
}
