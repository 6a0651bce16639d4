/** The element as files and texts for elsewhere: pictures, the report, other programs' formats, a link, the paper. */
import { html, render, type TemplateResult } from 'lit-html'
import { version } from '../../../package.json'
import type { Report } from '../../core/report'
import { reportJson } from '../../core/report-json'
import { jacdetInFull } from '../../model/decimal'
import { encodePermalink } from '../../model/permalink'
import { PNG_KEYWORD, withText } from '../../model/png-text'
import { copyText } from '../../views/copy-text'
import { saveFile } from '../../views/save-file'
import type { CreateView, Figure, FigureName, Frame, View, ViewHost } from '../../views/view'
import { figurePng, figureSvg } from './figure-files'
import { bibtex } from './formats/bibtex'
import { writers } from './formats/writers'
import css from './take-away.css?inline'

export const styles = css

/** A panel that is opened for its figure has its code to load first. */
const FIGURE_PATIENCE_MS = 5000

/** One line of the list: what it is, and how to have it. */
interface Row {
  readonly title: string
  readonly note: string
  /** There is nothing to have while the core gives no report. */
  readonly needsReport?: true
  /** A text, to copy and, where it has a file's name, to save. */
  readonly text?: () => string
  readonly file?: { readonly extension: string; readonly mediaType: string }
  /** Something else to save. */
  readonly save?: () => Promise<void>
}

class TakeAwayView implements View {
  readonly root = document.createElement('div')
  readonly #host: ViewHost
  readonly #rows: readonly Row[]
  #report: Report | null = null
  #drawnWithout: boolean | null = null
  /** What was done last; told until the element is another. */
  #done: { readonly title: string; readonly link: string; readonly message: string } | null = null
  #isDoneDrawn = true

  constructor(host: ViewHost) {
    this.#host = host
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
      { title: 'Link', note: 'opens this very element', text: () => host.permalink() },
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
        text: () => write(host.state().vertices, this.#name),
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
    return report ? jacdetInFull(value(report), report.exponent, this.#host.state().referenceCube) : ''
  }

  update({ report }: Frame): void {
    this.#report = report
    if (this.#done && this.#done.link !== this.#host.permalink()) {
      this.#done = null
      this.#isDoneDrawn = false
    }
    const without = report === null
    if (this.#isDoneDrawn && without === this.#drawnWithout) return
    this.#isDoneDrawn = true
    this.#drawnWithout = without
    render(this.#template(without), this.root)
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

  /** Of files and names in files. */
  get #name(): string {
    const { preset, start, vertices } = this.#host.state()
    return preset !== null && start === vertices ? preset : 'hexahedron'
  }

  #tell(title: string, message: string): void {
    this.#done = { title, link: this.#host.permalink(), message }
    this.#isDoneDrawn = false
    this.#host.requestFrame()
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
    const fragment = encodePermalink(this.#host.state().vertices)
    const name = this.#name
    const picture = await figurePng(await this.#figure('scene'))
    await this.#save('PNG', withText(picture, PNG_KEYWORD, fragment), 'png', 'image/png', name)
  }

  async #saveSvg(which: FigureName): Promise<void> {
    const fragment = encodePermalink(this.#host.state().vertices)
    const name = this.#name
    const text = figureSvg(await this.#figure(which), name, fragment)
    const title = which === 'scene' ? 'SVG' : 'SVG of the face maps'
    await this.#save(title, text, 'svg', 'image/svg+xml', which === 'scene' ? name : `${name}-face-maps`)
  }

  /** What is not on the page yet is put there first. */
  async #figure(name: FigureName): Promise<Figure> {
    let figure = this.#host.figure(name)
    if (figure === null && name === 'face-maps') {
      this.#host.dispatch({ type: 'open-panel', panel: name, isOpen: true })
      const until = performance.now() + FIGURE_PATIENCE_MS
      while (figure === null && performance.now() < until) {
        await new Promise(requestAnimationFrame)
        figure = this.#host.figure(name)
      }
    }
    if (figure === null) throw new Error('it is not on the page')
    return figure
  }
}

export const create: CreateView = host => new TakeAwayView(host)
