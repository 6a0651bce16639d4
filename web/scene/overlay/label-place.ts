/** The place of a label: near its anchor, clear of handles and other words, inside the picture, and without jumps. */
import type { Box, Point } from '../space/layout'

export interface LabelRequest {
  readonly anchor: Point
  readonly width: number
  readonly height: number
  readonly bounds: Box
  /** Middles of discs that it must not cover, of handles and of their numbers, and boxes that are taken. */
  readonly points: readonly Point[]
  readonly numbers: readonly Point[]
  readonly boxes: readonly Box[]
  /** Corners of the hull that it had better not cover, away from whose middle it goes. */
  readonly body: readonly Point[]
  /** The place chosen last, kept unless another is clearly better. */
  readonly previous: number | null
}

interface Place extends Point {
  readonly index: number
}

/** The middle of the label. */
export interface LabelPlace extends Place {
  /** True if it is inside the bounds and on no box: if nothing is free, the least bad place may be worse than none. */
  readonly isFree: boolean
}

const DIRECTIONS = 16
const DISTANCES = [34, 56, 84, 120, 170]

/** The weight of each fault, in units of distance from the anchor. */
const WEIGHT = { outside: 40, point: 220, crossing: 90, box: 400, body: 22, inwards: 22, stay: 60 }

const POINT_RADIUS = 12
const NUMBER_RADIUS = 9
const DIGIT = { width: 8, height: 10 }

export function placeLabel(request: LabelRequest): LabelPlace {
  const hull = convexHull(request.body)
  const middle = meanOf(request.body)
  let best: Place = { index: 0, ...request.anchor }
  let least = Infinity
  for (const index of inOrder(request.previous)) {
    const bonus = index === request.previous ? WEIGHT.stay : 0
    if (distanceOf(index) - bonus >= least) continue // its faults would only add to that
    const place = placeAt(request, index)
    const cost = costOf(place, request, hull, middle) - bonus
    if (cost < least) {
      least = cost
      best = place
    }
  }
  const box = boxAt(best, request)
  return { ...best, isFree: outsideBy(box, request.bounds) === 0 && !request.boxes.some(other => overlap(box, other)) }
}

/** Turns of a number about its handle, the least first. */
const TURNS = [0, 0.7, -0.7, 1.4, -1.4, 2.1, -2.1, 2.8]

/**
 * Where a number goes from its handle: in this unit direction, or turned from it so far that it lies on none of the others and
 * on no box that is taken.
 */
export function numberDirection(
  at: Point,
  { x, y }: Point,
  distance: number,
  others: readonly Point[],
  taken: readonly Box[],
): Point {
  const turned = TURNS.map(turn => ({
    x: x * Math.cos(turn) - y * Math.sin(turn),
    y: x * Math.sin(turn) + y * Math.cos(turn),
  }))
  const isClear = (way: Point) => {
    const middle = { x: at.x + way.x * distance, y: at.y + way.y * distance }
    const box = { x: middle.x - DIGIT.width / 2, y: middle.y - DIGIT.height / 2, ...DIGIT }
    return (
      others.every(other => Math.hypot(middle.x - other.x, middle.y - other.y) > 1.5 * NUMBER_RADIUS) &&
      !taken.some(other => overlap(box, other))
    )
  }
  return turned.find(isClear) ?? { x, y }
}

/** Every place, the previous one first: mostly it is so good that no other needs a look. */
function* inOrder(previous: number | null): Generator<number> {
  if (previous !== null) yield previous
  for (let index = 0; index < DIRECTIONS * DISTANCES.length; index++) if (index !== previous) yield index
}

function distanceOf(index: number): number {
  return DISTANCES[Math.floor(index / DIRECTIONS)] as number
}

/** The label's nearest side, not its middle, is at the distance. */
function placeAt({ anchor, width, height }: LabelRequest, index: number): Place {
  const angle = (((index % DIRECTIONS) + 0.5) * 2 * Math.PI) / DIRECTIONS // never straight up: a leader needs a side
  const distance = distanceOf(index)
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)]
  return {
    index,
    x: anchor.x + cos * distance + Math.sign(cos) * (width / 2),
    y: anchor.y + sin * distance + sin * (height / 2),
  }
}

