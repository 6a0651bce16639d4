/** All ways by which a mesh comes to the page: buttons for files, a folder and the clipboard, drop and paste. */
import { html, nothing, type TemplateResult } from 'lit-html'
import { ofFolder, unfolded } from '../../input/dropped-folders'
import { droppedIn, type PastedInput, pastedIn, takesDrop } from '../../input/pasted-input'
import { ALL_FORMATS } from './page-words'
import { isSettingsText } from './settings-text'

export interface DoorHost {
  open(input: PastedInput): void
  /** Settings of a picture, as a text. */
  use(settings: string): void
  /** Why nothing comes. */
  say(sentence: string): void
}

export class InputDoor {
  readonly #host: DoorHost
  readonly #files = document.createElement('input')
  /** Null where the browser opens no folders. */
  readonly #folders: HTMLInputElement | null

  constructor(host: DoorHost) {
    this.#host = host
    Object.assign(this.#files, { type: 'file', multiple: true, hidden: true })
    this.#files.addEventListener('change', () => {
      const files = takenFrom(this.#files)
      if (files.length > 0) host.open({ files })
    })
    this.#folders = this.#folderInput()
    this.#listen()
  }

  get buttons(): TemplateResult {
    const folders = this.#folders
    return html`<button type="button" class="open" title=${ALL_FORMATS} @click=${() => this.#files.click()}>Open files</button>
      ${folders === null ? nothing : html`<button type="button" class="folder" title="For example one of time steps" @click=${() => folders.click()}>Open a folder</button>`}
      <button type="button" @click=${() => this.#paste()}>Paste</button>
      ${this.#files}`
  }

  #folderInput(): HTMLInputElement | null {
    const input = document.createElement('input')
    if (!('webkitdirectory' in input)) return null
    Object.assign(input, { type: 'file', webkitdirectory: true })
    input.addEventListener('change', () => {
      const given = ofFolder(takenFrom(input))
      if ('files' in given && given.files.length > 0) this.#host.open(given)
      else this.#host.say('There are no files in this folder.')
    })
    return input
  }

  async #paste(): Promise<void> {
    try {
      const text = await navigator.clipboard.readText()
      if (text.trim() === '') this.#host.say('The clipboard has no text.')
      else this.#take({ text })
    } catch {
      this.#host.say('This browser does not let the page read the clipboard: press Ctrl+V instead.')
    }
  }

  #take(input: PastedInput): void {
    if ('text' in input && isSettingsText(input.text)) this.#host.use(input.text)
    else this.#host.open(input)
  }

  #listen(): void {
    document.addEventListener('paste', event => {
      const input = pastedIn(event)
      if (input) this.#take(input)
    })
    document.addEventListener('dragover', event => {
      if (!takesDrop(event) || !event.dataTransfer) return
      event.preventDefault()
      event.dataTransfer.dropEffect = 'copy'
      document.body.classList.add('is-drop-target')
    })
    for (const type of ['dragleave', 'drop', 'dragend'])
      document.addEventListener(type, () => document.body.classList.remove('is-drop-target'))
    document.addEventListener('drop', async event => {
      const input = droppedIn(event)
      if (!input) return
      const whole = await Promise.resolve(unfolded(event, input)).catch(() => null)
      if (whole) this.#host.open(whole)
      else this.#host.say('The folder could not be read.')
    })
  }
}

/** The files that were chosen; the same may be chosen again. */
function takenFrom(input: HTMLInputElement): File[] {
  const files = [...(input.files ?? [])]
  input.value = ''
  return files
}
