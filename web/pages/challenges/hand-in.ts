/** The link that a student hands in: challenges, and of each an element bit for bit. */
import { written } from '../../model/document-readers'
import type { Vertices } from '../../model/hexahedron'
import { LIMITS, plainText } from './challenge'
import { linkTo } from './challenge-link'
import { type Member, SERIES_VERSION } from './series'
import { encodeSeries } from './series-code'

/** Throws Refusal if the name is no plain text. */
export async function handInLink(
  members: readonly Member[],
  elements: readonly (Vertices | null)[],
  studentName: string,
): Promise<string> {
  const trimmed = studentName.trim()
  const name = trimmed === '' ? {} : { name: plainText(LIMITS.title)(trimmed, 'Your name') }
  const code = await encodeSeries({
    version: SERIES_VERSION,
    challenges: members.map(({ document }) => document),
    handedIn: { ...name, elements: elements.map(vertices => vertices && written(vertices)) },
  })
  return linkTo({ kind: 'series', code, at: 0, vertices: null })
}
