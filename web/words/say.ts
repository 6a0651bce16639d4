/**
 * The words of the element in the language of the page. English is what the code says; a language is a module that has a
 * sentence for each of the English ones, and may come before the element or after it.
 */
import type { Word } from './english'

/** Every English sentence, with the same holes, in another language. */
export type Dictionary = Readonly<Record<Word, string>>

/** The names in the braces of a sentence. */
type Holes<Sentence extends string> = Sentence extends `${string}{${infer Hole}}${infer Rest}`
  ? Hole | Holes<Rest>
  : never
type Values<Sentence extends string, Value> = [Holes<Sentence>] extends [never]
  ? []
  : [values: Readonly<Record<Holes<Sentence>, Value>>]

/** A sentence without holes. */
export type PlainWord = Exclude<Word, `${string}{${string}`>

/** Told to the window when a language arrives. */
export const ARRIVAL = 'hexlens-words'

/** The element and its languages are files of their own, which meet here: dictionaries by their language tags. */
const arrived = globalThis as { hexlensWords?: Record<string, Dictionary> }

let spoken = 'en'

export function addLanguage(tag: string, dictionary: Dictionary): void {
  arrived.hexlensWords = { ...arrived.hexlensWords, [tag]: dictionary }
  globalThis.dispatchEvent?.(new Event(ARRIVAL))
}

/** The tag of the language in which an element is to speak: of those that match, the most precise. */
export function languageOf(element: Element): string {
  const matching = Object.keys(arrived.hexlensWords ?? {}).filter(tag => element.matches(`:lang(${tag})`))
  return matching.reduce((best, tag) => (best === 'en' || tag.length > best.length ? tag : best), 'en')
}

/** What is said from now on is in this language, until another element speaks. Returns the one before. */
export function speak(tag: string): string {
  const before = spoken
  spoken = tag
  return before
}

/** A sentence with its holes filled. */
export function say<const Sentence extends Word>(
  sentence: Sentence,
  ...[values]: Values<Sentence, string | number>
): string {
  return filled(sentence, values).join('')
}

/** The parts of a sentence, some of its holes filled with markup. */
export function sayParts<const Sentence extends Word, Value>(
  sentence: Sentence,
  ...[values]: Values<Sentence, Value>
): (string | Value)[] {
  return filled<Value>(sentence, values)
}

function filled<Value>(sentence: Word, values?: Readonly<Record<string, Value>>): (string | Value)[] {
  return (arrived.hexlensWords?.[spoken]?.[sentence] ?? sentence)
    .split(/[{}]/)
    .map((part, i) => (i % 2 === 1 ? ((values as Readonly<Record<string, Value>>)[part] as Value) : part))
}

/** "1", "1 and 2", "1, 2 and 3". */
export function listed(names: readonly string[]): string {
  return names.length < 2
    ? names.join('')
    : say('{names} and {last}', { names: names.slice(0, -1).join(say(', ')), last: names.at(-1) as string })
}
