/** Elements of a group: what one shows the others show, in the same frame and without an echo. */
import { describe, expect, it } from 'vitest'
import { Sharing } from '../../web/element/sharing'
import { presets, presetVertices } from '../../web/model/presets'
import type { Action, CameraView } from '../../web/model/state'
import { createStore } from '../../web/model/store'

const cube = presetVertices(presets.find(({ id }) => id === 'cube') ?? presets[0])
const moved = cube.with(20, 3)
let groups = 0

/** An element without a picture; `frame` is its next one, `drawn` says when it was drawn. */
function member(group: string, share: Sharing['kinds'] = ['vertices', 'camera', 'probe'], vertices = cube) {
  const store = createStore(vertices, null)
  const drawn: number[] = []
  let camera: CameraView | null = null
  const sharing = new Sharing({
    state: () => store.state,
    history: () => store.history,
    camera: () => camera,
    source: () => 'pointer',
    dispatch: action => store.dispatch(action),
    lookFrom: asked => {
      camera = asked
    },
    draw: time => {
      drawn.push(time)
      sharing.tell(time)
    },
  })
  Object.assign(sharing, { name: group, kinds: share })
  sharing.join()
  return {
    store,
    sharing,
    drawn,
    camera: () => camera,
    turn(zoom: number) {
      camera = { direction: [1, 0, 0], zoom, pan: [0, 0, 0] }
    },
    do: (...actions: Action[]) => actions.forEach(store.dispatch),
    frame: (time: number) => sharing.tell(time),
    vertices: () => store.state.vertices,
  }
}

const pair = (...shares: (Sharing['kinds'] | undefined)[]) => {
  const group = `group ${groups++}`
  return [member(group, shares[0]), member(group, shares[1])] as const
}

describe('elements of a group', () => {
  it('have one element and one history: a drag is seen while it lasts, and is one step on both sides', () => {
    const [a, b] = pair()
    a.do({ type: 'select-vertex', vertex: 6 }, { type: 'begin-gesture' }, { type: 'move-all', vertices: moved })
    a.frame(1)
    expect([b.vertices(), b.store.state.gestureStart, b.store.state.selectedVertex]).toEqual([moved, cube, 6])
    const { vertices } = b.store.state
    a.do({ type: 'commit-gesture' })
    a.frame(2)
    expect(b.vertices()).toBe(vertices)
    expect(b.store.history).toEqual(a.store.history)
    expect(b.store.state).toMatchObject({ gestureStart: null, canUndo: true })
    b.do({ type: 'undo' })
    b.frame(3)
    expect([a.vertices(), a.store.state.canRedo]).toEqual([cube, true])
    expect(a.store.history).toEqual(b.store.history)
  })

  it('draw once in the frame of the one that changed, and nobody answers', () => {
    const [a, b] = pair()
    for (const [i, change] of [
      () => a.do({ type: 'move-all', vertices: moved }),
      () => a.do({ type: 'probe', point: [0.5, 0, 1] }),
      () => a.turn(2),
    ].entries()) {
      change()
      a.frame(i)
      expect(b.drawn).toEqual([...Array(i + 1).keys()])
      for (const time of [7, 8]) for (const each of [a, b]) each.frame(time)
      expect([a.drawn.length, b.drawn.length]).toEqual([0, i + 1])
    }
    expect([b.store.state.probe, b.camera()?.zoom]).toEqual([[0.5, 0, 1], 2])
  })

  it('share what both share', () => {
    const [before, after] = pair(['camera', 'probe'], ['vertices', 'camera'])
    after.do({ type: 'move-all', vertices: moved }, { type: 'probe', point: [0, 0, 0] })
    after.turn(3)
    after.frame(1)
    expect([before.vertices(), before.store.state.probe, before.camera()?.zoom]).toEqual([cube, null, 3])
  })

  it('give a newcomer what they have, to its first picture too', () => {
    const group = `group ${groups++}`
    const a = member(group)
    a.do({ type: 'move-all', vertices: moved })
    a.turn(2)
    a.frame(1)
    const b = member(group, undefined, cube.with(0, -1))
    expect([b.vertices(), b.camera()?.zoom]).toEqual([moved, 2])
    const [c, d] = pair()
    c.turn(2)
    c.frame(1)
    expect(d.camera()?.zoom).toBe(2)
    const [e, f] = pair()
    f.turn(5)
    f.frame(1)
    e.turn(1)
    f.frame(2)
    expect([e.camera()?.zoom, f.camera()?.zoom]).toEqual([1, 5])
  })

  it('go on without one that leaves, in the middle of its drag as well', () => {
    const [a, b] = pair()
    a.do({ type: 'probe', point: [0, 0, 0] }, { type: 'begin-gesture' }, { type: 'move-all', vertices: moved })
    a.frame(1)
    a.do({ type: 'cancel-gesture' }) // as its scene does when it goes
    a.sharing.leave()
    expect([b.vertices(), b.store.state.gestureStart, b.store.state.probe]).toEqual([cube, null, null])
    a.do({ type: 'move-all', vertices: moved })
    a.frame(2)
    expect([b.vertices(), b.drawn]).toEqual([cube, [1]])
    b.sharing.leave()
    const alone = member(b.sharing.name ?? '', undefined, moved)
    expect(alone.vertices()).toEqual(moved)
  })
})
