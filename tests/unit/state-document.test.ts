import { readFileSync } from 'node:fs'
import Ajv2020 from 'ajv/dist/2020.js'
import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import type { Vertices } from '../../web/model/hexahedron'
import type { Cameras, CameraView, State } from '../../web/model/state'
import { readState, stateDocument } from '../../web/model/state-document'
import { createStore } from '../../web/model/store'
import { choiceSlice } from '../../web/panels/embed/choice'
import { panels } from '../../web/panels/list'
import { nearest } from '../../web/panels/nearest'
import { knownPanels } from '../../web/panels/panel'
import { CONTROLS, type FaceDisplay, type Preview } from '../../web/views/scene-slices'
import { unitCube } from './core-fixtures'

const schema = JSON.parse(readFileSync(new URL('../../docs/state.schema.json', import.meta.url), 'utf8'))
const known = knownPanels([...panels, nearest])
const fits = new Ajv2020({ allErrors: true, strictTypes: false }).compile(schema)

const double = fc.double({ noNaN: true, noDefaultInfinity: true })
const vertices: fc.Arbitrary<Vertices> = fc.array(fc.oneof(double, fc.constantFrom(0, -0)), {
  minLength: 24,
  maxLength: 24,
})
/** Never -0, which JSON does not keep. */
const within = (min: number, max: number) => fc.double({ min, max, noNaN: true }).map(x => x + 0)
const below = (count: number) => fc.integer({ min: 0, max: count - 1 })
const camera: fc.Arbitrary<CameraView> = fc.record({
  direction: fc.tuple(within(-1, 1), within(-1, 1), fc.constantFrom(-1, 1)),
  zoom: within(0.01, 100),
  pan: fc.tuple(within(-9, 9), within(-9, 9), within(-9, 9)),
})
const state: fc.Arbitrary<State> = fc.record({
  vertices,
  preset: fc.option(fc.string()),
  start: vertices,
  selectedVertex: below(8),
  isVertexChosen: fc.boolean(),
  phase: fc.constantFrom('starting', 'begun'),
  gestureStart: fc.constant(null),
  referenceCube: fc.constantFrom('unit', 'biunit'),
  openPanels: fc.shuffledSubarray([...known.names]),
  cameras: fc.record({ camera: fc.option(camera), referenceCamera: fc.option(camera) }),
  probe: fc.constantFrom(null, [0, 0, 1] as const),
  isReadonly: fc.boolean(),
  canUndo: fc.boolean(),
  canRedo: fc.boolean(),
  slices: fc.record({
    proof: fc.record({ proofShown: fc.boolean() }),
    'face-maps': fc.record({ selectedFace: below(6) }),
    algorithm: fc.record({
      following: fc.record({
        query: fc.constantFrom('minimum', 'validity'),
        variant: fc.constantFrom('roots', 'roots-b'),
        step: below(26),
      }),
    }),
    embed: fc.record({
      embedding: fc.record({
        host: fc.string(),
        views: fc.array(fc.string()),
        theme: fc.constantFrom('auto', 'light', 'dark'),
        readonly: fc.boolean(),
        camera: fc.option(fc.string()),
        height: within(160, 4000),
        label: fc.option(fc.string()),
      }),
    }),
    morph: fc.record({ morphA: fc.option(vertices), morphB: fc.option(vertices) }),
    nearest: fc.record({ nearestRelativeMinimum: within(0, 0.9) }),
    scene: fc.record({
      faceDisplay: fc.constantFrom<FaceDisplay[]>('opaque', 'see-through', 'inside', 0, 1, 2, 3, 4, 5),
      referenceShown: fc.boolean(),
      camerasLinked: fc.boolean(),
      section: fc.record({ axis: fc.constantFrom(0, 1, 2), value: within(0, 1) }),
    }),
    controls: fc.record({ controls: fc.constantFrom(CONTROLS, []), helpShown: fc.boolean() }),
    marks: fc.record({
      highlight: fc.constantFrom(null, { kind: 'edge', id: 3 } as const),
      samples: fc.constantFrom(null, { points: [[0, 0.5, 1] as const], edges: true }),
    }),
    preview: fc.record({
      preview: fc.oneof<fc.Arbitrary<Preview | null>[]>(
        fc.constantFrom(null, { order: [1, 0, 3, 2, 5, 4, 7, 6] }),
        vertices.map(move => ({ move })),
      ),
    }),
  }),
})

function read(given: unknown) {
  const result = readState(given, known)
  if (!result.ok) throw new Error(result.error.message)
  return result.value
}

/** Named here once more: what a document leaves out is its promise, not its code's. */
function lastingOf(state: State) {
  const { phase, gestureStart, isVertexChosen, probe, isReadonly, canUndo, canRedo, slices, ...lasting } = state
  const { controls, marks, preview, ...lastingSlices } = slices
  return { ...lasting, slices: lastingSlices }
}

