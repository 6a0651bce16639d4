/** `certify` as scripts meet it: in-process on its streams, and the program itself. */
import { execFileSync } from 'node:child_process'
import { fileURLToPath } from 'node:url'
import { describe, expect, it } from 'vitest'
import { main } from '../../web/cli/from-sources'
import { certificateOf, checked } from './certificate-checker'
import { cases, unitCube } from './core-fixtures'

const cube = [0, 1, 2, 3, 4, 5, 6, 7].map(v => unitCube.slice(3 * v, 3 * v + 3))
const face = [{ t: ['0', '1'], by: 'b' }]

async function certify(text: string, args: readonly string[] = ['certify', '-']) {
  let output = ''
  let errors = ''
  const status = await main(args, {
    input: (async function* () {
      yield text
    })(),
    output: { write: piece => (output += piece) },
    errors: { write: piece => (errors += piece) },
  })
  return { status, output, errors }
}

describe('certify', () => {
  it('prints a certificate of each element, in order, which hold', async () => {
    const elements = JSON.stringify(cases)
    const { status, output, errors } = await certify(elements)
    expect([status, errors]).toEqual([0, ''])
    expect(JSON.parse(output)).toEqual(cases.map(({ name, vertices }) => certificateOf(name, vertices.flat())))
    expect(checked(output, elements)).toEqual({ status: 0, output: `${cases.length} certificates hold\n`, errors: '' })
  })

  it('prints what docs/certificates.md says', async () => {
    const moved = cube.with(0, [1, 1, 1])
    const { output } = await certify(
      JSON.stringify([
        { name: 'cube', vertices: cube },
        { name: 'moved', vertices: moved },
      ]),
    )
    const [valid, invalid] = JSON.parse(output)
    expect(valid).toEqual({
      name: 'cube',
      vertices: cube,
      valid: true,
      theorem: expect.stringContaining('P. Zhang, Validating Hexahedra through their Boundaries'),
      faces: [face, face, face, face, face, face],
    })
    expect(invalid).toEqual({ name: 'moved', vertices: moved, valid: false, point: ['0', '0', '0'], jacdet: '-2' })
  })

  it('puts an error in the place of what is not finite, which the checker does not pass', async () => {
    const text = `[{"name":"a","vertices":${JSON.stringify(cube)}},{"name":"b","vertices":${JSON.stringify(cube).replace('1', '1e999')}}]`
    const { status, output } = await certify(text)
    expect(status).toBe(0)
    expect(JSON.parse(output)[1]).toEqual({ name: 'b', error: 'Vertex 1 x is not a finite number.' })
    const { status: refused, output: lines } = checked(output)
    expect([refused, lines]).toEqual([1, 'refused: certificate 1 ("b"): it is not a certificate\n'])
  })

  it('takes an empty list and refuses bad input and wrong calls as analyze does', async () => {
    expect(await certify('[]')).toEqual({ status: 0, output: '[]\n', errors: '' })
    expect(await certify('[3]')).toMatchObject({ status: 2, errors: expect.stringMatching(/^hexlens: Entry 0/) })
    for (const args of [['certify'], ['certify', 'a', 'b'], []])
      expect(await certify('[]', args)).toMatchObject({ status: 2, errors: expect.stringMatching(/^Usage: /) })
    for (const name of ['certified', 'toString'])
      expect(await certify('[]', [name, '-'])).toMatchObject({ status: 2, errors: expect.stringContaining(name) })
  })

  it('is what the program runs', () => {
    const program = fileURLToPath(new URL('../../tools/hexlens.mjs', import.meta.url))
    const input = JSON.stringify([{ name: 'cube', vertices: cube }])
    const output = execFileSync(process.execPath, [program, 'certify', '-'], { input, encoding: 'utf8' })
    expect(JSON.parse(output)).toEqual([certificateOf('cube', unitCube)])
  })
})
