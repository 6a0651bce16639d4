/** `--ids`: the invalid hexahedra by their ids, as the input of a program or one on a line. */
import { Refusal } from '../model/result'
import { invalidCells, nameOf } from './invalid-cells'
import { type Output, shown, withoutControls } from './output'

export const ID_KINDS = ['abaqus', 'nastran', 'plain'] as const
export type IdKind = (typeof ID_KINDS)[number]

/** Abaqus reads 16 entries of a line at most. */
const ABAQUS_A_LINE = 16
/** Nastran's lines have 72 columns for a set. */
const NASTRAN_COLUMNS = 72

/** `say` gets sentences for people. Of several files each begins with a comment that names it. */
export function idsOutput(kind: IdKind, fileCount: number, say: (sentence: string) => void): Output {
  let sets = 0
  return {
    lists: {},
    *file(result) {
      if ('error' in result) return
      const { file, check } = result
      const first = FIRST[kind]
      const numbers = first === 0 ? 'indices' : 'numbers'
      const isNumbered = check.mesh.ids === null
      const numbered = `${withoutControls(file)} has no ids: these are ${numbers} from ${first}, in the file's order.`
      const ids = invalidCells(check).map(cell =>
        isNumbered ? String(first + cell) : withoutControls(nameOf(check, cell)),
      )
      if (ids.length > 0 && isNumbered) say(numbered)
      const foreign = kind === 'nastran' ? ids.find(id => !/^\d+$/.test(id)) : undefined
      if (foreign !== undefined)
        throw new Refusal(`${withoutControls(file)}: Nastran has no id such as ${shown(foreign)}.`)
      const comment = `${COMMENTS[kind]} ${withoutControls(file)}: ${ids.length} invalid`
      if (fileCount > 1) yield `${comment}\n`
      if (ids.length > 0 && isNumbered && first > 0) yield `${COMMENTS[kind]} ${numbered}\n`
      if (ids.length > 0) yield* writers[kind](ids, ++sets)
    },
    *end() {},
  }
}

/** Elements of Abaqus and Nastran are numbered from 1, as in the meshes that are written for them. */
const FIRST: Readonly<Record<IdKind, 0 | 1>> = { abaqus: 1, nastran: 1, plain: 0 }

const COMMENTS: Readonly<Record<IdKind, string>> = { abaqus: '**', nastran: '$', plain: '#' }

const writers: Readonly<Record<IdKind, (ids: readonly string[], set: number) => Iterable<string>>> = {
  *abaqus(ids, set) {
    yield `*ELSET, ELSET=HEXLENS_INVALID${set === 1 ? '' : `_${set}`}\n`
    for (let i = 0; i < ids.length; i += ABAQUS_A_LINE) yield `${ids.slice(i, i + ABAQUS_A_LINE).join(', ')}\n`
  },
  *nastran(ids, set) {
    let line = `SET ${set} = `
    for (const [i, id] of ids.entries()) {
      const entry = i === ids.length - 1 ? id : `${id},`
      if (line.length + entry.length > NASTRAN_COLUMNS) {
        yield `${line}\n`
        line = '  '
      }
      line += entry
    }
    yield `${line}\n`
  },
  *plain(ids) {
    for (const id of ids) yield `${id}\n`
  },
}
