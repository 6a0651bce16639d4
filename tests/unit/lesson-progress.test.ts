/** Progress in the lessons: what was seen and answered, in storages that keep, refuse, or hold other entries. */
import { afterEach, expect, it, vi } from 'vitest'
import { addressOf, type StepAddress } from '../../web/pages/lessons/address'
import { lessons } from '../../web/pages/lessons/content/lessons'
import { Progress } from '../../web/pages/lessons/progress'
import { entry } from './core-fixtures'
import { storage } from './storage'

const KEY = 'hexlens-lessons'
const at = (hash: string) => addressOf(hash) as StepAddress
const [first, second] = [at('#quadrilaterals-first/1'), at('#strictly/2')]
const asked = at('#quadrilaterals-first/4')

afterEach(() => vi.unstubAllGlobals())

it('outlives the page, knows the last step, and is gone when it is forgotten', () => {
  const kept = storage()
  const progress = new Progress()
  expect([progress.isEmpty, progress.last, progress.isKept]).toEqual([true, null, true])
  for (const address of [first, second, first]) progress.see(address)
  progress.answer(asked, 2)
  const again = new Progress()
  expect(again.last).toEqual(first)
  expect(lessons.map(lesson => again.countIn(lesson))).toEqual([1, 0, 0, 0, 0, 1, 0])
  expect(again.answerTo(asked)).toBe(2)
  again.forgetAnswer(asked)
  expect(again.answerTo(asked)).toBeUndefined()
  expect(again.last).toEqual(first)
  again.forget()
  expect(kept.size).toBe(0)
  expect(again.isEmpty).toBe(true)
})

it('loses nothing of what another tab has kept since', () => {
  storage()
  const [here, there] = [new Progress(), new Progress()]
  here.see(first)
  there.see(second)
  there.answer(asked, null)
  here.see(first)
  const again = new Progress()
  expect([again.countIn(first.lesson), again.countIn(second.lesson)]).toEqual([1, 1])
  expect(again.answerTo(asked)).toBeNull()
})

it('reads nothing that it does not understand, and overwrites nothing of a later version', () => {
  for (const text of ['', 'null', '7', '[]', '{"version":1}', '{"version":1,"seen":7,"answers":[]}', '{']) {
    storage({ [KEY]: text })
    const progress = new Progress()
    expect([progress.isEmpty, progress.isKept]).toEqual([true, true])
  }
  const seen = ['#strictly/2', '#nowhere/1', 7]
  // No question there; no such choice; an answer to a question of another kind.
  const answers = { '#strictly/1': 0, '#quadrilaterals-first/4': 9, '#quadrilaterals-first/3': 1 }
  storage({ [KEY]: JSON.stringify({ version: 1, seen, answers }) })
  const progress = new Progress()
  expect(progress.last).toEqual(second)
  for (const hash of Object.keys(answers)) expect(progress.answerTo(at(hash))).toBeUndefined()

  const later = JSON.stringify({ version: 2, seen: [] })
  const kept = storage({ [KEY]: later })
  const old = new Progress()
  old.see(first)
  expect([old.isKept, old.last]).toEqual([false, first])
  old.forget()
  expect(kept.get(KEY)).toBe(later)
})

it('lasts until the page is left where nothing can be kept', () => {
  for (const refused of ['getItem', 'setItem']) {
    storage({}, [refused])
    const progress = new Progress()
    progress.see(first)
    progress.answer(asked, 1)
    expect(progress.isKept).toBe(false)
    expect(progress.countIn(entry(lessons, 0))).toBe(1)
    expect(progress.answerTo(asked)).toBe(1)
    expect(() => progress.forget()).not.toThrow()
  }
})
