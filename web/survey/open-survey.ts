/** An open mesh as the page has it: questions to its worker, each answered by a promise. */
import { Pool, type WorkerPort, wordsOf } from '../core/workers'
import type { PastedInput } from '../input/pasted-input'
import type { ReadingProgress } from '../input/reading'
import type { StepAnswer } from '../mesh/step-answers'
import type {
  Arrangement,
  CellDetail,
  CutCells,
  CutFaces,
  FaceList,
  FixId,
  FormId,
  Histogram,
  Opening,
  Place,
  Row,
  Selected,
  Selection,
  ShownCells,
  StepList,
  StepOpening,
  StepWanted,
  SurveyJobs,
} from './survey-jobs'

/** Rejects with an Error whose message is a sentence when the worker has ended, was closed, or ran out of memory. */
export class OpenSurvey {
  readonly #pool: Pool<null, SurveyJobs>
  #selection = 0
  #writing = 0
  #closings = 0

  constructor(spawn: () => WorkerPort) {
    this.#pool = new Pool({ name: 'the worker of the mesh', size: 1, spawn, start: null })
  }

  /** Starts the worker before there is anything to open; whatever goes wrong is said when there is. */
  prepare(): void {
    this.#pool.run('prepare', null).catch(() => {})
  }

  /** Whatever goes wrong is a sentence. */
  async open(input: PastedInput, onProgress: (progress: ReadingProgress) => void): Promise<Opening> {
    try {
      return await this.#pool.run('open', input, { onProgress })
    } catch (reason) {
      return { refused: `Nothing was read: ${wordsOf(reason).replace(/[.]?$/, '.')}`, missing: [] }
    }
  }

  /** Ends the worker with all that it holds; what it was asked rejects. */
  close(): void {
    this.#selection++
    this.#writing++
    this.#closings++
    this.#pool.stop(new Error('The mesh was closed.'))
  }

  rows(from: number, to: number): Promise<readonly Row[]> {
    return this.#pool.run('rows', { from, to })
  }

  async arrange(order: Arrangement): Promise<void> {
    await this.#pool.run('arrange', order)
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
    let written = await this.#pool.run('write', form)
    while (own === this.#writing) {
      if ('refused' in written) return written
      // The browser keeps a Blob's bytes where it likes, also on the disk.
      parts.push(new Blob([written.bytes]))
      if (written.isEnd) return { content: new Blob(parts), said: written.said }
      onProgress(written.fraction)
      written = await this.#pool.run('writeOn', null)
    }
    return null
  }

  cancelWriting(): void {
    this.#writing++
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

export interface WrittenFile {
  readonly content: Blob
  /** Sentences about the file, for people. */
  readonly said: readonly string[]
}

interface Refused {
  /** One sentence. */
  readonly refused: string
}
