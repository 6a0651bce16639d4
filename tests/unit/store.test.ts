import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { vertexOf } from '../../web/model/hexahedron'
import { type Action, sliceChange, sliceOf } from '../../web/model/state'
import { createStore, HISTORY_LIMIT } from '../../web/model/store'
import { faceSlice } from '../../web/panels/face-maps/selected-face'
import { endsSlice } from '../../web/panels/morph/morph-question'
import { marksSlice, type Preview, previewSlice, sceneSlice } from '../../web/views/scene-slices'
import { unitCube } from './core-fixtures'

const other = unitCube.map(x => 2 * x)

function store() {
  return createStore(unitCube, 'cube')
}

function dispatched(...actions: Action[]) {
  const target = store()
  for (const action of actions) target.dispatch(action)
  return target
}

const move = (x: number, vertex = 6): Action => ({ type: 'move-vertex', vertex, to: [x, 1, 1] })
const begin: Action = { type: 'begin-gesture' }
const commit: Action = { type: 'commit-gesture' }
const cancel: Action = { type: 'cancel-gesture' }
const undo: Action = { type: 'undo' }
const redo: Action = { type: 'redo' }
const reset: Action = { type: 'reset' }
const set = (vertices: readonly number[], preset: string | null): Action => ({ type: 'set-vertices', vertices, preset })

const show = (preview: Preview | null) => sliceChange(previewSlice, { preview })
const previewed = (target: ReturnType<typeof store>) => sliceOf(previewSlice, target.state).preview

const xOf6 = (target: ReturnType<typeof store>) => vertexOf(target.state.vertices, 6)[0]

describe('one coordinate moved', () => {
  it('is a step like a vertex moved, and leaves the others as they are', () => {
    const target = dispatched(move(2), { type: 'move-coordinate', index: 19, to: 0.5 })
    expect(target.state.vertices).toEqual(unitCube.with(18, 2).with(19, 0.5))
    target.dispatch(undo)
    expect(target.state.vertices).toEqual(unitCube.with(18, 2))
  })

  it('is refused where there is none, or no number', () => {
    expect(() => dispatched({ type: 'move-coordinate', index: 24, to: 0 })).toThrow(RangeError)
    expect(() => dispatched({ type: 'move-coordinate', index: 0, to: Number.NaN })).toThrow(RangeError)
  })
})

describe('all vertices moved', () => {
  it('are one step, or a gesture’s, and preset and start stay', () => {
    const all = (vertices: readonly number[]): Action => ({ type: 'move-all', vertices })
    const target = dispatched(all(other))
    expect(target.state).toMatchObject({ vertices: other, preset: 'cube', start: unitCube })
    for (const action of [begin, all(unitCube.with(0, 3)), all(unitCube), commit, undo]) target.dispatch(action)
    expect(target.state).toMatchObject({ vertices: other, canUndo: true })
    target.dispatch(undo)
    expect(target.state).toMatchObject({ vertices: unitCube, canUndo: false })
    expect(() => target.dispatch(all(other.slice(1)))).toThrow(RangeError)
  })
})

describe('a gesture', () => {
  it('is one step, however many moves it has', () => {
    const target = dispatched(begin, move(2), move(3), move(4), commit)
    expect([xOf6(target), target.state.gestureStart]).toEqual([4, null])
    target.dispatch(undo)
    expect([xOf6(target), target.state.canUndo, target.state.canRedo]).toEqual([1, false, true])
    target.dispatch(redo)
    expect(xOf6(target)).toBe(4)
  })

  it('that ends where it began is no step and leaves the very same vertices', () => {
    const target = store()
    const { vertices } = target.state
    for (const action of [begin, move(2), move(1), commit]) target.dispatch(action)
    expect(target.state).toMatchObject({ canUndo: false, gestureStart: null })
    expect(target.state.vertices).toBe(vertices)
  })

  it('cancelled restores bit for bit', () => {
    const awkward = unitCube.with(0, -0).with(1, 0.1 + 0.2)
    const target = createStore(awkward, null)
    for (const action of [begin, move(2, 0), cancel]) target.dispatch(action)
    expect(target.state.vertices.every((value, i) => Object.is(value, awkward[i]))).toBe(true)
    expect(target.state.canUndo).toBe(false)
  })

  it('remembers where it began while it runs', () => {
    expect(dispatched(begin, move(2)).state.gestureStart).toEqual(unitCube)
  })

  it('is taken back by undo, and ends by that', () => {
    const target = dispatched(move(2), begin, move(3), undo)
    expect([xOf6(target), target.state.gestureStart, target.state.canUndo]).toEqual([2, null, true])
  })

  it('begun within another commits that one', () => {
    const target = dispatched(begin, move(2), begin, move(3), commit, undo)
    expect(xOf6(target)).toBe(2)
  })
})

