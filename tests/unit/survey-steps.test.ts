/** Time steps in the worker of an open mesh: the real one, with files of this test. */
import { readFileSync } from 'node:fs'
import { afterAll, describe, expect, test, vi } from 'vitest'
import type { PastedInput } from '../../web/input/pasted-input'
import { hdf5Files } from '../../web/mesh/hdf5-files'
import { Hdf5Loading } from '../../web/mesh/hdf5-reader'
import { serveSurvey } from '../../web/survey/serve-survey'
import type { Opening, StepOpening, SurveyJobs } from '../../web/survey/survey-jobs'
import { unitCube, wasmBytes } from './core-fixtures'
import { flat, invalidCorner, meshOf, mirroredCube, moved, notFinite, voxelOrder } from './mesh-fixtures'
import { pvdText, vtuOf, vtuText } from './vtu-text'

type Ask = <Kind extends keyof SurveyJobs>(
  kind: Kind,
  given: Parameters<SurveyJobs[Kind]>[0],
) => Promise<Awaited<ReturnType<SurveyJobs[Kind]>>>

const batch = new WebAssembly.Module(readFileSync(new URL('../../build/hexlens-batch.wasm', import.meta.url)))

/** A worker in this thread: its messages and the files of a browser are stood in for. */
async function worker(): Promise<Ask> {
  const waiting: { resolve: (answer: never) => void; reject: (reason: Error) => void }[] = []
  const post = (reply: { kind: string; answer?: unknown; message?: string }, transfer: ArrayBuffer[]) => {
    if (reply.kind === 'progress') return
    const task = waiting.shift()
    if (reply.kind === 'failed') task?.reject(new Error(reply.message))
    else task?.resolve(structuredClone(reply.answer, { transfer }) as never)
  }
  vi.stubGlobal('postMessage', post)
  vi.stubGlobal('navigator', {})
  vi.stubGlobal(
    'FileReaderSync',
    class {
      readAsArrayBuffer = (blob: { readonly bytes: Uint8Array }) => blob.bytes.slice().buffer
    },
  )
  serveSurvey({
    core: { wasm: async () => wasmBytes, twin: () => Promise.reject(new Error('none')) },
    batchModule: async () => batch,
    readingCore: async () => null,
    helper: () => {
      throw new Error('none')
    },
    hdf5: new Hdf5Loading(hdf5Files),
  })
  const { onmessage } = globalThis as unknown as { onmessage: (event: { data: unknown }) => void }
  const send = (kind: string, given: unknown) =>
    new Promise<never>((resolve, reject) => {
      waiting.push({ resolve, reject })
      onmessage({ data: { kind, given } })
    })
  await send('start', null)
  return send as Ask
}

/** Files as the page gives them. */
function given(texts: Readonly<Record<string, string | Uint8Array>>): PastedInput {
  const files = Object.entries(texts).map(([name, text]) => {
    const bytes = typeof text === 'string' ? new TextEncoder().encode(text) : text
    return { name, size: bytes.length, slice: (from: number, to: number) => ({ bytes: bytes.slice(from, to) }) }
  })
  return { files: files as unknown as File[] }
}

function openedOf<T extends Opening | StepOpening>(opening: T): Extract<T, { opened: unknown }> {
  if ('refused' in opening) throw new Error(opening.refused)
  return opening as Extract<T, { opened: unknown }>
}

/** Cube 1 is pressed in from step to step, until its corner has gone through. */
const depths = [1, 0.8, 0.5, 0.3, 0.2]
const elements = depths.map(at => [unitCube, moved(6, [at, at, at]), unitCube])
const series = Object.fromEntries(elements.map((all, step) => [`w_${step + 8}.vtu`, vtuOf(all, step / 10)]))

afterAll(() => {
  vi.unstubAllGlobals()
})

