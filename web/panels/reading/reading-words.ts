/** Sentences about the last input. */

import type { ReadCells, Reading } from '../../input/reading'
import { shown } from '../../mesh/shown'
import type { NodeOrder } from '../../model/node-orders'

export function statusSentence(reading: Reading): string {
  if (reading.state === 'refused') return reading.message
  if (reading.state === 'under-way') {
    const name = reading.name === 'the text' ? reading.name : shown(reading.name)
    const step = reading.step === 'reading' ? `Reading ${name}` : `Deciding the cells of ${name}`
    return reading.fraction > 0 ? `${step} … ${Math.floor(100 * Math.min(reading.fraction, 1))} %` : `${step} …`
  }
  const { cells, summary } = reading
  if (cells.count > 1) return `${summary.headline} Read as ${summary.format}.`
  return `Read as ${summary.format}${cells.hasIds ? `, cell ${cells.at(0).id}` : ''}.`
}

/** Notes, without those on the text's node order if another one is used. */
export function notesOf({ summary }: ReadCells, order: NodeOrder | null): readonly string[] {
  return order === null ? summary.sentences : summary.sentences.filter(note => !note.includes('order of the text'))
}

/** "lexicographic order", "the order “Top first”". */
export function orderPhrase({ name }: NodeOrder): string {
  const [, more] = /^Lexicographic(.*)$/.exec(name) ?? []
  if (more === undefined) return `the order “${name}”`
  return more === '' ? 'lexicographic order' : `lexicographic order${more},`
}
