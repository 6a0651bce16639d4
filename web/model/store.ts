/**
 * The state and its history. One store belongs to one element; dispatching is the only way to change it.
 *
 * A step is what one undo takes back: a change of vertices, preset or start outside a gesture, or a whole gesture.
 * Changes are told by the bits, so that -0 and 0 differ; what changes nothing is no step and keeps the state object itself,
 * and a gesture that ends where it began gives back the `vertices` array it began with.
 */
import {
  COORDINATE_COUNT,
  sameBits,
  VERTEX_COUNT,
  type Vec3,
  type Vertices,
  vertexReference,
  withVertex,
} from './hexahedron'
import { type Action, type History, type LastingState, type Phase, type Snapshot, type State, sliceOf } from './state'

export interface Store {
  /** The state now: a new object after every change, never mutated. */
  readonly state: State
  /** All elements that undo and redo lead to; of a gesture that still runs, where it began. */
  readonly history: History
  /**
   * Applies one action. In short:
   * - `begin-gesture` commits a gesture that still runs; commit and cancel without a gesture do nothing.
   * - `undo` in a gesture that moved something takes back that gesture alone; in one that did not, the step before it.
   * - `redo`, `reset` in a gesture cancel it first.
   * - `restore` and `take-history` cancel a gesture that still runs.
   * - `set-vertices` makes the given element the one that `reset` goes back to; undo brings back the earlier one. Numbers that are
   *   already there change nothing, unless they are now called by a preset's name.
   *
   * Throws RangeError for what no caller may send: not 24 finite coordinates, no such vertex, coordinate, face or step, a
   * place outside the reference cube, no order of eight vertices.
   */
  dispatch(action: Action): void
}

/** Undo steps kept; a page that animates an element for hours must not fill the memory. */
export const HISTORY_LIMIT = 1000

type Shown = Omit<State, keyof Snapshot | 'phase' | 'gestureStart' | 'canUndo' | 'canRedo'>

/** The state of a new element. */
export const SHOWN_FIRST: Shown = {
  selectedVertex: 0,
  isVertexChosen: false,
  referenceCube: 'unit',
  cameras: null,
  probe: null,
  openPanels: [],
  isReadonly: false,
  slices: {},
}

/** A store that starts at these vertices, which reset goes back to. Throws RangeError unless they are 24 finite numbers. */
export function createStore(vertices: Vertices, preset: string | null, firstPhase: Phase = 'begun'): Store {
  const start = accepted(vertices)
  let present: Snapshot = { vertices: start, preset, start }
  let phase = firstPhase
  /** Steps are kept from the first frame on; with a history, at once. */
  let isRecording = phase === 'begun'
  let past: readonly Snapshot[] = []
  let future: readonly Snapshot[] = []
  let gestureStart: Snapshot | null = null
  let shown = SHOWN_FIRST
  /** Names of slices that end when the vertices change. */
  const ending = new Set<string>()
  let state = currentState()

  function currentState(): State {
    const moved = gestureStart !== null && !sameSnapshot(gestureStart, present)
    return {
      ...present,
      ...shown,
      phase,
      gestureStart: gestureStart?.vertices ?? null,
      canUndo: past.length > 0 || moved,
      canRedo: future.length > 0,
    }
  }

  function record(before: Snapshot): void {
    if (!isRecording) return
    past = [...past, before].slice(-HISTORY_LIMIT)
    future = []
  }

  function change(next: Snapshot): void {
    const before = present
    present = next
    if (gestureStart === null && !sameSnapshot(before, next)) record(before)
  }

  function commit(): void {
    if (gestureStart === null) return
    if (sameSnapshot(gestureStart, present)) present = gestureStart
    else record(gestureStart)
    gestureStart = null
  }

  /** True if a gesture was taken back. */
  function cancel(): boolean {
    if (gestureStart === null) return false
    const moved = !sameSnapshot(gestureStart, present)
    present = gestureStart
    gestureStart = null
    return moved
  }

  function undo(): void {
    const before = cancel() ? undefined : past.at(-1)
    if (!before) return
    past = past.slice(0, -1)
    future = [...future, present]
    present = before
  }

  function redo(): void {
    cancel()
    const after = future.at(-1)
    if (!after) return
    future = future.slice(0, -1)
    past = [...past, present]
    present = after
  }

  function apply(action: Action): void {
    switch (action.type) {
      case 'move-vertex': {
        const moved = accepted(withVertex(present.vertices, checkedVertex(action.vertex), action.to))
        change({ ...present, vertices: kept(present.vertices, moved) })
        break
      }
      case 'move-coordinate': {
        const { index, to } = action
        const moved = accepted(present.vertices.with(checkIndex(index, COORDINATE_COUNT, 'coordinate'), to))
        change({ ...present, vertices: kept(present.vertices, moved) })
        break
      }
      case 'move-all':
        change({ ...present, vertices: kept(present.vertices, accepted(action.vertices)) })
        break
      case 'set-vertices': {
        const vertices = kept(present.vertices, accepted(action.vertices))
        const isNamed = action.preset !== null && action.preset !== present.preset
        if (phase === 'begun' && vertices === present.vertices && !isNamed) break
        const start = kept(present.start, action.start ? accepted(action.start) : vertices)
        change({ vertices, preset: action.preset, start })
        break
      }
      case 'begin':
        phase = 'begun'
        isRecording = true
        break
      case 'begin-gesture':
        commit()
        gestureStart = present
        break
      case 'commit-gesture':
        commit()
        break
      case 'cancel-gesture':
        cancel()
        break
      case 'undo':
        undo()
        break
      case 'redo':
        redo()
        break
      case 'reset':
        cancel()
        change({ ...present, vertices: kept(present.vertices, present.start) })
        break
      case 'select-vertex':
        shown = {
          ...shown,
          selectedVertex: checkedVertex(action.vertex ?? shown.selectedVertex),
          isVertexChosen: action.vertex !== null,
        }
        break
      case 'show-reference-cube':
        shown = { ...shown, referenceCube: action.referenceCube }
        break
      case 'open-panel':
        shown = { ...shown, openPanels: withPanel(shown.openPanels, action.panel, action.isOpen) }
        break
      case 'look':
        shown = { ...shown, cameras: action.cameras }
        break
      case 'probe':
        if (action.point) checkInCube(action.point)
        shown = { ...shown, probe: samePoint(shown.probe, action.point) ? shown.probe : action.point }
        break
      case 'change-slice': {
        const { slice, change } = action
        const before = sliceOf(slice, shown)
        const after = { ...before, ...change }
        slice.check?.(after)
        if (slice.endsWithVertices) ending.add(slice.name)
        if (!sameEntries(before, after)) shown = { ...shown, slices: { ...shown.slices, [slice.name]: after } }
        break
      }
      case 'set-readonly':
        shown = { ...shown, isReadonly: action.isReadonly }
        break
      case 'restore':
        cancel()
        restore(action.state)
        break
      case 'take-history':
        cancel()
        takeHistory(action.history)
        break
    }
  }

  /** The reader of the state has checked the rest. */
  function restore({ vertices, preset, start, slices, ...others }: LastingState): void {
    const began = kept(present.start, accepted(start))
    change({ vertices: kept(present.vertices, kept(began, accepted(vertices))), preset, start: began })
    endSlices()
    // The first vertex is everybody's who chose none.
    const isVertexChosen = others.selectedVertex !== SHOWN_FIRST.selectedVertex
    shown = { ...shown, ...others, isVertexChosen, slices: { ...shown.slices, ...slices }, probe: null }
  }

  /** The reader of the history has checked it. */
  function takeHistory({ elements, present: index }: History): void {
    const next = elements[index] as Snapshot
    past = elements.slice(0, index)
    present = { ...next, vertices: kept(present.vertices, next.vertices), start: kept(present.start, next.start) }
    future = elements.slice(index + 1).toReversed()
    isRecording = true
  }

  function endSlices(): void {
    const left = Object.entries(shown.slices).filter(([name]) => !ending.has(name))
    shown = { ...shown, slices: Object.fromEntries(left) }
    ending.clear()
  }

  return {
    get state() {
      return state
    },
    get history() {
      return { elements: [...past, gestureStart ?? present, ...future.toReversed()], present: past.length }
    },
    dispatch(action) {
      const { vertices } = present
      apply(action)
      if (present.vertices !== vertices && ending.size > 0) endSlices()
      const next = currentState()
      if (!sameEntries(state, next)) state = next
    },
  }
}

