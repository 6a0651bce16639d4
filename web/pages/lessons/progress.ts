/**
 * The steps that the reader has seen, the last of them, and the answers given, kept in this browser. If it keeps nothing, they are known
 * until the page is left; entries of a later version of the page are neither read nor lost.
 */
import { addressOf, hashOf, type StepAddress } from './address'
import { type Lesson, lessons } from './content/lessons'
import { type Given, isAnswerTo } from './question'

interface Kept {
  readonly version: typeof VERSION
  /** Addresses of steps, the one seen last at the end. */
  readonly seen: readonly string[]
  readonly answers: Readonly<Record<string, Given>>
}

const KEY = 'hexlens-lessons'
const VERSION = 1
const NONE: Kept = { version: VERSION, seen: [], answers: {} }

export class Progress {
  #kept: Kept = NONE
  /** False if it does not outlive the page. */
  isKept = true

  constructor() {
    this.#read()
  }

  /** The step that was read last; null if none was. */
  get last(): StepAddress | null {
    return addressOf(this.#kept.seen.at(-1) ?? '')
  }

  get isEmpty(): boolean {
    return this.#kept.seen.length === 0
  }

  countIn(lesson: Lesson): number {
    return lesson.steps.filter((_, step) => this.#kept.seen.includes(hashOf({ lesson, step }))).length
  }

  answerTo(address: StepAddress): Given | undefined {
    return this.#kept.answers[hashOf(address)]
  }

  see(address: StepAddress): void {
    const hash = hashOf(address)
    this.#change(kept => ({ ...kept, seen: [...kept.seen.filter(other => other !== hash), hash] }))
  }

  answer(address: StepAddress, given: Given): void {
    this.#change(kept => ({ ...kept, answers: { ...kept.answers, [hashOf(address)]: given } }))
  }

  forgetAnswer(address: StepAddress): void {
    this.#change(({ answers, ...kept }) => {
      const { [hashOf(address)]: _, ...others } = answers
      return { ...kept, answers: others }
    })
  }

  forget(): void {
    this.#kept = NONE
    try {
      if (this.isKept) localStorage.removeItem(KEY)
    } catch {
      // Nothing was kept.
    }
  }

  /** Another tab may have gone on since. */
  #change(change: (kept: Kept) => Kept): void {
    this.#read()
    this.#kept = change(this.#kept)
    if (!this.isKept) return
    try {
      localStorage.setItem(KEY, JSON.stringify(this.#kept))
    } catch {
      this.isKept = false
    }
  }

  #read(): void {
    if (!this.isKept) return
    try {
      const kept = parsed(localStorage.getItem(KEY))
      if (typeof kept?.version === 'number' && kept.version > VERSION) this.isKept = false
      else this.#kept = { version: VERSION, seen: seenIn(kept?.seen), answers: answersIn(kept?.answers) }
    } catch {
      this.isKept = false // storage is refused
    }
  }
}

/** Null where nothing was kept, or somebody else has written there. */
function parsed(text: string | null): Partial<Record<keyof Kept, unknown>> | null {
  try {
    return JSON.parse(text ?? 'null')
  } catch {
    return null
  }
}

const steps = new Map(
  lessons.flatMap(lesson => lesson.steps.map((step, i) => [hashOf({ lesson, step: i }), step] as const)),
)

function seenIn(seen: unknown): string[] {
  return Array.isArray(seen) ? seen.filter(hash => steps.has(hash)) : []
}

function answersIn(answers: unknown): Record<string, Given> {
  if (typeof answers !== 'object' || answers === null) return {}
  return Object.fromEntries(
    Object.entries(answers).filter(([hash, given]) => {
      const question = steps.get(hash)?.question
      return question !== undefined && isAnswerTo(question, given)
    }),
  )
}
