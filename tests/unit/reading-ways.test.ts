/** Files are read the same with wasm and without. */
import { readdirSync, readFileSync, statSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { isDeepStrictEqual } from 'node:util'
import { describe, expect, test } from 'vitest'
import { loadReadingCore } from '../../web/core/reading-core'
import type { ReadingCore } from '../../web/core/reading-interface'
import { hdf5Files } from '../../web/mesh/hdf5-files'
import { type Mesh, MeshRefusal } from '../../web/mesh/mesh'
import { readMeshes } from '../../web/mesh/read-mesh'
import { fileOfBytes, type MeshFile } from '../../web/mesh/source'

const core = await loadReadingCore(readFileSync(new URL('../../build/hexlens-reading.wasm', import.meta.url)))
const hdf5 = await hdf5Files()
const shared = fileURLToPath(new URL('../../../shared/', import.meta.url))

type Outcome = { readonly meshes: readonly object[] } | { readonly message: string }

function outcome(file: MeshFile, way: ReadingCore | null): Outcome {
  try {
    return { meshes: readMeshes(file, { core: way, hdf5 }).map(plain) }
  } catch (error) {
    if (!(error instanceof MeshRefusal)) throw error
    return { message: error.message }
  }
}

/** Lists may be parts of longer memory; and a coordinate that is not finite is the same as another. */
function plain(mesh: Mesh): object {
  const places = mesh.coordinatePlaces
  return {
    ...mesh,
    points: [...mesh.points],
    cells: [...mesh.cells],
    ids: mesh.ids === null ? null : [...mesh.ids],
    coordinatePlaces: places?.kind === 'tokens' ? { from: [...places.from], lengths: [...places.lengths] } : places,
  }
}

function expectSame(file: MeshFile): Outcome {
  const [byWasm, without] = [outcome(file, core), outcome(file, null)]
  // Node compares the long lists in a tenth of the time, and tells 0 from -0, too; where it finds a difference, expect describes it.
  if (!isDeepStrictEqual(byWasm, without)) expect(byWasm, file.name).toEqual(without)
  return byWasm
}

describe.each(['meshes', 'pastes'])('the given %s', folder => {
  const paths = readdirSync(`${shared}${folder}`, { recursive: true, encoding: 'utf8' })
    .map(name => `${shared}${folder}/${name}`)
    .filter(path => statSync(path).isFile() && statSync(path).size < 3_000_000)
  test.each(paths.map(path => [path.slice(shared.length), path]))('%s', (_, path) => {
    expectSame(fileOfBytes(path.slice(path.lastIndexOf('/') + 1), new Uint8Array(readFileSync(path))))
  })
})

/** A row of cubes, as many as fill several windows, and between the lines what ends rows. */
const CUBES = 3000
const nodes = Array.from({ length: 4 * (CUBES + 1) }, (_, i) => {
  const [layer, corner] = [Math.floor(i / 4), i % 4]
  // The ids are in no order, and have gaps.
  const id = 1 + ((i * 7919) % 20_011)
  return { id, x: layer / 7, y: [0, 1, 1, 0][corner] as number, z: [0, 0, 0.1, 0.1][corner] as number }
})
const cells = Array.from({ length: CUBES }, (_, i) => ({
  id: 2 * CUBES - i,
  nodes: [0, 1, 2, 3, 4, 5, 6, 7].map(v => (nodes[4 * i + v] as (typeof nodes)[number]).id),
}))
const small = (value: number) => String(value).slice(0, 8).padStart(8)

function lines<T>(list: readonly T[], line: (entry: T) => string, oddities: readonly string[]): string {
  return list
    .map((entry, i) => line(entry) + (i % 701 === 700 ? `\n${oddities[((i / 700) % oddities.length) | 0]}` : ''))
    .join('\n')
}

const abaqus = `*NODE
${lines(nodes, n => `${n.id}, ${n.x}, ${n.y}, ${n.z}`, ['** a comment', '', '*NODE', '*NODE, NSET=SOME'])}
*ELEMENT, TYPE=C3D8, ELSET=ALL
${lines(cells, c => `${c.id}, ${c.nodes.join(', ')}`, ['** a comment', '*ELEMENT, TYPE=C3D8, ELSET=MORE'])}
`

function nastran(isFree: boolean): string {
  const grid = (n: (typeof nodes)[number]) =>
    isFree
      ? `GRID,${n.id},,${n.x},${n.y},${n.z}`
      : `GRID    ${small(n.id)}        ${small(n.x)}${small(n.y)}${small(n.z)}`
  const hexahedron = (c: (typeof cells)[number]) => {
    const fields = [c.id, 1 + (c.id % 2), ...c.nodes].map(value => (isFree ? `,${value}` : small(value)))
    return `${isFree ? 'CHEXA' : 'CHEXA   '}${fields.slice(0, 8).join('')}\n${isFree ? '' : '        '}${fields.slice(8).join('')}`
  }
  return `BEGIN BULK
${lines(nodes, grid, ['$ a comment', 'GRID    77777                   1.0-3   1.+1      2.', 'PSOLID,1,1'])}
${lines(cells, hexahedron, ['$ a comment', 'CTETRA  88888   1       1       2       3       4'])}
ENDDATA
`
}

const node = (n: (typeof nodes)[number]) => `${n.id} ${n.x} ${n.y} ${n.z}`
const msh2 = `$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n${nodes.length}\n${nodes.map(node).join('\n')}\n$EndNodes
$Elements\n${cells.length}
${cells.map((c, i) => `${c.id} 5 ${i % 500 === 3 ? '3 1 2 3' : `2 ${1 + (i % 2)} 4`} ${c.nodes.join(i % 900 === 9 ? '  ' : ' ')}`).join('\n')}
$EndElements\n`
const msh1 = `$NOD\n${nodes.length}\n${nodes.map(node).join('\n')}\n$ENDNOD\n$ELM\n${cells.length}
${cells.map(c => `${c.id} 5 1 2 8 ${c.nodes.join(' ')}`).join('\n')}\n$ENDELM\n`
const msh41 = `$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 ${nodes.length} 1 20011\n3 1 0 ${nodes.length}
${nodes.map(({ id }) => id).join('\n')}\n${nodes.map(n => `${n.x} ${n.y} ${n.z}`).join('\n')}\n$EndNodes
$Elements\n1 ${cells.length} 1 ${2 * CUBES}\n3 1 5 ${cells.length}\n${cells.map(c => `${c.id} ${c.nodes.join(' ')}`).join('\n')}\n$EndElements\n`

const made: Readonly<Record<string, string>> = {
  'a.inp': abaqus,
  'small.bdf': nastran(false),
  'free.bdf': nastran(true),
  '1.msh': msh1,
  '2.msh': msh2,
  '4.msh': msh41,
}

describe.each(Object.entries(made))('%s', (name, text) => {
  const fileOf = (content: string) => fileOfBytes(name, new TextEncoder().encode(content))

  test('whole', () => {
    const read = expectSame(fileOf(text))
    expect('meshes' in read ? (read.meshes[0] as { cells: number[] }).cells.length : read.message).toBe(8 * CUBES)
  })

  test('with other ends of lines', () => {
    expectSame(fileOf(text.replaceAll('\n', '\r\n')))
  })

  test('cut off, or with a word or a number that is wrong', () => {
    for (let i = 1; i < 12; ++i) {
      const at = Math.floor((i * text.length) / 12)
      expectSame(fileOf(text.slice(0, at)))
      expectSame(fileOf(`${text.slice(0, at)}x${text.slice(at)}`))
      expectSame(fileOf(`${text.slice(0, at)}\n${text.slice(at)}`))
      expectSame(fileOf(`${text.slice(0, at)}7${text.slice(at)}`))
    }
  })
})
