/** Several files: steps of one mesh, or its parts. */
import { describe, expect, test } from 'vitest'
import { orderOfNumbers } from '../../web/mesh/file-numbers'
import { fileOfBytes, type MeshFile } from '../../web/mesh/source'
import { stepFilesOf } from '../../web/mesh/step-files'
import { unitCube } from './core-fixtures'
import { invalidCorner, meshOf, moved } from './mesh-fixtures'
import { pvdText, pvtuText, vtuOf, vtuText } from './vtu-text'

const OPTIONS = { onProgress: () => {}, throwIfCancelled: () => {} }
const textFile = (name: string, text: string) => fileOfBytes(name, new TextEncoder().encode(text))

const one = vtuOf([unitCube])
const bad = vtuOf([invalidCorner])
const two = vtuOf([unitCube, unitCube])

function filesOf(texts: Readonly<Record<string, string>>): MeshFile[] {
  return Object.entries(texts).map(([name, text]) => textFile(name, text))
}

function decided(texts: Readonly<Record<string, string>>) {
  return stepFilesOf(filesOf(texts), OPTIONS)
}

describe('names', () => {
  const ordered = (names: readonly string[]) => orderOfNumbers(names)?.map(index => names[index])
  test.each<readonly [readonly string[], readonly string[] | undefined]>([
    [
      ['a_10.vtu', 'a_9.vtu', 'a_2.vtu'],
      ['a_2.vtu', 'a_9.vtu', 'a_10.vtu'],
    ],
    [
      ['a010.vtu', 'a009.vtu', 'a2.vtu'],
      ['a2.vtu', 'a009.vtu', 'a010.vtu'],
    ],
    [
      ['run3_s2.vtu.gz', 'Run3_S1.vtu.gz', 'run03_s0.vtu.gz'],
      ['run03_s0.vtu.gz', 'Run3_S1.vtu.gz', 'run3_s2.vtu.gz'],
    ],
    [
      ['t0.5.vtu', 't0.25.vtu', 't1.vtu'],
      ['t0.25.vtu', 't0.5.vtu', 't1.vtu'],
    ],
    [
      ['t1e-2.vtu', 't1e-3.vtu', 't2.5e-3.vtu'],
      ['t1e-3.vtu', 't2.5e-3.vtu', 't1e-2.vtu'],
    ],
    [
      ['w.0002.vtk', 'w.0001.vtk'],
      ['w.0001.vtk', 'w.0002.vtk'],
    ],
    [
      ['a2.vtu', 'a02.vtu', 'a1.vtu'],
      ['a1.vtu', 'a2.vtu', 'a02.vtu'],
    ],
    [
      ['a90071992547409930.vtu', 'a90071992547409929.vtu'],
      ['a90071992547409929.vtu', 'a90071992547409930.vtu'],
    ],
    // Counters behind a version, or decimals: nobody knows.
    [['a1.5.vtu', 'a1.10.vtu'], undefined],
    [['a1_1.vtu', 'a2_2.vtu'], undefined],
    [['a1.vtu', 'b2.vtu'], undefined],
    [['a1.vtu', 'a2.vtk'], undefined],
    [['a.vtu', 'a1.vtu'], undefined],
    [['a1.vtu', 'a1.vtu'], undefined],
    [['a1.vtu'], undefined],
    [[], undefined],
  ])('%j', (names, expected) => {
    expect(ordered(names)).toEqual(expected)
  })
})

