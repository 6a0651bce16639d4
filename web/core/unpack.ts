/** Reads packed results (wasm/src/pack.c) in the order they were written. */
import type { Vec3, Vertices } from '../model/hexahedron'
import type {
  Candidate,
  CandidateKind,
  Check,
  CheckId,
  ElementClass,
  FaceReport,
  FaceRoot,
  JacobianReport,
  Report,
  RootFate,
  Shape,
  VolumeMinimum,
} from './report'

const KINDS: readonly CandidateKind[] = ['vertex', 'edge', 'face']
const VERDICTS: readonly (boolean | undefined)[] = [undefined, true, false]
/** The classes by hl_class. */
export const CLASSES: readonly (ElementClass | undefined)[] = [undefined, 'valid', 'invalid', 'inverted', 'collapsed']
const SHAPES: readonly (Shape | null)[] = [null, 'wedge', 'pyramid', 'tetrahedron']
/** The checks by hl_check. */
export const CHECKS: readonly CheckId[] = [
  'corners',
  'corners-and-centre',
  'gauss-2',
  'gauss-3',
  'edges',
  'bernstein',
  'subdivision',
  'tangents',
]
const FATES: readonly RootFate[] = ['kept', 'a-not-positive', 's-outside']

const DISAGREE = 'The packed result is not as expected: wasm and TypeScript disagree.'

/** A cursor over the packed doubles in the core's memory; what it returns are copies. */
export class Unpacker {
  #at = 0
  readonly #packed: Float64Array

  constructor(packed: Float64Array) {
    this.#packed = packed
  }

  number(): number {
    if (this.#at >= this.#packed.length) throw new Error(DISAGREE)
    return this.#packed[this.#at++] as number
  }

  flag(): boolean {
    return this.number() !== 0
  }

  numbers(count: number): number[] {
    const from = this.#at
    this.#at += count
    if (this.#at > this.#packed.length) throw new Error(DISAGREE)
    const packed = this.#packed
    const list = new Array<number>(count)
    for (let i = 0; i < count; ++i) list[i] = packed[from + i] as number
    return list
  }

  vec3(): Vec3 {
    return [this.number(), this.number(), this.number()]
  }

  oneOf<T>(names: readonly (T | undefined)[]): T {
    const name = names[this.number()]
    if (name === undefined) throw new Error(DISAGREE)
    return name
  }

  list<T>(read: (packed: Unpacker) => T): T[] {
    const count = this.number()
    const list: T[] = []
    for (let i = 0; i < count; ++i) list.push(read(this))
    return list
  }
}

export function unpackVerdict(packed: Unpacker): boolean {
  return packed.oneOf(VERDICTS)
}

function readCandidate(packed: Unpacker): Candidate {
  return {
    kind: packed.oneOf(KINDS),
    id: packed.number(),
    point: packed.vec3(),
    position: packed.vec3(),
    value: packed.number(),
  }
}

function readVolumeMinimum(packed: Unpacker): VolumeMinimum {
  return { lower: packed.number(), upper: packed.number(), point: packed.vec3(), position: packed.vec3() }
}

export function check(id: CheckId, value: number): Check {
  return { id, value, passes: value > 0 }
}

function readRoot(packed: Unpacker): FaceRoot {
  const [t, a, s] = packed.vec3()
  const fate = packed.oneOf(FATES)
  return { t, a, s: fate === 'a-not-positive' ? null : s, fate }
}

function readFace(packed: Unpacker, id: number): FaceReport {
  return {
    id,
    bernstein: packed.numbers(9),
    lowerBound: packed.number(),
    runningMinimum: packed.number(),
    skippedByMinimumRule: packed.flag(),
    skippedByValidityRule: packed.flag(),
    quartic: packed.numbers(5),
    quarticExponent: packed.number(),
    quarticIsZero: packed.flag(),
    roots: packed.list(readRoot),
  }
}

/** Groups of several, from each vertex's least vertex at the same position. */
function groupsOf(least: readonly number[]): number[][] {
  if (least.every((other, vertex) => other === vertex)) return []
  const groups = least.map((_, first) => least.flatMap((other, vertex) => (other === first ? [vertex] : [])))
  return groups.filter(group => group.length > 1)
}

function readElement(
  packed: Unpacker,
): Pick<Report, 'class' | 'shape' | 'coincident' | 'volume' | 'volumeExponent' | 'relativeMinimum'> {
  const elementClass = packed.oneOf(CLASSES)
  const shape = packed.oneOf(SHAPES)
  const coincident = groupsOf(packed.numbers(8))
  const [volume, volumeExponent, relativeMinimum] = packed.vec3()
  return {
    class: elementClass,
    shape,
    coincident,
    volume,
    volumeExponent,
    relativeMinimum: volume === 0 ? null : relativeMinimum,
  }
}

export function unpackReport(packed: Unpacker, vertices: Vertices): Report {
  const valid = unpackVerdict(packed)
  const isExact = packed.flag()
  const exponent = packed.number()
  const minimizer = readCandidate(packed)
  const boundaryMinimumError = packed.number()
  const volumeMinimum = readVolumeMinimum(packed)
  const checks = CHECKS.map(id => check(id, packed.number()))
  const maximizer = readCandidate(packed)
  return {
    vertices,
    valid,
    decidedBy: isExact ? 'exact' : 'filter',
    exponent,
    boundaryMinimum: minimizer.value,
    boundaryMinimumError,
    minimizer,
    volumeMinimum,
    checks,
    boundaryMaximum: maximizer.value,
    maximizer,
    cornerMinimum: packed.number(),
    edgeMinimum: packed.number(),
    scaledJacobian: packed.number(),
    bernstein: packed.numbers(27),
    faces: [0, 1, 2, 3, 4, 5].map(face => readFace(packed, face)),
    candidates: packed.list(readCandidate),
    ...readElement(packed),
  }
}

export function unpackMinimum(packed: Unpacker): { minimizer: Candidate; exponent: number } {
  return { minimizer: readCandidate(packed), exponent: packed.number() }
}

export function unpackJacobian(packed: Unpacker, point: Vec3): JacobianReport {
  return {
    point,
    position: packed.vec3(),
    columns: [packed.vec3(), packed.vec3(), packed.vec3()],
    axisExponents: packed.vec3(),
    jacdet: packed.number(),
    exponent: packed.number(),
  }
}
