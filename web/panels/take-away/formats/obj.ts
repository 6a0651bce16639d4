/** Wavefront OBJ: eight points and the six faces, seen from outside; it has no curved faces. */
import { decimalText, pointsOf, type Writer } from '../../../model/written-element'

/** Counterclockwise from outside, in the order of the faces. */
const QUADS = [
  [0, 4, 7, 3],
  [1, 2, 6, 5],
  [0, 1, 5, 4],
  [3, 7, 6, 2],
  [0, 3, 2, 1],
  [4, 5, 6, 7],
]

export const obj: Writer = {
  title: 'OBJ',
  note: 'points, and the corners of the faces',
  extension: 'obj',
  mediaType: 'model/obj',
  write(vertices, name) {
    return [
      `o ${name}`,
      ...pointsOf(vertices).map(point => `v ${point.map(decimalText).join(' ')}`),
      ...QUADS.map(quad => `f ${quad.map(v => v + 1).join(' ')}`),
      '',
    ].join('\n')
  },
}
