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
import { say } from '../../words/say'
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
  #done: {
    readonly title: string
    readonly vertices: Vertices
    readonly message: string
    readonly isCopied: boolean
  } | null = null

  constructor(context: ViewContext) {
    this.#context = context
    this.root.className = 'take-away'
    this.#rows = [
      { title: 'PNG', note: say('the scene; dropped here it opens this element again'), save: () => this.#savePng() },
      {
        title: 'SVG',
        note: say('the scene: lines and words over a picture of the faces'),
        save: () => this.#saveSvg('scene'),
      },
      {
        title: say('SVG of the face maps'),
        note: say('the six faces unfolded, likewise'),
        save: () => this.#saveSvg('face-maps'),
      },
      ...(context.permalink() === null
        ? []
        : [{ title: say('Link'), note: say('opens this very element'), text: () => context.permalink() ?? '' }]),
      {
        title: say('Minimum'),
        note: say('jacdet in all digits, on the cube chosen'),
        needsReport: true,
        text: () => this.#inFull(report => report.boundaryMinimum),
      },
      {
        title: say('Maximum'),
        note: say('of the boundary, likewise'),
        needsReport: true,
        text: () => this.#inFull(report => report.boundaryMaximum),
      },
      {
        title: say('Report'),
        note: say('JSON, every number of it'),
        needsReport: true,
        text: () => (this.#report ? reportJson(this.#report, this.#name, version) : ''),
        file: { extension: 'json', mediaType: 'application/json' },
      },
      ...writers.map(({ title, note, write, ...file }) => ({
        title,
        note: say(note),
        text: () => write(context.state().vertices, this.#name),
        file,
      })),
      {
        title: 'BibTeX',
        note: say('the paper behind the verdict'),
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
    const button = (word: string, name: string, act: () => Promise<void>) =>
      html`<button type="button" ?disabled=${without && row.needsReport} aria-label=${name} @click=${act}>${word}</button>`
    const download = (act: () => Promise<void>) => button(say('Download'), say('Download {title}', { title }), act)
    const isCopied = this.#done?.title === title && this.#done.isCopied
    return html`<li>
      <span>${title} <span class="note">${note}</span></span>
      <span class="actions">
        ${
          text
            ? button(
                isCopied ? say('Copied') : say('Copy'),
                isCopied ? say('Copied {title}', { title }) : say('Copy {title}', { title }),
                () => this.#copy(title, text()),
              )
            : ''
        }
        ${text && file ? download(() => this.#save(title, text(), file.extension, file.mediaType)) : ''}
        ${save ? download(() => this.#trying(title, save)) : ''}
      </span>
    </li>`
  }

  /** The name of files, and in files. */
  get #name(): string {
    const { preset, start, vertices } = this.#context.state()
    return preset !== null && start === vertices ? preset : 'hexahedron'
  }

  #tell(title: string, message: string, isCopied = false): void {
    this.#done = { title, vertices: this.#context.state().vertices, message, isCopied }
    this.#context.requestFrame()
  }

  async #copy(title: string, text: string): Promise<void> {
    const [copied, refused] = [say('Copied: {what}.', { what: title }), say('The browser does not allow copying here.')]
    const isCopied = await copyText(text)
    this.#tell(title, isCopied ? copied : refused, isCopied)
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
    this.#tell(title, say('Saved as {file}.', { file: name }))
  }

  async #trying(title: string, save: () => Promise<void>): Promise<void> {
    try {
      await save()
    } catch (reason) {
      const why = reason instanceof Error ? reason.message : String(reason)
      this.#tell(title, say('This could not be drawn ({why}).', { why }))
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
    const title = which === 'scene' ? 'SVG' : say('SVG of the face maps')
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
    if (figure === null) throw new Error(say('it is not on the page'))
    return figure
  }
}

export const create: CreateView = context => new TakeAwayView(context)
