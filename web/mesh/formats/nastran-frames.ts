/** Coordinate frames of Nastran, each in another or by three nodes, and points turned out of them into the basic frame. */
import { add, cosineAndSine, cross, type Frame, minus, outOfFrame, unit, type Vector } from './movement'

export type FrameKind = 'R' | 'C' | 'S'

export interface FrameDefinition {
  readonly kind: FrameKind
  /** Origin, a point on z, a point in the xz-plane: coordinates in the frame `inFrame`, or nodes. */
  readonly points: readonly [Vector, Vector, Vector] | null
  readonly nodes: readonly [number, number, number] | null
  readonly inFrame: number
  readonly line: number
}

/** A chain of frames is no deeper. */
const DEEPEST = 256

export class Frames {
  readonly #definitions = new Map<number, FrameDefinition>()
  readonly #resolved = new Map<number, Frame>()

  /** `nodeOf` gives the coordinates of a node in the basic frame; `refuse` throws. */
  constructor(
    private readonly nodeOf: (id: number, depth: number) => Vector,
    private readonly refuse: (what: string, line?: number) => never,
  ) {}

  /** Refuses a second definition that differs from the first. */
  define(id: number, definition: FrameDefinition): void {
    const old = this.#definitions.get(id)
    const what = ({ kind, points, nodes, inFrame }: FrameDefinition) => JSON.stringify([kind, points, nodes, inFrame])
    if (old && what(old) !== what(definition)) this.refuse(`frame ${id} is defined twice.`, definition.line)
    this.#definitions.set(id, definition)
  }

  /** The point of these coordinates in the frame `id`, in the basic frame. */
  basic(id: number, coordinates: Vector, depth = 0): Vector {
    if (id === 0) return coordinates
    const definition = this.#definitions.get(id)
    if (!definition)
      this.refuse(`the frame ${id}, in which coordinates are given, is defined by no CORD1 or CORD2 entry.`)
    return outOfFrame(this.#frame(id, definition, depth), cartesian(definition.kind, coordinates))
  }

  #frame(id: number, definition: FrameDefinition, depth: number): Frame {
    const known = this.#resolved.get(id)
    if (known) return known
    const { points, nodes, inFrame, line } = definition
    if (depth > DEEPEST) this.refuse(`frame ${id} is defined by itself, or through more than ${DEEPEST} others.`, line)
    const [a, b, c] = (
      points
        ? points.map(point => this.basic(inFrame, point, depth + 1))
        : (nodes ?? []).map(node => this.nodeOf(node, depth + 1))
    ) as [Vector, Vector, Vector]
    const z = unit(minus(b, a))
    const y = z && unit(cross(z, minus(c, a)))
    if (z === null || y === null) this.refuse(`the three points of frame ${id} lie on a line.`, line)
    const frame: Frame = { origin: add(a, [0, 0, 0]), axes: [cross(y, z), y, z] }
    this.#resolved.set(id, frame)
    return frame
  }
}

function cartesian(kind: FrameKind, [first, second, third]: Vector): Vector {
  if (kind === 'R') return [first, second, third]
  const [c, s] = cosineAndSine(second)
  if (kind === 'C') return [first * c, first * s, third]
  const [cosine, sine] = cosineAndSine(third)
  return [first * s * cosine, first * s * sine, first * c]
}
