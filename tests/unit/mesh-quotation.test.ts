/** Every given text is the same mesh, or is refused as before, with what mail and Markdown put around it. */
import { readdirSync, readFileSync } from 'node:fs'
import { isDeepStrictEqual } from 'node:util'
import { describe, expect, test } from 'vitest'
import { type Mesh, MeshRefusal } from '../../web/mesh/mesh'
import { readMeshes } from '../../web/mesh/read-mesh'
import { fileOfBytes } from '../../web/mesh/source'

const shared = new URL('../../../shared/', import.meta.url)
const LARGEST = 1_000_000

interface Answer {
  readonly meshes?: readonly Pick<
    Mesh,
    'format' | 'points' | 'cells' | 'ids' | 'blocks' | 'other' | 'isOrderStated' | 'isCutOff'
  >[]
  readonly refused?: true
}

function answerTo(name: string, bytes: Uint8Array): Answer {
  try {
    const meshes = readMeshes(fileOfBytes(name, bytes))
    for (const mesh of meshes) checkPlaces(mesh, bytes)
    return {
      meshes: meshes.map(({ format, points, cells, ids, blocks, other, isOrderStated, isCutOff }) => ({
        ...{ format, points, cells, ids, blocks, other, isOrderStated, isCutOff },
      })),
    }
  } catch (error) {
    if (!(error instanceof MeshRefusal)) throw error
    return { refused: true }
  }
}

/** Tokens lie where they are said to lie. */
function checkPlaces({ points, coordinatePlaces: places }: Mesh, bytes: Uint8Array) {
  if (places?.kind !== 'tokens') return
  const text = Buffer.from(bytes).toString('latin1')
  for (const [i, from] of places.from.entries()) {
    const token = text.slice(from, from + (places.lengths[i] as number))
    // There are too many tokens to call expect for each.
    if (!/^[-+]?[\d.]/.test(token)) expect(token).toMatch(/^[-+]?[\d.]/)
    const isPlain = /^[-+]?[\d.]+(?:e[-+]\d+)?$/i.test(token)
    if (isPlain && !Object.is(Number(token), points[i])) expect(Number(token)).toBe(points[i])
  }
}

const encoded = (text: string) => new TextEncoder().encode(text)

function utf16(text: string): Uint8Array {
  return new Uint8Array(Buffer.from(`\ufeff${text}`, 'utf16le'))
}

const wrappings: readonly (readonly [string, (text: string) => Uint8Array])[] = [
  ['quoted', text => encoded(text.replace(/^/gm, '> '))],
  [
    'quoted twice, with words around',
    text => encoded(`Am Montag schrieb jemand:\n${text.replace(/^/gm, '>> ')}\nGruss\n`),
  ],
  ['fenced', text => encoded(`What is wrong here?\n\n\`\`\`text\n${text.replace(/\n?$/, '\n')}\`\`\`\n\nThanks\n`)],
  [
    'fenced in a quotation',
    text => encoded(`Hello,\n\`\`\`\n${text.replace(/\n?$/, '\n')}\`\`\`\n`.replace(/^/gm, '> ')),
  ],
  ['UTF-16', utf16],
  ['with a byte order mark', text => encoded(`\ufeff${text}`)],
]

describe.each(['meshes/made/', 'pastes/'])('%s', folder => {
  const names = readdirSync(new URL(folder, shared)).filter(name => /\.\w+$/.test(name) && !name.endsWith('.json'))
  test.each(names)('%s', name => {
    let bytes: Uint8Array
    try {
      bytes = new Uint8Array(readFileSync(new URL(folder + name, shared)))
    } catch {
      return
    }
    if (bytes.includes(0) || bytes.length > LARGEST) return
    const text = new TextDecoder().decode(bytes)
    if (text.includes('\ufffd') || /^\s*>|```/m.test(text)) return
    const plain = answerTo(name, bytes)
    for (const [wrapping, wrapped] of wrappings) {
      const answer = answerTo(name, wrapped(text))
      // Node compares long lists faster; where it finds a difference, expect describes it.
      if (!isDeepStrictEqual(answer, plain)) expect(answer, wrapping).toEqual(plain)
    }
  })
})

describe('marks that are none of quotation', () => {
  const points = [0, 1].flatMap(z => [0, 1].flatMap(y => [0, 1].map(x => [x, y, z])))
  const cell = '0 1 3 2 4 5 7 6'

  test('tags of XML that end at the beginning of a line', () => {
    const array = (type: string, name: string, numbers: string) =>
      `<DataArray type="${type}" Name="${name}" NumberOfComponents="${name === 'Points' ? 3 : 1}" format="ascii"\n>\n${numbers}\n</DataArray\n>\n`
    const text = `<VTKFile type="UnstructuredGrid"\n>\n<UnstructuredGrid>\n<Piece NumberOfPoints="8" NumberOfCells="1">\n<Points>
${array('Float64', 'Points', points.map(point => point.join(' ')).join('\n'))}</Points>\n<Cells>
${array('Int32', 'connectivity', cell)}${array('Int32', 'offsets', '8')}${array('UInt8', 'types', '12')}</Cells>
</Piece>\n</UnstructuredGrid>\n</VTKFile>\n`
    expect(readMeshes(fileOfBytes('a.vtu', encoded(text)))[0]?.cells.join(' ')).toBe(cell)
  })

  test('rulers in a log', () => {
    const ruler = '~'.repeat(30)
    const rows = points.map(point => point.map(x => `${x}.0`).join(' ')).join('\n')
    const text = `${ruler}\nPoints\n${ruler}\n${rows}\n${ruler}\nCells\n${ruler}\n${cell}\n`
    expect(readMeshes(fileOfBytes('a.txt', encoded(text)))[0]?.cells.join(' ')).toBe(cell)
  })
})
