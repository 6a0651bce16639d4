/** Eight points out of any text. Pure; vertices come out in VTK_HEXAHEDRON order, which all these formats share. */
import { abaqus } from './abaqus'
import { cArray } from './c-array'
import { counted, type Format, type Reading, Refused } from './format'
import { gmsh } from './gmsh'
import { json } from './json'
import { link } from './link'
import { matlab } from './matlab'
import { medit } from './medit'
import { numberPattern } from './numbers'
import { numpy } from './numpy'
import { obj } from './obj'
import { plainNumbers } from './plain-numbers'
import { countPoints, pointsInText } from './points-in-text'
import { vtk } from './vtk'

/** The first that knows a text reads it: those with a mark of their own come before those that any text may fit. */
export const formats: readonly Format[] = [
  link,
  json,
  vtk,
  gmsh,
  abaqus,
  medit,
  obj,
  cArray,
  numpy,
  matlab,
  pointsInText,
  plainNumbers,
]

export type ImportResult =
  | { readonly ok: true; readonly format: string; readonly reading: Reading }
  /** A sentence for people: what was looked for and what was seen. */
  | { readonly ok: false; readonly message: string }

/** Characters, or bytes of a file: more is refused, for reading it would take more memory than a page should. */
export const MOST_CHARACTERS = 50_000_000

export function readElements(text: string): ImportResult {
  if (text.length > MOST_CHARACTERS) return { ok: false, message: tooLarge(text.length) }
  const plain = text
    .replace(/^\uFEFF/, '')
    .replaceAll('\r\n', '\n')
    .replaceAll('\r', '\n')
  try {
    for (const format of formats) {
      const reading = format.read(plain)
      if (reading) return { ok: true, format: format.name, reading }
    }
    return { ok: false, message: nothingIn(plain) }
  } catch (error) {
    if (!(error instanceof Refused)) throw error
    return { ok: false, message: error.message }
  }
}

export function tooLarge(size: number): string {
  return `This is ${Math.round(size / 1e6)} MB; up to ${MOST_CHARACTERS / 1e6} MB are read. Cut out the cells in question.`
}

function nothingIn(text: string): string {
  if (text.trim() === '') return 'There is no text in it.'
  if (text.slice(0, 10_000).includes('\0')) return 'This file is binary, and text is needed: save the mesh as ASCII.'
  const notFinite = /(?<![\w.])[-+]?(?:nan|inf|infinity)(?!\w)/i.exec(text)?.[0]
  const numbers = text.match(numberPattern())?.length ?? 0
  const points = countPoints(text)
  const seen = [
    `${counted(numbers, 'number was', 'numbers were')} found; an element needs 24.`,
    points > 0 && 3 * points !== numbers
      ? `${counted(points, 'point', 'points')} of three coordinates among them; an element has 8.`
      : '',
    notFinite ? `“${notFinite}” is no number that a coordinate can be.` : '',
  ]
  return seen.filter(sentence => sentence !== '').join(' ')
}
