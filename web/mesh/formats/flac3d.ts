/**
 * FLAC3D's grids. In text: G lines with gridpoints, Z lines with zones, ZGROUP with names of zones. A brick has its own order: a corner, the three
 * beside it along x, y and z, then xy, yz and xz, and the one across.
 */
import { IdIndex } from '../id-index'
import type { OtherCell } from '../mesh-builder'
import { headText } from '../snippet-text'
import type { MeshFormat } from '../source'
import { shown } from '../text-cursor'
import { wordTable } from '../word-table'
import { binaryFlac3d, isBinaryFlac3d } from './flac3d-binary'
import { blanked, RowText } from './row-text'

const MOST_IN_LINE = 100_000
const ORDER = [0, 1, 4, 2, 3, 6, 7, 5]
const TYPES: Readonly<Record<string, OtherCell | 'hexahedron'>> = wordTable({
  B8: 'hexahedron',
  B7: 'other',
  W6: 'wedge',
  P5: 'pyramid',
  T4: 'tetrahedron',
})

export const flac3d: MeshFormat = {
  name: 'FLAC3D',
  recognizes: head => {
    if (isBinaryFlac3d(head)) return 'yes'
    const text = headText(head)
    if (/^\$/m.test(text)) return 'no'
    return /^[ \t]{0,20}\*\s{0,9}FLAC3D/im.test(text) || /^G[ \t]+\d+(?:[ \t,]+[-+.\deE]+){3}[ \t]*\r?$/m.test(text)
      ? 'yes'
      : 'no'
  },
  read(given, options) {
    if (isBinaryFlac3d(given.read(0, Math.min(given.size, 8)))) return [binaryFlac3d(given, options, ORDER)]
    const text = new RowText('FLAC3D', blanked(given, ','), options, /^\s*[*;]/)
    const { builder, cursor } = text
    const cellOfId = new IdIndex()
    const put = (cell: number, id: number) => {
      if (cellOfId.get(id) >= 0) text.refuse(`zone ${id} is defined twice.`)
      cellOfId.set(id, cell)
    }
    /** The name of the zones' group that is being read; null of one of faces, undefined outside. */
    let group: string | null | undefined
    const zone = () => {
      const type = cursor.word().toUpperCase()
      const cell = TYPES[type] ?? text.refuse(`${shown(type)} is no type of a zone.`)
      const id = cursor.count('the number of a zone')
      if (cell !== 'hexahedron') builder.otherCell(cell)
      else text.hexahedron(id, text.numbers('the number of a gridpoint', 8), own => put(own, id), ORDER)
    }
    text.lines(
      () => false,
      line => {
        const [, word = ''] = /^\s*(\S+)/.exec(line) ?? []
        const name = word.toUpperCase()
        if (/^\d/.test(name)) {
          if (group === undefined) text.refuse(`${shown(word)} stands where G, Z or a group was expected.`)
          for (const id of text.numbers('the number of a zone', MOST_IN_LINE)) {
            const cell = cellOfId.get(id)
            if (cell >= 0 && typeof group === 'string') builder.inBlock(group, cell)
          }
        } else {
          cursor.word()
          group = undefined
          if (name === 'G') text.node()
          else if (name === 'Z') zone()
          else if (name === 'ZGROUP') group = /^\s*\S+\s+(?:"([^"]*)"|(\S+))/.exec(line)?.slice(1).find(Boolean) ?? ''
          else if (name === 'FGROUP') group = null
          else if (name !== 'F') text.refuse(`${shown(word)} stands where G, Z or a group was expected.`)
        }
        cursor.skipLine()
      },
      line => {
        const [before] = /^\s*(?:G|Z\s+B8)(?=\s)/i.exec(line) ?? []
        if (before === undefined) return false
        if (/G/i.test(before)) return text.nodeRows({ before })
        return text.hexahedronRows(text.rows('wwwwwwwww', { before }), 0, 1, put, { order: ORDER })
      },
    )
    return [builder.mesh()]
  },
}
