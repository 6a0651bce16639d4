/**
 * The least distance to jacdet = 0 on the boundary, by best-first subdivision of the faces: a
 * patch's Bernstein coefficients bound it from below, its corners are values. The bound returned is
 * certain: docs/algorithm.md (N4), (N6), (N7).
 */
import { faces, type Vec3 } from '../../../model/hexahedron'
import type { DistanceKind, Entries } from './distances'
import { bernsteinOnFace, neighbours, pointOnFace } from './scaled-element'

export interface LeastDistance {
  readonly point: Vec3
  /** The distance there, as computed. */
  readonly value: number
  /** The distance is nowhere less on the boundary. */
  readonly bound: number
}

/** A coefficient may be off by this: docs/algorithm.md (N7). */
export const SLACK = 2 ** -40

/** The value is at most this much above the bound, relatively, if patches suffice. */
export const TOLERANCE = 2 ** -22
/** More patches would not help with surfaces of equal distances either. */
const MOST_PATCHES = 4000
/** The width after sixty halvings; coefficients are still within the slack. */
const LEAST_WIDTH = 2 ** -30
/** Patches between two pauses of the search. */
const PATCHES_AT_ONCE = 16

interface Patch {
  readonly face: number
  readonly low: readonly [number, number]
  readonly width: readonly [number, number]
  /** `[3 * i + j]` with i in s, j in t. */
  readonly coefficients: readonly Entries[]
  readonly bound: number
}

/** Yields now and then. */
export function* leastOnBoundary(edges: readonly Vec3[], kind: DistanceKind): Generator<undefined, LeastDistance> {
  const at = (point: Vec3) => kind.entriesAt(edges, point)
  const open = new Heap()
  let best: Pick<LeastDistance, 'point' | 'value'> = { point: [0, 0, 0], value: Number.POSITIVE_INFINITY }
  const add = ({ face, low, width, coefficients }: Omit<Patch, 'bound'>) => {
    for (const [i, j] of CORNERS) {
      const value = kind.distance(coefficients[3 * i + j] as Entries, 0)
      const [s, t] = [low[0] + (i / 2) * width[0], low[1] + (j / 2) * width[1]]
      if (value < best.value) best = { point: pointOnFace(face, s, t), value }
    }
    const bound = coefficients.reduce((least, entries) => Math.min(least, kind.distance(entries, SLACK)), Infinity)
    open.push({ face, low, width, coefficients, bound: Math.max(bound, 0) })
  }
  for (const face of faces.keys()) add({ face, low: [0, 0], width: [1, 1], coefficients: bernsteinOnFace(face, at) })
  for (let patches = faces.length; ; patches++) {
    const patch = open.pop()
    if (patch === null) throw new Error('A patch has halves.')
    if (patch.bound >= best.value * (1 - TOLERANCE)) return { ...best, bound: Math.min(patch.bound, best.value) }
    if (patches >= MOST_PATCHES || Math.max(...patch.width) <= LEAST_WIDTH)
      return { ...downhill(best.point, at, kind), bound: patch.bound }
    for (const half of halves(patch)) add(half)
    if (patches % PATCHES_AT_ONCE === 0) yield
  }
}

/** A point with none lower near it on its face, by steps along s and t that are halved. */
function downhill(start: Vec3, at: (point: Vec3) => Entries, kind: DistanceKind): Omit<LeastDistance, 'bound'> {
  let best = { point: start, value: kind.distance(at(start), 0) }
  for (let step = 1 / 16; step > 2 ** -40; step /= 2)
    for (let round = 0; round < 8; round++) {
      const before = best
      for (const point of neighbours(best.point, step).filter(isOnBoundary)) {
        const value = kind.distance(at(point), 0)
        if (value < best.value) best = { point, value }
      }
      if (best === before) break
    }
  return best
}

function isOnBoundary(point: Vec3): boolean {
  return point.some(x => x === 0 || x === 1)
}

const CORNERS = [
  [0, 0],
  [0, 2],
  [2, 0],
  [2, 2],
] as const

/** Halves along the longer side. */
function halves({ face, low, width, coefficients }: Patch): Omit<Patch, 'bound'>[] {
  const alongS = width[0] >= width[1]
  const lines = [0, 1, 2].map(k => [0, 1, 2].map(i => coefficients[alongS ? 3 * i + k : 3 * k + i] as Entries))
  const cut = lines.map(([a, b, c]) => {
    const [ab, bc] = [mean(a as Entries, b as Entries), mean(b as Entries, c as Entries)]
    const middle = mean(ab, bc)
    return [
      [a, ab, middle],
      [middle, bc, c],
    ] as [Entries[], Entries[]]
  })
  const size: readonly [number, number] = alongS ? [width[0] / 2, width[1]] : [width[0], width[1] / 2]
  return [0, 1].map(side => {
    const start: readonly [number, number] = alongS
      ? [low[0] + side * size[0], low[1]]
      : [low[0], low[1] + side * size[1]]
    const own = cut.map(pair => pair[side] as Entries[])
    const turned = [0, 1, 2].flatMap(i => [0, 1, 2].map(j => (alongS ? own[j]?.[i] : own[i]?.[j]) as Entries))
    return { face, low: start, width: size, coefficients: turned }
  })
}

function mean(a: Entries, b: Entries): Entries {
  return a.map((value, i) => (value + (b[i] as number)) / 2)
}

/** The patch with the least bound first. */
class Heap {
  readonly #patches: Patch[] = []

  push(patch: Patch): void {
    let i = this.#patches.length
    this.#patches.push(patch)
    for (let up = (i - 1) >> 1; i > 0 && this.#at(up).bound > patch.bound; i = up, up = (i - 1) >> 1)
      this.#patches[i] = this.#at(up)
    this.#patches[i] = patch
  }

  pop(): Patch | null {
    const [first] = this.#patches
    const last = this.#patches.pop()
    if (first === undefined || last === undefined) return null
    if (this.#patches.length === 0) return first
    let i = 0
    for (;;) {
      let down = 2 * i + 1
      if (down >= this.#patches.length) break
      if (down + 1 < this.#patches.length && this.#at(down + 1).bound < this.#at(down).bound) down++
      if (this.#at(down).bound >= last.bound) break
      this.#patches[i] = this.#at(down)
      i = down
    }
    this.#patches[i] = last
    return first
  }

  #at(i: number): Patch {
    return this.#patches[i] as Patch
  }
}
