/** The line over the steps of a mesh, and what is said of it. */
import { describe, expect, test } from 'vitest'
import {
  type Answers,
  besideSentences,
  firstInvalid,
  lineSentence,
  type StepAnswer,
  stepName,
  timeWords,
} from '../../web/mesh/step-answers'
import { stepLineOf, stepWords } from '../../web/pages/mesh/step-line'
import type { StepList } from '../../web/survey/survey-jobs'

type Made = Partial<StepAnswer> & { readonly invalid?: number; readonly unanswered?: number }

function answer(step: number, least: number | null, made: Made = {}): StepAnswer {
  const { invalid = least !== null && least <= 0 ? 1 : 0, unanswered = 0, ...others } = made
  return {
    step,
    time: String(step / 10),
    counts: { hexahedra: 1200, invalid, unanswered },
    least,
    worst: { cell: 10 * step, id: String(100 + step) },
    isOther: false,
    refused: null,
    ...others,
  }
}

function refused(step: number): StepAnswer {
  return answer(step, null, { counts: null, worst: null, time: null, refused: 'w.vtu: no.' })
}

function listOf(answers: Answers): StepList {
  const steps = answers.map((_, step) => ({ name: `w_${step}.vtu`, time: null }))
  return { sentences: [], areFiles: true, steps, shown: 0, answer: answers[0] ?? refused(0) }
}

const sentence = (answers: Answers) => lineSentence(listOf(answers), answers)

describe('the sentence', () => {
  const [one, two, three] = [answer(0, 0.9), answer(1, 0.5), answer(2, 0.7)]
  test.each<readonly [string, Answers]>([
    ['Step 3 (t = 0.2) is the first with an invalid cell: cell 102.', [one, two, answer(2, -0.1), answer(3, -0.5)]],
    [
      'Step 2 (t = 0.1) is the first with invalid cells, 1,100 of them: the worst is cell 101.',
      [one, answer(1, -2, { invalid: 1100 })],
    ],
    [
      'Step 2 (t = 0.1) is the first of those that could be read with an invalid cell: cell 101.',
      [refused(0), answer(1, 0)],
    ],
    ['Step 2 (t = 0.1) is the first so far with an invalid cell: cell 101.', [null, answer(1, -1), null]],
    ['No step has an invalid cell. The least relative minimum is 0.5: step 2 (t = 0.1), cell 101.', [one, two, three]],
    [
      'No step is known to have an invalid cell. The least relative minimum is 0.5: step 2 (t = 0.1), cell 101.',
      [one, answer(1, 0.5, { unanswered: 2 })],
    ],
    [
      'No step is known to have an invalid cell. The least relative minimum is 0.9: step 1 (t = 0), cell 100.',
      [one, refused(1)],
    ],
    ['2 of 4 steps are read: no cell is invalid.', [one, two, null, null]],
    ['', [null, null]],
    ['', [refused(0), refused(1)]],
  ])('%s', (expected, answers) => {
    expect(sentence(answers)).toBe(expected)
  })

  test('names a step by its file where it has no time', () => {
    const answers = [answer(0, 1, { time: null }), answer(1, 1)]
    expect(stepName(listOf(answers), answers, 0)).toBe('Step 1 (w_0.vtu)')
  })

  test('others say what could not be read, is unanswered or has other cells', () => {
    const answers = [
      answer(0, 1),
      refused(1),
      refused(2),
      answer(3, 1, { unanswered: 1 }),
      answer(4, 1, { isOther: true }),
    ]
    expect(besideSentences(listOf(answers), answers)).toEqual([
      '2 steps could not be read, first step 2 (w_1.vtu): w.vtu: no.',
      'Step 4 (t = 0.3) has unanswered cells.',
      'Step 5 (t = 0.4) has other cells than the step that was opened first.',
    ])
  })

  test('the slider says what its step is', () => {
    const answers = [answer(0, -Infinity), refused(1), null]
    const list = listOf(answers)
    expect([0, 1, 2].map(step => stepWords(list, answers, step))).toEqual([
      'Step 1 of 3, t = 0: 1 of 1,200 cells is invalid, least relative minimum none, volume 0',
      'Step 2 of 3: not read',
      'Step 3 of 3',
    ])
  })
})

describe('the line', () => {
  const line = (answers: Answers) => stepLineOf(listOf(answers), answers)

  test('rises with the numbers, has zero between the signs, and gaps where there is none', () => {
    const answers = [
      answer(0, 0.9),
      answer(1, 0.1),
      null,
      answer(3, -0.2),
      refused(4),
      answer(5, -50),
      answer(6, -Infinity),
    ]
    const { runs, zero, least, greatest } = line(answers) as NonNullable<ReturnType<typeof line>>
    expect(runs.map(run => run.map(({ step }) => step))).toEqual([[0, 1], [3], [5, 6]])
    const heights = runs.flat().map(({ y }) => y)
    expect(heights).toEqual(heights.toSorted((a, b) => a - b))
    expect(heights[1]).toBeLessThan(zero)
    expect(heights[2]).toBeGreaterThan(zero)
    expect(heights.every(y => y >= 0 && y <= 1)).toBe(true)
    expect([least, greatest]).toEqual([-50, 0.9])
    expect(runs.flat().map(({ isInvalid }) => isInvalid)).toEqual([false, false, true, true, true])
  })

  test('is over the times where these rise, else over the steps', () => {
    const at = (times: readonly (string | null)[]) => line(times.map((time, step) => answer(step, 1, { time })))?.places
    expect(at(['0', '1', '4'])).toEqual([0, 0.25, 1])
    expect(at(['0', '4', '4'])).toEqual([0, 1, 1])
    expect(at(['0', '4', '1'])).toEqual([0, 0.5, 1])
    expect(at(['2', '2', '2'])).toEqual([0, 0.5, 1])
    expect(at(['0', null, '1'])).toEqual([0, 0.5, 1])
    expect(at(['a', '1', '2'])).toEqual([0, 0.5, 1])
  })

  test('is none without a number', () => {
    expect(line([refused(0), null])).toBe(null)
    expect(firstInvalid([refused(0), null])).toBe(null)
  })
})

test('times are as the files have them, but for digits beyond single precision', () => {
  expect(['0.0', '0.25', '1e-12', '0.0799999982118607', '1234567.891234', 'summer', ''].map(timeWords)).toEqual([
    '0.0',
    '0.25',
    '1e-12',
    '0.08',
    '1234568',
    'summer',
    '',
  ])
})
