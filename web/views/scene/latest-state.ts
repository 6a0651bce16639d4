/**
 * The state as the scene's own actions leave it. Views see the new state once a frame, but two key presses can fall between
 * two frames, and the second must go on from the first.
 */
import { withVertex } from '../../model/hexahedron'
import type { Action, State } from '../../model/state'
import type { ViewHost } from '../view'

export class LatestState {
  readonly #host: ViewHost
  #state: State | null = null

  constructor(host: ViewHost) {
    this.#host = host
  }

  get state(): State | null {
    return this.#state
  }

  receive(state: State): void {
    this.#state = state
  }

  dispatch(action: Action): void {
    if (this.#state) this.#state = foresee(this.#state, action)
    this.#host.dispatch(action)
  }
}

function foresee(state: State, action: Action): State {
  switch (action.type) {
    case 'move-vertex':
      return { ...state, vertices: withVertex(state.vertices, action.vertex, action.to) }
    case 'select-vertex':
      return { ...state, selectedVertex: action.vertex }
    case 'show-faces':
      return { ...state, faceDisplay: action.faceDisplay }
    case 'show-reference-cube':
      return { ...state, referenceCube: action.referenceCube }
    case 'begin-gesture':
      return { ...state, gestureStart: state.vertices }
    case 'commit-gesture':
      return { ...state, gestureStart: null }
    case 'cancel-gesture':
      return { ...state, vertices: state.gestureStart ?? state.vertices, gestureStart: null }
    default:
      return state
  }
}
