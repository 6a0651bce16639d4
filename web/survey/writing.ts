/** A checked mesh as a file, written in steps, so that others may ask in between. */
import type { Core } from '../core/report'
import { sentenceOf } from '../core/workers'
import { exitOf } from '../mesh/check'
import type { MeshCheck } from '../mesh/mesh-check'
import { Refusal } from '../model/result'
import { invalidCertificates } from '../outputs/certificates'
import { csvOutput } from '../outputs/csv'
import { htmlOutput } from '../outputs/html'
import { idsOutput } from '../outputs/ids'
import { jsonOutput } from '../outputs/json'
import { MESH_FORMS } from '../outputs/meshes/list'
import { invalidPart, wholeMesh } from '../outputs/meshes/mesh-part'
import type { Output } from '../outputs/output'
import type { FormId, MeshFormId, Written } from './survey-jobs'

/** Bytes of a step, more or less. */
const CHUNK = 4 * 1024 * 1024
/** Cells that are listed at least, as the command line does. */
const WORST = 10

export interface Source {
  /** What the mesh is called in its files. */
  readonly name: string
  /** All its cells are among the worst. */
  readonly check: MeshCheck
  readonly core: Core
  /** The file that was read, with points that have moved, and what is to be said of it. */
  readonly own?: { readonly chunks: Iterable<Uint8Array>; readonly said: readonly string[] } | null
}

type Chunks = Iterable<string | Uint8Array>

interface Form {
  chunks(source: Source, say: (sentence: string) => void): Chunks
  /** How many there are, about. */
  count(check: MeshCheck): number
}

const UNCHECKED = { allowsUnchecked: false }
const PLAIN = { fileCount: 1, minRelative: null, skipsDegenerate: false }

const invalidCount = ({ invalid }: MeshCheck) => invalid
const ids = (kind: 'abaqus' | 'nastran' | 'plain'): Form => ({
  chunks: (source, say) => whole(idsOutput(kind, 1, say), source),
  count: invalidCount,
})

const forms: Readonly<Record<Exclude<FormId, MeshFormId>, Form>> = {
  csv: { chunks: source => whole(csvOutput(), source), count: ({ hexahedra }) => hexahedra },
  // All invalid cells, and ten at least.
  json: {
    chunks: source => whole(jsonOutput(), { ...source, check: withWorst(source.check, listedInJson(source.check)) }),
    count: listedInJson,
  },
  html: { chunks: source => whole(htmlOutput(PLAIN), source), count: () => WORST },
  own: {
    *chunks({ own }, say) {
      own?.said.forEach(say)
      yield* own?.chunks ?? []
    },
    count: ({ mesh }) => mesh.points.length,
  },
  certificates: { chunks: ({ check, core }) => invalidCertificates(check, core), count: invalidCount },
  abaqus: ids('abaqus'),
  nastran: ids('nastran'),
  plain: ids('plain'),
}

const meshForms = new Map(
  MESH_FORMS.flatMap(({ id, chunks, count }): [MeshFormId, Form][] => [
    [
      `mesh.${id}`,
      {
        chunks: ({ check }, say) => chunks(wholeMesh(check), say),
        count: ({ mesh, hexahedra }) => count({ points: mesh.points.length / 3, cells: hexahedra }),
      },
    ],
    [
      `invalid.${id}`,
      {
        chunks: ({ check }, say) => chunks(invalidPart(check), say),
        count: ({ invalid }) => count({ points: 0, cells: invalid }),
      },
    ],
  ]),
)

function formOf(id: FormId): Form {
  const form = id in forms ? forms[id as keyof typeof forms] : meshForms.get(id as MeshFormId)
  if (!form) throw new Error(`There is no form ${id}.`)
  return form
}

function listedInJson({ invalid }: MeshCheck): number {
  return Math.max(invalid, WORST)
}

function withWorst(check: MeshCheck, count: number): MeshCheck {
  return { ...check, worst: check.worst.subarray(0, count) }
}

/** As `check` writes of one file. */
function* whole(output: Output, { name, check }: Source): Generator<string | Uint8Array> {
  const exit = exitOf(check, UNCHECKED)
  yield* output.file({ file: name, exit, check })
  yield* output.end(exit)
}

export class Writing {
  readonly #chunks: Iterator<string | Uint8Array>
  readonly #count: number
  readonly #said: string[] = []
  #done = 0

  constructor(form: FormId, source: Source) {
    const { chunks, count } = formOf(form)
    this.#chunks = chunks(source, sentence => this.#said.push(sentence))[Symbol.iterator]()
    this.#count = Math.max(1, count(source.check))
  }

  /** Whatever goes wrong is a sentence. */
  run(milliseconds: number): Written {
    try {
      return this.#step(performance.now() + milliseconds)
    } catch (reason) {
      return { refused: reason instanceof Refusal ? reason.message : `It could not be written: ${sentenceOf(reason)}` }
    }
  }

  #step(end: number): Written {
    const pieces: Uint8Array[] = []
    let text = ''
    let length = 0
    let isEnd = false
    const flush = () => {
      if (text !== '') pieces.push(new TextEncoder().encode(text))
      text = ''
    }
    do {
      const next = this.#chunks.next()
      isEnd = next.done === true
      if (next.done) break
      this.#done++
      length += next.value.length
      if (typeof next.value === 'string') text += next.value
      else {
        flush()
        pieces.push(next.value)
      }
    } while (length < CHUNK && performance.now() < end)
    flush()
    return { bytes: joined(pieces), fraction: Math.min(1, this.#done / this.#count), isEnd, said: this.#said }
  }
}

/** A copy: pieces may be the mesh's own memory, and what is told is handed over. */
function joined(pieces: readonly Uint8Array[]): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(pieces.reduce((sum, { length }) => sum + length, 0))
  let at = 0
  for (const piece of pieces) {
    bytes.set(piece, at)
    at += piece.length
  }
  return bytes
}
