/** Reads what is pasted, dropped or opened: what it finds becomes the element, or a list of which one cell can be chosen. */

import type { Vertices } from '../model/hexahedron'
import { reordered } from '../model/node-order'
import type { NodeOrder } from '../model/node-orders'
import type { PastedInput } from './pasted-input'
import type { ReadInputOptions, ReadingOutcome, ReadingWorker } from './read-input'
import type { InputHost, Reading, ShownCell } from './reading'

export interface InputTaker {
  isWelcome(): boolean
  /** Makes them the element and returns them as the element has them. */
  take(vertices: Vertices): Vertices
  /** Says, with null takes back, why the last input was not read. */
  refuse(message: string | null): void
  /** `reading` has changed. */
  onNews(): void
}

export class InputReader implements InputHost {
  reading: Reading | null = null
  readonly #worker: () => Promise<ReadingWorker>
  readonly #taker: InputTaker
  #underWay: AbortController | null = null
  /** Undo and redo come back to the same lists of vertices. */
  #shown = new WeakMap<Vertices, ShownCell>()
  /** Files that name others which were not given; they wait for these. */
  #waiting: { readonly files: readonly File[]; readonly missing: readonly string[] } | null = null

  constructor(worker: () => Promise<ReadingWorker>, taker: InputTaker) {
    this.#worker = worker
    this.#taker = taker
  }

  isWelcome(): boolean {
    return this.#taker.isWelcome()
  }

  read(input: PastedInput): void {
    void this.#read(this.#completed(input))
  }

  close(): void {
    this.#underWay?.abort()
    this.#underWay = null
    this.#taker.refuse(null)
    this.#set(null)
  }

  show(cell: number, order: NodeOrder | null = null): void {
    if (this.reading?.state !== 'read') return
    const { cells } = this.reading
    const own = cells.verticesOf(cell)
    if (own === null) return
    const vertices = this.#taker.take(order ? reordered(own, order.permutation) : own)
    const { id } = cells.at(cells.rankOf(cell))
    this.#shown.set(vertices, { cell, id, order })
    this.#taker.onNews()
  }

  async #read(input: PastedInput): Promise<void> {
    this.close()
    const underWay = new AbortController()
    this.#underWay = underWay
    const name = nameOf(input)
    this.#set({ state: 'under-way', name, step: 'reading', fraction: 0 })
    const outcome = await outcomeOf(input, {
      readingWorker: this.#worker,
      signal: underWay.signal,
      onProgress: ({ step, fraction }) => {
        if (this.#underWay === underWay) this.#set({ state: 'under-way', name, step, fraction })
      },
    })
    if (this.#underWay !== underWay) return
    this.#underWay = null
    if (outcome.kind === 'refused') this.#refuse(outcome.message, input, outcome.missing)
    else await this.#take(outcome)
  }

  async #take({ summary, columns }: Extract<ReadingOutcome, { kind: 'read' }>): Promise<void> {
    const { CheckedCells } = await import('../mesh/checked-cells')
    const cells = new CheckedCells(columns)
    const { id, why } = cells.at(0)
    if (cells.count === 1 && cells.verticesOf(0) === null) {
      this.#refuse(`Read as ${summary.format}, but the element ${id} cannot be shown: ${why}.`, null, [])
      return
    }
    this.#waiting = null
    this.#shown = new WeakMap()
    this.reading = { state: 'read', summary, cells, cellOf: vertices => this.#shown.get(vertices) ?? null }
    if (cells.count === 1) this.show(0)
    else this.#taker.onNews()
  }

  #refuse(message: string, input: PastedInput | null, missing: readonly string[]): void {
    this.#waiting = input && 'files' in input && missing.length > 0 ? { files: input.files, missing } : null
    const sentence = `${message} The element is as it was.`
    this.#set({ state: 'refused', message: sentence })
    this.#taker.refuse(sentence)
  }

  /** The input with the files that wait for one of its own. */
  #completed(input: PastedInput): PastedInput {
    if (!('files' in input) || this.#waiting === null) return input
    const { files, missing } = this.#waiting
    const names = missing.map(name => name.split(/[\\/]/).at(-1)?.toLowerCase())
    if (!input.files.some(({ name }) => names.includes(name.toLowerCase()))) return input
    const others = files.filter(file => !input.files.some(({ name }) => name === file.name))
    return { files: [...others, ...input.files] }
  }

  #set(reading: Reading | null): void {
    this.reading = reading
    this.#taker.onNews()
  }
}

/** The code that reads comes with the first input. */
async function outcomeOf(input: PastedInput, options: ReadInputOptions): Promise<ReadingOutcome> {
  try {
    const { readInput } = await import('./read-input')
    return await readInput(input, options)
  } catch (reason) {
    const why = reason instanceof Error ? reason.message : reason
    return { kind: 'refused', message: `Nothing was read: what reads was not loaded (${why}).`, missing: [] }
  }
}

function nameOf(input: PastedInput): string {
  if ('text' in input) return 'the text'
  const [first] = input.files
  return input.files.length === 1 && first ? first.name : `${input.files.length} files`
}
