/** Events of `<hex-lens>`, and listeners whose types follow from their names. `npm run reference` reads what each means. */
import type { CameraView } from '../model/state'
import type { ChangeDetail } from './changes'

/** A point of the element that is pointed at. */
export interface ProbeDetail {
  /** (xi, eta, zeta) in [0,1]^3. */
  readonly point: readonly [number, number, number]
  /** Its image in space. */
  readonly position: readonly [number, number, number]
  /** jacdet there on [0,1]^3, times 2^exponent. */
  readonly jacdet: number
  /** 0 unless the element is huge or tiny. */
  readonly exponent: number
}

export interface HexLensEventMap {
  /**
   * The vertices have changed. At most once a frame, also during a drag. The detail of this and the
   * next two is `{ vertices, valid, boundaryMinimum, source }`: 24 numbers, a verdict and a number or
   * null, and whose the change is: `pointer`, `keyboard`, `field`, `panel`, `preset`, `paste`,
   * `history` (undo, redo, reset) or `program` (the page).
   */
  'hex-input': CustomEvent<ChangeDetail>
  /**
   * A change of the vertices is done: a drag has ended, or a number was entered. Not for what the
   * page itself has set, as with native inputs.
   */
  'hex-change': CustomEvent<ChangeDetail>
  /** The first verdict, and each one that differs from the one before. */
  'hex-verdict': CustomEvent<ChangeDetail>
  /** Everything in sight is drawn for the first time since the element came into the page. */
  'hex-ready': CustomEvent<null>
  /**
   * The camera has moved, by the reader or a program; the detail is `camera` as it is now. At most
   * once a frame. One that is given back changes nothing and is not told.
   */
  'hex-camera': CustomEvent<CameraView>
  /**
   * What is pointed at: its reference coordinates, its position and jacdet there; null when the
   * pointer leaves. At most once a frame.
   */
  'hex-probe': CustomEvent<ProbeDetail | null>
  /** There is a list of so many cells to choose from, and this is what it was read from; null when it is put away. */
  'hex-list': CustomEvent<{ text: string; cells: number } | { files: File[]; cells: number } | null>
  /**
   * Something does not work, and `message` says so in a sentence. The codes: an attribute, a
   * property or a call that is not understood (`bad-vertices`, `bad-highlight` and so on), which then
   * changes nothing, `core-failed`, `no-webgl`, `context-lost`, `input-refused`, `not-read`.
   */
  'hex-error': CustomEvent<{ code: string; message: string }>
}

/** An element that tells these events. */
export interface TellingElement<EventMap = HexLensEventMap> extends HTMLElement {
  addEventListener<Name extends keyof EventMap & string>(
    type: Name,
    listener: (this: this, event: EventMap[Name]) => unknown,
    options?: boolean | AddEventListenerOptions,
  ): void
  addEventListener<Name extends keyof HTMLElementEventMap>(
    type: Name,
    listener: (this: this, event: HTMLElementEventMap[Name]) => unknown,
    options?: boolean | AddEventListenerOptions,
  ): void
  addEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | AddEventListenerOptions,
  ): void
  removeEventListener<Name extends keyof EventMap & string>(
    type: Name,
    listener: (this: this, event: EventMap[Name]) => unknown,
    options?: boolean | EventListenerOptions,
  ): void
  removeEventListener<Name extends keyof HTMLElementEventMap>(
    type: Name,
    listener: (this: this, event: HTMLElementEventMap[Name]) => unknown,
    options?: boolean | EventListenerOptions,
  ): void
  removeEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | EventListenerOptions,
  ): void
}
