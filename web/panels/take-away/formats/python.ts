/** A NumPy array of 8×3; Python rounds float literals correctly, so decimals are exact. */
import { decimalText, pointsOf, type Writer } from '../../../model/written-element'

export const python: Writer = {
  title: 'Python',
  note: 'NumPy array, exact',
  extension: 'py',
  mediaType: 'text/x-python',
  write(vertices) {
    const rows = pointsOf(vertices).map(point => `    [${point.map(decimalText).join(', ')}],`)
    return ['import numpy as np', '', '# VTK_HEXAHEDRON order', 'vertices = np.array([', ...rows, '])', ''].join('\n')
  },
}
