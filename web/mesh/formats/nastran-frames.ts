/** Coordinate frames of Nastran, each in another or by three nodes, and nodes turned out of them into the basic frame. */
import { Runs } from '../runs'
import { add, cosineAndSine, cross, type Frame, minus, outOfFrame, unit, type Vector } from './movement'
import type { Card } from './nastran-card'
import type { NodeModel } from './node-model'
import type { TextLines } from './text-lines'

type FrameKind = 'R' | 'C' | 'S'

interface FrameDefinition {
  readonly kind: FrameKind
  /** Origin, a point on z, a point in the xz-plane: coordinates in the frame `inFrame`, or nodes. */
  readonly points: readonly [Vector, Vector, Vector] | null
  readonly nodes: readonly [number, number, number] | null
  readonly inFrame: number
  readonly line: number
}

/** The longest chain of frames that are defined by each other. */
const DEEPEST = 256

export class Frames {
  readonly #model: NodeModel
  readonly #refuse: (what: string, line?: number) => never
  readonly #definitions = new Map<number, FrameDefinition>()
  readonly #resolved = new Map<number, Frame>()
  /** Frames of the nodes that are not in the basic one, by slot. */
  readonly #frameOf = new Map<number, number>()
  /** Slots of nodes that state no frame. */
  readonly #withoutFrame = new Runs()
  /** The frame of those nodes; 0 is the basic one. */
  ofOthers = 0

  constructor(model: NodeModel, refuse: (what: string, line?: number) => never) {
    this.#model = model
    this.#refuse = refuse
  }

  /** Puts the node of this slot into a frame; false if it was there before, in another. */
  put(slot: number, frame: number, isNew: boolean): boolean {
    if (!isNew && this.#frameOf.get(slot) !== frame) return false
    this.#frameOf.set(slot, frame)
    return true
  }

  putWithout(slot: number): void {
    this.#withoutFrame.add(slot)
  }

  /** Two frames by CORD1R, CORD1C or CORD1S, whose points are nodes; or one. */
  defineByNodes(card: Card, lines: TextLines): void {
    for (const field of [0, 4]) {
      if (card.isGiven[field] !== 1 && field > 0) break
      const nodes = [1, 2, 3].map(i => card.id(field + i, 'a node', lines)) as [number, number, number]
      const kind = card.name[5] as FrameKind
      this.#define(card.id(field, 'a frame', lines), { kind, points: null, nodes, inFrame: 0, line: card.line })
    }
  }

  /** A frame by CORD2R, CORD2C or CORD2S, whose points are in another frame. */
  defineByPoints(card: Card, lines: TextLines): void {
    const point = (from: number) => [...card.values.subarray(from, from + 3)] as unknown as Vector
    this.#define(card.id(0, 'a frame', lines), {
      kind: card.name[5] as FrameKind,
      points: [point(2), point(5), point(8)],
      nodes: null,
      inFrame: card.isGiven[1] === 1 ? card.id(1, 'a frame', lines) : 0,
      line: card.line,
    })
  }

  /** Refuses a second definition that differs from the first. */
  #define(id: number, definition: FrameDefinition): void {
    const old = this.#definitions.get(id)
    const what = ({ kind, points, nodes, inFrame }: FrameDefinition) => JSON.stringify([kind, points, nodes, inFrame])
    if (old && what(old) !== what(definition)) this.#refuse(`frame ${id} is defined twice.`, definition.line)
    this.#definitions.set(id, definition)
  }

  /** Turns all nodes into the basic frame; returns how many were in others. */
  intoBasic(): number {
    if (this.ofOthers > 0) for (const slot of this.#withoutFrame) this.#frameOf.set(slot, this.ofOthers)
    const slots = [...this.#frameOf.keys()]
    for (const slot of slots) this.#basicOfSlot(slot, 0)
    return slots.length
  }

  #basicOfNode(id: number, depth: number): Vector {
    const slot = this.#model.definedSlot(id)
    if (slot < 0) this.#refuse(`a frame is defined by node ${id}, which is not defined.`)
    return this.#basicOfSlot(slot, depth)
  }

  #basicOfSlot(slot: number, depth: number): Vector {
    const { values } = this.#model.points
    const frame = this.#frameOf.get(slot)
    const point: Vector = [values[3 * slot] as number, values[3 * slot + 1] as number, values[3 * slot + 2] as number]
    if (frame === undefined) return point
    const basic = this.#basic(frame, point, depth)
    this.#frameOf.delete(slot)
    values.set(basic, 3 * slot)
    return basic
  }

  /** The point of these coordinates in the frame `id`, in the basic frame. */
  #basic(id: number, coordinates: Vector, depth: number): Vector {
    if (id === 0) return coordinates
    const definition = this.#definitions.get(id)
    if (!definition)
      this.#refuse(`the frame ${id}, in which coordinates are given, is defined by no CORD1 or CORD2 entry.`)
    return outOfFrame(this.#frame(id, definition, depth), cartesian(definition.kind, coordinates))
  }

  #frame(id: number, definition: FrameDefinition, depth: number): Frame {
    const known = this.#resolved.get(id)
    if (known) return known
    const { points, nodes, inFrame, line } = definition
    if (depth > DEEPEST) this.#refuse(`frame ${id} is defined by itself, or through more than ${DEEPEST} others.`, line)
    const [a, b, c] = (
      points
        ? points.map(point => this.#basic(inFrame, point, depth + 1))
        : (nodes ?? []).map(node => this.#basicOfNode(node, depth + 1))
    ) as [Vector, Vector, Vector]
    const z = unit(minus(b, a))
    const y = z && unit(cross(z, minus(c, a)))
    if (z === null || y === null) this.#refuse(`the three points of frame ${id} lie on a line.`, line)
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
