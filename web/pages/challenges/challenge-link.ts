/**
 * The fragment of the address of the page Challenges: one of its own challenges by id, or a
 * teacher's as JSON in percent-encoding; with it, as in any link of Hexlens, the 24 doubles of a
 * solution bit for bit.
 *
 *     #challenge=one-vertex        #challenge=one-vertex&v=1&vertices=0,0,0,…        #own=%7B%22version%22…        #write
 */
import type { Vertices } from '../../model/hexahedron'
import { decodePermalink, encodePermalink, percentDecoded } from '../../model/permalink'
import type { Result } from '../../model/result'

export type ChallengeAddress =
  | { readonly kind: 'list' }
  | { readonly kind: 'write' }
  | { readonly kind: 'challenge'; readonly id: string; readonly vertices: Vertices | null }
  | { readonly kind: 'own'; readonly json: string; readonly vertices: Vertices | null }

/** The fragment without its '#'. Throws RangeError unless given 24 finite numbers, or none. */
export function challengeFragment(address: ChallengeAddress): string {
  if (address.kind === 'list') return ''
  if (address.kind === 'write') return 'write'
  const what = address.kind === 'own' ? `own=${encodeURIComponent(address.json)}` : `challenge=${address.id}`
  return address.vertices ? `${what}&${encodePermalink(address.vertices)}` : what
}

/** The fragment with or without its '#'. */
export function readChallengeAddress(fragment: string): Result<ChallengeAddress, string> {
  const text = fragment.replace(/^#/, '')
  if (text === '') return { ok: true, value: { kind: 'list' } }
  if (text === 'write') return { ok: true, value: { kind: 'write' } }
  const [, what, given, link] = /^(challenge|own)=([^&]+)(?:&(.*))?$/s.exec(text) ?? []
  if (given === undefined)
    return broken('it should begin with challenge= or own=, and what comes then should not be empty')
  const value = percentDecoded(given)
  if (value === null) return broken('its percent-encoding is cut off or not UTF-8')
  const solution = link === undefined ? null : decodePermalink(link)
  if (solution?.ok === false) return { ok: false, error: solution.error.message }
  const vertices = solution?.value ?? null
  return {
    ok: true,
    value: what === 'own' ? { kind: 'own', json: value, vertices } : { kind: 'challenge', id: value, vertices },
  }
}

function broken(why: string): Result<ChallengeAddress, string> {
  return { ok: false, error: `The link is broken: ${why}.` }
}
