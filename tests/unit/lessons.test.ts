/** The lessons as content: every claim at its step's own element, formulas, links, and what the lens is asked to show. */
import { describe, expect, it } from 'vitest'
import { hashOf, neighbour, placeOf, type StepPlace } from '../../web/app/lessons/address'
import { stateOf, verticesOf } from '../../web/app/lessons/step-state'
import { lessons } from '../../web/content/lessons'
import { quantitiesOf } from '../../web/content/quantities'
import { isMet, parseCondition } from '../../web/model/condition'
import { readState } from '../../web/model/state-document'
import { core, entry } from './core-fixtures'

const places: readonly StepPlace[] = lessons.flatMap(lesson => lesson.steps.map((_, step) => ({ lesson, step })))
const steps = places.map(place => ({ name: hashOf(place), step: entry(place.lesson.steps, place.step) }))

function reportOf(vertices: readonly number[]) {
  const result = core.analyze(vertices)
  if (!result.ok) throw new Error(result.error.message)
  return result.value
}

it('six lessons, in the order in which they build on each other', () => {
  expect(lessons.map(({ id }) => id)).toEqual([
    'what-the-jacobian-determinant-is',
    'corners-are-not-enough',
    'edges-are-not-enough',
    'faces-are-enough',
    'strictly',
    'finding-the-minimum',
  ])
})

it('every link leads to its step and no two to the same, others to the beginning', () => {
  expect(new Set(places.map(hashOf)).size).toBe(places.length)
  for (const place of places) expect(placeOf(hashOf(place))).toEqual(place)
  for (const hash of ['', '#', '#nowhere/2', '#strictly/0', '#strictly/99', '#strictly/x', '#strictly'])
    expect(placeOf(hash)).toEqual({ lesson: hash.includes('strictly') ? lessons[4] : lessons[0], step: 0 })
})

it('forwards from the first step one comes through all of them, and back', () => {
  for (const [i, place] of places.entries()) {
    expect(neighbour(place, 1)).toEqual(places[i + 1] ?? null)
    expect(neighbour(place, -1)).toEqual(places[i - 1] ?? null)
  }
})

describe('every step', () => {
  it.each(steps)('$name: what it claims is so', ({ step }) => {
    const vertices = verticesOf(step)
    const quantities = quantitiesOf(reportOf(vertices), vertices)
    for (const { says, holds } of step.claims) {
      const condition = parseCondition(holds)
      expect(condition.ok, holds).toBe(true)
      if (condition.ok) expect(isMet(condition.value, quantities), `${says}: ${holds}`).toBe(true)
    }
  })

  it.each(steps)('$name: the lens understands it', ({ step }) => {
    const result = readState(stateOf(step))
    expect(result).toMatchObject({ ok: true })
    if (result.ok) expect({ ...result.value.state, ...result.value.cameras }).toMatchObject(step.state ?? {})
    const views = step.views.split(' ')
    expect(views).toContain('scene')
    for (const panel of step.state?.openPanels ?? []) expect(views).toContain(panel)
  })

  it.each(steps)('$name: plain words, and formulas that are well formed', ({ step }) => {
    expect(step.title).not.toMatch(/[.<]/)
    for (const html of [step.text, `<p>${step.task}</p>`]) {
      expect(unclosed(html)).toEqual([])
      expect(html.match(/<math/g) ?? []).toHaveLength((html.match(/<\/math>/g) ?? []).length)
      for (const formula of html.match(/<math[\s\S]*?<\/math>/g) ?? []) {
        const texts = formula.replace(/<(mi|mn|mo|mtext)\b[^>]*>[^<]+<\/\1>/g, '').replace(/<[^>]+>/g, '')
        expect(texts, formula).toBe('')
      }
      expect(html.replace(/<[^>]*>/g, ''), 'a true minus sign').not.toMatch(/(^|\s)-\d/)
    }
    expect(step.task).toMatch(/[.?]$/)
    for (const { says } of step.claims) expect(says).not.toMatch(/[.]$/)
  })
})

/** Names of elements that are not closed in their order. */
function unclosed(html: string): string[] {
  const open: string[] = []
  for (const [, slash, name = ''] of html.matchAll(/<(\/?)([a-z]+)[^>]*>/g)) {
    if (!slash) open.push(name)
    else if (open.pop() !== name) return [...open, `/${name}`]
  }
  return open
}
