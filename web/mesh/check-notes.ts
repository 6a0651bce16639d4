/** Sentences that the answers add to a mesh's own notes. */

import { counted } from './check-summary'
import type { MeshCheck } from './mesh-check'
import { shown } from './text-cursor'

type Answered = Omit<MeshCheck, 'notes'>

export function checkNotes(check: Answered): string[] {
  return [orderNote(check), ...otherNotes(check)].filter(note => note !== null)
}

/** The notes without the order of nodes, for outputs that describe it themselves. */
export function notesBesideOrder(check: Answered): string[] {
  return otherNotes(check).filter(note => note !== null)
}

function otherNotes(check: Answered): (string | null)[] {
  return [
    mirroredNote(check),
    unansweredNote(check),
    notTrilinearNote(check),
    check.mesh.isCutOff ? 'The file is cut off: the answer is for what is whole in it.' : null,
  ]
}

function mirroredNote({ mirrored, hexahedra }: Answered): string | null {
  if (mirrored === 0) return null
  const all = `${mirrored === hexahedra && hexahedra > 1 ? 'All' : `${mirrored} of`} ${counted(hexahedra, 'hexahedron', 'hexahedra')}`
  const [are, them, their, they] = mirrored === 1 ? ['is', 'it', 'its', 'it is'] : ['are', 'them', 'their', 'they are']
  const cause = `because ${their} nodes are numbered the other way round or an axis is reversed`
  return `${all} ${are} mirrored, jacdet < 0 everywhere in ${them}, ${cause}; with nodes 0 to 3 and 4 to 7 exchanged ${they} valid.`
}

function unansweredNote(check: Answered): string | null {
  const isUnanswered = (cell: number) => check.standingOf(cell) === 'unanswered'
  const unanswered = check.unanswered - [...check.openOrders.keys()].filter(isUnanswered).length
  if (unanswered === 0) return null
  for (let cell = 0; cell < check.hexahedra; ++cell) {
    if (!isUnanswered(cell) || check.openOrders.has(cell)) continue
    const answer = check.answerTo(cell)
    const why = 'why' in answer ? answer.why : ''
    if (unanswered === 1) return `The hexahedron ${nameOf(check, cell)} is unanswered: ${lowerFirst(why)}`
    return `${unanswered} hexahedra are unanswered, first ${nameOf(check, cell)}: ${lowerFirst(why)}`
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
    : `${answer}, and ${straight === 0 ? 'none has' : counted(straight, 'has', 'have')} all further nodes at the middles.`
}

function orderNote(check: Answered): string | null {
  const [first] = check.openOrders
  if (!first) return null
  const [cell, { name, usedBy }] = first
  const order = `“${name}”${usedBy === null ? '' : ` (${usedBy})`}`
  const open = 'It is not stated in which order the nodes are'
  if (check.hexahedra === 1)
    return `${open}, so the verdict is open: in the order of the text the hexahedron is not valid, in the order ${order} it is.`
  const several = counted(check.openOrders.size, 'hexahedron is', 'hexahedra are')
  return `${open}: ${several} not valid in the order of the text, but in another, first ${nameOf(check, cell)} in the order ${order}.`
}

/** The cell's name for people: its id, or its index if the file has none. */
function nameOf({ idOf }: Answered, cell: number): string {
  const id = idOf(cell)
  return id === null ? `with index ${cell}` : shown(id).slice(1, -1)
}

function lowerFirst(sentence: string): string {
  return sentence.slice(0, 1).toLowerCase() + sentence.slice(1)
}