describe('files without a list', () => {
  test('that differ only in a number and in places of points are steps in its order', () => {
    const found = decided({ 'w_10.vtu': bad, 'w_2.vtu': one, 'w_9.vtu': one })
    expect(found?.sentences).toEqual(['3 files are taken as 3 steps of one mesh, in the order of their numbers.'])
    expect(found?.steps.map(({ name, time }) => [name, time])).toEqual([
      ['w_2.vtu', null],
      ['w_9.vtu', null],
      ['w_10.vtu', null],
    ])
    expect(found?.first?.points).toEqual(meshOf([unitCube]).points)
    expect(found?.steps[2]?.read(OPTIONS).points).toEqual(meshOf([invalidCorner]).points)
  })

  const square = meshOf([unitCube])
  test.each([
    ['of other counts', { 'w_1.vtu': one, 'w_2.vtu': two }],
    [
      'of as many cells with other nodes',
      { 'w_1.vtu': one, 'w_2.vtu': vtuText({ ...square, cells: Uint32Array.of(4, 5, 6, 7, 0, 1, 2, 3) }) },
    ],
    [
      'of other points beside the same cells',
      { 'w_1.vtu': one, 'w_2.vtu': vtuText({ ...square, points: new Float64Array(27) }) },
    ],
    ['of other names', { 'left.vtu': one, 'right.vtu': bad }],
    ['without hexahedra', { 'w_1.vtu': vtuOf([]), 'w_2.vtu': vtuOf([]) }],
    ['alone', { 'w_1.vtu': one }],
    ['that name each other', { 'w_1.pvtu': pvtuText(['w_2.pvtu']), 'w_2.pvtu': pvtuText(['w_1.pvtu']) }],
  ])('%s are no steps', (_, texts) => {
    expect(decided(texts)).toBe(null)
  })

  test('one that is refused refuses them, by its name', () => {
    expect(() => decided({ 'w_1.vtu': one, 'w_2.vtu': 'no' })).toThrow('w_2.vtu')
  })

  test('that consist of pieces are steps with them', () => {
    const found = decided({
      's_2_0.vtu': one,
      's_2_1.vtu': bad,
      's_1_0.vtu': one,
      's_1_1.vtu': one,
      's_2.pvtu': pvtuText(['s_2_0.vtu', 's_2_1.vtu']),
      's_1.pvtu': pvtuText(['s_1_0.vtu', 's_1_1.vtu']),
    })
    expect(found?.sentences[0]).toBe(
      '2 files with 4 pieces are taken as 2 steps of one mesh, in the order of their numbers.',
    )
    expect(found?.steps.map(({ name }) => name)).toEqual(['s_1.pvtu', 's_2.pvtu'])
    expect(found?.steps[1]?.read(OPTIONS).cells.length).toBe(16)
  })
})

describe('files out of folders', () => {
  const within = (texts: Readonly<Record<string, string>>): MeshFile[] =>
    Object.entries(texts).map(([path, text]) => ({ ...textFile(path.slice(path.lastIndexOf('/') + 1), text), path }))
  const read = (texts: Readonly<Record<string, string>>) => stepFilesOf(within(texts), OPTIONS)
  const early = vtuOf([moved(6, [2, 1, 1])])
  const x6 = (points: Float64Array | undefined) => points?.[18]

  test('whose folders alone differ in a number are steps, named by their paths', () => {
    const found = read({ 'run/0.5/w.vtu': one, 'run/0.25/w.vtu': early, 'run/1/w.vtu': one })
    expect(found?.steps.map(({ name }) => name)).toEqual(['run/0.25/w.vtu', 'run/0.5/w.vtu', 'run/1/w.vtu'])
    expect(found?.steps.map(step => x6(step.read(OPTIONS).points))).toEqual([2, 1, 1])
  })

  test('are found by a .pvd at their paths, and by each .pvtu beside it', () => {
    const sets = ['0', '1'].map(time => ({ time, file: `t${time}/w.pvtu` }))
    const found = read({
      'run/t1/w_0.vtu': one,
      'run/t0/w_0.vtu': early,
      'run/t0/w.pvtu': pvtuText(['w_0.vtu']),
      'run/t1/w.pvtu': pvtuText(['w_0.vtu']),
      'run/a.pvd': pvdText(sets),
    })
    expect(found?.sentences).toEqual(['a.pvd has 2 time steps of one mesh.'])
    expect(found?.steps.map(step => x6(step.read(OPTIONS).points))).toEqual([2, 1])
  })

  test('of two numbers are no steps; a name that two could have is missing', () => {
    expect(read({ 'r1/w_0.vtu': one, 'r1/w_1.vtu': one, 'r2/w_0.vtu': one, 'r2/w_1.vtu': one })).toBe(null)
    const sets = ['0', '1'].map(time => ({ time, file: `w_${time}.vtu` }))
    const found = read({ 'a.pvd': pvdText(sets), 'x/w_0.vtu': one, 'y/w_0.vtu': early, 'x/w_1.vtu': one })
    expect(found?.sentences[1]).toBe('1 of them lacks files, first “w_0.vtu”.')
  })
})

