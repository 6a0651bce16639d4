/**
 * The fragment of the address of the page Challenges: one of its own challenges by id, a teacher's as
 * JSON in percent-encoding, or a series as series-code.ts writes it and which of its challenges; with
 * it, as in any link of Hexlens, the 24 doubles of an element bit for bit.
 *
 *     #challenge=one-vertex        #challenge=one-vertex&v=1&vertices=0,0,0,…        #own=%7B%22version%22…
 *     #series=q1YqSy0q…&at=2       #write
 */
import type { Vertices } from '../../model/hexahedron'
import { decodePermalink, encodePermalink, percentDecoded } from '../../model/permalink'
import type { Result } from '../../model/result'

export type ChallengeAddress =
  | { readonly kind: 'list' }
  | { readonly kind: 'write' }
  | { readonly kind: 'challenge'; readonly id: string; readonly vertices: Vertices | null }
  | { readonly kind: 'own'; readonly json: string; readonly vertices: Vertices | null }
  | {
      readonly kind: 'series'
      readonly code: string
      /** From 0. */
      readonly at: number
      readonly vertices: Vertices | null
    }

/** The fragment without its '#'. Throws RangeError unless given 24 finite numbers, or none. */
export function challengeFragment(address: ChallengeAddress): string {
  if (address.kind === 'list') return ''
  if (address.kind === 'write') return 'write'
  const what = subject(address)
  return address.vertices ? `${what}&${encodePermalink(address.vertices)}` : what
}

function subject(address: Exclude<ChallengeAddress, { kind: 'list' | 'write' }>): string {
  if (address.kind === 'own') return `own=${encodeURIComponent(address.json)}`
  if (address.kind === 'challenge') return `challenge=${address.id}`
  return `series=${address.code}${address.at > 0 ? `&at=${address.at + 1}` : ''}`
}

/** The fragment with or without its '#'. */
export function readChallengeAddress(fragment: string): Result<ChallengeAddress, string> {
  const text = fragment.replace(/^#/, '')
  if (text === '') return { ok: true, value: { kind: 'list' } }
  if (text === 'write') return { ok: true, value: { kind: 'write' } }
  const [, what, given, at, link] = /^(challenge|own|series)=([^&]+)(?:&at=(\d+))?(?:&(.*))?$/s.exec(text) ?? []
  if (given === undefined)
    return broken('it should begin with challenge=, own= or series=, and what comes then should not be empty')
  const value = percentDecoded(given)
  if (value === null) return broken('its percent-encoding is cut off or not UTF-8')
  if (at !== undefined && what !== 'series') return broken('only a series has at=')
  const solution = link === undefined ? null : decodePermalink(link)
  if (solution?.ok === false) return { ok: false, error: solution.error.message }
  const vertices = solution?.value ?? null
  if (what === 'series')
    return { ok: true, value: { kind: 'series', code: value, at: Math.max(0, Number(at ?? 1) - 1), vertices } }
  return {
    ok: true,
    value: what === 'own' ? { kind: 'own', json: value, vertices } : { kind: 'challenge', id: value, vertices },
  }
}

function broken(why: string): Result<ChallengeAddress, string> {
  return { ok: false, error: `The link is broken: ${why}.` }
}

/** A link of the page that is open. */
export function linkTo(address: ChallengeAddress): string {
  const url = new URL(location.href)
  url.hash = challengeFragment(address)
  return url.href
}

/** Longer links are cut off by some programs that hand them on. */
const LONG_LINK = 8000

/** A sentence on a link that some programs cut off; empty of a shorter one. */
export function lengthWarning(link: string): string {
  return link.length > LONG_LINK
    ? `The link has ${link.length} characters. Some mail and chat programs cut links off after ${LONG_LINK}: try it before you hand it on.`
    : ''
}
