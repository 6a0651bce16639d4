/**
 * PERMAS (.dato): $COOR has an id and three coordinates a line, $ELEMENT TYPE=HEXE8 or HEXFO8 an id and nodes, $ESET the elements of a set. "!"
 * begins a comment, "&" a line that goes on with the one before.
 */
import type { OtherCell } from '../mesh-builder'
import { headText } from '../snippet-text'
import type { MeshFormat } from '../source'
import { shown } from '../text-cursor'
import { RowText } from './row-text'

const TYPES: readonly (readonly [RegExp, OtherCell | 'hexahedron'])[] = [
  [/^HEX/, 'hexahedron'],
  [/^TET/, 'tetrahedron'],
  [/^PENTA/, 'wedge'],
  [/^PYRA/, 'pyramid'],
  [/^(?:TRI|SHELL3|PLOTA[36]|LOADA[36])/, 'triangle'],
  [/^(?:QUA|SHELL|PLOTA|LOADA)/, 'quadrilateral'],
  [/^(?:PLOTL|FLA|BE|FSCPIPE)/, 'line'],
  [/^PLOT1/, 'vertex'],
]
const isKeyword = (line: string) => /^\s*\$/.test(line)

export const permas: MeshFormat = {
  name: 'PERMAS',
  recognizes: head => (/^(?:!PERMAS|[ \t]*\$ENTER\s+COMPONENT)/im.test(headText(head)) ? 'yes' : 'no'),
  read(file, options) {
    const text = new RowText('PERMAS', file, options, /^\s*!/)
    const { cursor } = text
    for (let line = text.line(); line !== null; line = text.line()) {
      const [, word = '', rest = ''] = /^\s*\$(\w+)(.*)/.exec(line) ?? []
      const name = word.toUpperCase()
      const parameter = (key: string) => new RegExp(String.raw`\b${key}\s*=\s*(\S+)`, 'i').exec(rest)?.[1]
      cursor.skipLine()
      if (name === 'COOR') {
        if (parameter('RSYS') !== undefined) text.refuse('coordinates in a system of their own are not read.')
        text.nodes(isKeyword)
      } else if (name === 'ELEMENT') {
        const type = parameter('TYPE')?.toUpperCase() ?? text.refuse('$ELEMENT says no TYPE.')
        const cell = TYPES.find(([pattern]) => pattern.test(type))?.[1] ?? 'other'
        text.later(() => text.elements(cell, parameter('ESET') ?? type, isKeyword))
        text.pass(isKeyword)
      } else text.pass(isKeyword)
    }
    if (text.builder.pointCount === 0) text.refuse(`the nodes were expected, behind ${shown('$COOR')}; there are none.`)
    text.readLater()
    return [text.builder.mesh()]
  },
}
