/** One mesh at several times: files are kept, and of each step its least relative minimum; the mesh of one step is open. */
import { CLASSES } from '../core/unpack'
import type { Mesh } from '../mesh/mesh'
import type { MeshCheck } from '../mesh/mesh-check'
import type { TogetherOptions } from '../mesh/read-mesh'
import { shown } from '../mesh/shown'
import { areEqual, haveSameCells, type StepFile, type StepFiles, type Topology } from '../mesh/step-files'
import type { StepAnswer, StepList } from './survey-jobs'

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
  readonly #steps: readonly StepFile[]
  readonly #corrections: Correction[] = []
  /** Of the step that was read first, as its file has it: steps with the same cells share their memory. */
  #first: Topology | null = null

  constructor({ sentences, steps }: StepFiles) {
    this.#sentences = sentences
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
    return { sentences: this.#sentences, steps, shown: shownStep, answer }
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
    const { hexahedra, invalid, unanswered, mesh } = check
    const [worst] = check.worst
    const { time } = this.#steps[step] as StepFile
    return {
      step,
      time: time ?? (mesh.steps.length === 1 ? shown(mesh.steps[0] as string).slice(1, -1) : null),
      counts: { hexahedra, invalid, unanswered },
      least: worst === undefined || !check.isAnswered(worst) ? null : leastOf(check, worst),
      worst: worst === undefined ? null : { cell: worst, id: shown(check.idOf(worst) ?? String(worst)).slice(1, -1) },
      isOther,
      refused: null,
    }
  }

  refusedStep(step: number, sentence: string): StepAnswer {
    const { time } = this.#steps[step] as StepFile
    return { step, time, counts: null, least: null, worst: null, isOther: false, refused: sentence }
  }
}

function corrected(mesh: Mesh, { before, after, isOrderStated, note }: Correction): Mesh {
  if (areEqual(mesh.cells, before)) return { ...mesh, cells: after, isOrderStated, notes: [...mesh.notes, note] }
  const sentence = 'What was corrected in another step is not corrected here: its cells are others.'
  return { ...mesh, notes: [...mesh.notes, sentence] }
}

/** As the list of the worst has it: a cell of volume 0 is below everything, or 0 if all of it is flat. */
function leastOf({ answers: { relativeMinima, classes } }: MeshCheck, cell: number): number {
  const relative = relativeMinima[cell] as number
  if (!Number.isNaN(relative)) return relative
  return CLASSES[classes[cell] as number] === 'collapsed' ? 0 : -Infinity
}
