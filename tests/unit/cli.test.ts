/** `analyze` as scripts meet it: the program itself on real files, and its streams in-process. */
import { execFile } from 'node:child_process'
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { promisify } from 'node:util'
import { afterAll, describe, expect, it } from 'vitest'
import { main } from '../../web/cli/from-sources'
import { cases, core, unitCube } from './core-fixtures'

const folder = mkdtempSync(join(tmpdir(), 'hexlens-'))
afterAll(() => rmSync(folder, { recursive: true }))

const cube = [0, 1, 2, 3, 4, 5, 6, 7].map(v => unitCube.slice(3 * v, 3 * v + 3))

async function analyze(text: string, args: readonly string[] = ['analyze', '-']) {
  let output = ''
  let errors = ''
  const status = await main(args, {
    input: (async function* () {
      // Two chunks, as a pipe may deliver them.
      const bytes = Buffer.from(text)
      yield bytes.subarray(0, bytes.length >> 1)
      yield bytes.subarray(bytes.length >> 1)
    })(),
    output: { write: piece => (output += piece) },
    errors: { write: piece => (errors += piece) },
  })
  return { status, output, errors }
}

async function answers(entries: unknown) {
  const { status, output, errors } = await analyze(JSON.stringify(entries))
  expect({ status, errors }).toEqual({ status: 0, errors: '' })
  return JSON.parse(output)
}

describe('analyze', () => {
  it('answers in order, with numbers that read back bit for bit', async () => {
    const list = await answers(cases.map(({ name, vertices }) => ({ name, vertices, note: 'ignored' })))
    expect(list.map(({ name }: { name: string }) => name)).toEqual(cases.map(({ name }) => name))
    for (const [i, { vertices }] of cases.entries()) {
      const result = core.analyze(vertices.flat())
      if (!result.ok || result.value.exponent !== 0) continue
      const { valid, decidedBy, boundaryMinimum, cornerMinimum, edgeMinimum, minimizer, volumeMinimum } = result.value
      expect(list[i]).toEqual({
        name: cases[i]?.name,
        valid,
        class: result.value.class,
        coincident: result.value.coincident,
        shape: result.value.shape,
        boundary_min: boundaryMinimum,
        boundary_min_error: result.value.boundaryMinimumError,
        minimizer: { kind: minimizer.kind, id: minimizer.id, point: minimizer.point },
        corner_min: cornerMinimum,
        edge_min: edgeMinimum,
        volume_min: [volumeMinimum.lower, volumeMinimum.upper],
        volume_minimizer: volumeMinimum.point,
        volume: result.value.volume * 2 ** result.value.volumeExponent,
        relative_min: result.value.relativeMinimum,
        decided_by: decidedBy,
        checks: Object.fromEntries(result.value.checks.map(({ id, value, passes }) => [id, { value, passes }])),
      })
    }
  })

  it('writes a value outside the doubles as a decimal of 17 digits', async () => {
    const [huge, tiny] = await answers([
      { name: 'huge', vertices: cube.map(point => point.map(x => x * 1e150)) },
      { name: 'tiny', vertices: cube.map(point => point.map(x => x * 1e-310)) },
    ])
    expect(huge.boundary_min).toMatch(/^9\.9999999999999\d{3}e\+449$|^1\.0000000000000\d{3}e\+450$/)
    expect(tiny.boundary_min).toMatch(/^9\.99999\d{11}e-931$|^1\.00000\d{11}e-930$/)
    expect([huge.valid, tiny.valid]).toEqual([true, true])
    expect(huge.volume).toBe('9.9999999999999992e+449')
    expect(tiny.volume).toBe('9.9999999999999077e-931')
    for (const { relative_min } of [huge, tiny]) expect(Math.abs(relative_min - 1)).toBeLessThanOrEqual(2 ** -52)
  })

  it('says what is degenerate, inverted or collapsed', async () => {
    const at = (places: string) => [...places].map(v => cube[Number(v)])
    const said = async (places: string) => {
      const [{ valid, class: elementClass, coincident, shape, volume, relative_min }] = await answers([
        { name: places, vertices: at(places) },
      ])
      return { valid, class: elementClass, coincident, shape, volume, relative_min }
    }
    const invalid = { valid: false, class: 'invalid', relative_min: 0 }
    expect(await said('01234567')).toEqual({
      valid: true,
      class: 'valid',
      coincident: [],
      shape: null,
      volume: 1,
      relative_min: 1,
    })
    expect(await said('01214567')).toMatchObject({ ...invalid, coincident: [[1, 3]], shape: null, relative_min: -2 })
    expect(await said('01234466')).toEqual({
      ...invalid,
      coincident: [
        [4, 5],
        [6, 7],
      ],
      shape: 'wedge',
      volume: 1 / 2,
    })
    expect(await said('01234444')).toEqual({
      ...invalid,
      coincident: [[4, 5, 6, 7]],
      shape: 'pyramid',
      volume: 1 / 3,
    })
    expect(await said('01224444')).toEqual({
      ...invalid,
      coincident: [
        [2, 3],
        [4, 5, 6, 7],
      ],
      shape: 'tetrahedron',
      volume: 1 / 6,
    })
    expect(await said('45670123')).toMatchObject({ class: 'inverted', shape: null, volume: -1, relative_min: -1 })
    expect(await said('01230123')).toMatchObject({ class: 'collapsed', volume: 0, relative_min: null })
  })

  it('puts an error in the place of what cannot be analysed', async () => {
    const { status, output } = await analyze(
      `[{"name":"a","vertices":${JSON.stringify(cube)}},{"name":"b","vertices":${JSON.stringify(cube).replace('1', '1e999')}}]`,
    )
    expect(status).toBe(0)
    expect(JSON.parse(output)).toEqual([
      expect.objectContaining({ name: 'a', valid: true, boundary_min: 1 }),
      { name: 'b', error: 'Vertex 1 x is not a finite number.' },
    ])
  })

  it('takes an empty list and a byte order mark', async () => {
    expect(await analyze('\uFEFF[]')).toEqual({ status: 0, output: '[]\n', errors: '' })
  })
})

