/** Cells that meet a condition: by intervals where they decide it, else by the core's report. */
import { FALSE, filterOf, OPEN, TRUE } from '../core/filter/filter'
import { quantitiesOf } from '../core/quantities'
import { verticesOf } from '../mesh/vertices-of'
import { isMet, parseCondition } from '../model/condition'
import { exactly } from '../model/condition/enclosure'
import type { NumberNode } from '../model/condition/parse'
import { scaledInteger } from '../model/rational'
import type { Meeting } from './selection'

/** Cells that are unanswered meet no condition. */
export const meeting: Meeting = (check, core, text) => {
  const parsed = parseCondition(text)
  if (!parsed.ok) throw new RangeError(parsed.error.message)
  const condition = parsed.value
  const own = new Float64Array(24)
  const filter = filterOf(condition, NO_MEASURE, NOWHERE, core)
  return cell => {
    if (!check.isAnswered(cell)) return false
    const isValid = check.answers.valid[cell] === 1
    const vertices = verticesOf(check.mesh, cell)
    own.set(vertices)
    const mayBe = isValid ? filter.mayBe.valid : filter.mayBe.invalid
    const truth = !isOrdinary(own) ? OPEN : mayBe ? filter.judge(own, 0, isValid) : FALSE
    if (truth !== OPEN) return truth === TRUE
    const report = core.analyze(vertices)
    return report.ok && isMet(condition, quantitiesOf(report.value, vertices))
  }
}

/** The filter's bounds are for products of three coordinates within the range of doubles. */
function isOrdinary(vertices: Float64Array): boolean {
  let greatest = 0
  for (const coordinate of vertices) greatest = Math.max(greatest, Math.abs(coordinate))
  return greatest > 2 ** -300 && greatest < 2 ** 300
}

const NO_MEASURE: NumberNode = { kind: 'constant', value: exactly(scaledInteger(0n, 0)) }
/** The place from which `moved` would count: nobody asks for it here. */
const NOWHERE: readonly number[] = new Array(24).fill(0)
