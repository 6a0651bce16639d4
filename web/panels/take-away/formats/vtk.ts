/** VTK legacy, ASCII: one VTK_HEXAHEDRON. */
import { decimalText, pointsOf, type Writer } from '../../../model/written-element'

export const vtk: Writer = {
  title: 'VTK',
  note: 'legacy file with one VTK_HEXAHEDRON',
  extension: 'vtk',
  mediaType: 'text/plain',
  write(vertices, name) {
    return [
      '# vtk DataFile Version 3.0',
      name,
      'ASCII',
      'DATASET UNSTRUCTURED_GRID',
      'POINTS 8 double',
      ...pointsOf(vertices).map(point => point.map(decimalText).join(' ')),
      'CELLS 1 9',
      '8 0 1 2 3 4 5 6 7',
      'CELL_TYPES 1',
      '12',
      '',
    ].join('\n')
  },
}
