/**
 * Elements that the reader keeps, in the browser's storage: versioned JSON, the same as what is exported. Where nothing can be stored
 * they last as long as the page.
 */
import { COORDINATE_COUNT, VERTEX_COUNT, type Vertices, vertexOf } from '../../model/hexahedron'

export interface KeptElement {
  readonly name: string
  readonly vertices: Vertices
  /** The property that it was found by, a condition. */
  readonly property: string
}

/** `unavailable`: the storage refuses. `newer`: a later version has written, and is left alone. */
export type Persistence = 'stored' | 'unavailable' | 'newer'

const KEY = 'hexlens-kept'
const VERSION = 1

type Store = Pick<Storage, 'getItem' | 'setItem'>

export class KeptElements {
  readonly #store: () => Store
  #elements: readonly KeptElement[] = []
  #persistence: Persistence = 'stored'

  /** A browser may refuse to hand its storage out: the function then throws. */
  constructor(store: () => Store) {
    this.#store = store
    this.read()
  }

  get elements(): readonly KeptElement[] {
    return this.#elements
  }

  get persistence(): Persistence {
    return this.#persistence
  }

  /** Reads the storage: another page may have kept something. */
  read(): void {
    try {
      const stored = this.#store().getItem(KEY)
      const read = stored === null ? [] : readKept(stored)
      this.#persistence = read === null ? 'newer' : 'stored'
      if (read) this.#elements = read
    } catch {
      this.#persistence = 'unavailable'
    }
  }

  /** Adds an element in front of the others; it is kept once, by its last name. */
  add(element: KeptElement): void {
    this.#change(elements => [element, ...elements.filter(other => !isSame(other.vertices, element.vertices))])
  }

  remove(element: KeptElement): void {
    this.#change(elements => elements.filter(other => !isSame(other.vertices, element.vertices)))
  }

  #change(change: (elements: readonly KeptElement[]) => readonly KeptElement[]): void {
    if (this.#persistence === 'stored') this.read()
    this.#elements = change(this.#elements)
    if (this.#persistence !== 'stored') return
    try {
      this.#store().setItem(KEY, JSON.stringify({ version: VERSION, elements: this.#elements.map(written) }))
    } catch {
      this.#persistence = 'unavailable'
    }
  }
}

export function isSame(a: Vertices, b: Vertices): boolean {
  return a.every((x, i) => x === b[i])
}

/** JSON that the command line and Paste read. */
export function exported(elements: readonly KeptElement[]): string {
  return `[\n${elements.map(element => JSON.stringify(written(element))).join(',\n')}\n]\n`
}

function written({ name, vertices, property }: KeptElement) {
  return { name, vertices: Array.from({ length: VERTEX_COUNT }, (_, v) => vertexOf(vertices, v)), property }
}

/** Null if a later version has written them. Entries that are no elements are left out. */
function readKept(text: string): KeptElement[] | null {
  try {
    const { version, elements } = JSON.parse(text) as { version?: unknown; elements?: unknown }
    if (typeof version === 'number' && version > VERSION) return null
    return Array.isArray(elements) ? elements.flatMap(readElement) : []
  } catch {
    return []
  }
}

function readElement(given: Record<string, unknown> | null): KeptElement[] {
  const { name, vertices, property } = given ?? {}
  const numbers = Array.isArray(vertices) ? vertices.flat() : []
  if (numbers.length !== COORDINATE_COUNT || !numbers.every(Number.isFinite)) return []
  return [{ name: String(name ?? 'element'), vertices: numbers, property: String(property ?? '') }]
}
