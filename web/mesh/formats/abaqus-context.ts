/** The lines, part and frame that a keyword of Abaqus acts on, and the actions for the lines under it. */
import type { PrintedDigits } from '../precision'
import { shown } from '../text-cursor'
import type { Keyword } from './abaqus-keyword'
import type { AbaqusPart } from './abaqus-part'
import type { Frame } from './movement'
import type { TextLines } from './text-lines'

export interface Context {
  /** Lines of the file that is being read: an included one has its own. */
  lines: TextLines
  keyword: Keyword
  part: AbaqusPart
  /** The frame of *SYSTEM, in which nodes are given. */
  frame: Frame | null
  readonly precision: PrintedDigits
  readonly notes: string[]
}

/** Actions for each data line of a keyword, and at their end. */
export interface Section {
  readonly line: () => void
  readonly end?: () => void
}

/** The whole number that a parameter of the keyword has. */
export function wholeNumber({ keyword, lines }: Context, parameter: string): number {
  const text = keyword.parameters.get(parameter) ?? ''
  if (!/^[-+]?\d{1,15}$/.test(text))
    lines.refuse(`${shown(keyword.written)}: ${parameter} with a whole number was expected.`)
  return Number(text)
}
