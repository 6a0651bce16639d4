/** The simplicity of an element that is to be written down and remembered. */
import { COORDINATE_COUNT, VERTEX_COUNT, type Vertices } from '../../../model/hexahedron'

/** The cost of a vertex that is not where the start has it. */
const MOVED_VERTEX = 3

/** 0 for the unit cube as the start; digits, sizes and moved vertices add to it. Less is simpler. */
export function complexityOf(vertices: Vertices, start: Vertices): number {
  let complexity = 0
  for (let v = 0; v < VERTEX_COUNT; ++v)
    if ([3 * v, 3 * v + 1, 3 * v + 2].some(i => vertices[i] !== start[i])) complexity += MOVED_VERTEX
  for (let i = 0; i < COORDINATE_COUNT; ++i) complexity += complexityOfNumber(vertices[i] as number)
  return complexity
}

/** Zero costs nothing; else the size, the sign and the decimals do. */
export function complexityOfNumber(value: number): number {
  if (value === 0) return 0
  const size = Math.abs(value)
  return 0.5 + 0.5 * Math.log2(1 + size) + (value < 0 ? 0.25 : 0) + complexityOfDecimals(size)
}

function complexityOfDecimals(size: number): number {
  if (Number.isInteger(size)) return 0
  if (Number.isInteger(2 * size)) return 1.5
  if (Number.isInteger(4 * size)) return 2.5
  for (const [decimals, unit] of TENS.entries()) if (Math.round(size * unit) / unit === size) return 2 * decimals
  return 2 * ALL_DECIMALS
}

/** Powers of ten; with more decimals a number is one that nobody writes down. */
const TENS = [1, 10, 100, 1e3, 1e4, 1e5, 1e6]
const ALL_DECIMALS = 17
