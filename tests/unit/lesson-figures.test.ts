/** The least jacdet by boxes, which lesson 4 shows beside that of the boundary, against the core and against samples. */
import { describe, expect, it } from 'vitest'
import { valueInside } from '../../web/core/section'
import { gallery } from '../../web/pages/gallery/gallery'
import { lessons } from '../../web/pages/lessons/content/lessons'
import { leastByBoxes } from '../../web/pages/lessons/least-by-boxes'
import { verticesOf } from '../../web/pages/lessons/step-state'
import { core, entry, randomSource } from './core-fixtures'

const elements = lessons.flatMap(lesson =>
  lesson.steps.map((step, i) => ({ name: `${lesson.id}/${i + 1}`, vertices: verticesOf(step) })),
)

function reportOf(vertices: readonly number[]) {
  const result = core.analyze(vertices)
  if (!result.ok) throw new Error(result.error.message)
  return result.value
}

describe('the least jacdet by boxes', () => {
  it.each(elements)('$name: agrees with the core, and no sample is below', ({ vertices }) => {
    const { valid, bernstein, boundaryMinimum, volumeMinimum } = reportOf(vertices)
    const { lower, upper } = leastByBoxes(bernstein)
    const greatest = Math.max(...bernstein.map(Math.abs))
    const rounding = 1e-12 * greatest
    expect(upper - lower).toBeLessThanOrEqual(greatest / 500)
    const least = valid ? { lower: boundaryMinimum, upper: boundaryMinimum } : volumeMinimum
    expect(least.upper).toBeGreaterThanOrEqual(lower - rounding)
    expect(least.lower).toBeLessThanOrEqual(upper + rounding)
    const random = randomSource(23)
    for (let n = 0; n < 2000; n++)
      expect(valueInside(bernstein, [random(), random(), random()])).toBeGreaterThanOrEqual(lower - rounding)
  })

  it('needs one box where a corner has the least coefficient, and says so', () => {
    expect(leastByBoxes(Array.from({ length: 27 }, () => 1))).toEqual({ lower: 1, upper: 1, boxes: 1 })
    const falling = Array.from({ length: 27 }, (_, i) => 27 - i)
    expect(leastByBoxes(falling)).toEqual({ lower: 1, upper: 1, boxes: 1 })
  })
})

it('lesson 2 is about the element of the gallery with a scaled Jacobian of 0.57', () => {
  const shown = gallery.flatMap(room => room.elements).find(({ id }) => id === 'scaled-0-57')
  for (const step of entry(lessons, 2).steps.slice(0, 4)) expect(step).toMatchObject({ element: shown?.element ?? [] })
})
