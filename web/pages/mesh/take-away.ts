/** What can be taken away of the open mesh: a menu of files, which the mesh's worker writes. */
import { html, nothing, render, type TemplateResult } from 'lit-html'
import { MESH_FORMS } from '../../outputs/meshes/list'
import type { OpenSurvey } from '../../survey/open-survey'
import type { FormId, MovementCounts, Overview } from '../../survey/survey-jobs'
import { saveFile } from '../../views/save-file'
import { ButtonSection } from './button-section'
import { fileStem, sizeWords } from './file-names'

export interface TakeAwayHost {
  /** Null where no mesh is open. */
  survey(): OpenSurvey | null
  /** Null where there is no picture. */
  picture(): Promise<Blob> | null
  /** The mesh as it is has been saved whole. */
  saved(): void
}

interface FileWords {
  readonly form: FormId | 'png'
  readonly name: string
  readonly what: string
  /** Stands behind the mesh's name. */
  readonly ending: string
  readonly mediaType: string
}

const WHOLE: readonly FileWords[] = [
  {
    form: 'html',
    name: 'Report',
    what: 'one HTML file to keep: the sentence, the histogram, the worst ten drawn',
    ending: '-report.html',
    mediaType: 'text/html',
  },
  { form: 'csv', name: 'CSV', what: 'a line for each cell', ending: '.csv', mediaType: 'text/csv' },
  {
    form: 'json',
    name: 'JSON',
    what: 'counts, notes, the invalid cells, ten at least',
    ending: '.json',
    mediaType: 'application/json',
  },
  ...MESH_FORMS.map(
    ({ id, name, what, mediaType }): FileWords => ({
      form: `mesh.${id}`,
      name,
      what,
      ending: `-checked.${id}`,
      mediaType,
    }),
  ),
  { form: 'png', name: 'PNG', what: 'the picture as it is', ending: '.png', mediaType: 'image/png' },
]

const INVALID: readonly FileWords[] = [
  ...MESH_FORMS.map(
    ({ id, name, whatOfPart, mediaType }): FileWords => ({
      form: `invalid.${id}`,
      name,
      what: whatOfPart,
      ending: `-invalid.${id}`,
      mediaType,
    }),
  ),
  {
    form: 'certificates',
    name: 'Certificates',
    what: 'a point with jacdet ≤ 0 of each, to be checked by anybody',
    ending: '-certificates.json',
    mediaType: 'application/json',
  },
  {
    form: 'abaqus',
    name: 'ELSET',
    what: 'ids for Abaqus and CalculiX',
    ending: '-invalid-ids.inp',
    mediaType: 'text/plain',
  },
  { form: 'nastran', name: 'SET', what: 'ids for Nastran', ending: '-invalid-ids.nas', mediaType: 'text/plain' },
  { form: 'plain', name: 'List', what: 'ids, one on a line', ending: '-invalid-ids.txt', mediaType: 'text/plain' },
]

const NONE_INVALID = 'No cell is invalid, so there are no such files.'
const NO_PICTURE = 'There is no picture without WebGL.'

interface Shown {
  readonly overview: Overview | null
  readonly movement: MovementCounts | null
  readonly writing: { readonly file: string; readonly fraction: number } | null
  readonly message: string
}

export class TakeAway {
  readonly #menu = new ButtonSection('take-away', 'Take away')
  readonly #host: TakeAwayHost
  #shown: Shown = { overview: null, movement: null, writing: null, message: '' }
  #writer: OpenSurvey | null = null

  constructor(host: TakeAwayHost) {
    this.#host = host
  }

  /** Shows and hides the menu. */
  get button(): HTMLElement {
    return this.#menu.button
  }

  /** The menu for this mesh, closed for another one; it stays as it is if only vertices have moved. */
  show(overview: Overview | null, movement: MovementCounts): HTMLElement {
    if (this.button.hidden === (overview === null) && overview === this.#shown.overview) return this.#menu.root
    this.button.hidden = overview === null
    const hasMoved = movement !== this.#shown.movement && (movement.canUndo || movement.canRedo)
    if (!hasMoved) this.#menu.open(false)
    this.#set({ overview, movement, writing: null, message: '' })
    return this.#menu.root
  }

  /** The file that was read, of another name so that it stays. */
  #own({ name, format }: Overview): FileWords {
    const ending = /\.[a-z0-9]+$/i.exec(name)?.[0] ?? '.txt'
    const what = `the file that was read, with the moved vertices; all else is as it was`
    return { form: 'own', name: format, what, ending: `-moved${ending}`, mediaType: 'application/octet-stream' }
  }

