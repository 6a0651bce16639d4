import { type Action, type State, sliceChange, sliceOf } from '../../model/state'
import { sceneSlice } from '../../views/scene-slices'
import { fold } from '../fold'
import type { Panel } from '../panel'

/** Opening it shows the inside in the scene, closing it the faces again. */
export function toggled(state: State, isOpen: boolean): Action {
  const { faceDisplay } = sliceOf(sceneSlice, state)
  return sliceChange(sceneSlice, { faceDisplay: isOpen ? 'inside' : faceDisplay === 'inside' ? 'opaque' : faceDisplay })
}

export const inside: Panel = fold({ name: 'inside', title: 'Inside', load: () => import('./inside-panel'), toggled })
