/** How often other checks are wrong: over random elements, the invalid ones each accepts and the valid ones each rejects. */
import type { Check, Report } from '../../web/core/report'
import { core, randomHexahedron, randomSource } from '../unit/core-fixtures'

const ELEMENTS = 20000
const SIGMAS = [0.1, 0.2, 0.3, 0.5, 1]

export async function main(): Promise<void> {
  console.log(`${ELEMENTS} elements a column: the unit cube with normal displacements`)
  const columns = SIGMAS.map(sigma => reports(sigma))
  row('sigma', SIGMAS)
  row(
    'invalid',
    columns.map(column => column.filter(({ valid }) => !valid).length),
  )
  for (const id of (columns[0]?.[0]?.checks ?? []).map(check => check.id)) {
    row(`accepted by ${id}`, count(columns, id, false))
    row(`rejected by ${id}`, count(columns, id, true))
  }
}

function reports(sigma: number): Report[] {
  const random = randomSource(1)
  return Array.from({ length: ELEMENTS }, () => {
    const result = core.analyze(randomHexahedron(random, sigma))
    if (!result.ok) throw new Error(result.error.message)
    return result.value
  })
}

/** Of the valid or the invalid elements, those on which the check is wrong. */
function count(columns: readonly Report[][], id: Check['id'], valid: boolean): number[] {
  const isWrong = (report: Report) => report.checks.some(check => check.id === id && check.passes !== valid)
  return columns.map(column => column.filter(report => report.valid === valid && isWrong(report)).length)
}

function row(name: string, values: readonly number[]): void {
  console.log(name.padEnd(32) + values.map(value => String(value).padStart(9)).join(''))
}
