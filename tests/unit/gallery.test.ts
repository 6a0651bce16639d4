/** The gallery: each claim holds, exactly; what is said to be a test case or a preset is that one, bit for bit. */
import { describe, expect, it } from 'vitest'
import { quantitiesOf } from '../../web/core/quantities'
import { isMet, parseCondition } from '../../web/model/condition'
import { challenges } from '../../web/pages/challenges/challenges'
import { gallery } from '../../web/pages/gallery/gallery'
import { elementVertices } from '../../web/pages/gallery/gallery-vertices'
import { lessons } from '../../web/pages/lessons/content/lessons'
import { rampOf, type Theme } from '../../web/scene/paint/colour-map'
import { paletteOf } from '../../web/scene/paint/face-raster'
import { THUMBNAIL_SIDE, thumbnailPixels, thumbnailText } from '../../web/scene/paint/thumbnail'
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
  const colours = { theme, palette: paletteOf(rampOf(theme), theme) }
  const pictureOf = (id: string) => {
    const report = reportOf(
      elementVertices(
        entry(
          elements.filter(element => element.id === id),
          0,
        ),
      ),
    )
    return { pixels: thumbnailPixels(report, colours), text: thumbnailText(report) }
  }
  /** Pixels by what is in them: ink, red and blue under a hatch or not, a neutral between these, or nothing. */
  function countsOf(pixels: Uint8ClampedArray) {
    const counts = { red: 0, blue: 0, other: 0, clear: 0, partly: 0 }
    for (let at = 0; at < pixels.length; at += 4) {
      const [r, , b, alpha] = pixels.subarray(at, at + 4) as unknown as [number, number, number, number]
      if (alpha === 0) counts.clear += 1
      else if (alpha < 255) counts.partly += 1
      else if (r > b + 15) counts.red += 1
      else if (b > r + 15) counts.blue += 1
      else counts.other += 1
    }
    return counts
  }

  it('are red where jacdet is negative, and nowhere else', () => {
    expect(countsOf(pictureOf('cube').pixels)).toMatchObject({ red: 0 })
    expect(countsOf(pictureOf('touching').pixels)).toMatchObject({ red: 0 })
    expect(countsOf(pictureOf('inverted').pixels)).toMatchObject({ blue: 0 })
    const { red, blue } = countsOf(pictureOf('face-negative').pixels)
    expect(red).toBeGreaterThan(100)
    expect(blue).toBeGreaterThan(2 * red)
  })

  it('have the colour of jacdet at each pixel: many, where eight times eight tiles a face would have few', () => {
    const { pixels } = pictureOf('depth-guard')
    expect(new Set(new Uint32Array(pixels.buffer)).size).toBeGreaterThan(500)
  })

  it('have smooth outlines inside themselves, whatever the size of the element', () => {
    for (const { id } of elements) {
      const { pixels } = pictureOf(id)
      const { clear, partly } = countsOf(pixels)
      expect(clear, id).toBeGreaterThan(0.2 * THUMBNAIL_SIDE ** 2)
      expect(partly, id).toBeGreaterThan(100)
      for (let k = 0; k < THUMBNAIL_SIDE; k++)
        for (const at of [k, k * THUMBNAIL_SIDE]) expect(pixels[4 * at + 3], id).toBe(0)
    }
  })

  it('say in words what they show', () => {
    expect(pictureOf('cube').text).toBe('Valid, minimum 1 on vertex 0')
    expect(pictureOf('edge-negative').text).toBe('Invalid, minimum −0.020833 on edge 0–4')
    expect(pictureOf('face-negative').text).toMatch(/^Invalid, minimum −1\/16 on face [−+]ζ$/)
    expect(pictureOf('beyond-doubles').text).toBe('Valid, minimum 3.8813×10⁴⁴⁹ on vertex 1')
  })
})
