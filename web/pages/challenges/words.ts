/** Conditions and numbers of a challenge as people read them. */
import { numbers, shownNumber } from '../../core/quantities'
import type { Report } from '../../core/report'
import type { Condition } from '../../model/condition'
import { isNumberName, type NumberName } from '../../model/condition/names'
import { formatJacdet, formatNumber } from '../../model/decimal'
import type { Challenge, Contest } from './challenge'

const SIGNS: readonly (readonly [RegExp, string])[] = [
  [/<=/g, '≤'],
  [/>=/g, '≥'],
  [/!=/g, '≠'],
  [/-/g, '−'],
  [/\*/g, '·'],
]

/** "corner_min >= 0" as "Corner minimum ≥ 0". */
export function conditionInWords({ text, names }: Condition): string {
  const printed = SIGNS.reduce((words, [sign, better]) => words.replace(sign, better), text)
  const named = names.filter(isNumberName).reduce((words, name) => {
    return words.replace(new RegExp(`\\b${name}\\b`, 'g'), numbers[name].name)
  }, printed)
  const claimed = named.replace(/\bnot valid\b/g, 'invalid')
  return claimed.charAt(0).toUpperCase() + claimed.slice(1)
}

/** The element's numbers that are in the condition. */
export function numbersInWords(condition: Condition, report: Report, start: Challenge['start']): string {
  const names = condition.names.filter(isNumberName)
  if (names.length === 0) return report.valid ? 'it is valid' : 'it is invalid'
  return names.map(name => numberInWords(name, report, start)).join(' and ')
}

export function numberInWords(name: NumberName, report: Report, start: Challenge['start']): string {
  const { value, exponent } = shownNumber(name, report, start)
  return numbers[name].unit === 'jacdet' ? formatJacdet(value, exponent, 'unit') : formatNumber(value)
}

/** "Twist: the greatest wins." */
export function contestInWords({ quantity, best }: Contest): string {
  return `${numbers[quantity].name}: the ${best} wins.`
}
