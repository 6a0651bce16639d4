/** Progress of the challenges in storages that keep, refuse, or hold other entries. */
import { afterEach, describe, expect, it, vi } from 'vitest'
import { parseCondition } from '../../web/model/condition'
import { type Challenge, readChallenge } from '../../web/pages/challenges/challenge'
import { challenges } from '../../web/pages/challenges/challenges'
import { Progress } from '../../web/pages/challenges/progress'
import { conditionInWords, numbersInWords } from '../../web/pages/challenges/words'
import { core, unitCube } from './core-fixtures'
import { storage } from './storage'

const KEY = 'hexlens-challenges'

afterEach(() => vi.unstubAllGlobals())

describe('progress', () => {
  it('outlives the page, and is gone when it is forgotten', () => {
    const kept = storage()
    const progress = new Progress()
    expect([progress.count, progress.isKept]).toEqual([0, true])
    progress.add('one-vertex', { best: null })
    progress.add('most-twisted', { best: 151.5 })
    progress.add('most-twisted', { best: 160 })
    const again = new Progress()
    expect([again.count, again.of('one-vertex'), again.of('most-twisted')]).toEqual([2, { best: null }, { best: 160 }])
    expect(again.of('touch-zero')).toBeNull()
    again.forget()
    expect([again.count, kept.size, new Progress().count]).toEqual([0, 0, 0])
  })

  it.each([[['getItem', 'setItem', 'removeItem']], [['setItem', 'removeItem']]])(
    'is known until the page is left where %s is refused',
    refused => {
      storage({}, refused)
      const progress = new Progress()
      progress.add('one-vertex', { best: null })
      expect([progress.count, progress.isKept]).toEqual([1, false])
      progress.forget()
      expect(progress.count).toBe(0)
    },
  )

  it('is there without any storage, too', () => {
    const progress = new Progress()
    progress.add('one-vertex', { best: null })
    expect([progress.count, progress.isKept]).toEqual([1, false])
  })

  it.each(['', '{', 'null', '7', '[]', '{"version":1}', '{"version":1,"solved":{"a":null,"b":7,"c":{"best":"x"}}}'])(
    'is none where somebody has written %s',
    text => {
      storage({ [KEY]: text })
      const progress = new Progress()
      expect(progress.count).toBe(0)
      progress.add('one-vertex', { best: null })
      expect(new Progress().count).toBe(1)
    },
  )

  it('of a later version is neither read nor lost', () => {
    const later = JSON.stringify({ version: 2, solved: { 'one-vertex': { best: null } } })
    const kept = storage({ [KEY]: later })
    const progress = new Progress()
    progress.add('touch-zero', { best: null })
    expect([progress.count, progress.isKept, kept.get(KEY)]).toEqual([1, false, later])
  })
})

describe('a condition in words', () => {
  it.each([
    ['not valid', 'Invalid'],
    ['valid', 'Valid'],
    ['corner_min > 0', 'Corner minimum > 0'],
    ['gauss2_min >= 1/4', '2×2×2 Gauss points ≥ 1/4'],
    ['volume_min < boundary_min', 'Volume minimum < Boundary minimum'],
    ['2 * moved - 1 != 3 or valid', '2 · Moved vertices − 1 ≠ 3 or valid'],
  ])('%s is %s', (text, words) => {
    const result = parseCondition(text)
    expect(result.ok && conditionInWords(result.value)).toBe(words)
  })

  it('has the numbers that it speaks of', () => {
    const result = core.analyze(unitCube)
    if (!result.ok) throw new Error(result.error.message)
    const words = challenges.map(document => {
      const read = readChallenge(document)
      if (!read.ok) throw new Error(read.error.message)
      const challenge: Challenge = { ...read.value, start: unitCube }
      return challenge.goal.map(condition => numbersInWords(condition, result.value, challenge.start))
    })
    expect(words[0]).toEqual(['it is valid', '0'])
    expect(words[5]).toEqual(['1 and 1'])
    expect(words[6]).toEqual(['it is valid', '0', '0'])
  })
})