describe('steps', () => {
  test('each have their answer, which is that of the shown one', async () => {
    const ask = await worker()
    const { opened } = openedOf(await ask('open', given(series)))
    expect([opened.name, opened.hexahedra, opened.counts.invalid]).toEqual(['w_8.vtu', 3, 0])
    const list = await ask('steps', null)
    expect(list?.sentences).toEqual(['5 files are taken as 5 steps of one mesh, in the order of their numbers.'])
    expect(list?.steps.map(({ name }) => name)).toEqual(['w_8.vtu', 'w_9.vtu', 'w_10.vtu', 'w_11.vtu', 'w_12.vtu'])
    expect(list).toMatchObject({ shown: 0, answer: { step: 0, time: '0', least: 1, isOther: false } })
    for (const step of depths.keys()) {
      const answer = await ask('readStep', step)
      const { opened, answer: shown } = openedOf(await ask('showStep', { step, chosen: null }))
      expect(shown).toEqual(answer)
      const [worst] = opened.worst
      expect([answer.worst?.cell, answer.least]).toEqual([worst?.cell, worst?.relativeMinimum])
      expect(answer).toMatchObject({ step, time: String(step / 10), refused: null, isOther: false })
      expect(answer.counts).toEqual({ hexahedra: 3, invalid: opened.counts.invalid, unanswered: 0 })
    }
    // The corner's jacdet is 3 at - 2, so it is 0 or less from 2/3 down.
    const invalid = await Promise.all(depths.map((_, step) => ask('readStep', step)))
    expect(invalid.map(({ counts, worst }) => [counts?.invalid, worst?.id])).toEqual([
      [0, '0'],
      [0, '1'],
      [1, '1'],
      [1, '1'],
      [1, '1'],
    ])
  })

  test('keep the chosen cell and the picture where they are, and faces that are joined', async () => {
    const ask = await worker()
    await ask('open', given(series))
    const all = { cells: { which: 'all' }, isWhole: false, most: Infinity } as const
    const before = await ask('faces', all)
    const { chosen } = openedOf(await ask('showStep', { step: 4, chosen: 1 }))
    expect(chosen).toBe(1)
    const after = await ask('faces', all)
    expect(after.origin).toEqual(before.origin)
    expect(after.vertices.length).toBe(before.vertices.length)
    expect((await ask('detail', 1)).row.standing).toBe('invalid')
  })

  test('the worst cell may have volume 0, be flat, or unanswered', async () => {
    // The top is the bottom's mirror image: jacdet is 1 - 2 zeta.
    const zeroVolume = unitCube.map((x, i) => (i >= 12 && i % 3 === 0 ? 1 - x : x))
    const cells = [unitCube, zeroVolume, flat, notFinite, voxelOrder]
    const ask = await worker()
    await ask('open', given(Object.fromEntries(cells.map((cell, step) => [`w${step}.vtu`, vtuOf([cell])]))))
    const answers = await Promise.all(cells.map((_, step) => ask('readStep', step)))
    expect(answers.slice(0, 4).map(({ least, counts }) => [least, counts?.invalid, counts?.unanswered])).toEqual([
      [1, 0, 0],
      [Number.NEGATIVE_INFINITY, 1, 0],
      [0, 1, 0],
      [null, 0, 1],
    ])
    expect(answers[4]?.least).toBeLessThan(0)
  })

  test('that are damaged or lack files have a sentence, and leave the shown one as it is', async () => {
    const ask = await worker()
    const sets = ['0', '1', '2', '3'].map(time => ({ time, file: `w_${time}.vtu` }))
    const texts = { 'a.pvd': pvdText(sets), 'w_1.vtu': vtuOf([unitCube]), 'w_2.vtu': 'no', 'w_3.vtu': vtuOf([]) }
    expect(openedOf(await ask('open', given(texts))).opened.hexahedra).toBe(1)
    expect((await ask('steps', null))?.shown).toBe(1)
    const answers = await Promise.all([0, 2, 3].map(step => ask('readStep', step)))
    expect(answers.map(({ refused }) => refused)).toEqual([
      'a.pvd: it needs “w_0.vtu” beside it: give it together with this file.',
      'w_2.vtu: this is no VTU: there is no <VTKFile> in it.',
      expect.stringContaining('no hexahedra of eight nodes.'),
    ])
    expect(answers.map(({ counts, least }) => [counts, least])).toEqual([
      [null, null],
      [null, null],
      [null, null],
    ])
    for (const step of [0, 2, 3]) expect(await ask('showStep', { step, chosen: 0 })).toHaveProperty('refused')
    expect((await ask('steps', null))?.shown).toBe(1)
    expect((await ask('detail', 0)).row.standing).toBe('valid')
  })

  test('of other cells than the first are told, and the chosen cell is found by its id', async () => {
    const ask = await worker()
    const texts = {
      'a.pvd': pvdText(['0', '1', '2'].map(time => ({ time, file: `w_${time}.vtu` }))),
      'w_0.vtu': vtuOf([unitCube, invalidCorner]),
      'w_1.vtu': vtuOf([unitCube]),
      'w_2.vtu': vtuOf([unitCube, unitCube]),
    }
    await ask('open', given(texts))
    expect((await ask('readStep', 1)).isOther).toBe(true)
    expect((await ask('readStep', 2)).isOther).toBe(false)
    expect(openedOf(await ask('showStep', { step: 1, chosen: 1 })).chosen).toBe(null)
    expect(openedOf(await ask('showStep', { step: 2, chosen: 0 })).chosen).toBe(0)
  })

  test('are corrected all in the same cells: what turns inside out later is no fault of the order', async () => {
    const ask = await worker()
    const texts = {
      'w_1.vtu': vtuOf([unitCube, mirroredCube]),
      'w_2.vtu': vtuOf([unitCube, mirroredCube]),
      'w_3.vtu': vtuOf([mirroredCube, mirroredCube]),
    }
    const { opened } = openedOf(await ask('open', given(texts)))
    expect(opened.fixes.map(({ id }) => id)).toEqual(['mirrored'])
    expect(openedOf(await ask('mend', 'mirrored')).opened.counts.invalid).toBe(0)
    expect((await ask('steps', null))?.answer.counts?.invalid).toBe(0)
    expect((await ask('readStep', 1)).counts?.invalid).toBe(0)
    expect(await ask('readStep', 2)).toMatchObject({ counts: { invalid: 1 }, worst: { cell: 0 } })
    const { opened: second } = openedOf(await ask('showStep', { step: 1, chosen: null }))
    expect(second.sentences.join(' ')).toContain('1 mirrored hexahedron has been corrected here')
  })

  test('are parts of one mesh where that is asked for', async () => {
    const ask = await worker()
    await ask('open', given(series))
    const { opened } = openedOf(await ask('together', null))
    expect([opened.hexahedra, opened.counts.invalid, opened.name]).toEqual([15, 3, '5 files'])
    expect(await ask('steps', null)).toBe(null)
  })

  test('of a .pvd, too, and without it', async () => {
    const ask = await worker()
    const sets = ['0', '1'].map(time => ({ time, file: `w_${time}.vtu` }))
    await ask('open', given({ 'a.pvd': pvdText(sets), 'w_0.vtu': vtuOf([unitCube]), 'w_1.vtu': vtuOf([flat]) }))
    expect(openedOf(await ask('together', null)).opened).toMatchObject({ hexahedra: 2, name: '2 files' })
  })
})

