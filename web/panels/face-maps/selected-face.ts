/** The panel's slice: the face whose quartic is shown. */
import { described, indexBelow } from '../../model/document-readers'
import { faces } from '../../model/hexahedron'
import type { Slice } from '../../model/state'
import { checkIndex } from '../../model/store'

export const faceSlice: Slice<{ readonly selectedFace: number }> = {
  name: 'face-maps',
  first: { selectedFace: 0 },
  readers: { selectedFace: described('The face whose quartic is shown.', indexBelow(faces.length)) },
  check: ({ selectedFace }) => checkIndex(selectedFace, faces.length, 'face'),
}
