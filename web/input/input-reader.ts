/** Reads what is pasted, dropped or opened: what it finds becomes the element, or a list of which one cell can be chosen. */
import { runAlone, sentenceOf, type WorkerPort } from '../core/workers'
import { CheckedCells } from '../mesh/checked-cells'
import type { Vertices } from '../model/hexahedron'
import { reordered } from '../model/node-order'
import type { NodeOrder } from '../model/node-orders'
import { droppedIn, type PastedInput, pastedIn, takesDrop } from './pasted-input'
import type { InputHost, Reading, ReadingProgress, ShownCell } from './reading'
import type { ReadingJobs, ReadingOutcome } from './serve-reading'
import { WaitingFiles } from './waiting-files'

/** Resolves to what starts the worker that reads, which each build has somewhere else; rejects where there is none to be had. */
export type ReadingWorker = () => Promise<() => WorkerPort>

export interface InputTaker {
  /** True if anything is taken at all. */
  isWelcome(): boolean
  /** Makes them the element and returns them as the element has them. */
  take(vertices: Vertices): Vertices
  /** Says, with null takes back, why the last input was not read. */
  refuse(message: string | null): void
  /** `reading` has changed. */
  onNews(): void
  /** There is a list of so many cells to choose from, and what it was read from; null when it is put away. */
  onList(list: (PastedInput & { readonly cells: number }) | null): void
}

export class InputReader implements InputHost {
  reading: Reading | null = null
  readonly #worker: ReadingWorker
  readonly #taker: InputTaker
  #underWay: AbortController | null = null
  /** Undo and redo come back to the same lists of vertices. */
  #shown = new WeakMap<Vertices, ShownCell>()
  readonly #waiting = new WaitingFiles()

  constructor(worker: ReadingWorker, taker: InputTaker) {
    this.#worker = worker
    this.#taker = taker
  }

  isWelcome(): boolean {
    return this.#taker.isWelcome()
  }

  /** Listens for what is pasted or dropped anywhere in an element; `lens` shows where a drop will be taken. */
  listen(shadow: ShadowRoot, lens: HTMLElement): void {
    const onInput = (input: PastedInput | null) => input !== null && this.read(input)
    const onDrag = (isTaken: boolean) => lens.classList.toggle('is-drop-target', isTaken)
    shadow.addEventListener('paste', event => {
      if (this.#taker.isWelcome()) onInput(pastedIn(event as ClipboardEvent))
    })
    shadow.addEventListener('dragover', event => {
      const { dataTransfer } = event as DragEvent
      if (!onDrag(this.#taker.isWelcome() && takesDrop(event as DragEvent)) || !dataTransfer) return
      event.preventDefault()
      dataTransfer.dropEffect = 'copy'
    })
    for (const type of ['dragleave', 'dragend', 'drop']) shadow.addEventListener(type, () => onDrag(false))
    shadow.addEventListener('drop', event => {
      if (this.#taker.isWelcome()) onInput(droppedIn(event as DragEvent))
    })
  }

  read(input: PastedInput, isQuiet = false): void {
    void this.#read(this.#waiting.completed(input), isQuiet)
  }

  close(): void {
    this.#underWay?.abort()
    this.#underWay = null
    this.#taker.refuse(null)
    if (this.reading?.state === 'read') this.#taker.onList(null)
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

  async #read(input: PastedInput, isQuiet: boolean): Promise<void> {
    this.close()
    const underWay = new AbortController()
    this.#underWay = underWay
    const name = nameOf(input)
    const onProgress = (progress: ReadingProgress) => this.#set({ state: 'under-way', name, ...progress })
    onProgress({ step: 'reading', fraction: 0 })
    const outcome = await this.#outcomeOf(input, { signal: underWay.signal, onProgress })
    if (underWay.signal.aborted) return
    this.#underWay = null
    if ('refused' in outcome) this.#refuse(outcome.refused, input, outcome.missing)
    else this.#take(outcome, input, isQuiet)
  }

  /** Whatever ends the worker becomes a sentence. */
  async #outcomeOf(
    input: PastedInput,
    options: { readonly signal: AbortSignal; readonly onProgress: (progress: ReadingProgress) => void },
  ): Promise<ReadingOutcome> {
    try {
      const spawn = await this.#worker().catch(reason => () => {
        throw reason
      })
      const worker = { name: 'the worker that reads', spawn, start: null }
      return await runAlone<ReadingJobs, 'read'>(worker, { kind: 'read', given: input }, options)
    } catch (reason) {
      return { refused: `Nothing was read: ${sentenceOf(reason)}`, missing: [] }
    }
  }

  #take(
    { summary, columns }: Extract<ReadingOutcome, { columns: unknown }>,
    input: PastedInput,
    isQuiet: boolean,
  ): void {
    const cells = new CheckedCells(columns)
    const { id, why } = cells.at(0)
    if (cells.count === 1 && cells.verticesOf(0) === null) {
      this.#refuse(`Read as ${summary.format}, but the element ${id} cannot be shown: ${why}.`, null, [])
      return
    }
    this.#waiting.refused(null, [])
    this.#shown = new WeakMap()
    this.reading = { state: 'read', isQuiet, summary, cells, cellOf: vertices => this.#shown.get(vertices) ?? null }
    if (cells.count === 1) this.show(0)
    else {
      this.#taker.onNews()
      this.#taker.onList({ ...input, cells: cells.count })
    }
  }

  #refuse(message: string, input: PastedInput | null, missing: readonly string[]): void {
    this.#waiting.refused(input, missing)
    const sentence = `${message} The element is as it was.`
    this.#set({ state: 'refused', message: sentence })
    this.#taker.refuse(sentence)
  }

  #set(reading: Reading | null): void {
    this.reading = reading
    this.#taker.onNews()
  }
}

function nameOf(input: PastedInput): string {
  if ('text' in input) return 'the text'
  const [first] = input.files
  return input.files.length === 1 && first ? first.name : `${input.files.length} files`
}
