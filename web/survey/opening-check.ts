/**
 * The check of a mesh that is being opened: first what the sentence on top and the worst cells need, then the rest. Volumes take longer than
 * verdicts and minima together, so that those of the worst cells alone come first.
 */
import { type Answers, emptyAnswers, type Wanted } from '../core/batch/lists'
import type { Core } from '../core/report'
import { CLASSES } from '../core/unpack'
import { invalidOf, type SomeCells, someOf } from '../mesh/accepted-invalid'
import { type ClassifyCells, checkMesh } from '../mesh/check'
import { inParts } from '../mesh/in-parts'
import type { Mesh } from '../mesh/mesh'
import { type MeshCheck, NEEDED } from '../mesh/mesh-check'
import { verticesOf } from '../mesh/vertices-of'
import { FEW, worstFirst } from '../mesh/worst'
import { volumeBoundsOf } from './volume-bounds'

/** Lists that the page shows; which checks accept a cell, and minimizers, are asked for when they are. */
const LISTS = { minima: true, minimizers: false, volumes: true, exact: true } as const

/** What is asked of all cells of a mesh that is opened in two steps, at first. */
export const FIRST_LISTS = { ...LISTS, ...NEEDED, volumes: false, relativeMinima: false } as const

/** Meshes with fewer cells are checked at once. */
const MANY = 50_000
/** More candidates than that are no gain. */
const MOST_CANDIDATES = 20_000

export interface OpeningCheck {
  /** All of it, or all but volumes, relative minima and the order: of these what the `FEW` worst cells have. */
  readonly check: MeshCheck
  /** All invalid cells, if they were looked at. */
  readonly invalid?: SomeCells
  /** The whole check, in the same lists; null if it is whole. */
  readonly finish: (() => Promise<MeshCheck>) | null
}

interface Tools {
  readonly classify: ClassifyCells
  readonly core: Core
}

export async function openingCheck(mesh: Mesh, tools: Tools, many = MANY): Promise<OpeningCheck> {
  const plain = { minRelative: null, skipsDegenerate: false }
  const count = mesh.cells.length / 8
  if (count >= many) {
    const later = emptyAnswers(count, { volumes: true, relativeMinima: true })
    const first = await checkMesh(
      mesh,
      { ...tools, classify: without(later, tools.classify) },
      { ...plain, worst: 0, lists: LISTS },
    )
    // No valid cell is worse than an invalid one.
    const isOfInvalid = first.invalid >= FEW && first.invalid <= MOST_CANDIDATES
    const invalid = isOfInvalid ? someOf(mesh, invalidOf(first)) : undefined
    const candidates = invalid ? invalid.indices : candidatesOf(first)
    const finish = () => finished(first, tools)
    if (candidates) {
      const worst = await worstOf(first, invalid ?? someOf(mesh, candidates), tools)
      return { check: { ...first, worst }, finish, ...(invalid && { invalid }) }
    }
    return { check: await finished(first, tools), finish: null }
  }
  return { check: await checkMesh(mesh, tools, { ...plain, worst: Infinity, lists: LISTS }), finish: null }
}

/** Classifies without the lists that come later, and puts these among the answers, all NaN and 0. */
function without(later: Answers, classify: ClassifyCells): ClassifyCells {
  const own = async (points: Float64Array, cells: Uint32Array, wanted: Wanted) => {
    if (!wanted.relativeMinima) return classify(points, cells, wanted)
    const answers = await classify(points, cells, FIRST_LISTS)
    later.relativeMinima?.fill(Number.NaN)
    return { ...answers, volumes: later.volumes, relativeMinima: later.relativeMinima }
  }
  return own as ClassifyCells
}

/** The `FEW` worst of some cells; these get volumes and relative minima. */
async function worstOf(check: MeshCheck, some: SomeCells, { classify }: Tools): Promise<Uint32Array> {
  const candidates = some.indices
  const found = await classify(some.points, some.cells, { volumes: true, relativeMinima: true })
  const { volumes, relativeMinima } = check.answers
  for (const [i, cell] of candidates.entries()) {
    relativeMinima[cell] = found.relativeMinima[i] as number
    if (!volumes) continue
    volumes.values[cell] = found.volumes.values[i] as number
    volumes.exponents[cell] = found.volumes.exponents[i] as number
  }
  const order = worstFirst(candidates.length, severityOf(check, candidates), FEW, () => true)
  return order.map(i => candidates[i] as number)
}

