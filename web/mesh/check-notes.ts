/** Sentences that the answers add to a mesh's own notes. */

import { nodeOrders } from '../content/node-orders'
import type { Core } from '../core/report'
import { reordered } from '../model/node-order'
import type { MeshCheck } from './check'
import { shown } from './text-cursor'
import { verticesOf } from './vertices-of'

type Answered = Omit<MeshCheck, 'notes'>

export function checkNotes(check: Answered, core: Core): string[] {
  return [
    check.mesh.isOrderStated ? null : orderNote(check, core),
    mirroredNote(check),
    unansweredNote(check),
    notTrilinearNote(check),
    check.mesh.isCutOff ? 'The file is cut off: the answer is for what is whole in it.' : null,
  ].filter(note => note !== null)
}

function mirroredNote({ mirrored, hexahedra }: Answered): string | null {
  if (mirrored === 0) return null
  const all = `${mirrored === hexahedra && hexahedra > 1 ? 'All' : `${mirrored} of`} ${counted(hexahedra, 'hexahedron', 'hexahedra')}`
  const [are, them, their, they] = mirrored === 1 ? ['is', 'it', 'its', 'it is'] : ['are', 'them', 'their', 'they are']
  const cause = `because ${their} nodes are numbered the other way round or an axis is reversed`
  return `${all} ${are} mirrored, jacdet < 0 everywhere in ${them}, ${cause}; with nodes 0 to 3 and 4 to 7 exchanged ${they} valid.`
}

function unansweredNote(check: Answered): string | null {
  if (check.unanswered === 0 || !check.mesh.isOrderStated) return null
  for (let cell = 0; cell < check.hexahedra; ++cell) {
    if (check.standingOf(cell) !== 'unanswered') continue
    const answer = check.answerTo(cell)
    const why = 'why' in answer ? answer.why : ''
    if (check.unanswered === 1) return `The hexahedron ${nameOf(check, cell)} is unanswered: ${lowerFirst(why)}`
    return `${check.unanswered} hexahedra are unanswered, first ${nameOf(check, cell)}: ${lowerFirst(why)}`
  }
  return null
}

function notTrilinearNote({ mesh, notTrilinear: { count, validByCorners } }: Answered): string | null {
  if (count === 0) return null
  const cells = counted(count, 'cell has more than eight nodes and is', 'cells have more than eight nodes and are')
  const answer = `${cells} not trilinear: by the eight corners ${validByCorners} would be valid`
  const { straight } = mesh.notTrilinear
  return straight === null
    ? `${answer}.`
    : `${answer}, and ${straight} ${straight === 1 ? 'has' : 'have'} all further nodes at the middles.`
}

/** More cells than that are not tried in other orders. */
const MOST_TRIED = 100

function orderNote({ mesh, hexahedra }: Answered, core: Core): string {
  const open = 'It is not stated in which order the nodes are, so the verdict is open'
  if (hexahedra === 0 || hexahedra > MOST_TRIED) return `${open}.`
  const elements = Array.from({ length: hexahedra }, (_, cell) => verticesOf(mesh, cell))
  const areValidIn = (permutation: readonly number[]) =>
    elements.every(vertices => {
      const verdict = core.isValid(reordered(vertices, permutation))
      return verdict.ok && verdict.value
    })
  const [subject, is] = hexahedra === 1 ? ['the hexahedron', 'is'] : ['the hexahedra', 'are']
  if (areValidIn([0, 1, 2, 3, 4, 5, 6, 7])) return `${open}; in the order of the text ${subject} ${is} valid.`
  const order = nodeOrders.find(({ permutation }) => areValidIn(permutation))
  const invalid = `${open}; in the order of the text ${subject} ${is} not valid`
  if (!order) return `${invalid}.`
  const usedBy = order.usedBy === null ? '' : ` (${order.usedBy})`
  return `${invalid}, in the order “${order.name}”${usedBy} ${is === 'is' ? 'it is' : 'they are'}.`
}

/** What people find the cell by: its id, or its index where the file has none. */
function nameOf({ idOf }: Answered, cell: number): string {
  const id = idOf(cell)
  return id === null ? `with index ${cell}` : shown(id).slice(1, -1)
}

function counted(count: number, one: string, many: string): string {
  return `${count} ${count === 1 ? one : many}`
}

function lowerFirst(sentence: string): string {
  return sentence.slice(0, 1).toLowerCase() + sentence.slice(1)
}
