/** The element and state of a step of a lesson. */

import type { Vertices } from '../../model/hexahedron'
import { type Preset, presets, presetVertices } from '../../model/presets'
import { STATE_VERSION, type StateDocument } from '../../model/state-document'
import type { LessonStep } from './content/lessons'

export function verticesOf({ element }: LessonStep): Vertices {
  if (typeof element !== 'string') return element.flat()
  return presetVertices(presets.find(({ id }) => id === element) as Preset)
}

/** The step's state; all else is as in a new element. */
export function stateOf(step: LessonStep): StateDocument {
  const preset = typeof step.element === 'string' ? step.element : null
  return { version: STATE_VERSION, vertices: verticesOf(step), preset, ...step.state } as StateDocument
}
