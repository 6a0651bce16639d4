import { describe, expect, it } from 'vitest'
import { presets, presetVertices } from '../../web/model/presets'
import { sliceChange, sliceOf } from '../../web/model/state'
import { createStore } from '../../web/model/store'
import { toggled } from '../../web/panels/inside'
import { insideSentence } from '../../web/panels/inside/inside-words'
import { curveOf, heightOf } from '../../web/panels/morph/curve'
import { type FaceDisplay, sceneSlice } from '../../web/views/scene-slices'
import { core, unitCube } from './core-fixtures'

function reportOf(id: string) {
  const preset = presets.find(candidate => candidate.id === id)
  const result = preset && core.analyze(presetVertices(preset))
  if (!result?.ok) throw new Error(`There is no report of ${id}.`)
  return result.value
}

describe('what the boundary says of the inside', () => {
  it('is enough where it is positive, and not where it is zero', () => {
    expect(insideSentence(reportOf('cube'), 'unit')).toMatch(/nothing inside is lower/)
    expect(insideSentence(reportOf('non-strict'), 'unit')).toMatch(
      /J ≥ 0 on the boundary, yet inside it falls to −1\/4/,
    )
    expect(insideSentence(reportOf('non-strict'), 'biunit')).toMatch(/−1\/32/)
    expect(insideSentence(reportOf('edge-negative'), 'unit')).toMatch(/^The boundary already shows/)
  })
})

it('is in the scene while its panel is open, unless something else is chosen', () => {
  const store = createStore(unitCube, null)
  const shown = (): FaceDisplay => sliceOf(sceneSlice, store.state).faceDisplay
  store.dispatch(toggled(store.state, true))
  expect(shown()).toBe('inside')
  store.dispatch(toggled(store.state, false))
  expect(shown()).toBe('opaque')
  store.dispatch(toggled(store.state, true))
  store.dispatch(sliceChange(sceneSlice, { faceDisplay: 2 }))
  store.dispatch(toggled(store.state, false))
  expect(shown()).toBe(2)
})

describe('the curve of a way', () => {
  const sample = (tau: number, minimum: number, exponent = 0) => ({ tau, minimum, exponent, valid: minimum > 0 })

  it('has zero at its height, whatever the exponents', () => {
    const curve = curveOf({ samples: [sample(0, 3), sample(0.5, 1), sample(1, -2, -1)] })
    expect(curve.zero).toBeCloseTo(0.25, 12)
    expect(curve.points.map(({ height }) => height)).toEqual([1, 0.5, 0])
    expect(heightOf(curve, 0.25)).toBeCloseTo(0.75, 12)
    expect([heightOf(curve, 0), heightOf(curve, 1)]).toEqual([1, 0])
  })

  it('is on the side of its verdict, and finite for the largest and the smallest', () => {
    const [first] = curveOf({ samples: [{ tau: 0, minimum: -1e-20, exponent: 0, valid: true }, sample(1, -1)] }).points
    expect(first?.height).toBe(1)
    const huge = curveOf({ samples: [sample(0, Number.MAX_VALUE), sample(1, -Number.MAX_VALUE)] })
    expect([huge.zero, ...huge.points.map(({ height }) => height)]).toEqual([0.5, 1, 0])
    expect(curveOf({ samples: [sample(0, 0), sample(1, 0)] }).zero).toBe(0)
  })
})
