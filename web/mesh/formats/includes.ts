/** Files that others name as parts of themselves. */
import type { ReadOptions } from '../source'
import { shown } from '../text-cursor'
import { TextLines } from './text-lines'

const DEEPEST = 16

/** The lines of the file that `keyword` includes at this depth; refuses one that is missing. */
export function includedLines(
  lines: TextLines,
  options: ReadOptions,
  keyword: string,
  name: string,
  depth: number,
): TextLines {
  if (depth >= DEEPEST) lines.refuse(`${keyword} of ${shown(name)}: files are included ${DEEPEST} deep.`)
  const file = options.find(name)
  if (file === null) lines.refuse(`${keyword} names ${shown(name)}, which is missing: give it together with this file.`)
  return new TextLines(file, options)
}
