/** Faces of cells that are to be seen, as lists for a painter. */
import { FACES, LOOPS } from '../mesh/face-loops'
import type { MeshCheck } from '../mesh/mesh-check'
import type { Neighbours } from '../mesh/neighbours'
import type { Vec3 } from '../model/hexahedron'
import { facesBehind } from './slice'
import type { FaceList, ShownCells } from './survey-jobs'

export interface Faced {
  readonly check: MeshCheck
  readonly neighbours: Neighbours
  readonly origin: Vec3
  /** The middles of cells less the origin, three numbers each. */
  readonly middles: Float32Array
  readonly isListed: (cell: number) => boolean
}

/** Faces that bound what is shown; all faces of its cells if these are drawn whole. One with a coordinate that is not finite is left out. */
export function facesOf(faced: Faced, shown: ShownCells): FaceList {
  if (shown.cells.which === 'behind-plane' && !shown.isWhole && shown.most === Infinity) {
    const { faces, count } = facesBehind(faced.middles, faced.neighbours, shown.cells)
    return { ...faceList(faced, faces), shown: count, wanted: count }
  }
  return facesOfMask(faced, maskOf(faced, shown.cells), shown)
}

/** Changes the mask where it has more cells than `most`. */
export function facesOfMask(
  faced: Faced,
  mask: Uint8Array,
  { isWhole, most }: Pick<ShownCells, 'isWhole' | 'most'>,
): FaceList {
  const { check, neighbours } = faced
  let wanted = 0
  for (const flag of mask) wanted += flag
  const shown = leaveTheWorst(mask, check.worst, wanted, most)
  const faces = isWhole ? inner(mask, neighbours, true) : outer(mask, neighbours)
  return { ...faceList(faced, faces), shown, wanted }
}

/** 1 for each cell that is meant. */
export function maskOf({ check, middles, isListed }: Faced, cells: ShownCells['cells']): Uint8Array {
  const count = check.hexahedra
  const mask = new Uint8Array(count)
  const relative = check.answers.relativeMinima
  const { standingOf } = check
  switch (cells.which) {
    case 'all':
      mask.fill(1)
      break
    case 'behind-plane': {
      const [x, y, z] = cells.normal
      for (let cell = 0, at = 0; cell < count; ++cell, at += 3) {
        const along = x * (middles[at] as number) + y * (middles[at + 1] as number) + z * (middles[at + 2] as number)
        if (along <= cells.offset) mask[cell] = 1
      }
      break
    }
    case 'invalid':
      for (let cell = 0; cell < count; ++cell) if (standingOf(cell) === 'invalid') mask[cell] = 1
      for (let ring = 0; ring < cells.rings; ++ring) grow(mask, check)
      break
    case 'below':
      for (let cell = 0; cell < count; ++cell) if ((relative[cell] as number) < cells.relativeMinimum) mask[cell] = 1
      break
    case 'listed':
      for (let cell = 0; cell < count; ++cell) if (isListed(cell)) mask[cell] = 1
      break
    case 'block':
      for (const cell of check.mesh.blocks[cells.block]?.cells ?? []) mask[cell] = 1
      break
    case 'one':
      mask[cells.cell] = 1
  }
  return mask
}

/** Adds the cells that share a point with one of the mask. */
export function grow(mask: Uint8Array, { mesh: { points, cells } }: MeshCheck): void {
  const isTouched = new Uint8Array(points.length / 3)
  for (let i = 0; i < cells.length; ++i) if (mask[i >> 3] === 1) isTouched[cells[i] as number] = 1
  for (let i = 0; i < cells.length; ++i) if (isTouched[cells[i] as number] === 1) mask[i >> 3] = 1
}

/** Takes all but the worst `most` out of the mask; returns how many are left. */
function leaveTheWorst(mask: Uint8Array, worst: Uint32Array, wanted: number, most: number): number {
  if (wanted <= most) return wanted
  let left = 0
  for (const cell of worst) {
    if (mask[cell] !== 1) continue
    if (left < most) left++
    else mask[cell] = 0
  }
  return left
}

function inner(mask: Uint8Array, { across }: Neighbours, isWhole: boolean): Uint32Array {
  const isSeen = (face: number) => {
    const other = across[face] as number
    return isWhole || other < 0 || mask[(other / FACES) | 0] !== 1
  }
  let count = 0
  for (let cell = 0; cell < mask.length; ++cell)
    if (mask[cell] === 1) for (let face = FACES * cell; face < FACES * cell + FACES; ++face) if (isSeen(face)) count++
  const faces = new Uint32Array(count)
  let found = 0
  for (let cell = 0; cell < mask.length; ++cell)
    if (mask[cell] === 1)
      for (let face = FACES * cell; face < FACES * cell + FACES; ++face) if (isSeen(face)) faces[found++] = face
  return faces
}

/** The mesh's own boundary is known, unless cells were left out. */
function outer(mask: Uint8Array, neighbours: Neighbours): Uint32Array {
  return mask.includes(0) ? inner(mask, neighbours, false) : neighbours.boundary
}

function faceList(faced: Faced, faces: Uint32Array): Omit<FaceList, 'shown' | 'wanted'> {
  const { check, origin, middles: allMiddles } = faced
  const { points, cells: indices } = check.mesh
  const corners = new Float32Array(12 * faces.length)
  const relativeMinima = new Float32Array(faces.length)
  const cells = new Uint32Array(faces.length)
  const middles = new Float32Array(3 * faces.length)
  let count = 0
  for (const face of faces) {
    const cell = (face / FACES) | 0
    const loop = 4 * (face - FACES * cell)
    let isWhole = true
    for (let corner = 0; corner < 4; ++corner) {
      const point = 3 * (indices[8 * cell + (LOOPS[loop + corner] as number)] as number)
      for (let axis = 0; axis < 3; ++axis) {
        const value = (points[point + axis] as number) - (origin[axis] as number)
        corners[12 * count + 3 * corner + axis] = value
        isWhole &&= Number.isFinite(value)
      }
    }
    if (!isWhole) continue
    for (let axis = 0; axis < 3; ++axis) middles[3 * count + axis] = allMiddles[3 * cell + axis] as number
    relativeMinima[count] = check.isAnswered(cell) ? (check.answers.relativeMinima[cell] as number) : Number.NaN
    cells[count++] = cell
  }
  return {
    corners: corners.slice(0, 12 * count),
    relativeMinima: relativeMinima.slice(0, count),
    cells: cells.slice(0, count),
    middles: middles.slice(0, 3 * count),
    origin,
  }
}
