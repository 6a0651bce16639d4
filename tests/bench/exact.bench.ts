/** Every verdict of the sweep, 21 rows of 100,000 elements in batches, against exact arithmetic. --quick: 2,000 a row. */
import { exactBoundarySign } from '../../web/core/exact/exact-sign'
import { randomSource, unitCube } from '../unit/core-fixtures'
import { batchCores } from '../unit/node-workers'

const ROWS = 21

export async function main(options: readonly string[]): Promise<void> {
  const elements = options.includes('--quick') ? 2_000 : 100_000
  const random = randomSource(20260801)
  const normal = () => Math.sqrt(-2 * Math.log(1 - random())) * Math.cos(2 * Math.PI * random())
  const displacements = Float64Array.from({ length: 24 * elements }, normal)
  let [all, wrong, exact] = [0, 0, 0]
  for (let row = 0; row < ROWS; ++row) {
    const sigma = row / 10
    const points = displacements.map((displacement, i) => (unitCube[i % 24] as number) + sigma * displacement)
    const { valid, validCount, exactCount } = batchCores.vectors.classify({ points, cells: null, firstPoint: 0 }, {})
    for (let n = 0; n < elements; ++n) {
      const isValid = exactBoundarySign(Array.from(points.subarray(24 * n, 24 * n + 24))) > 0
      if (isValid !== (valid[n] === 1)) wrong += 1
    }
    all += elements
    exact += exactCount
    console.log(`sigma ${sigma.toFixed(1)}: ${elements - validCount} of ${elements} invalid`)
  }
  console.log(`${all} verdicts, ${exact} of them left open by doubles, ${wrong} that exact arithmetic does not confirm`)
}