describe('a long list', () => {
  it('is read and answered entry by entry, wherever its pieces are cut', async () => {
    const names = ['a', 'ü€😀', '"]},[{\\', '\\u005d', '']
    const entries = names.map((name, i) => ({ name, vertices: cube, note: { deep: [[{ i }], '[{"'] } }))
    const bytes = Buffer.from(`\uFEFF  ${JSON.stringify(entries, null, 1)}\n `)
    for (const length of [1, 2, 3, 7, 64, 1000]) {
      let [output, asked] = ['', 0]
      const input = (async function* () {
        for (let at = 0; at < bytes.length; at += length) {
          asked++
          yield bytes.subarray(at, at + length)
        }
      })()
      const streams = { input, output: { write: (text: string) => (output += text) }, errors: { write: () => {} } }
      expect(await main(['analyze', '-'], streams)).toBe(0)
      expect(JSON.parse(output).map(({ name }: { name: string }) => name)).toEqual(names)
      expect(asked).toBe(Math.ceil(bytes.length / length))
    }
  })

  it('goes out before it has come in', async () => {
    const entry = JSON.stringify({ name: 'cube', vertices: cube })
    let [written, writtenBeforeEnd] = [0, 0]
    const input = (async function* () {
      yield '['
      for (let i = 0; i < 3000; ++i) yield `${entry},`
      writtenBeforeEnd = written
      yield `${entry}]`
    })()
    const output = { write: (text: string) => (written += text.length) }
    expect(await main(['analyze', '-'], { input, output, errors: { write: () => {} } })).toBe(0)
    expect(writtenBeforeEnd).toBeGreaterThan(2 ** 20)
  })
})

