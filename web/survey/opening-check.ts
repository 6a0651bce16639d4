/**
 * The check of a mesh that is being opened: first what the sentence on top and the worst cells need, then the rest. Volumes take longer than
 * verdicts and minima together, so that those of the worst cells alone come first.
 */
import { type Answers, emptyAnswers, type Wanted } from '../core/batch/lists'
import type { Core } from '../core/report'
import { CLASSES } from '../core/unpack'
import { cellsAt } from '../mesh/accepted-invalid'
import { type ClassifyCells, checkMesh } from '../mesh/check'
import type { Mesh } from '../mesh/mesh'
import { type MeshCheck, NEEDED } from '../mesh/mesh-check'
import { verticesOf } from '../mesh/vertices-of'
import { FEW, worstFirst } from '../mesh/worst'

/** Lists that the page shows; which checks accept a cell, and minimizers, are asked for when they are. */
const LISTS = { minima: true, minimizers: false, volumes: true, exact: true, acceptedInvalid: true, box: true } as const

/** What is asked of all cells of a mesh that is opened in two steps, at first. */
export const FIRST_LISTS = { ...LISTS, ...NEEDED, volumes: false, relativeMinima: false, worst: FEW } as const

/** Meshes with fewer cells are checked at once. */
const MANY = 50_000

export interface OpeningCheck {
  /** All of it, or all but volumes, relative minima and the order: of these what the `FEW` worst cells have. */
  readonly check: MeshCheck
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
    const candidates = first.openOrders.size > 0 ? null : (first.answers.candidates ?? null)
    // Fewer than the page shows are where hardly any cell is answered.
    if (!candidates || candidates.cells.length < FEW) return { check: await finished(first, tools), finish: null }
    const worst = await worstOf(first, Uint32Array.from(candidates.cells).sort(), tools)
    return { check: { ...first, worst }, finish: () => finished(first, tools) }
  }
  return { check: await checkMesh(mesh, tools, { ...plain, worst: Infinity, lists: LISTS }), finish: null }
}

/** Classifies without the lists that come later, and puts these among the answers, all 0. */
function without(later: Answers, classify: ClassifyCells): ClassifyCells {
  const own = async (points: Float64Array, cells: Uint32Array, wanted: Wanted) => {
    if (!wanted.relativeMinima) return classify(points, cells, wanted)
    const answers = await classify(points, cells, FIRST_LISTS)
    return { ...answers, volumes: later.volumes, relativeMinima: later.relativeMinima }
  }
  return own as ClassifyCells
}

/** The `FEW` worst of some cells; these get volumes and relative minima. */
async function worstOf(check: MeshCheck, candidates: Uint32Array, { classify }: Tools): Promise<Uint32Array> {
  const { points, cells } = check.mesh
  const found = await classify(points, cellsAt(cells, candidates), { volumes: true, relativeMinima: true })
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

const LEAST_NORMAL = 2 ** -1022

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
    if (statuses[cell] !== 0) {
      relativeMinima[cell] = Number.NaN
      continue
    }
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
