/** An open mesh as the page has it: questions to its worker, each answered by a promise. */
import { Pool, sentenceOf, type WorkerPort } from '../core/workers'
import type { PastedInput } from '../input/pasted-input'
import type { ReadingProgress } from '../input/reading'
import type { StepAnswer } from '../mesh/step-answers'
import {
  ACCEPTED_IN,
  type Around,
  type Arrangement,
  type CellDetail,
  type CutCells,
  type CutFaces,
  type FaceList,
  type FixId,
  type FormId,
  type Histogram,
  type MovedMesh,
  type Moves,
  type Opening,
  type Place,
  type Row,
  type Selected,
  type Selection,
  type ShownCells,
  type StepList,
  type StepOpening,
  type StepWanted,
  type SurveyJobs,
  type TangledPart,
} from './survey-jobs'

/** Rejects with an Error whose message is a sentence when the worker has ended, was closed, or ran out of memory. */
export class OpenSurvey {
  readonly #pool: Pool<null, SurveyJobs>
  #selection = 0
  #arranging = 0
  #writing = 0
  #closings = 0
  #isPractising = true

  constructor(spawn: () => WorkerPort) {
    this.#pool = new Pool({ name: 'the worker of the mesh', size: 1, spawn, start: null })
  }

  /** Starts the worker before there is anything to open, and lets it practise until there is; whatever goes wrong is said then. */
  prepare(): void {
    this.#practise().catch(() => {})
  }

  async #practise(): Promise<void> {
    for (const practice of await this.#pool.run('prepare', null)) {
      if (!this.#isPractising) return
      await this.#pool.run('practise', practice)
    }
  }

  /** Whatever goes wrong is a sentence. */
  async open(input: PastedInput, onProgress: (progress: ReadingProgress) => void): Promise<Opening> {
    this.#isPractising = false
    try {
      return await this.#pool.run('open', input, { onProgress })
    } catch (reason) {
      return { refused: `Nothing was read: ${sentenceOf(reason)}`, missing: [] }
    }
  }

  /** Ends the worker with all that it holds; what it was asked rejects. */
  close(): void {
    this.#isPractising = false
    this.#selection++
    this.#arranging++
    this.#writing++
    this.#closings++
    this.#pool.stop(new Error('The mesh was closed.'))
  }

  rows(from: number, to: number): Promise<readonly Row[]> {
    return this.#pool.run('rows', { from, to })
  }

  /** Tells of each step that an order by what is not known yet takes. Another order, or a cancel, ends it: false then. */
  async arrange(order: Arrangement, onStep: (part: number) => void = () => {}): Promise<boolean> {
    const own = ++this.#arranging
    const isWanted = () => own === this.#arranging
    if (order.column === 'accepted-by' && !(await this.#accept('all', onStep, isWanted))) return false
    await this.#pool.run('arrange', order)
    return true
  }

  cancelArranging(): void {
    this.#arranging++
  }

  async #accept(cells: 'invalid' | 'all', onStep: (part: number) => void, isWanted: () => boolean): Promise<boolean> {
    for (let part = 0; part < 1; ) {
      part = await this.#pool.run('accept', cells)
      if (!isWanted()) return false
      onStep(part)
    }
    return true
  }

  /** Tells of each step; the last has looked at all cells. Another selection ends it: null then. */
  async select(selection: Selection, total: number, onStep: (selected: Selected) => void): Promise<Selected | null> {
    const own = ++this.#selection
    let selected = await this.#pool.run('select', selection)
    while (own === this.#selection) {
      onStep(selected)
      if (selected.done === total) return selected
      selected = await this.#pool.run('selectOn', null)
    }
    return null
  }

  find(id: string, after: number): Promise<Place | null> {
    return this.#pool.run('find', { id, after })
  }

  nextInvalid(rank: number, step: 1 | -1): Promise<Place | null> {
    return this.#pool.run('nextInvalid', { rank, step })
  }

  placeOf(cell: number): Promise<Place> {
    return this.#pool.run('placeOf', cell)
  }

  histogram(): Promise<Histogram> {
    return this.#pool.run('histogram', null)
  }

  detail(cell: number): Promise<CellDetail> {
    return this.#pool.run('detail', cell)
  }

  /** Tells of each step; in the end, 1, it is known which cells share a face. Closing ends it. */
  async join(onStep: (part: number) => void): Promise<void> {
    const own = this.#closings
    for (let part = 0; part < 1 && own === this.#closings; ) {
      part = await this.#pool.run('join', null)
      onStep(part)
    }
  }

  faces(shown: ShownCells): Promise<FaceList> {
    return this.#pool.run('faces', shown)
  }

  cut(cells: CutCells): Promise<CutFaces> {
    return this.#pool.run('cut', cells)
  }

  mend(fix: FixId): Promise<Opening> {
    return this.#pool.run('mend', fix)
  }

  /** The mesh as a file. Null if another one is begun, or this one is cancelled. */
  async write(form: FormId, onProgress: (fraction: number) => void): Promise<WrittenFile | Refused | null> {
    const own = ++this.#writing
    const parts: Blob[] = []
    const accepted = ACCEPTED_IN[form]
    const before = accepted ? ACCEPTING : 0
    const isWanted = () => own === this.#writing
    if (accepted && !(await this.#accept(accepted, part => onProgress(before * part), isWanted))) return null
    let written = await this.#pool.run('write', form)
    while (own === this.#writing) {
      if ('refused' in written) return written
      // The browser keeps a Blob's bytes where it likes, also on the disk.
      parts.push(new Blob([written.bytes]))
      if (written.isEnd) return { content: new Blob(parts), said: written.said }
      onProgress(before + (1 - before) * written.fraction)
      written = await this.#pool.run('writeOn', null)
    }
    return null
  }

  cancelWriting(): void {
    this.#writing++
  }

  around(cell: number): Promise<Around | null> {
    return this.#pool.run('around', cell)
  }

  move(moves: Moves): Promise<MovedMesh> {
    return this.#pool.run('move', moves)
  }

  undo(): Promise<MovedMesh> {
    return this.#pool.run('undo', null)
  }

  redo(): Promise<MovedMesh> {
    return this.#pool.run('redo', null)
  }

  restore(points: readonly number[] | null): Promise<MovedMesh> {
    return this.#pool.run('restore', points)
  }

  tangled(part: { readonly cell: number; readonly rings: number } | null): Promise<TangledPart> {
    return this.#pool.run('tangled', part)
  }

  steps(): Promise<StepList | null> {
    return this.#pool.run('steps', null)
  }

  readStep(step: number, onProgress: (progress: ReadingProgress) => void): Promise<StepAnswer> {
    return this.#pool.run('readStep', step, { onProgress })
  }

  showStep(wanted: StepWanted, onProgress: (progress: ReadingProgress) => void): Promise<StepOpening> {
    return this.#pool.run('showStep', wanted, { onProgress })
  }

  together(onProgress: (progress: ReadingProgress) => void): Promise<Opening> {
    return this.#pool.run('together', null, { onProgress })
  }
}

/** About which part of the writing goes to the checks that accept cells. */
const ACCEPTING = 0.4

export interface WrittenFile {
  readonly content: Blob
  /** Sentences about the file, for people. */
  readonly said: readonly string[]
}

interface Refused {
  /** One sentence. */
  readonly refused: string
}