describe('a .pvd', () => {
  test('says what the steps are, parts and all, whatever their cells', () => {
    const sets = [
      { time: '0', file: 'x/left.vtu', part: 0 },
      { time: '0', file: 'x/right.vtu', part: 1 },
      { time: '0.5', file: 'x/late.vtu' },
    ]
    const found = decided({ 'late.vtu': bad, 'a.pvd': pvdText(sets), 'left.vtu': one, 'right.vtu': one })
    expect(found?.sentences).toEqual(['a.pvd has 2 time steps of one mesh.'])
    expect(found?.steps.map(({ name, time }) => [name, time])).toEqual([
      ['a.pvd', '0'],
      ['a.pvd', '0.5'],
    ])
    expect(found?.steps.map(step => step.read(OPTIONS).cells.length / 8)).toEqual([2, 1])
  })

  test('names files that were not given, and not others that were', () => {
    const sets = ['0', '1', '2'].map(time => ({ time, file: `w_${time}.vtu` }))
    const found = decided({ 'a.pvd': pvdText(sets), 'w_1.vtu': one, 'w_7.vtu': one })
    expect(found?.sentences).toEqual([
      'a.pvd has 3 time steps of one mesh.',
      '2 of them lack files, first “w_0.vtu”.',
      '“w_7.vtu” is not named in a.pvd and was left out.',
    ])
    expect(found?.steps[1]?.read(OPTIONS).cells.length).toBe(8)
    expect(() => found?.steps[0]?.read(OPTIONS)).toThrow('a.pvd: it needs “w_0.vtu” beside it')
  })

  test('counts pieces of a .pvtu among its files', () => {
    const sets = ['0', '1'].map(time => ({ time, file: `p${time}.pvtu` }))
    const found = decided({
      'a.pvd': pvdText(sets),
      'p0.pvtu': pvtuText(['p0_0.vtu']),
      'p1.pvtu': pvtuText(['p1_0.vtu', 'p1_1.vtu']),
      'p0_0.vtu': one,
      'p1_0.vtu': one,
    })
    expect(found?.sentences.slice(1)).toEqual(['1 of them lacks files, first “p1_1.vtu”.'])
    expect(found?.steps[0]?.read(OPTIONS).cells.length).toBe(8)
  })

  test('has its steps in the order of their times; two that are equal as numbers stay two', () => {
    const sets = ['10', '0.50', '2', '0.5'].map((time, i) => ({ time, file: `${i}.vtu` }))
    const texts = Object.fromEntries(sets.map(({ file }, i) => [file, vtuOf([moved(6, [1 + i, 1, 1])])] as const))
    const found = decided({ 'a.pvd': pvdText(sets), ...texts })
    expect(found?.steps.map(({ time }) => time)).toEqual(['0.50', '0.5', '2', '10'])
    expect(found?.steps.map(step => step.read(OPTIONS).points[18])).toEqual([2, 4, 3, 1])
  })

  test('that names files of the same name in several folders is refused: one would stand for all', () => {
    const sets = ['0', '1'].map(time => ({ time, file: `t${time}/w.vtu` }))
    expect(() => decided({ 'a.pvd': pvdText(sets), 'w.vtu': one })).toThrow(
      'a.pvd: it names “t0/w.vtu” and “t1/w.vtu”, and “w.vtu” here could be either',
    )
    const same = ['0', '1'].map(time => ({ time, file: time === '0' ? './w.vtu' : 'w.vtu' }))
    expect(decided({ 'a.pvd': pvdText(same), 'w.vtu': one })?.steps.length).toBe(2)
  })

  test('of steps without numbers keeps its own order', () => {
    const sets = ['late', 'early'].map(time => ({ time, file: `${time}.vtu` }))
    const found = decided({ 'a.pvd': pvdText(sets), 'late.vtu': one, 'early.vtu': one })
    expect(found?.steps.map(({ time }) => time)).toEqual(['late', 'early'])
  })

  test.each([
    ['with one step', { 'a.pvd': pvdText([{ time: '0', file: 'w.vtu' }]), 'w.vtu': one }],
    ['without its files', { 'a.pvd': pvdText(['0', '1'].map(time => ({ time, file: `w_${time}.vtu` }))) }],
    [
      'that is one of two',
      {
        'a.pvd': pvdText(['0', '1'].map(time => ({ time, file: `w_${time}.vtu` }))),
        'b.pvd': pvdText(['0', '1'].map(time => ({ time, file: `w_${time}.vtu` }))),
        'w_0.vtu': one,
        'w_1.vtu': one,
      },
    ],
  ])('%s is read as before', (_, texts) => {
    expect(decided(texts)).toBe(null)
  })
})
