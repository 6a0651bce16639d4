import { describe, expect, it } from 'vitest'
import { Turns } from '../../web/element/turns'
import type { Frame, Turn, View } from '../../web/views/view'

/** A turn takes a millisecond by `clock`. */
let clock = 0
let done: string[] = []
const turn =
  (name: string): Turn =>
  () => {
    done.push(name)
    clock++
  }
const view = (name: string, ...turns: string[]) =>
  ({ update: turn(name), ...(turns.length > 0 && { turns: turns.map(turn) }) }) as unknown as View
const views = [view('scene'), view('maps', 'left', 'right'), view('inside', 'section')]
const afterAll = ['scene', 'maps', 'inside', 'left', 'right', 'section']

function frame(turns: Turns, isNews: boolean, isGesture: boolean, shown: readonly View[] = views): string[] {
  done = []
  for (const take of turns.due(shown, isNews, isGesture)) take({} as Frame)
  return done
}

describe('turns', () => {
  it('are for gestures: between them everything is up to date after each frame', () => {
    const turns = new Turns(() => clock)
    expect(frame(turns, true, false)).toEqual(afterAll)
    expect(turns.isWaiting).toBe(false)
  })

  it('come round, one every second frame where the time is over, however often there is news; what takes no turns never waits', () => {
    const turns = new Turns(() => clock)
    const frames = Array.from({ length: 8 }, () => frame(turns, true, true))
    expect(frames.map(names => names.slice(0, 3))).toEqual(Array(8).fill(['scene', 'maps', 'inside']))
    expect(frames.map(names => names.slice(3))).toEqual([[], ['left'], [], ['right'], [], ['section'], [], ['left']])
  })

  it('are as many in a frame as there is time for', () => {
    const turns = new Turns(() => clock)
    frame(turns, true, true)
    expect([frame(turns, false, true), frame(turns, false, true)]).toEqual([['left', 'right'], ['section']])
    expect(turns.isWaiting).toBe(false)
  })

  it('are all taken in every frame where they take no time', () => {
    const turns = new Turns(() => 0)
    expect(frame(turns, true, true)).toEqual(afterAll)
    expect(turns.isWaiting).toBe(false)
  })

  it('leave nothing behind once the gesture ends', () => {
    const turns = new Turns(() => clock)
    frame(turns, true, true)
    frame(turns, true, true)
    expect(frame(turns, true, false)).toEqual(['scene', 'maps', 'inside', 'right', 'section', 'left'])
    expect(turns.isWaiting).toBe(false)
  })

  it('are forgotten with their view', () => {
    const turns = new Turns(() => clock)
    frame(turns, true, true)
    expect(frame(turns, false, true, [views[0] as View])).toEqual([])
    expect(turns.isWaiting).toBe(false)
  })
})
