/** What the picture shows of a mesh. */
import { MOST_WHOLE } from '../../mesh-scene/loaded-faces'
import type { Vec3 } from '../../model/hexahedron'
import type { CutCells, Overview } from '../../survey/survey-jobs'

/** The cells to begin with; the slice, the threshold and so on take some of them away. */
export type CellSet = 'all' | 'invalid' | 'listed' | 'around' | `block-${number}`

/** Which block of the mesh a set is; null if it is none. */
export function blockOf(set: CellSet): number | null {
  const [, block] = /^block-(\d+)$/.exec(set) ?? []
  return block === undefined ? null : Number(block)
}

/** What is in front of the plane goes; `place` is its part of the way through the mesh along the normal. */
export interface Slice {
  readonly normal: Vec3
  readonly place: number
}

export interface PictureSettings {
  readonly set: CellSet
  /** Rings of cells around the invalid ones, or around the chosen one. */
  readonly rings: number
  readonly slice: Slice | null
  /** Relative minima from one number to another, both within. */
  readonly relative: readonly [number, number] | null
  /** Layers of cells that are peeled off the boundary. */
  readonly layers: number
  /** Cells that are dug away, the last one last. */
  readonly away: readonly number[]
  readonly isApart: boolean
  /** Whether the valid cells have a colour, too. */
  readonly colours: 'all' | 'invalid'
}

export const FIRST_SETTINGS: PictureSettings = {
  set: 'all',
  rings: 0,
  slice: null,
  relative: null,
  layers: 0,
  away: [],
  isApart: false,
  colours: 'all',
}

export const MOST_RINGS = 8

type Plane = NonNullable<CutCells['plane']>

/** The plane of a slice, less the origin that the middle of the bounds is given from. */
export function planeOf({ normal, place }: Slice, middle: Vec3, bounds: Overview['bounds']): Plane {
  const unit = unitOf(normal)
  return { normal: unit, offset: sum(axis => unit[axis] * middle[axis]) + (2 * place - 1) * reachOf(unit, bounds) }
}

/** The slice of a plane, held within the mesh. */
export function sliceAt({ normal, offset }: Plane, middle: Vec3, bounds: Overview['bounds']): Slice {
  const unit = unitOf(normal)
  const reach = reachOf(unit, bounds)
  const across = offset - sum(axis => unit[axis] * middle[axis])
  const place = reach > 0 ? across / reach / 2 + 0.5 : 0.5
  return { normal, place: Number(Math.max(0, Math.min(1, place)).toFixed(4)) }
}

/** Half the way between the two corners of the bounds that lie farthest apart along the normal. */
function reachOf(unit: Vec3, bounds: Overview['bounds']): number {
  return bounds ? sum(axis => (Math.abs(unit[axis]) * (bounds.greatest[axis] - bounds.least[axis])) / 2) : 0
}

/** Without a chosen cell there is nothing around it: then all cells are shown. */
export function cutOf(settings: PictureSettings, plane: Plane | null, chosen: number | null): CutCells {
  const { set, rings, relative, layers, away, isApart } = settings
  return {
    set: setOf(set, rings, chosen),
    plane,
    relative,
    layers,
    away,
    onlyInvalid: false,
    isWhole: isApart,
    hasBoundary: true,
    most: MOST_WHOLE,
  }
}

/** The invalid cells of the set, which are seen through what a slice and peeling leave; null where the picture has no others. */
export function invalidCutOf(settings: PictureSettings, chosen: number | null): CutCells | null {
  if (settings.set === 'invalid' && settings.rings === 0) return null
  return { ...cutOf(settings, null, chosen), layers: 0, onlyInvalid: true, hasBoundary: false }
}

function setOf(set: CellSet, rings: number, chosen: number | null): CutCells['set'] {
  if (set === 'invalid') return { which: 'invalid', rings }
  if (set === 'listed') return { which: 'listed' }
  if (set === 'around' && chosen !== null) return { which: 'around', cell: chosen, rings }
  const block = blockOf(set)
  return block === null ? { which: 'all' } : { which: 'block', block }
}

export function flipped({ normal: [x, y, z], place }: Slice): Slice {
  return { normal: [0 - x, 0 - y, 0 - z], place: 1 - place }
}

export function unitOf([x, y, z]: Vec3): Vec3 {
  const length = Math.hypot(x, y, z)
  return [x / length, y / length, z / length]
}

/** As it travels: to 0.006 degrees. */
export function roundedNormal(normal: Vec3): Vec3 {
  const [x, y, z] = unitOf(normal).map(value => Number(value.toFixed(4)) + 0)
  return [x as number, y as number, z as number]
}

function sum(term: (axis: 0 | 1 | 2) => number): number {
  return term(0) + term(1) + term(2)
}
