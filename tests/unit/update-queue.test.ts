import { describe, expect, it } from 'vitest'
import { UpdateQueue } from '../../web/element/update-queue'
import type { Frame, Update, View } from '../../web/views/view'

/** Each update takes a millisecond by `clock`. */
let clock = 0
let done: string[] = []
const update =
  (name: string): Update =>
  () => {
    done.push(name)
    clock++
  }
const view = (name: string, ...updates: string[]) =>
  ({ update: update(name), ...(updates.length > 0 && { updates: updates.map(update) }) }) as unknown as View
const views = [view('scene'), view('maps', 'left', 'right'), view('inside', 'section')]
const afterAll = ['scene', 'maps', 'inside', 'left', 'right', 'section']

function frame(queue: UpdateQueue, isNews: boolean, isGesture: boolean, shown: readonly View[] = views): string[] {
  done = []
  for (const take of queue.due(shown, isNews, isGesture)) take({} as Frame)
  return done
}

describe('updates', () => {
  it('are for gestures: between them everything is up to date after each frame', () => {
    const queue = new UpdateQueue(() => clock)
    expect(frame(queue, true, false)).toEqual(afterAll)
    expect(queue.isWaiting).toBe(false)
  })

  it('come round, one every second frame where the time is over, however often there is news; what takes no updates never waits', () => {
    const queue = new UpdateQueue(() => clock)
    const frames = Array.from({ length: 8 }, () => frame(queue, true, true))
    expect(frames.map(names => names.slice(0, 3))).toEqual(Array(8).fill(['scene', 'maps', 'inside']))
    expect(frames.map(names => names.slice(3))).toEqual([[], ['left'], [], ['right'], [], ['section'], [], ['left']])
  })

  it('are as many in a frame as there is time for', () => {
    const queue = new UpdateQueue(() => clock)
    frame(queue, true, true)
    expect([frame(queue, false, true), frame(queue, false, true)]).toEqual([['left', 'right'], ['section']])
    expect(queue.isWaiting).toBe(false)
  })

  it('are all taken in every frame where they take no time', () => {
    const queue = new UpdateQueue(() => 0)
    expect(frame(queue, true, true)).toEqual(afterAll)
    expect(queue.isWaiting).toBe(false)
  })

  it('leave nothing behind once the gesture ends', () => {
    const queue = new UpdateQueue(() => clock)
    frame(queue, true, true)
    frame(queue, true, true)
    expect(frame(queue, true, false)).toEqual(['scene', 'maps', 'inside', 'right', 'section', 'left'])
    expect(queue.isWaiting).toBe(false)
  })

  it('are forgotten with their view', () => {
    const queue = new UpdateQueue(() => clock)
    frame(queue, true, true)
    expect(frame(queue, false, true, [views[0] as View])).toEqual([])
    expect(queue.isWaiting).toBe(false)
  })
})
