/** Conditions as rows of menus and as text: what is the same condition, and what menus cannot say. */
import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { parseCondition } from '../../web/model/condition'
import { NUMBERS } from '../../web/model/condition/names'
import { COMPARISONS } from '../../web/model/condition/parse'
import {
  mistakeIn,
  newRow,
  type Row,
  rowOf,
  rowsOf,
  SUBJECTS,
  subjectOf,
  textOfRow,
  textOfRows,
  withSubject,
} from '../../web/pages/conditions/rows'

const number = fc.oneof(
  fc.integer({ min: -99, max: 99 }).map(String),
  fc.tuple(fc.integer({ min: -9, max: 9 }), fc.integer({ min: 1, max: 9 })).map(([a, b]) => `${a}/${b}`),
  fc.double({ min: 0, max: 1e6, noNaN: true }).map(String),
)
const menuRow: fc.Arbitrary<Row> = fc.oneof(
  fc.boolean().map(isValid => ({ kind: 'claim' as const, isValid })),
  fc.record({
    kind: fc.constant('comparison' as const),
    quantity: fc.constantFrom(...NUMBERS),
    comparison: fc.constantFrom(...COMPARISONS),
    number,
  }),
)

describe('conditions as rows', () => {
  it('of menus come back from their text', () => {
    fc.assert(
      fc.property(fc.array(menuRow, { maxLength: 8 }), rows => {
        expect(rowsOf(textOfRows(rows))).toEqual(rows)
        expect(rows.map(mistakeIn)).toEqual(rows.map(() => null))
      }),
    )
  })

  it('say the same as the text, however it is written', () => {
    const texts = fc.oneof(
      fc
        .tuple(
          fc.constantFrom(...NUMBERS),
          fc.constantFrom(...COMPARISONS, '≤', '≥', '≠'),
          number,
          fc.constantFrom('', ' ', '  '),
        )
        .map(([name, sign, value, space]) => `${space}${name}${space}${sign}${space}${value}${space}`),
      fc.constantFrom(
        'not valid',
        'valid',
        'not not valid',
        'corner_min > edge_min',
        '0 < centre',
        '0 < centre < 1',
        'valid and twist > 3',
      ),
    )
    fc.assert(
      fc.property(texts, text => {
        const [one, other] = [parseCondition(text), parseCondition(textOfRow(rowOf(text)))]
        expect(one.ok && other.ok && other.value.claim).toEqual(one.ok && one.value.claim)
      }),
    )
  })

  it.each([
    ['not  valid', { kind: 'claim', isValid: false }],
    ['corner_min>=−1/8', { kind: 'comparison', quantity: 'corner_min', comparison: '>=', number: '−1/8' }],
    ['twist > (1 + 2) * 3', { kind: 'comparison', quantity: 'twist', comparison: '>', number: '(1 + 2) * 3' }],
    ['corner_min > edge_min', { kind: 'text', text: 'corner_min > edge_min' }],
    ['0 < centre', { kind: 'text', text: '0 < centre' }],
    ['0 < centre < 1', { kind: 'text', text: '0 < centre < 1' }],
    ['(centre) > 1', { kind: 'text', text: '(centre) > 1' }],
    ['smoothness > 3', { kind: 'text', text: 'smoothness > 3' }],
  ])('%s', (text, row) => {
    expect(rowOf(text)).toEqual(row)
  })

  it.each<[Row, RegExp]>([
    [{ kind: 'comparison', quantity: 'twist', comparison: '>', number: ' ' }, /^Here a number is missing\.$/],
    [{ kind: 'comparison', quantity: 'twist', comparison: '>', number: '0,5' }, /“,”/],
    [{ kind: 'comparison', quantity: 'twist', comparison: '>', number: 'centre' }, /^A number is wanted here/],
    [{ kind: 'comparison', quantity: 'twist', comparison: '>', number: '0 or valid' }, /^A number is wanted here/],
    [{ kind: 'text', text: 'valid and smooth' }, /^At character 11: “smooth” is not a name/],
    [{ kind: 'text', text: '' }, /^At character 1: There is no condition\.$/],
  ])('%# with a mistake is told so', (row, sentence) => {
    expect(mistakeIn(row)).toMatch(sentence)
  })

  it('keep what has a place when another subject is chosen', () => {
    const row: Row = { kind: 'comparison', quantity: 'twist', comparison: '<', number: '7' }
    expect(withSubject(row, 'centre')).toEqual({ ...row, quantity: 'centre' })
    expect(withSubject(row, 'text')).toEqual({ kind: 'text', text: 'twist < 7' })
    for (const subject of SUBJECTS) expect(subjectOf(withSubject(row, subject))).toBe(subject)
  })

  it('are added without a mistake and without a contradiction', () => {
    let rows: readonly Row[] = []
    for (let n = 0; n < SUBJECTS.length + 2; n++) rows = [...rows, newRow(rows)]
    expect(rows.map(mistakeIn).every(mistake => mistake === null)).toBe(true)
    const subjects = rows.map(subjectOf)
    expect(subjects.includes('valid') && subjects.includes('invalid')).toBe(false)
  })
})
