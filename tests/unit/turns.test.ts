import { describe, expect, it } from 'vitest'
import { Turns } from '../../web/element/turns'
import type { View } from '../../web/views/view'

const view = (takesTurns: boolean) => ({ takesTurns }) as View
const [scene, maps, steps, inside] = [view(false), view(true), view(true), view(true)]
const views = [scene, maps, steps, inside]

describe('turns', () => {
  it('are for gestures: between them every view is up to date after each frame', () => {
    const turns = new Turns()
    expect(turns.due(views, true, false)).toEqual(views)
    expect(turns.isWaiting).toBe(false)
  })

  it('come round, one a frame, however often there is news, and the scene never waits', () => {
    const turns = new Turns()
    const frames = Array.from({ length: 6 }, () => turns.due(views, true, true))
    for (const due of frames) expect(due).toHaveLength(2)
    expect(frames.map(due => due[0])).toEqual(Array(6).fill(scene))
    expect(frames.map(due => due[1])).toEqual([maps, steps, inside, maps, steps, inside])
  })

  it('leave no view behind once the pointer rests, or the gesture ends', () => {
    const turns = new Turns()
    turns.due(views, true, true)
    expect([turns.due(views, false, true), turns.due(views, false, true)]).toEqual([[steps], [inside]])
    expect(turns.isWaiting).toBe(false)
    turns.due(views, true, true)
    expect(turns.due(views, true, false)).toEqual([scene, steps, inside, maps])
    expect(turns.isWaiting).toBe(false)
  })
})
