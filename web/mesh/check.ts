/**
 * The check of a mesh: counts of valid hexahedra, the worst of them, and sentences for people.
 * Pure: batches and single elements are answered by whoever is given, so that it runs on a page and
 * in Node.
 */

import type { Classification } from '../core/batch/classify'
import { STATUSES, type Wanted } from '../core/batch/lists'
import type { Core } from '../core/report'
import { CLASSES } from '../core/unpack'
import type { NodeOrder } from '../model/node-orders'
import { countOf, eachPlace, turned } from './bytes'
import { checkNotes } from './check-notes'
import { firstBlocks, type Mesh } from './mesh'
import { type CheckAnswers, type MeshCheck, NEEDED, STANDINGS, type Standing } from './mesh-check'
import { openOrdersOf } from './open-orders'
import { verticesOf } from './vertices-of'
import { worstFirst } from './worst'

/** The answers of a Classifier for lists that are whole. */
export type ClassifyCells = <W extends Wanted>(
  points: Float64Array,
  cells: Uint32Array,
  wanted: W,
) => Promise<Classification<W>>

export interface CheckOptions {
  /** The number of worst cells that are put in order; Infinity for all. */
  readonly worst: number
  /** Cells whose relative minimum is less are counted in `below`. */
  readonly minRelative: number | null
  /** Cells with coincident vertices are counted in `degenerate` alone, and not among the worst. */
  readonly skipsDegenerate: boolean
  /** Lists that are wanted beside those that the counts need. */
  readonly lists?: Wanted
}

export async function checkMesh(
  mesh: Mesh,
  { classify, core }: { readonly classify: ClassifyCells; readonly core: Core },
  { worst, minRelative, skipsDegenerate, lists = {} }: CheckOptions,
): Promise<MeshCheck> {
  const { points, cells, notTrilinear } = mesh
  const hexahedra = cells.length / 8
  const answers: CheckAnswers = await classify(points, cells, { ...lists, ...NEEDED })
  const byCorners = await classify(points, notTrilinear.corners, {})
  const { coincident } = answers

  const openOrders = mesh.isOrderStated ? new Map<number, NodeOrder>() : openOrdersOf(mesh, answers.valid, core)

  const standings = standingsOf({ answers, openOrders, coincident: skipsDegenerate ? coincident : null })
  const isAnswered = (cell: number) => IS_ANSWERED[answers.statuses[cell] as number] === 1 && !openOrders.has(cell)
  const standingOf = (cell: number) => STANDINGS[standings[cell] as number] as Standing
  const isBelow = (cell: number) => minRelative !== null && isLess(answers, cell, minRelative)

  const counts = standingCounts(answers, standings, openOrders.size === 0 && !skipsDegenerate)
  let below = 0
  if (minRelative !== null)
    for (let cell = 0; cell < hexahedra; ++cell) if ((standings[cell] as number) <= INVALID && isBelow(cell)) below++
  const severity = {
    relativeMinima: answers.relativeMinima,
    isCollapsed: (cell: number) => CLASSES[answers.classes[cell] as number] === 'collapsed',
    isUnanswered: (cell: number) => !isAnswered(cell),
  }
  const check = {
    mesh,
    answers,
    hexahedra,
    standings,
    ...counts,
    degenerate: answers.coincidentCount,
    below,
    notTrilinear: { count: notTrilinear.corners.length / 8, validByCorners: byCorners.validCount },
    worst: worstFirst(hexahedra, severity, worst, cell => standingOf(cell) !== 'degenerate'),
    openOrders,
    standingOf,
    isAnswered,
    isBelow,
    idOf: (cell: number) => (mesh.ids === null ? null : String(mesh.ids[cell])),
    blockOf: blocksByCell(mesh),
    answerTo(cell: number) {
      const order = openOrders.get(cell)
      if (order) return { why: `The order of its nodes is not stated; in the order “${order.name}” it is valid.` }
      const result = core.analyze(verticesOf(mesh, cell))
      return result.ok ? { report: result.value } : { why: result.error.message }
    },
  }
  return { ...check, notes: [...mesh.notes, ...checkNotes(check)] }
}

