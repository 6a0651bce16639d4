/** The verdict of C is that of the oracle and has a proof, the minimum is exact: on elements that doubles leave open, most of them. */
import fc from 'fast-check'
import { expect, it } from 'vitest'
import { holdsFor, seed } from '../property/replay'
import { FAMILIES } from './families'
import { classified, expectAsOracle, expectProved } from './laws'
import { report, scaled, TIMEOUT } from './scale'

const ELEMENTS = scaled(200_000)

/** Proofs take longest. */
const EACH_PROVED = 5

for (const { name, hexahedra, share, each } of FAMILIES)
  it(`C, oracle and proof agree on ${ELEMENTS * share} hexahedra, ${name}`, { timeout: TIMEOUT }, () => {
    const counted = { all: 0, valid: 0, exact: 0, proved: 0 }
    const points: number[] = []
    const verdicts: number[] = []
    const law = (vertices: readonly number[]) => {
      const said = holdsFor(vertices, () => expectAsOracle(vertices))
      if (counted.all++ % EACH_PROVED === 0) {
        holdsFor(vertices, () => expectProved(vertices, said))
        counted.proved += 1
      }
      counted.valid += Number(said.valid)
      counted.exact += Number(said.decidedBy === 'exact')
      points.push(...vertices)
      verdicts.push(Number(said.valid))
    }
    const runs = Math.ceil((ELEMENTS * share) / each)
    // Shrinking would take hours and show what is no harder.
    fc.assert(
      fc.property(hexahedra, drawn => drawn.forEach(law)),
      { seed, numRuns: runs, endOnFailure: true },
    )
    expect(classified(new Float64Array(points))).toEqual(new Uint8Array(verdicts))
    expect(counted.all).toBeGreaterThanOrEqual(ELEMENTS * share)
    expect(counted.proved).toBeGreaterThan(0)
    report(
      `${name}: ${counted.all}, ${counted.valid} valid, ${counted.exact} by integers, ${counted.proved} proved (seed ${seed})`,
    )
  })
