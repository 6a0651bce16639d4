/**
 * A history as it is stored: the first element, and of each other what is not as in the one before.
 * A step moves a vertex or two, so that a thousand of them are a tenth as long as their elements.
 */
import type { HistoryDocument, HistoryElement } from '../model/history-document'

type Coordinates = HistoryElement['vertices']
/** An index, the coordinate there, and so on. */
type Difference = readonly Coordinates[number][]

interface Step {
  readonly vertices?: Difference
  readonly start?: Difference
  readonly preset?: string | null
}

export interface PackedHistory extends Omit<HistoryDocument, 'elements'> {
  readonly first: HistoryElement
  readonly steps: readonly Step[]
}

export function packed({ elements, ...others }: HistoryDocument): PackedHistory {
  const steps = elements.slice(1).map((element, i) => stepTo(element, elements[i] as HistoryElement))
  return { ...others, first: elements[0] as HistoryElement, steps }
}

/** Throws, or gives what the lens refuses, if it is no such history. */
export function unpacked({ first, steps, ...others }: PackedHistory): HistoryDocument {
  const elements = [first]
  for (const step of steps) elements.push(after(elements.at(-1) as HistoryElement, step))
  return { ...others, elements }
}

function stepTo({ vertices, start, preset }: HistoryElement, before: HistoryElement): Step {
  const [moved, begun] = [difference(before.vertices, vertices), difference(before.start, start)]
  return {
    ...(moved.length > 0 && { vertices: moved }),
    ...(begun.length > 0 && { start: begun }),
    ...(preset !== before.preset && { preset }),
  }
}

function after(before: HistoryElement, { vertices, start, preset = before.preset }: Step): HistoryElement {
  return { vertices: changed(before.vertices, vertices), start: changed(before.start, start), preset }
}

/** Minus zero is a text here, and so another value than zero. */
function difference(before: Coordinates, now: Coordinates): Difference {
  const all: Coordinates[number][] = []
  for (const [i, value] of now.entries()) if (value !== before[i]) all.push(i, value)
  return all
}

function changed(before: Coordinates, difference: Difference = []): Coordinates {
  const now = [...before]
  for (let i = 0; i < difference.length; i += 2) now[Number(difference[i])] = difference[i + 1] as Coordinates[number]
  return now
}
