/** The meaning of the names before tables of numbers. */
import type { NumberTable } from './number-table'

export const POINT_NAME = /point|coord|vert|node|xyz|pos|corner|doflocs|^p$|\.p$|^x$/i
export const NO_POINT_NAME =
  /normal|disp|velo|force|gradient|colou?r|uv|tangent|stress|strain|jacob|weight|gauss|quadrature|integration|^j$/i
export const CELL_NAME =
  /cell|elem|conn|face|quad|tri|tet|hex|brick|topol|simpli|ien|lnods|index|indic|edge|prism|wedge|pyra|^t$|\.t$/i
export const NO_CELL_NAME = /type|tag|material|region|flag|rank|colou?r|cell_?data|size|shape|count|offset/i
export const HEXAHEDRON_NAME = /hex|brick|c3d8|q1|cube/i
/** Cells that are no hexahedra, however many nodes they have. */
export const OTHER_CELL_NAME = /(?:^|\.)(?:line|edge|triangle|tri|quad|tetra|tet|prism|wedge|pyramid)s?\d*$/i
export const TRIANGLE_NAME = /tri|face|index|indic|simpli|^t$|\.t$/i

/** Functions that make a list in some language, and name none. */
export const LIST_MAKER = /(?:^|\.)(?:array|matrix|list|vector)$/i

export function isNamed({ names }: NumberTable, pattern: RegExp): boolean {
  return names.some(name => pattern.test(name))
}
