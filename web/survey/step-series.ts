/** One mesh at several times: its files are kept, and of each step its least relative minimum; the mesh of one step is open. */
import type { Mesh } from '../mesh/mesh'
import type { MeshCheck } from '../mesh/mesh-check'
import type { TogetherOptions } from '../mesh/read-mesh'
import { type StepAnswer, stepAnswerOf } from '../mesh/step-answers'
import { areEqual, haveSameCells, type StepFile, type StepFiles, type Topology } from '../mesh/step-files'
import type { StepList } from './survey-jobs'

/** Another order of nodes, which holds in all steps: it is the file's, and no movement. */
interface Correction {
  readonly before: Uint32Array
  readonly after: Uint32Array
  readonly isOrderStated: boolean
  readonly note: string
}

export interface StepMesh {
  readonly mesh: Mesh
  /** True if its cells are others than those of the step that was read first. */
  readonly isOther: boolean
}

export class StepSeries {
  readonly #sentences: readonly string[]
  readonly #areFiles: boolean
  readonly #steps: readonly StepFile[]
  readonly #corrections: Correction[] = []
  /** Of the step that was read first, as its file has it: steps with the same cells share their memory. */
  #first: Topology | null = null

  constructor({ sentences, areFiles, steps }: StepFiles) {
    this.#sentences = sentences
    this.#areFiles = areFiles
    this.#steps = steps
  }

  get count(): number {
    return this.#steps.length
  }

  nameOf(step: number): string {
    return this.#steps[step]?.name ?? ''
  }

  list(shownStep: number, answer: StepAnswer): StepList {
    const steps = this.#steps.map(({ name, time }) => ({ name, time }))
    return { sentences: this.#sentences, areFiles: this.#areFiles, steps, shown: shownStep, answer }
  }

  /** Throws a MeshRefusal. */
  read(step: number, options: TogetherOptions): StepMesh {
    return this.taken((this.#steps[step] as StepFile).read(options))
  }

  /** The mesh of a step as it was read, corrected. */
  taken(mesh: Mesh): StepMesh {
    const { cells, notTrilinear, other, points } = mesh
    this.#first ??= { cells, notTrilinear, other, points: { length: points.length } }
    const isOther = !haveSameCells(this.#first, mesh)
    const own = isOther ? mesh : { ...mesh, cells: this.#first.cells }
    return { mesh: this.#corrections.reduce(corrected, own), isOther }
  }

  /** Every step is read so from now on. */
  correct(before: Mesh, after: Mesh): void {
    const { cells, isOrderStated } = after
    this.#corrections.push({ before: before.cells, after: cells, isOrderStated, note: after.notes.at(-1) ?? '' })
  }

  /** The answer of a step with `check`, whose worst cell is the first in its list. */
  answerOf(step: number, check: MeshCheck, isOther: boolean): StepAnswer {
    return stepAnswerOf(check, { step, time: this.#timeOf(step), isOther })
  }

  #timeOf(step: number): string | null {
    return this.#steps[step]?.time ?? null
  }

  refusedStep(step: number, sentence: string): StepAnswer {
    const time = this.#timeOf(step)
    return { step, time, counts: null, least: null, worst: null, isOther: false, refused: sentence }
  }
}

function corrected(mesh: Mesh, { before, after, isOrderStated, note }: Correction): Mesh {
  if (areEqual(mesh.cells, before)) return { ...mesh, cells: after, isOrderStated, notes: [...mesh.notes, note] }
  const sentence = 'What was corrected in another step is not corrected here: its cells are others.'
  return { ...mesh, notes: [...mesh.notes, sentence] }
}