/** A copy of its own, so that nobody changes it behind the store's back. */
function accepted(vertices: Vertices): Vertices {
  checkFinite(vertices)
  return vertices.slice()
}

/** Throws RangeError unless these are 24 finite numbers. */
export function checkFinite(vertices: Vertices): void {
  if (vertices.length !== COORDINATE_COUNT || !vertices.every(Number.isFinite))
    throw new RangeError(`A hexahedron is 24 finite numbers, not ${vertices.length} with ${vertices.join(', ')}.`)
}

function checkedVertex(vertex: number): number {
  return checkIndex(vertex, VERTEX_COUNT, 'vertex')
}

export function checkIndex(index: number, count: number, what: string): number {
  if (!Number.isInteger(index) || index < 0 || index >= count) throw new RangeError(`There is no ${what} ${index}.`)
  return index
}

export function checkWithin(value: number, least: number, greatest: number): void {
  if (!(value >= least && value <= greatest)) throw new RangeError(`${value} is not in [${least},${greatest}].`)
}

export function checkOrder(order: readonly number[]): void {
  const isOrder = order.length === VERTEX_COUNT && vertexReference.every((_, v) => order.includes(v))
  if (!isOrder) throw new RangeError(`${order.join(', ')} is no order of eight vertices.`)
}

export function checkInCube(point: Vec3): void {
  if (!point.every(x => x >= 0 && x <= 1)) throw new RangeError(`(${point.join(', ')}) is not in [0,1]³.`)
}

function samePoint(a: Vec3 | null, b: Vec3 | null): boolean {
  return a === b || (a !== null && b !== null && a.every((x, axis) => Object.is(x, b[axis])))
}

function withPanel(open: readonly string[], panel: string, isOpen: boolean): readonly string[] {
  if (open.includes(panel) === isOpen) return open
  return isOpen ? [...open, panel] : open.filter(other => other !== panel)
}

/** The old array where the new one says the same: identity then tells change. */
function kept(before: Vertices, after: Vertices): Vertices {
  return sameBits(before, after) ? before : after
}

function sameSnapshot(a: Snapshot, b: Snapshot): boolean {
  return sameBits(a.vertices, b.vertices) && a.preset === b.preset && sameBits(a.start, b.start)
}

function sameEntries<T extends object>(a: T, b: T): boolean {
  return (Object.keys(b) as (keyof T)[]).every(key => Object.is(a[key], b[key]))
}
