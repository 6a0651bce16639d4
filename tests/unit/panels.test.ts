/** A panel that no build has: what it says of itself is all that an element needs to keep its state and to answer its question. */
import { describe, expect, it } from 'vitest'
import { Analyzer } from '../../web/element/analyzer'
import { readAttribute, viewNames } from '../../web/element/attributes'
import { flag } from '../../web/model/document-readers'
import { type Slice, sliceChange, sliceOf } from '../../web/model/state'
import { readState, stateDocument } from '../../web/model/state-document'
import { createStore } from '../../web/model/store'
import { fold } from '../../web/panels/fold'
import { panels } from '../../web/panels/list'
import { answerTo, knownPanels, type Panel, type Question } from '../../web/panels/panel'
import { core, unitCube } from './core-fixtures'

const slice: Slice<{ readonly mirrored: boolean }> = {
  name: 'mirror',
  first: { mirrored: false },
  readers: { mirrored: flag },
}
const question: Question<boolean> = {
  name: 'mirror',
  start: () => ({
    answer: (core, state) => {
      const seen = sliceOf(slice, state).mirrored
        ? state.vertices.map((x, i) => (i % 3 === 0 ? -x : x))
        : state.vertices
      const verdict = core.isValid(seen)
      return verdict.ok ? verdict.value : null
    },
  }),
}
const mirror: Panel = {
  ...fold({ name: 'mirror', title: 'Mirror', load: () => Promise.reject(new Error('It has no view here.')) }),
  slice,
  question,
}
const all = [...panels, mirror]

describe('one more panel', () => {
  it('is a word of the attribute views', () => {
    expect(readAttribute('views', 'scene mirror', viewNames({ panels: all, otherPanels: [] }))).toEqual([
      'scene',
      'mirror',
    ])
  })

  it('keeps its state in the document, and is left out of one by a build without it', () => {
    const store = createStore(unitCube, null)
    store.dispatch(sliceChange(slice, { mirrored: true }))
    store.dispatch({ type: 'open-panel', panel: 'mirror', isOpen: true })
    const document = stateDocument(store.state, knownPanels(all))
    expect(document).toMatchObject({ mirrored: true, openPanels: ['mirror'] })
    const back = readState(document, knownPanels(all))
    expect(back.ok && sliceOf(slice, back.value)).toEqual({ mirrored: true })
    expect(readState({ ...document, mirrored: 'no' }, knownPanels(all))).toMatchObject({ ok: false })
    const elsewhere = readState(document, knownPanels(panels))
    expect(elsewhere.ok && elsewhere.value.openPanels).toEqual([])
  })

  it('has its question answered with every frame', () => {
    const analyzer = new Analyzer(
      all,
      () => {},
      () => {},
    )
    const store = createStore(unitCube, null)
    expect(answerTo(question, analyzer.analyze(store.state))).toBeNull()
    analyzer.core = core
    expect(answerTo(question, analyzer.analyze(store.state))).toBe(true)
    store.dispatch(sliceChange(slice, { mirrored: true }))
    expect(answerTo(question, analyzer.analyze(store.state))).toBe(false)
  })
})
