/** The check of a mesh of which some points have moved: the cells that have one are decided anew, all others keep their answers. */
import type { Core } from '../core/report'
import { cellsAt } from '../mesh/accepted-invalid'
import { type ClassifyCells, checkMesh } from '../mesh/check'
import { countsIn } from '../mesh/counts-in'
import type { Mesh } from '../mesh/mesh'
import { type CheckAnswers, type MeshCheck, NEEDED } from '../mesh/mesh-check'

/** Cells with one of the points, ascending. */
export function cellsWith({ points, cells }: Mesh, moved: Iterable<number>): Uint32Array {
  const isMoved = new Uint8Array(points.length / 3)
  for (const point of moved) isMoved[point] = 1
  const found: number[] = []
  for (let cell = 0; cell < cells.length / 8; ++cell)
    for (let i = 8 * cell; i < 8 * cell + 8; ++i)
      if (isMoved[cells[i] as number] === 1) {
        found.push(cell)
        break
      }
  return Uint32Array.from(found)
}

/** `before` has minima and volumes, and is of no more use afterwards: its lists are those of the new check. `mesh` has the same cells. */
export async function recheck(
  before: MeshCheck,
  mesh: Mesh,
  moved: Uint32Array,
  { classify, core }: { readonly classify: ClassifyCells; readonly core: Core },
): Promise<MeshCheck> {
  const some = cellsWith(mesh, moved)
  const wanted = { ...NEEDED, minima: true, volumes: true, exact: true, acceptedInvalid: true } as const
  const found = await classify(mesh.points, cellsAt(mesh.cells, some), wanted)
  const answers = put(found, before.answers, some)
  const known = (points: Float64Array, cells: Uint32Array, lists: object) =>
    cells === mesh.cells ? Promise.resolve(answers) : classify(points, cells, lists)
  return checkMesh(
    mesh,
    { classify: known as ClassifyCells, core },
    { worst: Infinity, minRelative: null, skipsDegenerate: false },
  )
}

/** The answers to some cells in place of theirs. Which checks accept a cell is asked anew. */
function put(found: CheckAnswers, all: CheckAnswers, some: Uint32Array): CheckAnswers {
  const lists: [from: Numbers | undefined, to: Numbers | undefined, each: number][] = [
    [found.valid, all.valid, 1],
    [found.statuses, all.statuses, 1],
    [found.classes, all.classes, 1],
    [found.coincident, all.coincident, 1],
    [found.relativeMinima, all.relativeMinima, 1],
    [found.acceptedInvalid ?? undefined, all.acceptedInvalid ?? undefined, 1],
    [found.exact ?? undefined, all.exact ?? undefined, 1],
    [found.minima?.values, all.minima?.values, 1],
    [found.minima?.minimizers, all.minima?.minimizers, 3],
    [found.minima?.cornerMinima, all.minima?.cornerMinima, 1],
    [found.minima?.exponents, all.minima?.exponents, 1],
    [found.volumes?.values, all.volumes?.values, 1],
    [found.volumes?.exponents, all.volumes?.exponents, 1],
  ]
  for (const [from, to, each] of lists)
    for (const [i, cell] of some.entries())
      for (let k = 0; from && to && k < each; ++k) to[each * cell + k] = from[each * i + k] as number
  const validCount = all.valid.reduce((sum, flag) => sum + flag, 0)
  const firstUnanswered = all.statuses.findIndex(status => status !== 0)
  const unansweredCount = all.statuses.reduce((sum, status) => sum + Number(status !== 0), 0)
  return {
    ...all,
    ...countsIn(all),
    acceptedBy: null,
    box: null,
    candidates: null,
    validCount,
    unansweredCount,
    invalidCount: all.valid.length - validCount - unansweredCount,
    firstUnanswered: firstUnanswered < 0 ? null : firstUnanswered,
    exactCount: all.exact?.reduce((sum, flag) => sum + flag, 0) ?? 0,
  }
}

type Numbers = Float64Array | Uint8Array | Int16Array
