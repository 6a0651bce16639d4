/** Part of the hexahedra on which verdicts are checked by certificates: the border met by moving all vertices. */
import { describe, it } from 'vitest'
import { CROSSING_SIZE } from './border'
import { CROSSINGS, expectVerdictLawAtBorder, TIMEOUT } from './verdict-law'

const COUNT = CROSSINGS.segments * CROSSING_SIZE

describe('verdicts are certain and certified', () => {
  it(`on ${COUNT} hexahedra where a segment meets the border`, { timeout: TIMEOUT }, () =>
    expectVerdictLawAtBorder(CROSSINGS.segments, 'all'),
  )
})
