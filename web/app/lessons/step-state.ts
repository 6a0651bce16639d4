/** What the lens shows in a step of a lesson. */
import type { LessonStep } from '../../content/lessons'
import { type Preset, presets, presetVertices } from '../../content/presets'
import type { Vertices } from '../../model/hexahedron'
import { STATE_VERSION, type StateDocument } from '../../model/state-document'

export function verticesOf({ element }: LessonStep): Vertices {
  if (typeof element !== 'string') return element.flat()
  return presetVertices(presets.find(({ id }) => id === element) as Preset)
}

/** With what is not said as in a new element. */
export function stateOf(step: LessonStep): StateDocument {
  const preset = typeof step.element === 'string' ? step.element : null
  return { version: STATE_VERSION, vertices: verticesOf(step), preset, ...step.state } as StateDocument
}
