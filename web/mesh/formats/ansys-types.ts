/** Element types of Ansys by the number of their routine: the cell that each is. */
import type { OtherCell } from '../mesh-builder'

export type AnsysType =
  | { readonly kind: 'hexahedron' }
  | { readonly kind: 'quadratic' }
  /** A face: a triangle if its third and fourth node are the same. */
  | { readonly kind: 'face' }
  | { readonly kind: 'other'; readonly cell: OtherCell }

const KINDS: readonly (readonly [AnsysType, string])[] = [
  [{ kind: 'hexahedron' }, '5 30 45 46 62 64 65 69 70 73 80 96 97 107 142 164 185 190 215 278'],
  [{ kind: 'quadratic' }, '90 95 117 120 122 147 186 191 216 220 226 231 236 239 279'],
  [{ kind: 'other', cell: 'tetrahedron' }, '72 87 92 98 119 123 127 148 168 187 217 221 227 232 237 240 285 291'],
  [
    { kind: 'face' },
    '13 25 28 29 35 41 42 43 53 55 57 63 67 75 77 78 79 81 82 83 91 93 99 118 121 131 132 141 143 145 146 150 151 152 154 157 162 163 181 182 183 212 213 214 223 230 233 238 281 292 293',
  ],
  [
    { kind: 'other', cell: 'line' },
    '1 3 4 8 9 10 11 16 17 18 20 23 24 31 32 33 34 44 51 54 59 61 68 160 161 167 180 188 189 208 209 288 289 290',
  ],
]

const types = new Map<number, AnsysType>(
  KINDS.flatMap(([type, numbers]) => numbers.split(' ').map(number => [Number(number), type] as const)),
)

/** MESH200 is what its first option says. */
const MESH_200: readonly AnsysType[] = [
  ...Array.from({ length: 4 }, () => ({ kind: 'other', cell: 'line' }) as const),
  ...Array.from({ length: 4 }, () => ({ kind: 'face' }) as const),
  { kind: 'other', cell: 'tetrahedron' },
  { kind: 'other', cell: 'tetrahedron' },
  { kind: 'hexahedron' },
  { kind: 'quadratic' },
]

/** Null for a type that is not known here. */
export function ansysType(routine: number, firstOption: number): AnsysType | null {
  if (routine === 200) return MESH_200[firstOption] ?? null
  return types.get(routine) ?? null
}
