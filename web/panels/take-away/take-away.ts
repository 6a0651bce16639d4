/** The element as files and texts: pictures, report, other programs' formats, link, paper. */
import { html, render, type TemplateResult } from 'lit-html'
import { version } from '../../../package.json'
import type { Report } from '../../core/report'
import { reportJson } from '../../core/report-json'
import { jacdetInFull } from '../../model/decimal'
import type { Vertices } from '../../model/hexahedron'
import { copyText } from '../../views/copy-text'
import { figurePng, figureSvg } from '../../views/figure-files'
import { isNew } from '../../views/is-new'
import { saveFile } from '../../views/save-file'
import type { CreateView, Figure, FigureName, Frame, View, ViewContext } from '../../views/view'
import { bibtex } from './formats/bibtex'
import { writers } from './formats/writers'
import css from './take-away.css?inline'

export const styles = css

/** A panel that is opened for its figure has its code to load first. */
const FIGURE_PATIENCE_MS = 5000

/** One line of the list: its title, and the buttons. */
interface Row {
  readonly title: string
  readonly note: string
  /** True if it needs a report. */
  readonly needsReport?: true
  /** A text, to copy and, where it has a file's name, to save. */
  readonly text?: () => string
  readonly file?: { readonly extension: string; readonly mediaType: string }
  /** A file to save. */
  readonly save?: () => Promise<void>
}

class TakeAwayView implements View {
  readonly root = document.createElement('div')
  readonly #context: ViewContext
  readonly #rows: readonly Row[]
  #report: Report | null = null
  /** The last thing done; reported until the element is another. */
  #done: { readonly title: string; readonly vertices: Vertices; readonly message: string } | null = null

  constructor(context: ViewContext) {
    this.#context = context
    this.root.className = 'take-away'
    this.#rows = [
      { title: 'PNG', note: 'the scene; dropped here it opens this element again', save: () => this.#savePng() },
      {
        title: 'SVG',
        note: 'the scene: lines and words over a picture of the faces',
        save: () => this.#saveSvg('scene'),
      },
      {
        title: 'SVG of the face maps',
        note: 'the six faces unfolded, likewise',
        save: () => this.#saveSvg('face-maps'),
      },
      ...(context.permalink() === null
        ? []
        : [{ title: 'Link', note: 'opens this very element', text: () => context.permalink() ?? '' }]),
      {
        title: 'Minimum',
        note: 'jacdet in all digits, on the cube chosen',
        needsReport: true,
        text: () => this.#inFull(report => report.boundaryMinimum),
      },
      {
        title: 'Maximum',
        note: 'of the boundary, likewise',
        needsReport: true,
        text: () => this.#inFull(report => report.boundaryMaximum),
      },
      {
        title: 'Report',
        note: 'JSON, every number of it',
        needsReport: true,
        text: () => (this.#report ? reportJson(this.#report, this.#name, version) : ''),
        file: { extension: 'json', mediaType: 'application/json' },
      },
      ...writers.map(({ title, note, write, ...file }) => ({
        title,
        note,
        text: () => write(context.state().vertices, this.#name),
        file,
      })),
      {
        title: 'BibTeX',
        note: 'the paper behind the verdict',
        text: () => bibtex,
        file: { extension: 'bib', mediaType: 'application/x-bibtex' },
      },
    ]
  }

  #inFull(value: (report: Report) => number): string {
    const report = this.#report
    return report ? jacdetInFull(value(report), report.exponent, this.#context.state().referenceCube) : ''
  }

  update({ report, state }: Frame): void {
    this.#report = report
    if (this.#done?.vertices !== state.vertices) this.#done = null
    const without = report === null
    if (isNew(this.root, without, this.#done)) render(this.#template(without), this.root)
  }

  dispose(): void {}

  #template(without: boolean): TemplateResult {
    return html`<ul>${this.#rows.map(row => this.#row(row, without))}</ul>
      <p aria-live="polite">${this.#done?.message ?? ''}</p>`
  }

  #row(row: Row, without: boolean): TemplateResult {
    const { title, note, text, file, save } = row
    const button = (word: string, act: () => Promise<void>) => {
      const isDone = this.#done?.title === title && this.#done.message.startsWith(word === 'Copy' ? 'Copied' : 'Saved')
      const shown = isDone && word === 'Copy' ? 'Copied' : word
      return html`<button type="button" ?disabled=${without && row.needsReport} aria-label=${`${shown} ${title}`} @click=${act}>${shown}</button>`
    }
    return html`<li>
      <span>${title} <span class="note">${note}</span></span>
      <span class="actions">
        ${text ? button('Copy', () => this.#copy(title, text())) : ''}
        ${text && file ? button('Download', () => this.#save(title, text(), file.extension, file.mediaType)) : ''}
        ${save ? button('Download', () => this.#trying(title, save)) : ''}
      </span>
    </li>`
  }

  /** The name of files, and in files. */
  get #name(): string {
    const { preset, start, vertices } = this.#context.state()
    return preset !== null && start === vertices ? preset : 'hexahedron'
  }

  #tell(title: string, message: string): void {
    this.#done = { title, vertices: this.#context.state().vertices, message }
    this.#context.requestFrame()
  }

  async #copy(title: string, text: string): Promise<void> {
    const copied = await copyText(text)
    this.#tell(title, copied ? `Copied: ${title}.` : 'The browser does not allow copying here.')
  }

  async #save(
    title: string,
    content: BlobPart,
    extension: string,
    mediaType: string,
    stem = this.#name,
  ): Promise<void> {
    const name = title === 'BibTeX' ? 'zhang-hexahedra.bib' : `${stem}.${extension}`
    saveFile(name, content, mediaType)
    this.#tell(title, `Saved as ${name}.`)
  }

  async #trying(title: string, save: () => Promise<void>): Promise<void> {
    try {
      await save()
    } catch (reason) {
      this.#tell(title, `This could not be drawn (${reason instanceof Error ? reason.message : reason}).`)
    }
  }

  async #savePng(): Promise<void> {
    const { vertices } = this.#context.state()
    const name = this.#name
    const picture = await figurePng(await this.#figure('scene'), vertices)
    await this.#save('PNG', picture, 'png', 'image/png', name)
  }

  async #saveSvg(which: FigureName): Promise<void> {
    const { vertices } = this.#context.state()
    const name = this.#name
    const text = figureSvg(await this.#figure(which), vertices, name)
    const title = which === 'scene' ? 'SVG' : 'SVG of the face maps'
    await this.#save(title, text, 'svg', 'image/svg+xml', which === 'scene' ? name : `${name}-face-maps`)
  }

  /** Opens the panel of a figure that is not on the page yet. */
  async #figure(name: FigureName): Promise<Figure> {
    let figure = this.#context.figure(name)
    if (figure === null && name === 'face-maps') {
      this.#context.dispatch({ type: 'open-panel', panel: name, isOpen: true })
      const until = performance.now() + FIGURE_PATIENCE_MS
      while (figure === null && performance.now() < until) {
        await new Promise(requestAnimationFrame)
        figure = this.#context.figure(name)
      }
    }
    if (figure === null) throw new Error('it is not on the page')
    return figure
  }
}

export const create: CreateView = context => new TakeAwayView(context)
