/** VTU files that are made for tests. */
import type { Mesh } from '../../web/mesh/mesh'
import { meshOf } from './mesh-fixtures'

/** A file in ASCII; `time` stands in it as VTK writes it. */
export function vtuText({ points, cells }: Pick<Mesh, 'points' | 'cells'>, time: number | null = null): string {
  const count = cells.length / 8
  const array = (type: string, name: string, values: ArrayLike<number>, more = '') =>
    `<DataArray type="${type}" Name="${name}"${more} format="ascii">${Array.from(values).join(' ')}</DataArray>`
  const field =
    time === null ? '' : `<FieldData>${array('Float64', 'TimeValue', [time], ' NumberOfTuples="1"')}</FieldData>`
  const lists = [
    array('Int64', 'connectivity', cells),
    array(
      'Int64',
      'offsets',
      Array.from({ length: count }, (_, cell) => 8 * (cell + 1)),
    ),
    array('UInt8', 'types', new Array(count).fill(12)),
  ]
  return `<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian"><UnstructuredGrid>${field}
<Piece NumberOfPoints="${points.length / 3}" NumberOfCells="${count}">
<Points>${array('Float64', 'Points', points, ' NumberOfComponents="3"')}</Points>
<Cells>${lists.join('\n')}</Cells></Piece></UnstructuredGrid></VTKFile>`
}

export function vtuOf(elements: readonly (readonly number[])[], time: number | null = null): string {
  return vtuText(meshOf(elements), time)
}

export interface DataSet {
  readonly time: string
  readonly file: string
  readonly part?: number
}

export function pvdText(sets: readonly DataSet[]): string {
  const tags = sets.map(({ time, file, part = 0 }) => `<DataSet timestep="${time}" part="${part}" file="${file}"/>`)
  return `<VTKFile type="Collection" version="0.1"><Collection>${tags.join('\n')}</Collection></VTKFile>`
}

export function pvtuText(pieces: readonly string[]): string {
  const tags = pieces.map(piece => `<Piece Source="${piece}"/>`)
  return `<VTKFile type="PUnstructuredGrid"><PUnstructuredGrid GhostLevel="0">${tags.join('')}</PUnstructuredGrid></VTKFile>`
}
