/** Types of elements in CGNS. */
import type { RowType } from './node-rows'

export const [CGNS_MIXED, CGNS_NGON, CGNS_NFACE] = [20, 22, 23] as const

/** For each kind the numbers of its types, with their nodes: those of higher order among them. */
const KINDS: readonly (readonly [RowType['kind'], Readonly<Record<number, number>>])[] = [
  ['vertex', { 2: 1 }],
  ['line', { 3: 2, 4: 3, 24: 4, 40: 5 }],
  ['triangle', { 5: 3, 6: 6, 25: 9, 26: 10, 41: 12, 42: 15 }],
  ['quadrilateral', { 7: 4, 8: 8, 9: 9, 27: 12, 28: 16, 43: 16, 44: 25 }],
  ['tetrahedron', { 10: 4, 11: 10, 29: 16, 30: 20, 45: 22, 46: 34, 47: 35 }],
  ['pyramid', { 12: 5, 13: 14, 21: 13, 31: 21, 32: 29, 33: 30, 48: 29, 49: 50, 50: 55 }],
  ['wedge', { 14: 6, 15: 15, 16: 18, 34: 24, 35: 38, 36: 40, 51: 33, 52: 66, 53: 75 }],
  ['hexahedron', { 17: 8 }],
  ['curved', { 18: 20, 19: 27, 37: 32, 38: 56, 39: 64, 54: 44, 55: 98, 56: 125 }],
]

const TYPES = new Map<number, RowType>(
  KINDS.flatMap(([kind, types]) =>
    Object.entries(types).map(([number, nodes]): [number, RowType] => [Number(number), { kind, nodes }]),
  ),
)

/** Null for a number that is no type with nodes of its own. */
export function cgnsType(number: number): RowType | null {
  return TYPES.get(number) ?? null
}
