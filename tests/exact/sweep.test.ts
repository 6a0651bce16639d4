/** Every verdict of the sweep, 21 rows of elements in batches, is that of the oracle: none is wrong, none open. */
import { expect, it } from 'vitest'
import { exactBoundarySign } from '../../web/core/exact/exact-sign'
import { holdsFor, seed } from '../property/replay'
import { randomSource, unitCube } from '../unit/core-fixtures'
import { classified } from './laws'
import { report, scaled, TIMEOUT } from './scale'

const ROWS = 21
const EACH = scaled(100_000)

it(`${ROWS * EACH} verdicts of the sweep are exact`, { timeout: TIMEOUT }, () => {
  const random = randomSource(seed)
  const normal = () => Math.sqrt(-2 * Math.log(1 - random())) * Math.cos(2 * Math.PI * random())
  const displacements = Float64Array.from({ length: 24 * EACH }, normal)
  let invalid = 0
  for (let row = 0; row < ROWS; ++row) {
    const points = displacements.map((displacement, i) => (unitCube[i % 24] as number) + (row / 10) * displacement)
    const verdicts = classified(points)
    for (let n = 0; n < EACH; ++n) {
      const vertices = Array.from(points.subarray(24 * n, 24 * n + 24))
      const isValid = exactBoundarySign(vertices) > 0
      if (isValid !== (verdicts[n] === 1)) holdsFor(vertices, () => expect(verdicts[n] === 1).toBe(isValid))
      invalid += Number(!isValid)
    }
  }
  expect(invalid).toBeGreaterThan(ROWS * EACH * 0.5)
  report(`sweep: ${ROWS * EACH} verdicts, ${invalid} invalid, 0 wrong, 0 open (seed ${seed})`)
})
