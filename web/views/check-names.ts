/** What other checks are called, by their ids in the report. */
import type { CheckId } from '../core/report'
import type { PlainWord } from '../words/say'

export const checkNames: Readonly<Record<CheckId, PlainWord>> = {
  corners: 'Eight corners',
  'corners-and-centre': 'Corners and centre',
  'gauss-2': '2×2×2 Gauss points',
  'gauss-3': '3×3×3 Gauss points',
  edges: 'Twelve edges',
  bernstein: 'One Bernstein bound',
  subdivision: 'Subdivision to depth\u00a04',
  tangents: 'Four tangents',
}

/** In lists of a mesh's cells, as in the sentence on top: on cells with edges of no length VTK says something else than the corners do. */
export const checkNamesOfMeshes: Readonly<Record<CheckId, PlainWord>> = {
  ...checkNames,
  'corners-and-centre': 'VTK’s scaled Jacobian',
}
