/** Sentences about the last input. */

import type { ReadCells, Reading } from '../../input/reading'
import { shown } from '../../mesh/shown'
import type { NodeOrder } from '../../model/node-orders'
import { say } from '../../words/say'

export function statusSentence(reading: Reading): string {
  if (reading.state === 'refused') return reading.message
  if (reading.state === 'under-way') {
    const name = reading.name === 'the text' ? say('the text') : shown(reading.name)
    if (reading.step === 'loading') return say('Loading the HDF5 reader, 1 MB …')
    const step =
      reading.step === 'reading' ? say('Reading {name} …', { name }) : say('Deciding the cells of {name} …', { name })
    return reading.fraction > 0 ? `${step} ${Math.floor(100 * Math.min(reading.fraction, 1))} %` : step
  }
  const { cells, summary } = reading
  const { format } = summary
  if (cells.count > 1) return `${summary.headline} ${say('Read as {format}.', { format })}`
  return cells.hasIds
    ? say('Read as {format}, cell {cell}.', { format, cell: cells.at(0).id })
    : say('Read as {format}.', { format })
}

/** Notes, without those on the text's node order if another one is used. */
export function notesOf({ summary }: ReadCells, order: NodeOrder | null): readonly string[] {
  return order === null ? summary.sentences : summary.sentences.filter(note => !note.includes('order of the text'))
}