/** Cells among which the `FEW` worst are, ascending; null where the bounds of volumes leave too many open. */
function candidatesOf(check: MeshCheck): Uint32Array | null {
  const { mesh, answers, hexahedra, isAnswered } = check
  const minima = answers.minima as NonNullable<typeof answers.minima>
  const collapsed = CLASSES.indexOf('collapsed')
  // Where so many are invalid, no valid one is among the worst.
  const isOfInvalid = check.invalid >= FEW
  const least = new LeastUppers()
  const some: number[] = []
  const lowers: number[] = []
  const bounds = volumeBoundsOf(mesh)
  let isTooMany = false
  const look = (cell: number) => {
    if (isOfInvalid && answers.valid[cell] === 1) return
    const minimum = minima.values[cell] as number
    // Not below the worst so far, whatever its volume.
    if (minimum >= 0 && least.bound < 0) return
    if (answers.statuses[cell] !== 0 || !isAnswered(cell)) return
    let [lower, upper] = [-Infinity, Infinity]
    if (minimum === 0 || answers.classes[cell] === collapsed) lower = upper = 0
    else if (minima.exponents[cell] === 0 && bounds.find(cell)) {
      const { least: small, greatest: large } = bounds
      lower = below(minimum / (minimum < 0 ? small : large))
      upper = above(minimum / (minimum < 0 ? large : small))
    }
    if (!(lower <= least.bound)) return
    least.take(upper)
    some.push(cell)
    lowers.push(lower)
    if (some.length > MOST_CANDIDATES) {
      let kept = 0
      for (let i = 0; i < some.length; ++i)
        if ((lowers[i] as number) <= least.bound) {
          some[kept] = some[i] as number
          lowers[kept++] = lowers[i] as number
        }
      some.length = kept
      lowers.length = kept
      isTooMany ||= 2 * kept > MOST_CANDIDATES
    }
  }
  inParts(hexahedra, (from, to) => {
    for (let cell = from; cell < to && !isTooMany; ++cell) look(cell)
  })
  if (isTooMany) return null
  if (least.bound === Infinity) return null
  return Uint32Array.from(some.filter((_, i) => (lowers[i] as number) <= least.bound))
}

const LEAST_NORMAL = 2 ** -1022

/** Beyond the roundings of the volume and of two quotients; a relative minimum is no smaller than the least normal double. */
function below(quotient: number): number {
  return quotient - 2 ** -51 * Math.abs(quotient) - 2 * LEAST_NORMAL
}

function above(quotient: number): number {
  return -below(-quotient)
}

/** The `FEW` least of some numbers. */
class LeastUppers {
  readonly #list = new Float64Array(FEW).fill(Infinity)

  /** The greatest of them. */
  get bound(): number {
    return this.#list[FEW - 1] as number
  }

  take(value: number): void {
    const list = this.#list
    let at = FEW - 1
    if (!(value < (list[at] as number))) return
    for (; at > 0 && (list[at - 1] as number) > value; --at) list[at] = list[at - 1] as number
    list[at] = value
  }
}

function severityOf(check: MeshCheck, cells: Uint32Array | null) {
  const { relativeMinima, classes } = check.answers
  const at = (i: number) => (cells === null ? i : (cells[i] as number))
  return {
    relativeMinima: cells === null ? relativeMinima : Float64Array.from(cells, cell => relativeMinima[cell] as number),
    isCollapsed: (i: number) => CLASSES[classes[at(i)] as number] === 'collapsed',
    isUnanswered: (i: number) => !check.isAnswered(at(i)),
  }
}

async function finished(check: MeshCheck, { classify, core }: Tools): Promise<MeshCheck> {
  const { mesh, answers, hexahedra } = check
  const { volumes } = await classify(mesh.points, mesh.cells, { volumes: true })
  answers.volumes?.values.set(volumes.values)
  answers.volumes?.exponents.set(volumes.exponents)
  putRelativeMinima(check, core)
  return { ...check, worst: worstFirst(hexahedra, severityOf(check, null), Infinity, () => true) }
}

/** As the core has them: a quotient that is an ordinary double is the nearest one; others are the core's. */
function putRelativeMinima({ mesh, answers, hexahedra }: MeshCheck, core: Core): void {
  const { relativeMinima, statuses } = answers
  const minima = answers.minima as NonNullable<typeof answers.minima>
  const volumes = answers.volumes as NonNullable<typeof answers.volumes>
  for (let cell = 0; cell < hexahedra; ++cell) {
    if (statuses[cell] !== 0) continue
    const minimum = minima.values[cell] as number
    const volume = volumes.values[cell] as number
    const relative = minimum / Math.abs(volume)
    const size = Math.abs(relative)
    const isOrdinary = minima.exponents[cell] === 0 && volumes.exponents[cell] === 0
    if (isOrdinary && volume !== 0 && ((size >= LEAST_NORMAL && size < Infinity) || minimum === 0)) {
      relativeMinima[cell] = minimum === 0 ? 0 : relative
      continue
    }
    const result = core.analyze(verticesOf(mesh, cell))
    relativeMinima[cell] = result.ok ? (result.value.relativeMinimum ?? Number.NaN) : Number.NaN
  }
}