describe('a step', () => {
  it('outside a gesture is every move that changes a bit', () => {
    expect(dispatched(move(1)).state.canUndo).toBe(false)
    expect(dispatched({ type: 'move-vertex', vertex: 0, to: [-0, 0, 0] }).state.canUndo).toBe(true)
  })

  it('clears what could be redone; choosing and showing do not', () => {
    const target = dispatched(
      move(2),
      undo,
      { type: 'select-vertex', vertex: 3 },
      sliceChange(sceneSlice, { faceDisplay: 2 }),
    )
    expect(target.state).toMatchObject({ canRedo: true, selectedVertex: 3, slices: { scene: { faceDisplay: 2 } } })
    target.dispatch(move(5))
    expect(target.state.canRedo).toBe(false)
  })

  it('is kept for as many as the limit', () => {
    const target = store()
    for (let n = 0; n < HISTORY_LIMIT + 10; ++n) target.dispatch(move(2 + n))
    for (let n = 0; n < HISTORY_LIMIT; ++n) target.dispatch(undo)
    expect([xOf6(target), target.state.canUndo]).toEqual([11, false])
  })
})

describe('another element', () => {
  it('brings its own start and preset; undo brings back the earlier ones', () => {
    const target = dispatched(move(3), set(other, 'other'), move(9))
    target.dispatch(reset)
    expect(target.state).toMatchObject({ vertices: other, preset: 'other', start: other })
    for (const action of [undo, undo, undo]) target.dispatch(action)
    expect(target.state).toMatchObject({ preset: 'cube', start: unitCube })
    expect(xOf6(target)).toBe(3)
  })

  it('is reset as one step, and not at all when nothing moved', () => {
    const target = dispatched(move(3), move(4), reset)
    expect(target.state.vertices).toEqual(unitCube)
    target.dispatch(undo)
    expect(xOf6(target)).toBe(4)
    expect(dispatched(reset).state.canUndo).toBe(false)
  })
})

