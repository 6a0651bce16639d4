/** Numbers of elements, where a format wants them: the mesh's own ids where these can be, else counted from 1 in the file's order. */
import { cellIn, type MeshPart } from './mesh-part'

/** Throughout the mesh, so that some of its cells have the same numbers as in all. `most` is the format's largest; `say` gets what is so. */
export function numbering(part: MeshPart, most: number, say: (sentence: string) => void): (cell: number) => number {
  const { ids } = part.check.mesh
  const own = numbersOf(ids, most)
  if (typeof own !== 'string') return cell => own[cellIn(part, cell)] as number
  say(`${own}: elements are numbered from 1, in the file's order.`)
  return cell => cellIn(part, cell) + 1
}

/** Why they cannot be, if they cannot. */
function numbersOf(ids: MeshPart['check']['mesh']['ids'], most: number): Float64Array | string {
  if (ids === null) return 'The mesh has no ids'
  if (!(ids instanceof Float64Array)) return 'The ids are words'
  if (ids.some(id => !(Number.isInteger(id) && id > 0 && id <= most)))
    return `Not all ids are whole numbers from 1 to ${most}`
  return isDistinct(ids) ? ids : 'Several cells have one id'
}

function isDistinct(ids: Float64Array): boolean {
  const isRising = ids.every((id, i) => i === 0 || id > (ids[i - 1] as number))
  return (
    isRising ||
    ids
      .slice()
      .sort()
      .every((id, i, sorted) => id !== sorted[i - 1])
  )
}
