/** The points of an open mesh as they were read and as they have been moved, with the steps between. */
import { counted } from '../mesh/check-summary'
import type { Mesh } from '../mesh/mesh'
import type { Moves } from './survey-jobs'

interface Step extends Moves {
  readonly from: Float64Array
}

export class Movement {
  readonly #first: Mesh
  /** True if nodes of cells have been put into another order since the mesh was read. */
  readonly isRenumbered: boolean
  #now: Mesh
  readonly #moved: Set<number>
  readonly #done: Step[]
  readonly #undone: Step[]

  /** Of a mesh as it was read; or of the same with its nodes in another order, which goes on from `before`. */
  constructor(first: Mesh, before: Movement | null = null) {
    this.#first = before ? { ...first, points: before.#first.points, notes: withoutNote(first.notes, before) } : first
    this.#now = first
    this.isRenumbered = before !== null
    this.#moved = before ? before.#moved : new Set()
    this.#done = before ? before.#done : []
    this.#undone = before ? before.#undone : []
  }

  /** The mesh with the points as they were read. */
  get first(): Mesh {
    return this.#first
  }

  /** The mesh as it is. The points are other memory after each step. */
  get now(): Mesh {
    return this.#now
  }

  /** How many points are not where they were read. */
  get movedCount(): number {
    return this.#moved.size
  }

  get canUndo(): boolean {
    return this.#done.length > 0
  }

  get canRedo(): boolean {
    return this.#undone.length > 0
  }

  isMoved(point: number): boolean {
    return this.#moved.has(point)
  }

  /** One step. Returns the points that are elsewhere now. */
  move({ points, to }: Moves): Uint32Array {
    const from = this.#coordinatesOf(points, this.#now.points)
    this.#done.push({ points, from, to })
    this.#undone.length = 0
    return this.#put(points, to)
  }

  /** One step back; no points if there is none. */
  undo(): Uint32Array {
    return this.#exchange(this.#done, this.#undone, 'from')
  }

  redo(): Uint32Array {
    return this.#exchange(this.#undone, this.#done, 'to')
  }

  /** One step to where points were read: these, or all. */
  restore(points: Uint32Array | null): Uint32Array {
    const own = Uint32Array.from(points ?? this.#moved).filter(point => this.#moved.has(point))
    return own.length === 0 ? own : this.move({ points: own, to: this.#coordinatesOf(own, this.#first.points) })
  }

  #exchange(from: Step[], to: Step[], where: 'from' | 'to'): Uint32Array {
    const step = from.pop()
    if (!step) return new Uint32Array(0)
    to.push(step)
    return this.#put(step.points, step[where])
  }

  #put(points: Uint32Array, to: Float64Array): Uint32Array {
    const all = this.#now.points.slice()
    for (const [i, point] of points.entries()) {
      all.set(to.subarray(3 * i, 3 * i + 3), 3 * point)
      const isHome = [0, 1, 2].every(axis => Object.is(all[3 * point + axis], this.#first.points[3 * point + axis]))
      if (isHome) this.#moved.delete(point)
      else this.#moved.add(point)
    }
    this.#now = { ...this.#first, points: all, notes: [...this.#first.notes, ...noteOf(this.movedCount)] }
    return points
  }

  #coordinatesOf(points: Uint32Array, all: Float64Array): Float64Array {
    const own = new Float64Array(3 * points.length)
    for (const [i, point] of points.entries()) own.set(all.subarray(3 * point, 3 * point + 3), 3 * i)
    return own
  }
}

/** All outputs have the notes of the mesh. */
function noteOf(count: number): string[] {
  return count === 0 ? [] : [`${counted(count, 'vertex has', 'vertices have')} been moved here.`]
}

function withoutNote(notes: readonly string[], { movedCount }: Movement): readonly string[] {
  const [own] = noteOf(movedCount)
  return notes.filter(note => note !== own)
}