function costOf(place: Place, request: LabelRequest, hull: readonly Point[], middle: Point): number {
  const { width, anchor, bounds } = request
  const box = boxAt(place, request)
  let cost = distanceOf(place.index)
  cost += WEIGHT.outside * outsideBy(box, bounds)
  for (const points of [request.points, request.numbers]) {
    for (const point of points) {
      const near = POINT_RADIUS - distanceToBox(point, box)
      if (near > 0) cost += WEIGHT.point + near
    }
  }
  const near = { x: place.x - (Math.sign(place.x - anchor.x) * width) / 2, y: place.y }
  for (const number of request.numbers)
    if (distanceToLine(number, anchor, near) < NUMBER_RADIUS) cost += WEIGHT.crossing
  for (const other of request.boxes) if (overlap(box, other)) cost += WEIGHT.box
  for (const corner of cornersOf(box)) if (insideHull(corner, hull)) cost += WEIGHT.body
  const [ax, ay] = [anchor.x - middle.x, anchor.y - middle.y]
  const [bx, by] = [place.x - anchor.x, place.y - anchor.y]
  const lengths = Math.hypot(ax, ay) * Math.hypot(bx, by)
  if (lengths > 0) cost += WEIGHT.inwards * (1 - (ax * bx + ay * by) / lengths)
  return cost
}

function boxAt({ x, y }: Point, { width, height }: LabelRequest): Box {
  return { x: x - width / 2, y: y - height / 2, width, height }
}

function outsideBy(box: Box, bounds: Box): number {
  return (
    Math.max(0, bounds.x - box.x) +
    Math.max(0, bounds.y - box.y) +
    Math.max(0, box.x + box.width - bounds.x - bounds.width) +
    Math.max(0, box.y + box.height - bounds.y - bounds.height)
  )
}

function distanceToBox(point: Point, box: Box): number {
  const dx = Math.max(box.x - point.x, 0, point.x - box.x - box.width)
  const dy = Math.max(box.y - point.y, 0, point.y - box.y - box.height)
  return Math.hypot(dx, dy)
}

function distanceToLine(point: Point, from: Point, to: Point): number {
  const [dx, dy] = [to.x - from.x, to.y - from.y]
  const way = ((point.x - from.x) * dx + (point.y - from.y) * dy) / (dx * dx + dy * dy || 1)
  const within = Math.max(0, Math.min(1, way))
  return Math.hypot(from.x + dx * within - point.x, from.y + dy * within - point.y)
}

export function overlap(a: Box, b: Box): boolean {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height
}

function cornersOf({ x, y, width, height }: Box): Point[] {
  return [
    { x, y },
    { x: x + width, y },
    { x, y: y + height },
    { x: x + width, y: y + height },
  ]
}

export function meanOf(points: readonly Point[]): Point {
  const n = Math.max(points.length, 1)
  return { x: points.reduce((sum, p) => sum + p.x, 0) / n, y: points.reduce((sum, p) => sum + p.y, 0) / n }
}

/** Andrew's monotone chain; counter-clockwise where y points up. */
export function convexHull(points: readonly Point[]): Point[] {
  const sorted = [...points].sort((a, b) => a.x - b.x || a.y - b.y)
  const chain = (order: readonly Point[]): Point[] => {
    const hull: Point[] = []
    for (const point of order) {
      while (hull.length > 1 && turn(hull.at(-2) as Point, hull.at(-1) as Point, point) <= 0) hull.pop()
      hull.push(point)
    }
    return hull.slice(0, -1)
  }
  return [...chain(sorted), ...chain(sorted.reverse())]
}

function turn(a: Point, b: Point, c: Point): number {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)
}

function insideHull(point: Point, hull: readonly Point[]): boolean {
  return hull.length > 2 && hull.every((a, i) => turn(a, hull[(i + 1) % hull.length] as Point, point) > 0)
}
