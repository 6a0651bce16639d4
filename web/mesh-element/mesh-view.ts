/** The tree in the shadow root of `<hex-mesh>`: sentence, picture, list. It shows what it is given and tells what the reader does. */
import { html, nothing, render, type TemplateResult } from 'lit-html'
import type { ReadingProgress } from '../input/reading'
import { CellTable, type TableHost } from '../mesh-views/cell-table'
import listCss from '../mesh-views/cell-table.css?inline'
import { headlineTemplate } from '../mesh-views/headline'
import { formatNumber } from '../model/decimal'
import { adoptStyles } from '../panels/style-sheets'
import type { Arrangement, Overview, Row } from '../survey/survey-jobs'
import said from '../views/said.css?inline'
import type { Problem } from '../views/view'
import { say } from '../words/say'
import css from './hex-mesh.css?inline'
import type { Mode } from './mesh-attributes'
import { MeshStage, type StageHost } from './mesh-stage'

export interface ViewHost extends StageHost, Pick<TableHost, 'rows' | 'arrange'> {
  /** In the list, `rank` is its place there. */
  choose(cell: number, rank?: number): void
  setMode(mode: Mode): void
}

/** Everything that is shown; replaced, never changed. */
export interface ShownMesh {
  readonly overview: Overview | null
  readonly progress: {
    readonly step: 'fetching' | ReadingProgress['step']
    readonly name: string
    readonly fraction: number
  } | null
  readonly problems: readonly Problem[]
  readonly mode: Mode
  /** The chosen cell. */
  readonly row: Row | null
  /** The cell that is pointed at. */
  readonly pointed: Row | null
  /** What is not drawn, in words. */
  readonly left: string
  readonly isDrawn: boolean
  readonly label: string | null
}

export class MeshView {
  /** The box around all that is the element's own. */
  readonly lens = document.createElement('div')
  readonly stage: MeshStage
  readonly #host: ViewHost
  readonly #before = document.createElement('div')
  readonly #list = document.createElement('div')
  #table: CellTable | null = null

  constructor(shadow: ShadowRoot, host: ViewHost) {
    this.#host = host
    adoptStyles(shadow, [listCss, css, said])
    this.lens.className = 'lens'
    this.lens.part.add('mesh')
    this.#list.className = 'list'
    this.#list.part.add('list')
    this.#before.className = 'before'
    this.#before.part.add('fallback')
    this.#before.append(document.createElement('slot'))
    this.stage = new MeshStage(host)
    shadow.append(this.lens, this.#before)
  }

  begin(): void {
    this.#table = new CellTable(this.#list, this.#host)
  }

  end(): void {
    this.stage.dispose()
    this.#table?.dispose()
    this.#table = null
  }

  list({ hexahedra, blocks }: Overview, order: Arrangement): void {
    this.#table?.show(hexahedra, { hasBlocks: blocks.length > 0, order })
  }

  choose(cell: number | null, rank: number | null): void {
    this.#table?.choose(cell, rank)
  }

  show(shown: ShownMesh): void {
    const { overview, progress, problems, label } = shown
    this.stage.sayAnew()
    if (label === null) for (const name of ['role', 'aria-label']) this.lens.removeAttribute(name)
    else {
      this.lens.setAttribute('role', 'group')
      this.lens.setAttribute('aria-label', label)
    }
    this.#before.hidden = overview !== null
    render(
      html`<div class="problems" role="alert">
          ${problems.map(({ code, message }) => html`<p lang=${code === 'not-read' ? 'en' : nothing}>${message}</p>`)}
        </div>
        ${progress ? progressTemplate(progress) : nothing}
        <div class="overview" part="overview" role="status" lang="en">${overview ? overviewTemplate(overview) : nothing}</div>
        ${overview ? this.#meshTemplate(shown, overview) : nothing}`,
      this.lens,
    )
  }

  #meshTemplate({ mode, row, pointed, left, isDrawn }: ShownMesh, { counts }: Overview): TemplateResult {
    const option = (value: Mode, name: string) =>
      html`<option value=${value} .selected=${value === mode}>${name}</option>`
    const onMode = (event: Event) => this.#host.setMode((event.target as HTMLSelectElement).value as Mode)
    return html`${
      isDrawn
        ? html`<div class="picture">
              ${this.stage.root}
              <p class="tip" aria-hidden="true">${pointed ? cellWords(pointed) : left}</p>
            </div>`
        : nothing
    }
      <div class="bar">
        <p class="chosen" role="status">${row ? cellWords(row) : ''}</p>
        ${isDrawn && left ? html`<p class="said">${left}</p>` : nothing}
        ${
          counts.invalid > 0
            ? html`${
                isDrawn
                  ? html`<select aria-label=${say('Cells in the picture')} @change=${onMode}>
                        ${option('surface', say('Surface'))} ${option('invalid', say('Invalid cells'))}
                        ${option('neighbours', say('With neighbours'))}
                      </select>`
                  : nothing
              }<button type="button" title=${say('Previous invalid cell (P)')} @click=${() => this.#host.goToNext(-1)}>
                  ${say('Previous')}</button
                ><button type="button" title=${say('Next invalid cell (N)')} @click=${() => this.#host.goToNext(1)}>
                  ${say('Next')}
                </button>`
            : nothing
        }
        ${isDrawn ? html`<button type="button" title=${say('Show the whole mesh (F)')} @click=${() => this.stage.fit()}>${say('Fit')}</button>` : nothing}
      </div>
      ${this.#list}`
  }
}

function overviewTemplate({ name, format, headline, sentences }: Overview): TemplateResult {
  const file = html`<b>${name}</b>, ${format}.`
  // More would take the picture's room.
  return html`<p class="headline">${headlineTemplate(headline)}</p>
    ${
      sentences.length > 1
        ? html`<details class="notes"><summary>${file} ${sentences.length} notes</summary>${sentences.map(sentence => html`<p>${sentence}</p>`)}</details>`
        : html`<p class="notes">${file} ${sentences}</p>`
    }`
}

function progressTemplate({ step, name, fraction }: NonNullable<ShownMesh['progress']>): TemplateResult {
  const words = {
    fetching: () => say('Fetching {name} …', { name }),
    loading: () => say('Loading the HDF5 reader, 1 MB …'),
    reading: () => say('Reading {name} …', { name }),
    deciding: () => say('Deciding the cells of {name} …', { name }),
  }
  return html`<p class="progress"><label>${words[step]()} <progress max="1" .value=${fraction}></progress></label></p>`
}

function cellWords({ id, standing, relativeMinimum, why }: Row): string {
  if (why !== null) return say('Cell {cell}, {verdict}', { cell: id, verdict: say('unanswered') })
  const minimum = Number.isNaN(relativeMinimum) ? say('volume 0') : formatNumber(relativeMinimum)
  const verdict = standing === 'invalid' ? say('INVALID') : say('valid')
  return say('Cell {cell}, {verdict}, relative minimum {minimum}', { cell: id, verdict, minimum })
}