  async #take({ form, ending, mediaType }: FileWords): Promise<void> {
    const { overview } = this.#shown
    const survey = this.#host.survey()
    if (!overview || !survey) return
    this.#writer = survey
    const file = `${fileStem(overview.name)}${ending}`
    const isStill = () => overview === this.#shown.overview
    const tell = (message: string) => isStill() && this.#set({ ...this.#shown, writing: null, message })
    const onProgress = (fraction: number) => isStill() && this.#set({ ...this.#shown, writing: { file, fraction } })
    this.#set({ ...this.#shown, writing: { file, fraction: 0 }, message: '' })
    try {
      const written = form === 'png' ? await this.#picture() : await survey.write(form, onProgress)
      if (written === null) return
      if ('refused' in written) return void tell(written.refused)
      saveFile(file, written.content, mediaType)
      if (isStill() && (form === 'own' || form.startsWith('mesh.'))) this.#host.saved()
      tell([`${file}, ${sizeWords(written.content.size)}.`, ...written.said].join(' '))
    } catch (reason) {
      tell(`${file} was not written: ${reason instanceof Error ? reason.message : reason}`)
    }
  }

  async #picture(): Promise<{ readonly content: Blob; readonly said: readonly string[] }> {
    const content = await this.#host.picture()
    if (content === null) throw new Error(NO_PICTURE)
    return { content, said: [] }
  }

  #cancel(): void {
    this.#writer?.cancelWriting()
    this.#set({ ...this.#shown, writing: null, message: 'Cancelled: nothing was saved.' })
    this.button.focus()
  }

  #set(shown: Shown): void {
    this.#shown = shown
    render(this.#template(shown), this.#menu.root)
  }

  #template({ overview, movement, writing, message }: Shown): TemplateResult | typeof nothing {
    if (!overview) return nothing
    const hasInvalid = overview.counts.invalid > 0
    return html`<div class="now">
        <p role="status">${writing ? `Writing ${writing.file}.` : message}</p>
        ${
          writing === null
            ? nothing
            : html`<p class="writing">
                <progress max="1" aria-label=${`Writing ${writing.file}`} .value=${writing.fraction}></progress>
                <button type="button" @click=${() => this.#cancel()}>Cancel</button>
              </p>`
        }
      </div>
      ${movement && movement.movedCount > 0 ? this.#movedTemplate(overview, movement) : nothing}
      <div>
        <h2>All cells</h2>
        ${this.#list(WHOLE, null)}
      </div>
      <div>
        <h2>Invalid cells alone</h2>
        ${hasInvalid ? nothing : html`<p id="take-away-why">${NONE_INVALID}</p>`}
        ${this.#list(INVALID, hasInvalid ? null : 'take-away-why')}
      </div>`
  }

  #movedTemplate(overview: Overview, { movedCount, whyNotInPlace }: MovementCounts): TemplateResult {
    return html`<div class="moved">
      <h2>In the format of the file</h2>
      <p>As all files here, with ${movedCount.toLocaleString('en')} moved ${movedCount === 1 ? 'vertex' : 'vertices'}.</p>
      ${whyNotInPlace === null ? nothing : html`<p id="own-format-why">${whyNotInPlace} VTU has them.</p>`}
      ${this.#list([this.#own(overview)], whyNotInPlace === null ? null : 'own-format-why')}
    </div>`
  }

  /** Disabled for the reason with this id. */
  #list(files: readonly FileWords[], why: string | null): TemplateResult {
    return html`<ul>
      ${files.map(
        file => html`<li>
          <button
            type="button"
            ?disabled=${why !== null}
            aria-describedby=${why ?? nothing}
            @click=${() => this.#take(file)}
          >
            <b>${file.name}</b> <span>${file.what}</span>
          </button>
        </li>`,
      )}
    </ul>`
  }
}
