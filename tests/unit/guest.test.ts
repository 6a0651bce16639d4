/** The element as a guest of pages that hand its numbers back, or hand it something else. */
import { describe, expect, it } from 'vitest'
import { checkedVertices, readAttribute, viewNames } from '../../web/element/attributes'
import { type ChangeDetail, Changes } from '../../web/element/changes'
import type { Action } from '../../web/model/state'
import { createStore } from '../../web/model/store'
import { panels } from '../../web/panels/list'
import { isForeign, isSmallStep, pointStep } from '../../web/views/point-steps'
import { unitCube } from './core-fixtures'

const rows = Array.from({ length: 8 }, (_, v) => unitCube.slice(3 * v, 3 * v + 3))

describe('vertices', () => {
  it('are 24 numbers, eight times three, or a text', () => {
    const forms = [
      unitCube,
      new Float64Array(unitCube),
      rows,
      rows.map(row => new Float32Array(row)),
      unitCube.join(' '),
    ]
    for (const form of forms) expect(checkedVertices(form)).toEqual(unitCube)
    expect(Object.is(checkedVertices(unitCube.with(0, -0))[0], -0)).toBe(true)
  })

  it.each([
    [undefined, 'A hexahedron has 24 coordinates; none were given.'],
    [null, 'A hexahedron has 24 coordinates; none were given.'],
    [7, 'A hexahedron has 24 coordinates; none were given.'],
    [{}, 'A hexahedron has 24 coordinates; none were given.'],
    [rows.slice(1), 'A hexahedron has 24 coordinates; 7 were given.'],
    [rows.with(3, [1, 2]), 'A hexahedron has 24 coordinates; 8 were given.'],
    [unitCube.with(4, Number.NaN), 'Coordinate 4 is NaN, not a finite number.'],
    [rows.with(1, [0, null as unknown as number, 0]), 'Coordinate 4 is null, not a finite number.'],
    [unitCube.map(String), 'Coordinate 0 is of the type string, not a finite number.'],
    [[...unitCube.slice(1), Symbol('x')], 'Coordinate 23 is of the type symbol, not a finite number.'],
    ['1 2', 'A hexahedron has 24 coordinates; 2 were given.'],
  ])('are refused with a sentence: %#', (given, sentence) => {
    expect(() => checkedVertices(given)).toThrow(sentence)
  })
})

describe('the attribute app', () => {
  const read = (text: string | null) => readAttribute('app', text, viewNames({ panels, otherPanels: [] }))

  it('is the address of a page', () => {
    expect(read('https://example.org/hexlens/?a=b')?.href).toBe('https://example.org/hexlens/?a=b')
    expect(read(null)).toBe(null)
  })

  it.each(['javascript:alert(1)', 'data:text/html,x', 'http://', 'mailto:a@b.c'])('is not %s', text => {
    expect(() => read(text)).toThrow(/^The attribute app is not understood: “.*” is not the address of a page\.$/)
  })
})

describe('events of changes', () => {
  function told() {
    const store = createStore(unitCube, 'cube')
    const events: [string, ChangeDetail][] = []
    let reflected = 0
    const changes = new Changes({ tell: (event, detail) => events.push([event, detail]), reflect: () => reflected++ })
    const act = (action: Action, source: 'program' | null = null) => {
      const before = store.state
      store.dispatch(action)
      changes.note(before, store.state, action, source)
    }
    const frame = () => {
      changes.tell(store.state, null)
      return events.splice(0).map(([event, { source }]) => `${event} ${source}`)
    }
    frame()
    const move = (x: number) => act({ type: 'move-vertex', vertex: 6, to: [x, 1, 1] })
    return { store, changes, act, frame, move, reflected: () => reflected }
  }

  it('say whose a change is', () => {
    const { act, frame, move } = told()
    act({ type: 'begin-gesture', by: 'pointer' })
    move(2)
    expect(frame()).toEqual(['hex-input pointer'])
    act({ type: 'commit-gesture' })
    expect(frame()).toEqual(['hex-change pointer'])
    act({ type: 'undo' })
    expect(frame()).toEqual(['hex-input history', 'hex-change history'])
    act({ type: 'set-vertices', vertices: unitCube.with(0, 3), preset: 'x' })
    expect(frame()).toEqual(['hex-input preset', 'hex-change preset'])
  })

  it('of a page’s own are inputs alone, and still written to the attributes', () => {
    const { act, frame, reflected } = told()
    act({ type: 'set-vertices', vertices: unitCube.with(0, 3), preset: null }, 'program')
    expect(frame()).toEqual(['hex-input program'])
    expect(reflected()).toBe(1)
  })

  it('tell the end of a gesture as the reader’s, though a page has moved what was dragged', () => {
    const { act, frame, move } = told()
    act({ type: 'begin-gesture', by: 'keyboard' })
    move(2.2)
    act({ type: 'move-all', vertices: unitCube.with(18, 2) }, 'program')
    expect(frame()).toEqual(['hex-input program'])
    act({ type: 'commit-gesture' })
    expect(frame()).toEqual(['hex-change keyboard'])
  })

  it('are remembered: what they brought is known when it comes back late, by its bits', () => {
    const { act, frame, move, store, changes } = told()
    act({ type: 'begin-gesture', by: 'pointer' })
    move(2)
    frame()
    const late = store.state.vertices.slice()
    move(-0)
    expect(changes.isEcho(late)).toBe(true)
    expect(changes.isEcho(unitCube)).toBe(true)
    expect(changes.isEcho(late.with(0, -0))).toBe(false)
    expect(changes.isEcho(store.state.vertices)).toBe(false) // not told yet
  })
})

describe('arrow keys', () => {
  const key = (name: string, held: object = {}) =>
    ({ key: name, altKey: false, ctrlKey: false, metaKey: false, shiftKey: false, ...held }) as KeyboardEvent

  it('make small steps with Ctrl; with Alt they are the browser’s', () => {
    expect(pointStep(key('ArrowLeft', { ctrlKey: true }))).toBe(1 / 64)
    expect(isForeign(key('ArrowLeft', { ctrlKey: true }))).toBe(false)
    expect(isForeign(key('ArrowLeft', { altKey: true }))).toBe(true)
    expect(isSmallStep(key('PageDown', { altKey: true }))).toBe(true)
    for (const name of ['PageDown', 's', 'Home', 'Escape']) expect(isForeign(key(name, { ctrlKey: true }))).toBe(true)
    expect(isForeign(key('x'))).toBe(false)
  })
})
