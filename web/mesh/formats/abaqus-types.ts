/** Element types of Abaqus and CalculiX: the cell that each is, and its nodes. */
import type { OtherCell } from '../mesh-builder'
import { wordTable } from '../word-table'
import { ORDER_OF_20 } from './node-model'

export type AbaqusType =
  | { readonly kind: 'hexahedron'; readonly nodes: 8 }
  | { readonly kind: 'quadratic'; readonly nodes: 20 | 27; readonly fewest: number }
  /** `nodes` is null where the name does not say it. */
  | { readonly kind: 'other'; readonly cell: OtherCell; readonly nodes: number | null }

/** Continua in three dimensions: stress, heat, acoustics, piezoelectricity, Euler, electromagnetics, fluids; continuum shells. */
const SOLID = /^(?:C|DC|DCC|AC|Q|EC|EMC|F|FC|SC|CSS)(?:3D)?(\d+)/
const IS_SOLID = /^(?:(?:C|DC|DCC|AC|Q|EC|EMC|F|FC)3D|SC|CSS)\d/

const SOLIDS: Readonly<Record<string, readonly [OtherCell, number]>> = wordTable({
  4: ['tetrahedron', 4],
  5: ['pyramid', 5],
  6: ['wedge', 6],
  10: ['tetrahedron', 10],
  13: ['pyramid', 13],
})

/** Shells, membranes, surfaces, rigid faces; plane and axisymmetric continua. */
const FACE = /^(?:S|DS|STRI|M3D|SFM3D|R3D|CPS|CPE|CPEG|CAX|CGAX|DCAX|DC2D|AC2D|ACAX|WARP2D|DCC2D|DCCAX)(\d+)/
const LINE = /^(?:B2|B3|T2D|T3D|PIPE|ELBOW|FRAME|DC1D|DCC1D|D$|AC1D|R2D|RAX|SAX|MAX|DSAX)/

export function abaqusType(name: string): AbaqusType {
  const type = name.toUpperCase().replace(/\s/g, '')
  const solid = IS_SOLID.test(type) ? SOLID.exec(type)?.[1] : undefined
  if (solid === '8') return { kind: 'hexahedron', nodes: 8 }
  if (solid === '20') return { kind: 'quadratic', nodes: 20, fewest: 20 }
  if (solid === '27') return { kind: 'quadratic', nodes: 27, fewest: 21 }
  if (solid === '15') return { kind: 'other', cell: 'wedge', nodes: type.includes('V') ? null : 15 }
  const known = solid === undefined ? undefined : SOLIDS[solid]
  if (known) return { kind: 'other', cell: known[0], nodes: known[1] }
  const face = FACE.exec(type)?.[1]
  if (face !== undefined) {
    const nodes = face === '65' ? 6 : Number(face)
    if (nodes === 3 || nodes === 6) return { kind: 'other', cell: 'triangle', nodes }
    if (nodes === 4 || nodes === 8 || nodes === 9) return { kind: 'other', cell: 'quadrilateral', nodes }
  }
  return { kind: 'other', cell: LINE.test(type) ? 'line' : 'other', nodes: null }
}

/** C3D27: the centre, then the faces -zeta, +zeta, -eta, +xi, +eta, -xi. */
export const ORDER_OF_27: readonly number[] = [...ORDER_OF_20, 26, 24, 23, 25, 21, 22, 20]
