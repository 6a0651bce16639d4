/** Names that a condition can use; web/core/quantities.ts describes each. */

/** True or false. */
export const CLAIMS = ['valid'] as const
export type Claim = (typeof CLAIMS)[number]

export const NUMBERS = [
  'boundary_min',
  'boundary_max',
  'volume_min',
  'corner_min',
  'edge_min',
  'centre',
  'volume',
  'scaled_jacobian',
  'gauss2_min',
  'gauss3_min',
  'bernstein_min',
  'subdivision',
  'moved',
  'twist',
] as const
export type NumberName = (typeof NUMBERS)[number]

export type QuantityName = Claim | NumberName

export function isNumberName(name: QuantityName): name is NumberName {
  return name !== 'valid'
}