describe('bad input gets one line that says which entry and why, and status 2', () => {
  const bad: [string, string, RegExp][] = [
    ['no JSON', '{"name":\n', /^hexlens: The input is not JSON: .+$/],
    ['nothing', '', /not JSON/],
    ['NaN', '[{"name":"a","vertices":[[NaN,0,0]]}]', /not JSON/],
    ['not a list', '{"name":"a"}', /The input is an object, not a list/],
    ['an end too early', `[${JSON.stringify({ name: 'a', vertices: cube })},`, /not JSON: it ends in entry 1/],
    ['more after the list', '[] []', /not JSON: there is more after the end of the list/],
    ['an open string', '[{"name":"a', /not JSON: it ends in entry 0/],
    ['a comma too many', `[${JSON.stringify({ name: 'a', vertices: cube })},]`, /not JSON: entry 1: /],
    ['deep brackets', '['.repeat(200_000), /not JSON: it ends in entry 0/],
    ['deep brackets that are closed', '['.repeat(100_000) + ']'.repeat(100_000), /Entry 0: it is a list/],
    ['an entry of another kind', '[3]', /Entry 0: it is a number/],
    ['no name', JSON.stringify([{ vertices: cube }]), /Entry 0: "name" is missing/],
    ['no vertices', '[{"name":"a"}]', /Entry 0 \(“a”\): "vertices" is missing/],
    [
      'seven vertices',
      JSON.stringify([
        { name: 'ok', vertices: cube },
        { name: 'a', vertices: cube.slice(1) },
      ]),
      /Entry 1 \(“a”\): it has 7 vertices, not 8/,
    ],
    [
      'two coordinates',
      JSON.stringify([{ name: 'a', vertices: cube.with(2, [0, 1]) }]),
      /vertex 2 has 2 coordinates, not 3/,
    ],
    [
      'a word',
      JSON.stringify([{ name: 'a', vertices: cube.with(2, [0, 'x', 1] as never) }]),
      /vertex 2 y is a string, not a number/,
    ],
    ['null', JSON.stringify([{ name: 'a', vertices: cube.with(2, [0, 1, null] as never) }]), /vertex 2 z is null/],
    ['a line break in a name', JSON.stringify([{ name: 'a\nb', vertices: [] }]), /Entry 0 \(“ab”\): it has 0 vertices/],
  ]
  for (const [what, text, message] of bad)
    it(what, async () => {
      const { status, output, errors } = await analyze(text)
      expect([status, output]).toEqual([2, ''])
      expect(errors).toMatch(/^hexlens: [^\n]+\n$/)
      expect(errors.trimEnd()).toMatch(message)
    })

  it('a missing file', async () => {
    const { status, errors } = await analyze('', ['analyze', join(folder, 'none.json')])
    expect(status).toBe(2)
    expect(errors).toMatch(/^hexlens: The file .*none\.json cannot be read \(ENOENT\)\.\n$/)
  })

  it('a wrong call', async () => {
    for (const args of [[], ['analyze'], ['analyze', 'a', 'b']]) {
      const { status, output, errors } = await analyze('', args)
      expect([status, output]).toEqual([2, ''])
      expect(errors).toMatch(/^Usage: /)
    }
    expect(await analyze('', ['analyse', 'x'])).toMatchObject({
      status: 2,
      output: '',
      errors: expect.stringMatching(
        /^hexlens: There is no command “analyse”\. .*hexlens.* --help says what there is\.\n$/,
      ),
    })
    for (const args of [['--help'], ['-h'], ['analyze', '--help'], ['certify', '-h']])
      expect(await analyze('', args)).toMatchObject({
        status: 0,
        output: expect.stringMatching(/^Usage: /),
        errors: '',
      })
  })
})

describe('the program', () => {
  const program = fileURLToPath(new URL('../../tools/hexlens.mjs', import.meta.url))
  const run = (args: string[]) => promisify(execFile)(process.execPath, [program, ...args], { maxBuffer: 2 ** 26 })

  it('reads a file and prints nothing but the list, however long', async () => {
    const file = join(folder, 'many.json')
    const entries = Array.from({ length: 3000 }, (_, i) => ({ name: `cube ${i}`, vertices: cube }))
    writeFileSync(file, JSON.stringify(entries))
    const { stdout } = await run(['analyze', file])
    expect(JSON.parse(stdout).length).toBe(3000)
  })

  it('says its version', async () => {
    const { version } = JSON.parse(readFileSync(new URL('../../package.json', import.meta.url), 'utf8'))
    expect(await analyze('', ['--version'])).toEqual({ status: 0, output: `${version}\n`, errors: '' })
  })

  it('ends with the status', async () => {
    await expect(run(['analyze', join(folder, 'none.json')])).rejects.toMatchObject({ code: 2, stdout: '' })
  })
})
