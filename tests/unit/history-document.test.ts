/** Undo and redo as data: through JSON and back, in a store that goes on from there, and refused where it is none. */
import { readFileSync } from 'node:fs'
import Ajv2020 from 'ajv/dist/2020.js'
import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { type HistoryDocument, historyDocument, readHistory } from '../../web/model/history-document'
import type { Action } from '../../web/model/state'
import { createStore, HISTORY_LIMIT, type Store } from '../../web/model/store'
import { packed, unpacked } from '../../web/pages/packed-history'
import { unitCube } from './core-fixtures'

const schema = JSON.parse(readFileSync(new URL('../../docs/history.schema.json', import.meta.url), 'utf8'))
const fits = new Ajv2020({ allErrors: true, strictTypes: false }).compile(schema)

const double = fc.oneof(fc.double({ noNaN: true, noDefaultInfinity: true }), fc.constantFrom(0, -0, 5e-324))
const vertices = fc.array(double, { minLength: 24, maxLength: 24 })
const action: fc.Arbitrary<Action> = fc.oneof(
  fc.record({ type: fc.constant('move-coordinate' as const), index: fc.nat(23), to: double }),
  fc.record({ type: fc.constant('move-all' as const), vertices }),
  fc.record({ type: fc.constant('set-vertices' as const), vertices, preset: fc.constantFrom(null, 'cube') }),
  fc.constantFrom<Action[]>(
    { type: 'undo' },
    { type: 'redo' },
    { type: 'reset' },
    { type: 'begin-gesture' },
    { type: 'commit-gesture' },
    { type: 'cancel-gesture' },
  ),
)

const cube = { vertices: unitCube, preset: 'cube', start: unitCube }
const one: HistoryDocument = { version: 1, elements: [cube], present: 0 }

function read(given: unknown) {
  const result = readHistory(given)
  if (!result.ok) throw new Error(result.error.message)
  return result.value
}

/** All elements from here by undo to the first, and from there by redo to the last. */
function walked(store: Store) {
  const snapshot = () => ({ vertices: store.state.vertices, preset: store.state.preset, start: store.state.start })
  const all = [snapshot()]
  for (const type of ['undo', 'redo'] as const) {
    const isMore = () => (type === 'undo' ? store.state.canUndo : store.state.canRedo)
    for (; isMore(); all.push(snapshot())) store.dispatch({ type })
  }
  return all
}

function restored(history: unknown, phase: 'starting' | 'begun' = 'begun') {
  const store = createStore(unitCube.with(3, 7), null, phase)
  store.dispatch({ type: 'take-history', history: read(history) })
  return store
}

describe('a history', () => {
  it('fits the schema, and through JSON undo and redo lead to the same bits', () => {
    fc.assert(
      fc.property(fc.array(action, { maxLength: 30 }), actions => {
        const store = createStore(unitCube, 'cube')
        for (const each of [...actions, { type: 'cancel-gesture' } as const]) store.dispatch(each)
        const text = JSON.stringify(historyDocument(store.history))
        expect(fits(JSON.parse(text)), JSON.stringify(fits.errors)).toBe(true)
        const again = restored(JSON.parse(text))
        expect(unpacked(JSON.parse(JSON.stringify(packed(JSON.parse(text)))))).toEqual(JSON.parse(text))
        expect(JSON.stringify(historyDocument(again.history))).toBe(text)
        expect(walked(again)).toEqual(walked(store))
      }),
    )
  })

  it('has of a gesture where it began, and ends the gesture of a store that takes it', () => {
    const store = createStore(unitCube, 'cube')
    store.dispatch({ type: 'begin-gesture' })
    store.dispatch({ type: 'move-vertex', vertex: 6, to: [2, 2, 2] })
    expect(historyDocument(store.history)).toEqual(one)
    store.dispatch({ type: 'take-history', history: read(one) })
    expect(store.state).toMatchObject({ vertices: unitCube, gestureStart: null, canUndo: false, canRedo: false })
  })

  it('is no step, and what is set after it is one, before the first frame, too', () => {
    const store = restored({ ...one, elements: [cube, { ...cube, preset: null }], present: 1 }, 'starting')
    expect(store.state).toMatchObject({ preset: null, canUndo: true, canRedo: false })
    store.dispatch({ type: 'set-vertices', vertices: unitCube.with(0, -0), preset: null })
    expect(store.history).toMatchObject({ present: 2, elements: { length: 3 } })
    const { vertices } = store.state
    store.dispatch({ type: 'take-history', history: read(JSON.parse(JSON.stringify(historyDocument(store.history)))) })
    expect(store.state.vertices).toBe(vertices)
  })

  it('has at most as many steps as a store keeps, and a full one fits', () => {
    const store = createStore(unitCube, 'cube')
    for (let i = 0; i < HISTORY_LIMIT + 9; ++i) store.dispatch({ type: 'move-coordinate', index: 0, to: i + 0.5 })
    const document = historyDocument(store.history)
    expect([document.elements.length, document.present]).toEqual([HISTORY_LIMIT + 1, HISTORY_LIMIT])
    expect(fits(document)).toBe(true)
    expect(restored(document).state.canUndo).toBe(true)
    expect(unpacked(packed(document))).toEqual(document)
    expect(JSON.stringify(packed(document)).length).toBeLessThan(JSON.stringify(document).length / 5)
    const more = { ...document, elements: [...document.elements, cube] }
    expect(fits(more)).toBe(false)
    expect(readHistory(more)).toMatchObject({ ok: false, error: { message: expect.stringContaining('1001') } })
  })

  it('of a later version is refused as that, of none or with a mistake as malformed, in a sentence', () => {
    expect(readHistory({ ...one, version: 2 })).toMatchObject({ error: { code: 'unknown-version' } })
    const mistakes: [unknown, string][] = [
      [null, 'history has to be an object'],
      [{ ...one, version: '1' }, 'version'],
      [{ ...one, elements: [] }, 'history.present is 0'],
      [{ ...one, present: 1 }, 'history.present is 1'],
      [{ ...one, present: -1 }, 'history.present'],
      [{ ...one, present: 0.5 }, 'history.present'],
      [{ version: 1, elements: [cube] }, 'history.present'],
      [{ ...one, elements: [{ ...cube, vertices: unitCube.with(3, Number.NaN) }] }, 'history.elements[0].vertices[3]'],
      [{ ...one, elements: [cube, { ...cube, start: [] }] }, 'history.elements[1].start'],
      [{ ...one, elements: [{ ...cube, preset: 3 }] }, 'history.elements[0].preset'],
      [{ ...one, elements: [null] }, 'history.elements[0]'],
    ]
    for (const [given, part] of mistakes) {
      const result = readHistory(given)
      expect(result).toMatchObject({ ok: false, error: { code: 'malformed-history' } })
      if (!result.ok) expect(result.error.message).toMatch(/^[^.].*\.$/)
      if (!result.ok) expect(result.error.message).toContain(part)
    }
  })
})
