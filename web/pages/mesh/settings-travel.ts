/** The settings on their way: in the page's address, on the clipboard, and into a mesh that is opened later. */
import type { Overview } from '../../survey/survey-jobs'
import { copyText } from '../../views/copy-text'
import { FIRST_SETTINGS } from './picture-settings'
import { FIRST_LISTING, isSettingsText, readSettings, settingsIn, settingsText, type Travelling } from './settings-text'

export interface TravelHost {
  /** As they are; null while no mesh is open. */
  now(): Travelling | null
  overview(): Overview | null
  use(fitting: Travelling): void
  say(notice: string): void
  /** The text in the address is another one. */
  written(): void
}

/** Milliseconds from a change to the address: some browsers allow 100 changes in 30 seconds. */
const AFTER = 500

export class SettingsTravel {
  readonly #host: TravelHost
  /** Settings of a mesh that is not open yet. */
  #waiting: Travelling | null = null
  #notice = ''
  #timer: ReturnType<typeof setTimeout> | undefined

  constructor(host: TravelHost) {
    this.#host = host
    this.#await(location.hash)
    addEventListener('hashchange', () => {
      if (isSettingsText(location.hash)) this.use(location.hash)
    })
    addEventListener('pagehide', () => this.#write())
  }

  /** What a mesh that has just been opened is shown with; null where nothing waits for it. `isExample` is true of one that nobody chose. */
  arrivingIn(overview: Overview, isExample: boolean): Travelling | null {
    const waiting = this.#waiting
    if (!waiting || (isExample && waiting.of !== overview.hexahedra)) return null
    this.#waiting = null
    if (waiting.of !== overview.hexahedra) {
      const [theirs, own] = [waiting.of, overview.hexahedra].map(count => count.toLocaleString('en'))
      this.#notice = `The address had settings of a mesh of ${theirs} hexahedra; this one has ${own}, so they are not used.`
      return null
    }
    const { fitting, unfit } = settingsIn(waiting, overview)
    this.#notice = unfit.join(' ')
    return fitting
  }

  /** A sentence about settings that have come or that wait, once. */
  takeNotice(): string {
    const notice = this.#waiting
      ? `The address has settings of a mesh of ${this.#waiting.of.toLocaleString('en')} hexahedra: open it, and they are used.`
      : this.#notice
    this.#notice = ''
    return notice
  }

  /** The mesh that is opened next is the same one, changed. */
  keep(): void {
    this.#waiting = this.#host.now()
  }

  get text(): string {
    const now = this.#host.now()
    return now ? settingsText(now) : ''
  }

  /** Settings that were pasted or typed, or came with an address, for the mesh that is open. */
  use(text: string): void {
    const overview = this.#host.overview()
    const read = readSettings(text)
    if (!read.ok) this.#host.say(read.error.message)
    if (!read.ok || !overview) return
    this.#waiting = null
    const { fitting, unfit } = settingsIn(read.value, overview)
    this.#host.use(fitting)
    this.#host.say(unfit.length > 0 ? unfit.join(' ') : 'These settings are used now.')
  }

  async copy(): Promise<void> {
    const isCopied = await copyText(this.text)
    this.#host.say(
      isCopied ? 'The settings are copied.' : 'This browser does not let the page copy: take the text from the field.',
    )
  }

  /** Something may have changed. */
  touch(): void {
    this.#timer ??= setTimeout(() => this.#write(), AFTER)
  }

  #await(hash: string): void {
    if (!isSettingsText(hash)) return
    const read = readSettings(hash)
    if (read.ok) this.#waiting = read.value
    else this.#notice = read.error.message
  }

  #write(): void {
    clearTimeout(this.#timer)
    this.#timer = undefined
    const now = this.#host.now()
    // Settings that wait stay in the address, for a reload as well.
    if (!now || this.#waiting) return
    const text = isFirst(now) ? '' : `#${settingsText(now)}`
    if (text === location.hash || (text === '' && !isSettingsText(location.hash))) return
    history.replaceState(history.state, '', text || `${location.pathname}${location.search}`)
    this.#host.written()
  }
}

function isFirst({ of, ...others }: Travelling): boolean {
  const first = { of, picture: FIRST_SETTINGS, block: null, camera: null, chosen: null, listing: FIRST_LISTING }
  return settingsText({ of, ...others }) === settingsText(first)
}
