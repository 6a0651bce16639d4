/** The language of conditions: what it reads, what it refuses and where, and what it makes of open numbers. */
import { describe, expect, it } from 'vitest'
import { parseCondition, type Quantities, truthOf } from '../../web/model/condition'
import type { Enclosure } from '../../web/model/condition/enclosure'
import { scaledDouble } from '../../web/model/rational'

const between = (lower: number, upper: number): Enclosure => ({
  lower: scaledDouble(lower, 0),
  upper: scaledDouble(upper, 0),
})

/** centre is 3, corner_min 1/4, edge_min only known to be in [1, 2], volume_min exactly known where asked for exactly. */
const answers: Quantities = {
  claim: () => false,
  roughly: name => {
    if (name === 'centre') return between(3, 3)
    if (name === 'corner_min') return between(0.25, 0.25)
    if (name === 'edge_min') return between(1, 2)
    return null
  },
  exactly: name => {
    if (name === 'edge_min') return between(1, 1.5)
    return name === 'volume_min' ? between(-2, -2) : (answers.roughly(name) ?? between(0, 0))
  },
}

function truth(text: string): boolean | null {
  const result = parseCondition(text)
  if (!result.ok) throw new Error(`${text}: ${result.error.message} (${result.error.at})`)
  return truthOf(result.value, answers)
}

describe('a condition', () => {
  it.each([
    ['not valid', true],
    ['valid or centre = 3', true],
    ['valid and centre = 3', false],
    ['not valid and centre = 3 or valid', true],
    ['not (valid or centre = 3)', false],
    ['not not valid', false],
    ['centre < 3', false],
    ['centre <= 3', true],
    ['centre > 2.999', true],
    ['centre >= 3', true],
    ['centre != 3', false],
    ['centre ≥ 3 and centre ≤ 3 and centre ≠ −3', true],
    ['0 < corner_min < 1/3 < centre', true],
    ['0 < corner_min > 1/3', false],
    ['corner_min = 0.25', true],
    ['corner_min = 2.5e-1', true],
    ['corner_min = .25e+0', true],
    ['corner_min - 1/4 = 0', true],
    ['3 * corner_min = 3/4', true],
    ['1 + 2 * 3 = 7', true],
    ['(1 + 2) * 3 = 9', true],
    ['8 / 4 / 2 = 1', true],
    ['8 - 4 - 2 = 2', true],
    ['--3 = 3 and -3 * -3 = 9', true],
    ['0.1 + 0.2 = 0.3', true],
    ['1e400 > 1e399', true],
    ['1 / -2 < 0', true],
  ])('%s: %s', (text, expected) => {
    expect(truth(text)).toBe(expected)
  })

  it('is decided from what is known of a number, else from the exact one, else not at all', () => {
    expect(truth('edge_min > 1/2')).toBe(true)
    expect(truth('edge_min < 7/4')).toBe(true)
    expect(truth('edge_min < 5/4')).toBe(null)
    expect(truth('not edge_min < 5/4')).toBe(null)
    expect(truth('edge_min = edge_min')).toBe(null)
    expect(truth('edge_min < 5/4 or centre = 3')).toBe(true)
    expect(truth('edge_min < 5/4 and centre < 3')).toBe(false)
    expect(truth('volume_min = -2')).toBe(true)
    expect(truth('edge_min * volume_min <= -2 and volume_min / edge_min >= volume_min')).toBe(true)
    expect(truth('1 / (edge_min - 1.25) > 0')).toBe(null)
    expect(truth('1 / 0 > 0')).toBe(null)
  })

  it('names what it speaks of, each once', () => {
    const result = parseCondition('valid or -(centre + corner_min) / 2 > centre * 1 and not corner_min < 1')
    expect(result.ok && result.value.names).toEqual(['valid', 'centre', 'corner_min'])
  })
})

it.each([
  ['', 0, 'There is no condition.'],
  ['  ', 0, 'There is no condition.'],
  ['centre', 0, 'This is a number; compare it with another, as in “> 0”.'],
  ['not 3', 4, 'This is a number; compare it with another, as in “> 0”.'],
  ['valid and centre', 10, 'This is a number; compare it with another, as in “> 0”.'],
  ['valid = 1', 0, 'This is true or false, and no number.'],
  ['1 < (valid)', 4, 'This is true or false, and no number.'],
  ['-valid < 1', 1, 'This is true or false, and no number.'],
  ['2 * valid > 0', 4, 'This is true or false, and no number.'],
  ['(centre > 0) > 0', 0, 'This is true or false, and no number.'],
  ['centre >', 8, 'The condition breaks off: a number or a name is missing.'],
  ['centre > 0 and', 14, 'The condition breaks off: a number or a name is missing.'],
  ['centre > ) 0', 9, 'Before “)” a number or a name is missing.'],
  ['and valid', 0, 'Before “and” a number or a name is missing.'],
  ['centre == 0', 8, 'Before “=” a number or a name is missing.'],
  ['(centre > 0', 11, 'Here a parenthesis has to close.'],
  ['centre > 0)', 10, '“)” cannot stand here.'],
  ['centre > 0 valid', 11, '“valid” cannot stand here.'],
  ['1 2 > 0', 2, '“2” cannot stand here.'],
  ['centre > 0; alert(1)', 10, '“;” is nothing that a condition knows.'],
  ['constructor > 0', 0, '“constructor” is not a name that a condition knows'],
  ['centre > 1e401', 9, 'This number is too large or too small.'],
  ['centre > 1e99999999999', 9, 'This number is too large or too small.'],
  [`centre > ${'0'.repeat(1000)}`, 1000, 'A condition has at most 1000 characters.'],
])('%s is refused at %i: %s', (text, at, message) => {
  const result = parseCondition(text)
  expect(result.ok).toBe(false)
  if (result.ok) return
  expect(result.error.message).toContain(message)
  expect(result.error.at).toBe(at)
})
