/** Every given text is the same mesh, or is refused as before, with what mail and Markdown put around it. */
import { readdirSync, readFileSync } from 'node:fs'
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
    expect(token).toMatch(/^[-+]?[\d.]/)
    if (/^[-+]?[\d.]+(?:e[-+]\d+)?$/i.test(token)) expect(Number(token)).toBe(points[i])
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
    for (const [wrapping, wrapped] of wrappings) expect(answerTo(name, wrapped(text)), wrapping).toEqual(plain)
  })
})
