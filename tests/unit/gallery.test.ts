/** The gallery: each claim holds, exactly; what is said to be a test case or a preset is that one, bit for bit. */
import { describe, expect, it } from 'vitest'
import { quantitiesOf } from '../../web/core/quantities'
import { isMet, parseCondition } from '../../web/model/condition'
import { challenges } from '../../web/pages/challenges/challenges'
import { gallery } from '../../web/pages/gallery/gallery'
import { elementVertices } from '../../web/pages/gallery/gallery-vertices'
import { lessons } from '../../web/pages/lessons/content/lessons'
import { rampOf, type Theme } from '../../web/scene/paint/colour-map'
import { thumbnailAddress, thumbnailMarkup, thumbnailText } from '../../web/scene/paint/thumbnail'
import { cases, caseVertices, core, depthGuardCases, entry, unitCube } from './core-fixtures'

const elements = gallery.flatMap(({ elements }) => elements)

function reportOf(vertices: readonly number[]) {
  const result = core.analyze(vertices)
  if (!result.ok) throw new Error(result.error.message)
  return result.value
}

describe.each(elements)('$title', element => {
  const report = reportOf(elementVertices(element))

  it.each(element.claims)('%s', claim => {
    const condition = parseCondition(claim)
    if (!condition.ok) throw new Error(`${condition.error.message} (${condition.error.at})`)
    expect(isMet(condition.value, quantitiesOf(report, unitCube))).toBe(true)
  })
})

it('names each element once, in sentences', () => {
  for (const of of ['id', 'title'] as const)
    expect(new Set(elements.map(element => element[of])).size).toBe(elements.length)
  expect(new Set(elements.map(element => String(elementVertices(element)))).size).toBe(elements.length)
  for (const { note, source, id } of elements) {
    expect(note).toMatch(/^[A-Z0-9j].*\.$/)
    expect(source).not.toMatch(/\.$/)
    expect(id).toMatch(/^[a-z0-9-]+$/)
  }
})

it('leads to lessons and challenges that there are', () => {
  expect(elements.filter(({ lesson, challenge }) => lesson || challenge).length).toBeGreaterThan(15)
  for (const { lesson, challenge } of elements) {
    if (lesson) expect(lessons.map(({ id }) => id)).toContain(lesson)
    if (challenge) expect(challenges.map(({ id }) => id)).toContain(challenge)
  }
})

it('has the test cases that it names, bit for bit', () => {
  const named = elements.flatMap(element => {
    const name = /^exact test case (.*)$/.exec(element.source)?.[1]
    return name ? [{ element, name: `pub/${name}` }] : []
  })
  expect(named.length).toBeGreaterThan(10)
  for (const { element, name } of named) {
    expect(cases.map(({ name }) => name)).toContain(name)
    // The case has -5.6e-17 where a sine should be zero.
    const expected = caseVertices(name).map(x => (Math.abs(x) === 2 ** -54 ? 0 : x))
    expect(elementVertices(element)).toEqual(expected)
  }
  const depthGuard = elements.find(({ id }) => id === 'depth-guard')
  if (!depthGuard) throw new Error('There is no element that subdivision rejects.')
  expect(depthGuardCases.map(({ vertices }) => String(vertices))).toContain(String(elementVertices(depthGuard)))
})

it('what is said of doubles and of quartics is so', () => {
  for (const id of ['one-ulp-valid', 'one-ulp-invalid'])
    expect(
      reportOf(
        elementVertices(
          entry(
            elements.filter(element => element.id === id),
            0,
          ),
        ),
      ).decidedBy,
    ).toBe('exact')
  const faces = (id: string) =>
    reportOf(
      elementVertices(
        entry(
          elements.filter(element => element.id === id),
          0,
        ),
      ),
    ).faces
  expect(faces('line-of-minimizers').some(({ quarticIsZero }) => quarticIsZero)).toBe(true)
  expect(faces('non-strict').some(({ quarticIsZero }) => quarticIsZero)).toBe(true)
  expect(faces('cube').every(({ quarticIsZero }) => quarticIsZero)).toBe(true)
})

