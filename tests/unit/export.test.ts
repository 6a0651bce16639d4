import { readFile } from 'node:fs/promises'
import { crc32 } from 'node:zlib'
import fc from 'fast-check'
import { expect, test } from 'vitest'
import { loadCore } from '../../web/core/core'
import { reportJson } from '../../web/core/report-json'
import { readMeshes } from '../../web/mesh/read-mesh'
import { fileOfBytes } from '../../web/mesh/source'
import { decodePermalink, encodePermalink } from '../../web/model/permalink'
import { isPng, textOf, withText } from '../../web/model/png-text'
import { hexadecimal } from '../../web/panels/take-away/formats/c'
import { writers } from '../../web/panels/take-away/formats/writers'
import { readText, verticesOf } from './mesh-expectations'

const cube = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1]
const coordinates = fc.array(fc.double({ noNaN: true, noDefaultInfinity: true }), { minLength: 24, maxLength: 24 })
const hard = Array.from(
  { length: 24 },
  (_, i) => [-0, 5e-324, -2.2250738585072009e-308, Number.MAX_VALUE, 0.1, 1e21][i % 6] as number,
)
/** The smallest PNG: one grey pixel. */
const png = Uint8Array.from(
  atob('iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVQI12NgAAAAAgAB4iG8MwAAAABJRU5ErkJggg=='),
  character => character.charCodeAt(0),
)

function elementsOf(text: string): number[][] {
  const mesh = readText('the text', text)
  return Array.from({ length: mesh.cells.length / 8 }, (_, cell) => verticesOf(mesh, cell))
}

test.each(writers.map(writer => [writer.title, writer] as const))('%s reads back bit for bit', (_, writer) => {
  fc.assert(
    fc.property(coordinates, vertices => {
      expect(elementsOf(writer.write(vertices, 'hexahedron'))).toEqual([vertices])
    }),
    { examples: [[hard], [cube]] },
  )
})

test('a JSON report reads back bit for bit, and says all of the report', async () => {
  const core = await loadCore(await readFile(new URL('../../build/hexlens.wasm', import.meta.url)))
  const analysis = core.analyze(cube.with(0, -0).with(4, 5e-324))
  if (!analysis.ok) throw new Error(analysis.error.message)
  const text = reportJson(analysis.value, 'a', '1.2.3')
  const { name, version, hexlens, vertices, ...rest } = JSON.parse(text)
  expect([name, version, hexlens]).toEqual(['a', '1.2.3', 'report'])
  expect(vertices.flat()).toEqual(analysis.value.vertices)
  const { vertices: _, ...expected } = analysis.value
  expect(rest).toEqual(expected)
  expect(elementsOf(text)).toEqual([analysis.value.vertices])
  expect(readText('report.json', text).ids).toEqual(['a'])
})

test('hexadecimal floats are written as printf("%a") does', () => {
  const known = [0, -0, 1, -0.5, 0.1, 5e-324, Number.MAX_VALUE, 2 ** -1022]
  expect(known.map(hexadecimal)).toEqual([
    '0x0p+0',
    '-0x0p+0',
    '0x1p+0',
    '-0x1p-1',
    '0x1.999999999999ap-4',
    '0x0.0000000000001p-1022',
    '0x1.fffffffffffffp+1023',
    '0x1p-1022',
  ])
})

test('a PNG keeps its text bit for bit, and stays a PNG', () => {
  fc.assert(
    fc.property(coordinates, vertices => {
      const written = withText(png, 'hexlens', encodePermalink(vertices))
      expect(isPng(written)).toBe(true)
      const read = decodePermalink(textOf(written, 'hexlens') ?? '')
      expect(read.ok && read.value).toEqual(vertices)
    }),
    { examples: [[hard]] },
  )
})

test('a PNG is read as its element, bit for bit, and one without an element is refused', () => {
  const bytes = withText(png, 'hexlens', encodePermalink(hard))
  const [mesh] = readMeshes(fileOfBytes('a.png', bytes))
  expect(mesh && verticesOf(mesh, 0)).toEqual(hard)
  expect(() => readMeshes(fileOfBytes('a.png', png))).toThrow(
    /^a\.png: this is an image\. .* which has its element inside\.$/,
  )
})

test('a PNG without the text, or with a damaged one, gives none', () => {
  expect(textOf(png, 'hexlens')).toBe(null)
  const written = withText(png, 'hexlens', 'v=1')
  expect(textOf(written, 'other')).toBe(null)
  expect(textOf(written.with(50, 0), 'hexlens')).toBe(null)
  expect(textOf(written.subarray(0, 50), 'hexlens')).toBe(null)
  expect(textOf(new Uint8Array(4), 'hexlens')).toBe(null)
  expect(() => withText(new Uint8Array(40), 'hexlens', '')).toThrow(RangeError)
  const sum = new DataView(written.buffer).getUint32(33 + 8 + 11)
  expect(sum).toBe(crc32(written.subarray(37, 52)))
})
