/** What goes where in the element's own part of the scene, in units, by the room there is. */
import type { Box } from '../overlay/label-place'
import { readoutBox } from '../overlay/readout'
import type { Insets } from './camera'

export interface Layout {
  /** Laid out for a phone: the colour bar lies. */
  readonly isNarrow: boolean
  /** Too low for the words that say what the marks mean. */
  readonly isLow: boolean
  /** Kept free of the fitted element. */
  readonly insets: Insets
  readonly barLength: number
  /** What words other than the overlay's stand on. */
  readonly taken: readonly Box[]
  /** What the words about a point stand on while it is pointed at; where there is room, nothing else ever does. */
  readonly readout: Box
}

/** Below this width the scene is laid out for a phone. */
const NARROW = 560
/** Below this height what is not the element makes way for it. */
const LOW = 340
/** Below this one hardly anything is kept free. */
const LOWEST = 230
const TRIAD = { x: 0, y: 0, width: 84, height: 84 }

export function layoutOf(width: number, height: number): Layout {
  const isNarrow = width < NARROW
  const isLow = height < LOW
  const barLength = Math.round(Math.max(90, isNarrow ? Math.min(200, width - 210) : Math.min(220, height * 0.3)))
  const bar = isNarrow ? { width, height: 56 } : { width: 140, height: barLength + 64 }
  const controls = isNarrow && !isLow ? 66 : 44
  const readout = readoutBox(isNarrow)
  return {
    isNarrow,
    isLow,
    insets: insetsOf(isNarrow, height),
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

function insetsOf(isNarrow: boolean, height: number): Insets {
  if (height < LOWEST && isNarrow) return { top: 62, right: 36, bottom: 54, left: 36 }
  if (height < LOW)
    return isNarrow ? { top: 76, right: 36, bottom: 60, left: 36 } : { top: 44, right: 156, bottom: 60, left: 92 }
  return isNarrow ? { top: 110, right: 36, bottom: 96, left: 36 } : { top: 64, right: 156, bottom: 72, left: 92 }
}