/** Of STANDINGS; those of valid and invalid cells are `valid` turned. */
const [INVALID, UNANSWERED, DEGENERATE] = [1, 2, 3] as const
const INVERTED = CLASSES.indexOf('inverted')
const IS_ANSWERED = Uint8Array.from(STATUSES, status => Number(status === undefined))

interface StandingCounts {
  readonly valid: number
  readonly invalid: number
  readonly unanswered: number
  readonly mirrored: number
}

/** As batches count, where the standings are the answers and nothing else. */
function standingCounts(answers: CheckAnswers, standings: Uint8Array, areAnswers: boolean): StandingCounts {
  const { validCount: valid, invalidCount: invalid, unansweredCount: unanswered, invertedCount: mirrored } = answers
  if (areAnswers) return { valid, invalid, unanswered, mirrored }
  const own = [INVALID, UNANSWERED, DEGENERATE].map(each => countOf(standings, each))
  const [ownInvalid, ownUnanswered, degenerate] = own as [number, number, number]
  let ownMirrored = 0
  eachPlace(answers.classes, INVERTED, cell => {
    if (standings[cell] === INVALID) ownMirrored++
  })
  const ownValid = standings.length - ownInvalid - ownUnanswered - degenerate
  return { valid: ownValid, invalid: ownInvalid, unanswered: ownUnanswered, mirrored: ownMirrored }
}

/** Cells that are `coincident` are degenerate and nothing else. */
function standingsOf({
  answers: { valid, statuses, unansweredCount },
  openOrders,
  coincident,
}: Pick<MeshCheck, 'answers' | 'openOrders'> & { readonly coincident: Uint8Array | null }): Uint8Array {
  const standings = turned(valid)
  if (unansweredCount > 0)
    for (let cell = 0; cell < standings.length; ++cell)
      if (IS_ANSWERED[statuses[cell] as number] === 0) standings[cell] = UNANSWERED
  for (const cell of openOrders.keys()) standings[cell] = UNANSWERED
  if (coincident)
    for (let cell = 0; cell < standings.length; ++cell) if (coincident[cell] === 1) standings[cell] = DEGENERATE
  return standings
}

/** A cell of volume 0 is below everything if its minimum is negative, else it stands among the zeros. */
function isLess({ relativeMinima, classes }: CheckAnswers, cell: number, bound: number): boolean {
  const relative = relativeMinima[cell] as number
  if (!Number.isNaN(relative)) return relative < bound
  return CLASSES[classes[cell] as number] === 'collapsed' ? bound > 0 : true
}

/** The blocks are gone through when a cell's is first asked for. */
function blocksByCell(mesh: Mesh): (cell: number) => string | null {
  let places: Uint32Array | null | undefined
  return cell => {
    places ??= firstBlocks(mesh)
    return mesh.blocks[places?.[cell] ?? mesh.blocks.length]?.name ?? null
  }
}

/** 0 all valid; 1 invalid ones, or some below the bound; 2 unreadable; 3 nothing invalid, but not all could be answered. */
export type ExitStatus = 0 | 1 | 2 | 3

export function exitOf(check: MeshCheck, { allowsUnchecked }: { readonly allowsUnchecked: boolean }): ExitStatus {
  if (check.invalid > 0 || check.below > 0) return 1
  return isWhollyAnswered(check) || allowsUnchecked ? 0 : 3
}

/** Cells that are not hexahedra are nobody's question. */
export function isWhollyAnswered({ mesh, hexahedra, unanswered, notTrilinear }: MeshCheck): boolean {
  return hexahedra > 0 && unanswered === 0 && notTrilinear.count === 0 && !mesh.isCutOff
}

/** The gravest of several files: 2 before 1 before 3 before 0. */
export function gravestExit(exits: readonly ExitStatus[]): ExitStatus {
  return ([2, 1, 3] as const).find(exit => exits.includes(exit)) ?? 0
}
