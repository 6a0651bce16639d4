/** What is left to be seen of cells when some are cut away: by a plane, by relative minimum, layer by layer, one by one. */
import { FACES } from '../mesh/face-loops'
import type { Neighbours } from '../mesh/neighbours'
import { faces } from '../model/hexahedron'
import { boundaryOf, drawable, faceList, hiddenOf } from './face-list'
import type { Faced } from './faced'
import { facesOfMask, grow, innerFaces, leaveTheWorst, maskOf } from './faces'
import { slicedBy } from './slice'
import type { CutCells, CutFaces } from './survey-jobs'

export function cutFaces(faced: Faced, cut: CutCells): CutFaces {
  const layers = cut.layers > 0 ? layersOf(faced) : null
  const found = { layers: layers?.count ?? null }
  if (cut.plane && isPlain(cut)) return { ...sliced(faced, cut.plane), ...found }
  const mask = maskOfCut(faced, cut, layers)
  const isMany = cut.isWhole || boundingFaces(mask, faced.neighbours) > FACES * cut.most
  const most = isMany ? cut.most : Infinity
  if (cut.isWhole || !cut.hasBoundary)
    return { ...facesOfMask(faced, mask, { isWhole: cut.isWhole, most }), hidden: null, ...found }
  const counts = leaveTheWorst(mask, faced.check.worst, most)
  const faces = drawable(faced, innerFaces(mask, faced.neighbours))
  const hidden = hiddenOf(boundaryOf(faced), cell => mask[cell] === 1)
  return { ...faceList(faced, faces, false), ...counts, hidden, ...found }
}

/** Whether a slice is all that is wanted, for whoever has the boundary. */
function isPlain({ set, relative, layers, away, onlyInvalid, isWhole, hasBoundary }: CutCells): boolean {
  const isWholeSet = set.which === 'all' && relative === null && layers === 0 && away.length === 0
  return isWholeSet && !onlyInvalid && !isWhole && hasBoundary
}

function sliced(faced: Faced, plane: NonNullable<CutCells['plane']>): Omit<CutFaces, 'layers'> {
  const { faces, count, isBehind } = slicedBy(faced.middles, faced.neighbours, plane)
  const hidden = hiddenOf(boundaryOf(faced), isBehind)
  return { ...faceList(faced, drawable(faced, faces), false), shown: count, wanted: count, hidden }
}

function maskOfCut(faced: Faced, cut: CutCells, layers: Layers | null): Uint8Array {
  const { check } = faced
  const mask = setOf(faced, cut.set)
  const [lower, upper] = cut.relative ?? [-Infinity, Infinity]
  const behind = cut.plane ? maskOf(faced, { which: 'behind-plane', ...cut.plane }) : null
  const isUncut = !behind && !layers && cut.relative === null && !cut.onlyInvalid
  for (let cell = 0; cell < mask.length && !isUncut; ++cell) {
    if (mask[cell] !== 1) continue
    const relative = check.answers.relativeMinima[cell] as number
    const isLeft =
      behind?.[cell] !== 0 &&
      !(layers && (layers.of[cell] as number) <= cut.layers) &&
      (cut.relative === null || (relative >= lower && relative <= upper && check.isAnswered(cell))) &&
      (!cut.onlyInvalid || check.standingOf(cell) === 'invalid')
    if (!isLeft) mask[cell] = 0
  }
  for (const cell of cut.away) mask[cell] = 0
  return mask
}

function setOf(faced: Faced, set: CutCells['set']): Uint8Array {
  if (set.which !== 'around') return maskOf(faced, set)
  const mask = maskOf(faced, { which: 'one', cell: set.cell })
  for (let ring = 0; ring < set.rings; ++ring) grow(mask, faced.check)
  return mask
}

function boundingFaces(mask: Uint8Array, { across, boundary }: Neighbours): number {
  if (!mask.includes(0)) return boundary.length
  let count = 0
  for (let cell = 0; cell < mask.length; ++cell) {
    if (mask[cell] !== 1) continue
    for (let face = FACES * cell; face < FACES * cell + FACES; ++face) {
      const other = across[face] as number
      if (other < 0 || mask[(other / FACES) | 0] !== 1) count++
    }
  }
  return count
}

interface Layers {
  /** The layer of each cell, from 1; more than `count` for cells that no layer reaches. */
  readonly of: Uint16Array
  readonly count: number
}

/** Steps of a mesh have the same neighbours as long as their cells are the same. */
const known = new WeakMap<Neighbours, Layers>()
const NO_LAYER = 0xffff

function layersOf({ check, neighbours }: Faced): Layers {
  const before = known.get(neighbours)
  if (before) return before
  const layers = countLayers(check.mesh.cells, check.mesh.points.length / 3, neighbours)
  known.set(neighbours, layers)
  return layers
}

/** Each point is gone through once, when it is first reached, with the cells that have it. */
function countLayers(cells: Uint32Array, pointCount: number, { boundary }: Neighbours): Layers {
  const of = new Uint16Array(cells.length / 8).fill(NO_LAYER)
  const { firsts, corners } = cornersByPoint(cells, pointCount)
  const isReached = new Uint8Array(pointCount)
  let reached: number[] = []
  const reach = (point: number) => {
    if (isReached[point] === 1) return
    isReached[point] = 1
    reached.push(point)
  }
  for (const face of boundary) {
    const first = 8 * ((face / FACES) | 0)
    for (const vertex of faces[face % FACES]?.vertices ?? []) reach(cells[first + vertex] as number)
  }
  let count = 0
  while (reached.length > 0 && count + 2 < NO_LAYER) {
    const front = reached
    reached = []
    let hasCells = false
    for (const point of front)
      for (let i = firsts[point] as number; i < (firsts[point + 1] as number); ++i) {
        const cell = (corners[i] as number) >> 3
        if (of[cell] !== NO_LAYER) continue
        of[cell] = count + 1
        hasCells = true
        for (let corner = 8 * cell; corner < 8 * cell + 8; ++corner) reach(cells[corner] as number)
      }
    if (hasCells) count++
  }
  return { of, count }
}

/** Indices into `cells`, those with the point p from `firsts[p]` on. */
function cornersByPoint(cells: Uint32Array, pointCount: number) {
  const firsts = new Uint32Array(pointCount + 1)
  for (const point of cells) firsts[point + 1] = (firsts[point + 1] as number) + 1
  for (let point = 0; point < pointCount; ++point)
    firsts[point + 1] = (firsts[point + 1] as number) + (firsts[point] as number)
  const next = firsts.slice(0, pointCount)
  const corners = new Uint32Array(cells.length)
  for (let corner = 0; corner < cells.length; ++corner) {
    const point = cells[corner] as number
    const at = next[point] as number
    corners[at] = corner
    next[point] = at + 1
  }
  return { firsts, corners }
}