describe('the store', () => {
  it('keeps the state object when nothing changes, and never mutates one', () => {
    const target = store()
    const before = target.state
    const copy = structuredClone(before)
    for (const action of [undo, redo, reset, commit, cancel, move(1)]) target.dispatch(action)
    expect(target.state).toBe(before)
    target.dispatch(move(7))
    expect(target.state).not.toBe(before)
    expect(before).toEqual(copy)
  })

  it('throws for what no caller may send', () => {
    const target = store()
    expect(() => createStore(unitCube.slice(1), null)).toThrow(RangeError)
    expect(() => target.dispatch(move(Number.NaN))).toThrow(RangeError)
    expect(() => target.dispatch(move(1, 8))).toThrow(RangeError)
    expect(() => target.dispatch(sliceChange(sceneSlice, { faceDisplay: 6 }))).toThrow(RangeError)
    for (const value of [-0.1, 1.1, Number.NaN])
      expect(() => target.dispatch(sliceChange(sceneSlice, { section: { axis: 0, value } }))).toThrow(RangeError)
    expect(target.state.vertices).toEqual(unitCube)
  })

  it('keeps panels, probe and face out of the history, and refuses a probe outside the cube', () => {
    const target = dispatched(
      { type: 'open-panel', panel: 'morph', isOpen: true },
      { type: 'open-panel', panel: 'morph', isOpen: true },
      { type: 'probe', point: [0, 0.5, 1] },
      sliceChange(faceSlice, { selectedFace: 5 }),
    )
    expect(target.state).toMatchObject({ openPanels: ['morph'], probe: [0, 0.5, 1], canUndo: false })
    expect(sliceOf(faceSlice, target.state)).toEqual({ selectedFace: 5 })
    const before = target.state
    target.dispatch({ type: 'probe', point: [0, 0.5, 1] })
    expect(target.state).toBe(before)
    target.dispatch({ type: 'open-panel', panel: 'morph', isOpen: false })
    expect(target.state.openPanels).toEqual([])
    expect(() => target.dispatch({ type: 'probe', point: [0, 0.5, 1.5] })).toThrow(RangeError)
    expect(() => target.dispatch(sliceChange(faceSlice, { selectedFace: 6 }))).toThrow(RangeError)
  })

  it('keeps the reference cube and linked cameras out of the history', () => {
    const target = dispatched(
      sliceChange(sceneSlice, { referenceShown: true }),
      sliceChange(sceneSlice, { camerasLinked: true }),
    )
    expect(sliceOf(sceneSlice, target.state)).toMatchObject({ referenceShown: true, camerasLinked: true })
    expect(target.state.canUndo).toBe(false)
    const before = target.state
    target.dispatch(sliceChange(sceneSlice, { referenceShown: true }))
    expect(target.state).toBe(before)
  })

  it('keeps what is highlighted out of the history, and refuses an entity that is not there', () => {
    const highlight = { kind: 'edge', id: 11 } as const
    const target = dispatched(sliceChange(marksSlice, { highlight }))
    expect(target.state.canUndo).toBe(false)
    expect(sliceOf(marksSlice, target.state).highlight).toBe(highlight)
    const before = target.state
    target.dispatch(sliceChange(marksSlice, { highlight }))
    expect(target.state).toBe(before)
    expect(() => target.dispatch(sliceChange(marksSlice, { highlight: { kind: 'vertex', id: 8 } }))).toThrow(RangeError)
    target.dispatch(sliceChange(marksSlice, { highlight: null }))
    expect(sliceOf(marksSlice, target.state).highlight).toBeNull()
  })

  it('keeps a check’s samples out of the history, while the vertices move, and refuses a point that is not in the cube', () => {
    const samples = { points: [[0, 0.5, 1]], edges: false } as const
    const target = dispatched(sliceChange(marksSlice, { samples }))
    expect(target.state.canUndo).toBe(false)
    target.dispatch({ type: 'move-all', vertices: unitCube.with(4, 0.5) })
    expect(sliceOf(marksSlice, target.state).samples).toBe(samples)
    const outside = { points: [[0, 0.5, 1.5]], edges: false } as const
    expect(() => target.dispatch(sliceChange(marksSlice, { samples: outside }))).toThrow(RangeError)
    target.dispatch(sliceChange(marksSlice, { samples: null }))
    expect(sliceOf(marksSlice, target.state).samples).toBeNull()
  })

  it('keeps the face whose curve is drawn, and refuses one that is not there', () => {
    const target = dispatched(sliceChange(marksSlice, { curveOn: 4 }))
    expect(target.state.canUndo).toBe(false)
    target.dispatch({ type: 'move-all', vertices: unitCube.with(4, 0.5) })
    expect(sliceOf(marksSlice, target.state).curveOn).toBe(4)
    expect(() => target.dispatch(sliceChange(marksSlice, { curveOn: 6 }))).toThrow(RangeError)
    target.dispatch(sliceChange(marksSlice, { curveOn: null }))
    expect(sliceOf(marksSlice, target.state).curveOn).toBeNull()
  })

  it('previews a move until the vertices change, and refuses what is no element', () => {
    const moved = unitCube.with(4, 0.5)
    const target = dispatched(show({ move: moved }))
    expect(target.state).toMatchObject({ vertices: unitCube, canUndo: false })
    expect(previewed(target)?.move).toBe(moved)
    target.dispatch({ type: 'select-vertex', vertex: 5 })
    expect(previewed(target)?.move).toBe(moved)
    target.dispatch({ type: 'move-all', vertices: moved })
    expect(target.state).toMatchObject({ vertices: moved, canUndo: true })
    expect(previewed(target)).toBeNull()
    for (const wrong of [unitCube.slice(1), unitCube.with(7, Number.NaN)])
      expect(() => target.dispatch(show({ move: wrong }))).toThrow(RangeError)
  })

  it('previews another node order until the vertices change, and refuses what is none', () => {
    const order = [0, 1, 3, 2, 4, 5, 7, 6]
    const target = dispatched(show({ order }))
    expect(target.state.canUndo).toBe(false)
    target.dispatch({ type: 'select-vertex', vertex: 5 })
    expect(previewed(target)?.order).toBe(order)
    target.dispatch({ type: 'move-vertex', vertex: 5, to: [9, 9, 9] })
    expect(previewed(target)).toBeNull()
    target.dispatch(show({ order }))
    target.dispatch({ type: 'undo' })
    expect(previewed(target)).toBeNull()
    for (const wrong of [
      [0, 1, 2],
      [0, 1, 2, 3, 4, 5, 6, 6],
      [1, 2, 3, 4, 5, 6, 7, 8],
    ])
      expect(() => target.dispatch(show({ order: wrong }))).toThrow(RangeError)
  })

  it('takes what is set before the first frame as the start, not as steps', () => {
    const target = createStore(unitCube, 'cube', 'starting')
    target.dispatch({ type: 'set-vertices', vertices: unitCube.with(0, 3), preset: null })
    target.dispatch({ type: 'set-vertices', vertices: other, preset: 'named', start: unitCube })
    expect(target.state).toMatchObject({ vertices: other, preset: 'named', start: unitCube, canUndo: false })
    target.dispatch({ type: 'begin' })
    target.dispatch({ type: 'reset' })
    expect(target.state).toMatchObject({ phase: 'begun', vertices: unitCube, canUndo: true })
  })

  it('changes nothing where the numbers are there already, unless a preset names them', () => {
    const target = dispatched(set(other, null))
    const before = target.state
    target.dispatch({ type: 'set-vertices', vertices: other.slice(), preset: null })
    expect(target.state).toBe(before)
    target.dispatch({ type: 'set-vertices', vertices: other.slice(), preset: 'named' })
    expect(target.state).toMatchObject({ preset: 'named', start: other, canUndo: true })
    expect(target.state.vertices).toBe(before.vertices)
    target.dispatch({ type: 'set-vertices', vertices: other.with(0, -0), preset: null })
    expect(Object.is(target.state.vertices[0], -0)).toBe(true)
  })

  it('has a chosen vertex once somebody chose one, until it is let go of', () => {
    const target = dispatched()
    expect(target.state.isVertexChosen).toBe(false)
    target.dispatch({ type: 'select-vertex', vertex: 0 })
    expect(target.state).toMatchObject({ selectedVertex: 0, isVertexChosen: true })
    target.dispatch({ type: 'select-vertex', vertex: 5 })
    target.dispatch({ type: 'select-vertex', vertex: null })
    expect(target.state).toMatchObject({ selectedVertex: 5, isVertexChosen: false })
    const first = createStore(unitCube, 'cube').state
    target.dispatch({ type: 'restore', state: { ...first, selectedVertex: 4 } })
    expect(target.state.isVertexChosen).toBe(true)
    target.dispatch({ type: 'restore', state: first })
    expect(target.state).toMatchObject({ selectedVertex: 0, isVertexChosen: false })
  })

  it('restored keeps what is passing, but for a preview', () => {
    const samples = { points: [[0, 0.5, 1]], edges: false } as const
    const target = dispatched(sliceChange(marksSlice, { samples }), show({ order: [1, 0, 3, 2, 5, 4, 7, 6] }))
    target.dispatch({ type: 'restore', state: { ...createStore(unitCube, 'cube').state, selectedVertex: 4 } })
    expect(target.state).toMatchObject({ selectedVertex: 4, canUndo: false })
    expect(sliceOf(marksSlice, target.state).samples).toBe(samples)
    expect(previewed(target)).toBeNull()
  })

  it('keeps the ends of a way out of the history, and refuses what is no element', () => {
    const target = dispatched(sliceChange(endsSlice, { morphA: other }))
    expect(sliceOf(endsSlice, target.state)).toEqual({ morphA: other, morphB: null })
    expect(target.state.canUndo).toBe(false)
    target.dispatch(sliceChange(endsSlice, { morphB: unitCube }))
    expect(sliceOf(endsSlice, target.state)).toEqual({ morphA: other, morphB: unitCube })
    target.dispatch(sliceChange(endsSlice, { morphA: null }))
    expect(sliceOf(endsSlice, target.state).morphA).toBeNull()
    const before = target.state
    target.dispatch(sliceChange(endsSlice, { morphA: null }))
    expect(target.state).toBe(before)
    expect(() => target.dispatch(sliceChange(endsSlice, { morphB: [1] }))).toThrow(RangeError)
  })

  it('after any actions undoes all the way to the start and redoes all the way back', () => {
    const action = fc.oneof(
      fc.record({
        type: fc.constant('move-vertex' as const),
        vertex: fc.integer({ min: 0, max: 7 }),
        to: fc.tuple(fc.integer({ min: 0, max: 2 }), fc.constant(0), fc.constant(1)),
      }),
      fc.constantFrom(begin, commit, cancel, undo, redo, reset, set(other, 'other'), set(unitCube, null)),
    )
    fc.assert(
      fc.property(fc.array(action, { maxLength: 40 }), actions => {
        const target = dispatched(...actions, commit)
        const end = target.state
        for (let n = 0; target.state.canUndo; ++n) {
          expect(n).toBeLessThan(100)
          target.dispatch(undo)
        }
        expect(target.state).toMatchObject({ vertices: unitCube, preset: 'cube', start: unitCube })
        while (target.state.canRedo) target.dispatch(redo)
        if (!end.canRedo) expect(target.state).toEqual(end)
      }),
      { seed: 20260608, numRuns: 1000 },
    )
  })
})