test.each(['classic.e', 'netcdf4.exo', 'moving.xmf', 'moving.vtkhdf'])('%s has four steps', async name => {
  const ask = await worker()
  const bytes = new Uint8Array(readFileSync(new URL(`steps/${name}`, import.meta.url)))
  const { opened } = openedOf(await ask('open', given({ [name]: bytes })))
  expect([opened.name, opened.hexahedra, opened.counts.invalid]).toEqual([name, 2, 0])
  const list = await ask('steps', null)
  expect([list?.sentences, list?.areFiles, list?.shown]).toEqual([[`${name} has 4 time steps of one mesh.`], false, 0])
  const answers = await Promise.all([0, 1, 2, 3].map(step => ask('readStep', step)))
  expect(answers.map(({ time, counts, isOther }) => [time, counts?.invalid, isOther])).toEqual([
    ['0', 0, false],
    ['0.25', 0, false],
    ['0.5', 1, false],
    ['1', 1, false],
  ])
  const { opened: last, answer } = openedOf(await ask('showStep', { step: 3, chosen: 1 }))
  expect([last.counts.invalid, answer]).toEqual([1, answers[3]])
})

test('a file whose steps differ in results alone has none to choose from', async () => {
  const ask = await worker()
  const bytes = new Uint8Array(readFileSync(new URL('steps/results.e', import.meta.url)))
  await ask('open', given({ 'results.e': bytes }))
  expect(await ask('steps', null)).toBe(null)
})

test('files with other cells are joined, as they were, and have no steps', async () => {
  const ask = await worker()
  const texts = { 'w_1.vtu': vtuOf([unitCube]), 'w_2.vtu': vtuOf([unitCube, invalidCorner]) }
  const { opened } = openedOf(await ask('open', given(texts)))
  expect([opened.name, opened.hexahedra, opened.counts.invalid]).toEqual(['2 files', 3, 1])
  expect(await ask('steps', null)).toBe(null)
})

test('a mesh of many cells is decided in batches, step by step', async () => {
  const ask = await worker()
  const mesh = meshOf(Array.from({ length: 100 }, () => unitCube))
  const later = { ...mesh, points: mesh.points.map((x, i) => (Math.floor(i / 3) === 8 * 70 + 6 ? 0.2 : x)) }
  await ask('open', given({ 'w_1.vtu': vtuText(mesh), 'w_2.vtu': vtuText(later) }))
  expect(await ask('readStep', 1)).toMatchObject({ counts: { hexahedra: 100, invalid: 1 }, worst: { cell: 70 } })
})
