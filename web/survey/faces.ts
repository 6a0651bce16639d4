/** Faces of cells that are to be seen, as lists for a painter. */
import { FACES } from '../mesh/face-loops'
import type { MeshCheck } from '../mesh/mesh-check'
import type { Neighbours } from '../mesh/neighbours'
import { drawable, faceList } from './face-list'
import type { Faced } from './faced'
import type { FaceList, ShownCells } from './survey-jobs'

/** Faces that bound what is shown; all faces of its cells if these are drawn whole. One with a coordinate that is not finite is left out. */
export function facesOf(faced: Faced, shown: ShownCells): FaceList {
  return facesOfMask(faced, maskOf(faced, shown.cells), shown)
}

/** Changes the mask where it has more cells than `most`. */
export function facesOfMask(
  faced: Faced,
  mask: Uint8Array,
  { isWhole, most }: Pick<ShownCells, 'isWhole' | 'most'>,
): FaceList {
  const { check, neighbours } = faced
  const counts = leaveTheWorst(mask, check.worst, most)
  const faces = isWhole ? facesWhere(mask, () => true) : outer(mask, neighbours)
  return { ...faceList(faced, drawable(faced, faces), isWhole), ...counts }
}

/** 1 for each cell that is meant. */
export function maskOf({ check, middles, isListed }: Faced, cells: ShownCells['cells']): Uint8Array {
  const count = check.hexahedra
  const mask = new Uint8Array(count)
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

/** Takes all but the worst `most` out of the mask. */
export function leaveTheWorst(
  mask: Uint8Array,
  worst: Uint32Array,
  most: number,
): { readonly shown: number; readonly wanted: number } {
  let wanted = 0
  for (const flag of mask) wanted += flag
  if (wanted <= most) return { shown: wanted, wanted }
  let shown = 0
  for (const cell of worst) {
    if (mask[cell] !== 1) continue
    if (shown < most) shown++
    else mask[cell] = 0
  }
  return { shown, wanted }
}

/** The mesh's own boundary is known, unless cells were left out. */
function outer(mask: Uint8Array, { across, boundary }: Neighbours): Uint32Array {
  if (!mask.includes(0)) return boundary
  return facesWhere(mask, face => {
    const other = across[face] as number
    return other < 0 || mask[(other / FACES) | 0] !== 1
  })
}

/** Those between a cell of the mask and another one. */
export function innerFaces(mask: Uint8Array, { across }: Neighbours): Uint32Array {
  if (!mask.includes(0)) return new Uint32Array(0)
  return facesWhere(mask, face => {
    const other = across[face] as number
    return other >= 0 && mask[(other / FACES) | 0] !== 1
  })
}

function facesWhere(mask: Uint8Array, isSeen: (face: number) => boolean): Uint32Array {
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
