/** How many of the invalid cells the checks accept of which the sentence on top tells. */
import { CHECKS } from '../core/unpack'
import type { ClassifyCells } from './check'
import { inParts } from './in-parts'
import type { Mesh } from './mesh'
import { type MeshCheck, STANDINGS } from './mesh-check'

export interface AcceptedInvalid {
  readonly corners: number
  readonly vtk: number
}

const INVALID = STANDINGS.indexOf('invalid')
const CORNERS = 1 << CHECKS.indexOf('corners')
const VTK = 1 << CHECKS.indexOf('corners-and-centre')

/** From the list `acceptedBy`, if the check has it. */
export function acceptedInvalid(check: MeshCheck): AcceptedInvalid {
  const { acceptedBy } = check.answers
  let [corners, vtk] = [0, 0]
  if (acceptedBy)
    for (let cell = 0; cell < check.hexahedra; ++cell) {
      const mask = acceptedBy[cell] as number
      if ((mask & (CORNERS | VTK)) === 0 || check.standingOf(cell) !== 'invalid') continue
      if (mask & CORNERS) corners++
      if (mask & VTK) vtk++
    }
  return { corners, vtk }
}

/** The same without that list: asked are only the cells that one of the two checks may accept. The check has minima. */
export async function acceptedOfInvalid(
  check: MeshCheck,
  classify: ClassifyCells,
  invalid: SomeCells | null = null,
): Promise<AcceptedInvalid> {
  const { mesh, answers } = check
  const { cornerMinima } = answers.minima as NonNullable<typeof answers.minima>
  const some: number[] = []
  const { indices, points, cells } = invalid ?? { ...mesh, indices: invalidOf(check) }
  inParts(indices.length, (from, to) => {
    for (let i = from; i < to; ++i) {
      const cell = indices[i] as number
      if ((cornerMinima[cell] as number) > 0 || hasShortVector(points, cells, invalid ? i : cell)) some.push(cell)
    }
  })
  if (some.length === 0) return { corners: 0, vtk: 0 }
  const { acceptedBy } = await classify(mesh.points, cellsAt(mesh.cells, some), { acceptedBy: true })
  let [corners, vtk] = [0, 0]
  for (const mask of acceptedBy) {
    if (mask & CORNERS) corners++
    if (mask & VTK) vtk++
  }
  return { corners, vtk }
}

/** Cells of a mesh, each with its own eight points, so that they are at hand. */
export interface SomeCells {
  /** In the mesh. */
  readonly indices: Uint32Array
  readonly points: Float64Array
  readonly cells: Uint32Array
}

export function someOf({ points, cells }: Pick<Mesh, 'points' | 'cells'>, indices: Uint32Array): SomeCells {
  const own = new Float64Array(24 * indices.length)
  inParts(indices.length, (first, end) => {
    for (let i = first; i < end; ++i)
      for (let v = 0; v < 8; ++v) {
        const from = 3 * (cells[8 * (indices[i] as number) + v] as number)
        const to = 24 * i + 3 * v
        own[to] = points[from] as number
        own[to + 1] = points[from + 1] as number
        own[to + 2] = points[from + 2] as number
      }
  })
  const numbers = new Uint32Array(8 * indices.length)
  for (let i = 0; i < numbers.length; ++i) numbers[i] = i
  return { indices, points: own, cells: numbers }
}

/** Those that are answered have points that are there. */
export function invalidOf({ answers: { valid }, hexahedra, standings }: MeshCheck): Uint32Array {
  const some: number[] = []
  inParts(hexahedra, (from, to) => {
    for (let cell = from; cell < to; ++cell) if (valid[cell] !== 1 && standings[cell] === INVALID) some.push(cell)
  })
  return Uint32Array.from(some)
}

/** Eight indices for each of some cells. */
export function cellsAt(cells: Uint32Array, some: ArrayLike<number>): Uint32Array {
  const own = new Uint32Array(8 * some.length)
  for (let i = 0; i < some.length; ++i) {
    const from = 8 * (some[i] as number)
    for (let v = 0; v < 8; ++v) own[8 * i + v] = cells[from + v] as number
  }
  return own
}

/** Vertices of the edges, and those on either side of the middle along each axis. */
const EDGES = Uint8Array.of(0, 1, 1, 2, 3, 2, 0, 3, 4, 5, 5, 6, 7, 6, 4, 7, 0, 4, 1, 5, 2, 6, 3, 7)
const SIDES = [
  [1, 2, 5, 6, 0, 3, 4, 7],
  [2, 3, 6, 7, 0, 1, 4, 5],
  [4, 5, 6, 7, 0, 1, 2, 3],
].map(side => Uint8Array.from(side))

/**
 * VTK accepts a cell whose box has a diagonal below 2^-48, and one of which an edge, or the sum of the four edges along an axis, is shorter
 * than 2^-24 of the diagonal, (S2), as it computes it: from points about their mean in units of the diagonal, each off by up to 4u of the
 * greatest coordinate over the diagonal, a sum of eight by less than 2^-24 if that is below 2^24. So it may accept below these bounds.
 */
const SMALL = 2 ** -90
const SHORT = 2 ** -40
const FAR = 2 ** -48

const own = new Float64Array(24)

function hasShortVector(points: Float64Array, cells: Uint32Array, cell: number): boolean {
  let [greatest, square] = [0, 0]
  for (let v = 0; v < 8; ++v) {
    const at = 3 * (cells[8 * cell + v] as number)
    for (let axis = 0; axis < 3; ++axis) own[3 * v + axis] = points[at + axis] as number
  }
  for (let axis = 0; axis < 3; ++axis) {
    let least = own[axis] as number
    let most = least
    for (let i = axis + 3; i < 24; i += 3) {
      const value = own[i] as number
      if (value < least) least = value
      else if (value > most) most = value
    }
    square += (most - least) * (most - least)
    greatest = Math.max(greatest, most, -least)
  }
  if (!(square > SMALL && square > FAR * greatest * greatest && square < Infinity)) return true
  const short = SHORT * square
  for (let e = 0; e < 24; e += 2) {
    const [a, b] = [3 * (EDGES[e] as number), 3 * (EDGES[e + 1] as number)]
    const x = (own[a] as number) - (own[b] as number)
    if (x * x > short) continue
    const y = (own[a + 1] as number) - (own[b + 1] as number)
    const z = (own[a + 2] as number) - (own[b + 2] as number)
    if (x * x + y * y + z * z <= short) return true
  }
  for (let s = 0; s < SIDES.length; ++s) {
    const side = SIDES[s] as Uint8Array
    let size = 0
    for (let axis = 0; axis < 3 && size <= short; ++axis) {
      let sum = 0
      for (let i = 0; i < 4; ++i)
        sum += (own[3 * (side[i] as number) + axis] as number) - (own[3 * (side[i + 4] as number) + axis] as number)
      size += sum * sum
    }
    if (size <= short) return true
  }
  return false
}
