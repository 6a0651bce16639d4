/**
 * How the scene's box is shared, and where things are in the element's pane, in units. A unit is a CSS pixel, or more where the
 * text is larger, so that marks and words grow with the text and a figure looks alike on any screen.
 */

/** Text of this size in CSS pixels makes a unit one of them. */
export const TEXT_SIZE = 14

export interface Point {
  readonly x: number
  readonly y: number
}

export interface Box extends Point {
  readonly width: number
  readonly height: number
}

export interface Insets {
  readonly top: number
  readonly right: number
  readonly bottom: number
  readonly left: number
}

type Size = Pick<Box, 'width' | 'height'>

/** The element's pane. */
export interface PaneLayout extends Size {
  /** A phone's layout: the colour bar lies. */
  readonly isNarrow: boolean
  /** Too low for the legend. */
  readonly isLow: boolean
  /** The borders that a fitted element keeps free. */
  readonly insets: Insets
  readonly barLength: number
  /** Boxes of words that the overlay's own must not cover. */
  readonly taken: readonly Box[]
  /** The box of the readout while a point is marked; in a wide pane nothing else is ever there. */
  readonly readout: Box
}

/** Least width of a scene with the reference cube beside the element, else it is below it. */
const BESIDE = 560
/** In a lower scene it is beside it, too: below it one would have to scroll to see it. */
const TOO_LOW = 440
/** A narrower pane has a phone's layout. */
const NARROW = 560
/** In a narrower pane the legend has a row of its own. */
const LEGEND_BESIDE = 58 * TEXT_SIZE
/** In a narrower pane the buttons have two rows. */
const BUTTONS_BESIDE = 330
/** Heights of the controls in rows. */
const CONTROLS = [44, 66, 98] as const
/** In a lower pane everything but the element makes way for it. */
const LOW = 340
/** A lower pane keeps hardly anything free. */
const LOWEST = 230
const TRIAD = { x: 0, y: 0, width: 84, height: 84 }
/** From line to line of the readout. */
export const READOUT_LINE = 17

export class Layout {
  /** CSS pixels of one unit. */
  unit = 1
  whole: Size = { width: 0, height: 0 }
  pane = paneLayout(0, 0)
  readonly #root: HTMLElement
  readonly #pane: HTMLElement

  /** `root` is the scene, `pane` the element's share of it. */
  constructor(root: HTMLElement, pane: HTMLElement) {
    this.#root = root
    this.#pane = pane
  }

  get isEmpty(): boolean {
    return this.pane.width === 0 || this.pane.height === 0
  }

  /** Returns whether the pane has another size than before. `isSplit` says whether it shares the scene with the reference cube. */
  measure(isSplit: boolean): boolean {
    const [root, pane] = [this.#root, this.#pane]
    const unit = Number.parseFloat(getComputedStyle(root).fontSize) / TEXT_SIZE
    this.unit = unit
    this.whole = { width: root.clientWidth / unit, height: root.clientHeight / unit }
    root.dataset.split = isSplit ? this.#split() : 'none'
    const isTight = root.dataset.split === 'beside' && this.whole.width < BESIDE
    root.classList.toggle('tight', isTight)
    const [width, height] = [pane.offsetWidth / unit, pane.offsetHeight / unit]
    if (width === this.pane.width && height === this.pane.height) return false
    this.pane = paneLayout(width, height, isTight)
    root.classList.toggle('narrow', this.pane.isNarrow)
    root.classList.toggle('low', this.pane.isLow)
    return true
  }

  /** With the cube below the element the box is higher, and it stays below. */
  #split(): 'beside' | 'below' {
    const { width, height } = this.whole
    const isLow = height < TOO_LOW && this.#root.dataset.split !== 'below'
    return width >= BESIDE || isLow ? 'beside' : 'below'
  }
}

/** A tight scene has no triad here. */
function paneLayout(width: number, height: number, isTight = false): PaneLayout {
  const isNarrow = width < NARROW
  const isLow = height < LOW
  const barLength = Math.round(Math.max(90, isNarrow ? Math.min(200, width - 210) : Math.min(220, height * 0.3)))
  const bar = isNarrow ? { width, height: 56 } : { width: 140, height: barLength + 64 }
  const controls = CONTROLS[(isLow || width >= LEGEND_BESIDE ? 0 : 1) + (width >= BUTTONS_BESIDE ? 0 : 1)] as number
  // Right of the triad; in a narrow pane below the colour bar.
  const readout = {
    x: isTight ? 14 : 92,
    y: (isNarrow ? 62 : 18) - READOUT_LINE / 2,
    width: 260,
    height: (isNarrow ? 2 : 3) * READOUT_LINE,
  }
  return {
    width,
    height,
    isNarrow,
    isLow,
    insets: insetsOf(isNarrow, height, controls),
    barLength,
    taken: [
      { ...bar, x: width - bar.width, y: 0 },
      { x: 0, y: height - controls, width, height: controls },
      TRIAD,
      ...(isNarrow ? [] : [readout]),
    ],
    readout,
  }
}

function insetsOf(isNarrow: boolean, height: number, controls: number): Insets {
  if (height < LOWEST && isNarrow) return { top: 68, right: 36, bottom: controls + 10, left: 36 }
  if (height < LOW)
    return isNarrow
      ? { top: 76, right: 36, bottom: controls + 16, left: 36 }
      : { top: 44, right: 156, bottom: 60, left: 92 }
  return isNarrow
    ? { top: 110, right: 36, bottom: controls + 46, left: 36 }
    : { top: 64, right: 156, bottom: controls + 28, left: 92 }
}