it('the saddle is one: around it jacdet is now higher, now lower, four times in turn', () => {
  const saddle = elements.filter(({ id }) => id === 'saddle')
  const { bernstein, roots } = entry(reportOf(elementVertices(entry(saddle, 0))).faces, 2)
  const { s, t, fate } = entry(roots, 0) as { s: number; t: number; fate: string }
  expect(fate).toBe('kept')
  const basis = (x: number) => [(1 - x) ** 2, 2 * x * (1 - x), x * x]
  const at = (s: number, t: number) =>
    basis(s).reduce(
      (sum, bs, i) => sum + basis(t).reduce((all, bt, j) => all + bs * bt * entry(bernstein, 3 * i + j), 0),
      0,
    )
  const higher = Array.from({ length: 64 }, (_, k) => {
    const angle = (2 * Math.PI * k) / 64
    return at(s + 0.02 * Math.cos(angle), t + 0.02 * Math.sin(angle)) > at(s, t)
  })
  expect(higher.filter((is, k) => is !== higher[(k + 1) % 64]).length).toBe(4)
})

describe('small pictures', () => {
  const theme: Theme = {
    paper: [1, 1, 1],
    ink: [0, 0, 0],
    negative: [0.7, 0.1, 0.2],
    positive: [0.1, 0.4, 0.7],
    neutral: [0.96, 0.96, 0.96],
  }
  const colours = { theme, ramp: rampOf(theme) }
  const pictureOf = (id: string) => {
    const report = reportOf(
      elementVertices(
        entry(
          elements.filter(element => element.id === id),
          0,
        ),
      ),
    )
    return { markup: thumbnailMarkup(report, colours), text: thumbnailText(report), report }
  }
  const count = (markup: string, part: string) => markup.split(part).length - 1

  it('hatch exactly what is negative and draw all twelve edges', () => {
    const tiles = 6 * 8 * 8
    for (const [id, hatched] of [
      ['cube', [0, 0]],
      ['inverted', [tiles, tiles]],
      ['face-negative', [4, 60]],
      ['touching', [0, 0]],
    ] as const) {
      const { markup } = pictureOf(id)
      expect(count(markup, ' color="')).toBe(tiles)
      expect(count(markup, 'url(#hatch)')).toBeGreaterThanOrEqual(hatched[0])
      expect(count(markup, 'url(#hatch)')).toBeLessThanOrEqual(hatched[1])
      // Each edge borders two faces, a corner tile has two borders.
      expect(count(markup, 'stroke-width="1"')).toBe(6 * (4 * 8 - 4))
    }
  })

  it('stay inside themselves, whatever the size of the element, and are small', () => {
    for (const element of elements) {
      const markup = thumbnailMarkup(reportOf(elementVertices(element)), colours)
      const numbers = [...markup.matchAll(/[ML](-?[\d.]+) (-?[\d.]+)/g)].flatMap(([, x, y]) => [Number(x), Number(y)])
      expect(numbers.length).toBeGreaterThan(1000)
      expect(
        numbers.every(x => x >= 0 && x <= 120),
        element.id,
      ).toBe(true)
      expect(markup).not.toMatch(/NaN|undefined/)
      expect(thumbnailAddress(reportOf(elementVertices(element)), colours).length).toBeLessThan(120_000)
    }
  })

  it('say in words what they show', () => {
    expect(pictureOf('cube').text).toBe('Valid, minimum 1 on vertex 0')
    expect(pictureOf('edge-negative').text).toBe('Invalid, minimum −0.020833 on edge 0–4')
    expect(pictureOf('face-negative').text).toMatch(/^Invalid, minimum −1\/16 on face [−+]ζ$/)
    expect(pictureOf('beyond-doubles').text).toBe('Valid, minimum 3.8813×10⁴⁴⁹ on vertex 1')
  })
})
