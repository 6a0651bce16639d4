/** A survey whose check may still have to be finished, which whoever needs it waits for. */
import type { ClassifyCells } from '../mesh/check'
import type { MeshCheck } from '../mesh/mesh-check'
import { Accepting } from './accepting'
import type { Survey } from './survey'

export class OpenedSurvey {
  readonly survey: Survey
  readonly #classify: ClassifyCells
  #finish: (() => Promise<MeshCheck>) | null
  #accepting: Accepting | null = null

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

  /** Goes on to find the checks that accept cells. Returns which part is done; 1 once all is. */
  async accept(cells: 'invalid' | 'all'): Promise<number> {
    const { check } = await this.whole()
    if (check.answers.acceptedBy !== null) return 1
    this.#accepting ??= new Accepting(check, this.#classify)
    const part = await this.#accepting.run(cells)
    if (cells === 'all' && part === 1) this.survey.accept(this.#accepting.lists)
    return part
  }

  /** The whole survey with the checks that accept each cell, and with minimizers. */
  async accepting(): Promise<Survey> {
    while ((await this.accept('all')) < 1);
    return this.survey
  }

  /** The whole check with the checks that accept the invalid cells, and perhaps others. */
  async acceptingInvalid(): Promise<MeshCheck> {
    while ((await this.accept('invalid')) < 1);
    const { check } = this.survey
    return this.#accepting
      ? { ...check, answers: { ...check.answers, acceptedBy: this.#accepting.lists.acceptedBy } }
      : check
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
