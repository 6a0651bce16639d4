/** Proofs as text: long numbers cut, neighbouring intervals taken together. */
import { describe, expect, it } from 'vitest'
import { type CertifiedInterval, certificateOf, certify } from '../../web/core/exact/certificate'
import { fractionText } from '../../web/model/rational'
import { sliceChange, sliceOf } from '../../web/model/state'
import { createStore } from '../../web/model/store'
import { proofSlice } from '../../web/panels/proof/proof-question'
import { rationalText, roundedText } from '../../web/panels/proof/rational-text'
import { runsOf } from '../../web/panels/proof/runs'
import { cases, core, depthGuardCases, entry, unitCube } from './core-fixtures'

const rational = (numerator: bigint, denominator = 1n) => ({ numerator, denominator })

describe('a rational number', () => {
  it('is shown whole where it is short', () => {
    expect([rational(0n), rational(-9n, 64n), rational(5n, 7n), rational(-4053n)].map(rationalText)).toEqual([
      '0',
      '−9/64',
      '5/7',
      '−4053',
    ])
    expect(roundedText(rational(-9n, 64n))).toBe('')
  })

  it('is cut in the middle where it is long, and then said rounded too', () => {
    const long = rational(-(12345n * 10n ** 30n + 6789n), 1n << 160n)
    expect(rationalText(long)).toBe('−1234…6789/2¹⁶⁰')
    expect(roundedText(long)).toBe('\u00a0≈\u00a0−8.4468×10⁻¹⁵')
    expect(rationalText(rational(-39n, 1n << 60n))).toBe('−39/2⁶⁰')
    expect(roundedText(rational(-39n, 1n << 60n))).toBe('\u00a0≈\u00a0−3.3827×10⁻¹⁷')
    expect(rationalText(rational(1n, 3n ** 40n))).toBe('1/1215…8801')
    expect(fractionText(rational(-39n, 1n << 60n))).toBe('-39/1152921504606846976')
  })
})

describe('the intervals of a face', () => {
  it('are taken together where neighbours have one reason, and none is lost', () => {
    for (const { vertices } of [...cases, ...depthGuardCases]) {
      const certificate = certify(vertices.flat())
      if (!certificate.valid) continue
      for (const intervals of certificate.faces) {
        const runs = runsOf(intervals)
        expect(runs.reduce((sum, { count }) => sum + count, 0)).toBe(intervals.length)
        expect(runs[0]?.from).toEqual(intervals[0]?.from)
        expect(runs.at(-1)?.to).toEqual(intervals.at(-1)?.to)
        for (const [i, run] of runs.entries()) if (i > 0) expect(run.by).not.toBe(entry(runs, i - 1).by)
      }
    }
    const half = rational(1n, 2n)
    const two: CertifiedInterval[] = [
      { from: rational(0n), to: half, by: 'b' },
      { from: half, to: rational(1n), by: 'D' },
    ]
    expect(runsOf(two).map(({ by, count }) => [by, count])).toEqual([
      ['b', 1],
      ['D', 1],
    ])
  })
})

describe('asking for a proof', () => {
  it('gives the certificate, or refuses what has no verdict', () => {
    expect(certificateOf(core, unitCube)).toEqual({ ok: true, value: certify(unitCube) })
    expect(certificateOf(core, unitCube.slice(1))).toMatchObject({ ok: false, error: { code: 'wrong-count' } })
    expect(certificateOf(core, unitCube.with(3, Number.NaN))).toMatchObject({
      ok: false,
      error: { code: 'not-finite' },
    })
  })

  it('is no step of history', () => {
    const store = createStore(unitCube, null)
    const isShown = () => sliceOf(proofSlice, store.state).proofShown
    expect(isShown()).toBe(false)
    store.dispatch(sliceChange(proofSlice, { proofShown: true }))
    expect([isShown(), store.state.canUndo]).toEqual([true, false])
    store.dispatch({ type: 'undo' })
    expect(isShown()).toBe(true)
    store.dispatch(sliceChange(proofSlice, { proofShown: false }))
    expect(isShown()).toBe(false)
  })
})
