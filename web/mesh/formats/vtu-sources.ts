/** Files that a .pvd or a .pvtu names. */
import type { MeshFile, ReadOptions } from '../source'
import { XmlScanner } from '../xml-scanner'
import { COLLECTION, scanDocument, type VtkDocument } from './vtu-document'

export interface NamedStep {
  /** As it stands in the file. */
  readonly time: string
  readonly files: readonly string[]
}

/** The time steps of a .pvd, in the order of their times, or as they come where one is no number. */
export function stepsOf({ sources }: VtkDocument): readonly NamedStep[] {
  const steps = new Map<string, string[]>()
  for (const { attributes } of sources) {
    const time = attributes.get('timestep') ?? '0'
    steps.set(time, [...(steps.get(time) ?? []), attributes.get('file') ?? ''])
  }
  const named = [...steps].map(([time, files]) => ({ time, files }))
  const isTime = ({ time }: NamedStep) => time.trim() !== '' && Number.isFinite(Number(time))
  return named.every(isTime) ? named.sort((a, b) => Number(a.time) - Number(b.time)) : named
}

export function piecesOf({ sources }: VtkDocument): readonly string[] {
  return sources.map(({ attributes }) => attributes.get('Source') ?? '')
}

/** Null for a file that is no .pvd. Throws a MeshRefusal for one that is damaged. */
export function collectionSteps(file: MeshFile, options: ReadOptions): readonly NamedStep[] | null {
  const document = scanDocument(new XmlScanner(file), file, options)
  return document?.type === COLLECTION ? stepsOf(document) : null
}

/** Names of the pieces of a .pvtu; none for any other file. Throws a MeshRefusal for one that is damaged. */
export function pieceNames(file: MeshFile, options: ReadOptions): readonly string[] {
  if (!/\.pvtu$/i.test(file.name)) return []
  const document = scanDocument(new XmlScanner(file), file, options)
  return document === null ? [] : piecesOf(document)
}
