/** Walks through a long text by words or lines without cutting all of it up first. */
import { Refused } from './format'
import { toDouble } from './numbers'

const SPACE = 32

export class Scanner {
  readonly #text: string
  #at: number

  constructor(text: string, at = 0) {
    this.#text = text
    this.#at = at
  }

  /** The next word; '' at the end. */
  word(): string {
    const text = this.#text
    let at = this.#at
    while (at < text.length && text.charCodeAt(at) <= SPACE) at++
    const from = at
    while (at < text.length && text.charCodeAt(at) > SPACE) at++
    this.#at = at
    return text.slice(from, at)
  }

  /** The next line that is not blank, trimmed; null at the end. */
  line(): string | null {
    while (this.#at < this.#text.length) {
      const end = this.#text.indexOf('\n', this.#at)
      const line = this.#text.slice(this.#at, end < 0 ? undefined : end).trim()
      this.#at = end < 0 ? this.#text.length : end + 1
      if (line !== '') return line
    }
    return null
  }

  /** The next word as a coordinate. */
  double(): number {
    const word = this.word()
    if (word === '') throw new Refused('The text ends in the middle of its coordinates.')
    return toDouble(word)
  }

  /** The next word as a count or an index. */
  integer(): number {
    const word = this.word()
    if (word === '') throw new Refused('The text ends in the middle of its cells.')
    return toInteger(word)
  }
}

export function toInteger(text: string): number {
  if (!/^[-+]?\d+$/.test(text)) throw new Refused(`“${text}” stands where a whole number is needed.`)
  return Number(text)
}
