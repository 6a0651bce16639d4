/** A survey whose check may still have to be finished, which whoever needs it waits for. */
import type { ClassifyCells } from '../mesh/check'
import type { MeshCheck } from '../mesh/mesh-check'
import type { Survey } from './survey'

export class OpenedSurvey {
  readonly survey: Survey
  readonly #classify: ClassifyCells
  #finish: (() => Promise<MeshCheck>) | null

  constructor(survey: Survey, finish: (() => Promise<MeshCheck>) | null, classify: ClassifyCells) {
    this.survey = survey
    this.#classify = classify
    this.#finish = finish
  }

  /** The survey with the whole check. */
  async whole(): Promise<Survey> {
    if (this.#finish) {
      const check = await this.#finish()
      this.#finish = null
      this.survey.complete(check)
    }
    return this.survey
  }

  /** The whole survey with the checks that accept each cell, and with minimizers. */
  async accepting(): Promise<Survey> {
    const { check } = await this.whole()
    if (check.answers.acceptedBy === null) {
      const { points, cells } = check.mesh
      this.survey.accept(await this.#classify(points, cells, { acceptedBy: true, minima: true }))
    }
    return this.survey
  }

  /** The survey with the rows up to a rank. */
  async withRows(to: number): Promise<Survey> {
    return this.survey.hasRows(to) ? this.survey : this.whole()
  }

  /** The survey with everything about one cell. */
  async withCell(cell: number): Promise<Survey> {
    return this.survey.check.worst.includes(cell) ? this.survey : this.whole()
  }
}
