/** The element and state of a step of a lesson. */

import type { Vertices } from '../../model/hexahedron'
import { type Preset, presets, presetVertices } from '../../model/presets'
import { STATE_VERSION, type StateDocument } from '../../model/state-document'
import { isInPlane, type LessonStep } from './content/lessons'
import { drawnOut } from './plane/quadrilateral'

export function verticesOf(step: LessonStep): Vertices {
  if (isInPlane(step)) return drawnOut(step.quadrilateral)
  const { element } = step
  if (typeof element !== 'string') return element.flat()
  return presetVertices(presets.find(({ id }) => id === element) as Preset)
}

/** The step's state; all else is as in a new element. */
export function stateOf(step: LessonStep): StateDocument {
  const vertices = verticesOf(step)
  if (isInPlane(step)) return planeState(vertices)
  const preset = typeof step.element === 'string' ? step.element : null
  return { version: STATE_VERSION, vertices, preset, ...step.state } as StateDocument
}

/** The plane keeps no more. */
export function planeState(vertices: Vertices): StateDocument {
  return { version: STATE_VERSION, vertices } as StateDocument
}

/** The step as it begins: while its question waits for an answer, with what is shown before. */
export function shownStep<Step extends LessonStep>(step: Step, isAsked: boolean): Step {
  return isAsked ? { ...step, ...step.question?.before } : step
}
