/** The output for people: a verdict, its basis, and the worst cells. */
import { isWhollyAnswered } from '../mesh/check'
import { countSentences, headline } from '../mesh/check-summary'
import type { MeshCheck } from '../mesh/mesh-check'
import { formatPoint, speakJacdet, speakNumber } from '../model/decimal'
import { type Output, shown, withoutControls } from './output'

export interface TextOptions {
  /** True if the worst are listed even if nothing is wrong with them. */
  readonly listsAll: boolean
  readonly minRelative: number | null
  readonly skipsDegenerate: boolean
  /** True if others could have been asked for at once. */
  readonly isOneStep: boolean
}

export function textOutput(options: TextOptions): Output {
  let count = 0
  return {
    lists: {},
    *file(result) {
      if (count++ > 0) yield '\n'
      const file = withoutControls(result.file)
      if ('error' in result) yield `${file}: not read.\n  ${result.error}\n`
      else for (const line of lines(file, result.check, options)) yield `${line}\n`
    },
    *end() {},
  }
}

function* lines(file: string, check: MeshCheck, options: TextOptions): Generator<string> {
  const { mesh, below, notes } = check
  yield `${file} (${mesh.format}): ${headline(check, options)}`
  if (options.minRelative !== null) yield `  ${below} with a relative minimum below ${options.minRelative}.`
  for (const sentence of countSentences(check, options)) yield `  ${sentence}`
  for (const note of notes) yield `  ${note}`
  if (options.isOneStep && mesh.steps.length > 1 && !mesh.isSteady) yield '  --step all checks every step.'
  if (!isWhollyAnswered(check) && check.invalid === 0 && below === 0)
    yield '  Not all could be answered: exit status 3, or 0 with --allow-unchecked.'
  yield* worstLines(check, options)
}

function* worstLines(check: MeshCheck, options: TextOptions): Generator<string> {
  const { worst, mesh } = check
  const isBad = (cell: number) => check.standingOf(cell) === 'invalid' || check.isBelow(cell)
  if (worst.length === 0) return
  const listed = options.listsAll ? worst : worst.filter(isBad)
  if (listed.length === 0) {
    if (check.isAnswered(worst[0] as number)) yield `  Least: ${leastOf(check, worst[0] as number)}`
    return
  }
  yield '  Worst first, by the minimum of jacdet over |volume|:'
  const name = mesh.ids === null ? 'index' : 'id'
  const header = [name, 'block', 'relative', 'minimum', 'at', 'accepted by']
  const rows = listed.length > MOST_ALIGNED ? [header] : [header, ...[...listed].map(cell => row(check, cell))]
  const hasBlocks = mesh.blocks.length > 0
  const columns = header.map((_, i) => i).filter(i => hasBlocks || i !== 1)
  const widths = columns.map(i => Math.max(...rows.map(fields => (fields[i] as string).length), 6))
  const aligned = (fields: readonly string[]) =>
    `    ${columns.map((i, c) => (fields[i] as string).padEnd(widths[c] as number)).join('  ')}`.trimEnd()
  for (const fields of rows) yield aligned(fields)
  if (listed.length > MOST_ALIGNED) for (const cell of listed) yield aligned(row(check, cell))
}

/** Columns are as wide as what is in them where rows are few; else they are not held in memory. */
const MOST_ALIGNED = 1000

function row(check: MeshCheck, cell: number): string[] {
  const name = [check.idOf(cell) ?? String(cell), check.blockOf(cell) ?? '-'].map(text => shown(text).slice(1, -1))
  const answer = check.answerTo(cell)
  if ('why' in answer) return [...name, '-', '-', '-', answer.why]
  const { relativeMinimum, boundaryMinimum, exponent, minimizer, checks } = answer.report
  const accepting = checks.filter(({ passes }) => passes).map(({ id }) => id)
  return [
    ...name,
    relativeMinimum === null ? 'none' : speakNumber(relativeMinimum),
    speakJacdet(boundaryMinimum, exponent, 'unit'),
    `${minimizer.kind} ${minimizer.id}${minimizer.kind === 'vertex' ? '' : ` ${ascii(formatPoint(minimizer.point))}`}`,
    accepting.length === 0 ? 'none' : accepting.length === checks.length ? 'all' : accepting.join(', '),
  ]
}

function leastOf(check: MeshCheck, cell: number): string {
  const [name, , relative, minimum, at] = row(check, cell)
  return `relative minimum ${relative}, minimum ${minimum}, ${check.mesh.ids === null ? 'index' : 'id'} ${name} at ${at}.`
}

function ascii(text: string): string {
  return text.replaceAll('−', '-')
}