describe('a state', () => {
  it('fits the schema, and through JSON every bit of it comes back', () => {
    fc.assert(
      fc.property(state, given => {
        const text = JSON.stringify(stateDocument(given, known))
        expect(fits(JSON.parse(text)), JSON.stringify(fits.errors)).toBe(true)
        expect(read(JSON.parse(text))).toEqual(lastingOf(given))
      }),
    )
  })

  it('written by hand needs a version and vertices, and means a new element in all the rest', () => {
    const state = read({
      version: 1,
      vertices: unitCube,
      more: 'of later',
      openPanels: ['later', 'morph', 'morph'],
    })
    const fresh = lastingOf(createStore(unitCube, null).state)
    const slices = Object.fromEntries(known.slices.map(({ name, first }) => [name, first]))
    const cameras = { camera: null, referenceCamera: null }
    expect(state).toEqual({ ...fresh, cameras, slices, openPanels: ['morph'] })
  })

  it('kept by any earlier program is read, and written again key by key', () => {
    const camera = { direction: [3, 0, 4], zoom: 2, pan: [0, 0, 0.5] }
    const kept = {
      version: 1,
      vertices: ['-0', ...unitCube.slice(1)],
      preset: 'cube',
      start: unitCube,
      selectedVertex: 3,
      referenceCube: 'biunit',
      faceDisplay: 'inside',
      openPanels: ['inside', 'algorithm'],
      referenceShown: true,
      camerasLinked: true,
      section: { axis: 0, value: 0.83 },
      camera,
      referenceCamera: { ...camera, zoom: 1 },
      proofShown: true,
      selectedFace: 5,
      following: { query: 'validity', variant: 'roots', step: 9 },
      morphA: unitCube,
      morphB: null,
    }
    const state = read(JSON.parse(JSON.stringify(kept)))
    expect(state.slices.scene).toEqual({
      faceDisplay: 'inside',
      referenceShown: true,
      camerasLinked: true,
      section: { axis: 0, value: 0.83 },
    })
    // What came later is as in a new element.
    expect(stateDocument(state, known)).toEqual({ ...kept, nearestRelativeMinimum: 0, ...choiceSlice.first })
  })

  it('of a later version is refused as that, of none as malformed', () => {
    for (const version of [2, 7, 1.5]) {
      const result = readState({ version, vertices: unitCube }, known)
      expect(result).toMatchObject({ ok: false, error: { code: 'unknown-version' } })
    }
    for (const given of [{ vertices: unitCube }, { version: '1', vertices: unitCube }, { version: 0 }, null, 'x', []]) {
      expect(readState(given, known)).toMatchObject({ ok: false, error: { code: 'malformed-state' } })
    }
  })

  it('is read where the schema lets it through, and refused with a sentence that names the key where it does not', () => {
    const cameras: Cameras = { camera: { direction: [1, 0, 0], zoom: 2, pan: [0, 0, 0] }, referenceCamera: null }
    const whole = stateDocument({ ...createStore(unitCube, 'cube').state, cameras }, known)
    const odd = [
      undefined,
      null,
      true,
      0,
      -0,
      1,
      -1,
      5,
      6,
      8,
      25,
      26,
      0.5,
      181,
      1e-9,
      Infinity,
      Number.NaN,
      '',
      '-0',
      'unit',
      [],
      {},
    ]
    const lists = [
      [1, 2, 3],
      [0, 0, 0],
      [1e-7, 0, 0],
      [0, 0, 2000],
      ['morph'],
      [3],
      unitCube.with(3, Infinity),
      unitCube.slice(1),
    ]
    const counts = { read: 0, refused: 0 }
    for (const path of pathsOf(whole)) {
      for (const value of [...odd, ...lists, unitCube]) {
        const given = changed(whole, path, value)
        const result = readState(given, known)
        expect(result.ok, `${path.join('.')} = ${JSON.stringify(value)}`).toBe(fits(given))
        counts[result.ok ? 'read' : 'refused']++
        if (!result.ok && result.error.code === 'malformed-state') expect(result.error.message).toContain(path[0])
      }
    }
    expect(Math.min(counts.read, counts.refused)).toBeGreaterThan(100)
  })

  it('that a store takes on is one step to undo, and none where the element is the same', () => {
    const store = createStore(unitCube, 'cube')
    const state = read({ version: 1, vertices: unitCube.with(0, -0), preset: 'other', openPanels: ['inside'] })
    store.dispatch({ type: 'restore', state })
    expect(store.state).toMatchObject({ preset: 'other', openPanels: ['inside'], canUndo: true })
    store.dispatch({ type: 'undo' })
    expect(store.state).toMatchObject({ preset: 'cube', openPanels: ['inside'], canUndo: false })
    const { vertices } = store.state
    store.dispatch({ type: 'restore', state: { ...store.state, vertices: unitCube.slice(), selectedVertex: 4 } })
    expect(store.state).toMatchObject({ selectedVertex: 4, canUndo: false })
    expect(store.state.vertices).toBe(vertices)
  })
})

/** Every key of the document, and every key and first entry within. */
function pathsOf(value: unknown, path: readonly string[] = []): string[][] {
  if (typeof value !== 'object' || value === null) return []
  const keys = Array.isArray(value) ? ['0'] : Object.keys(value)
  return keys.flatMap(key => [[...path, key], ...pathsOf((value as Record<string, unknown>)[key], [...path, key])])
}

function changed(whole: object, [key, ...rest]: readonly string[], value: unknown): object {
  const before = whole as Record<string, unknown>
  const after = rest.length === 0 ? value : changed(before[key as string] as object, rest, value)
  if (Array.isArray(whole)) return Object.assign([...whole], { [key as string]: after })
  const { [key as string]: _, ...others } = before
  return after === undefined ? others : { ...others, [key as string]: after }
}
