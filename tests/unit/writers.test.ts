/** Checked meshes as files: each format is read back bit for bit, whole and of the invalid cells alone, and is what the command line writes. */
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { afterAll, describe, expect, it, test } from 'vitest'
import { main } from '../../web/cli/from-sources'
import type { Mesh } from '../../web/mesh/mesh'
import type { MeshCheck } from '../../web/mesh/mesh-check'
import { readMeshes } from '../../web/mesh/read-mesh'
import { fileOfBytes } from '../../web/mesh/source'
import { verticesOf } from '../../web/mesh/vertices-of'
import { FORM_WORDS } from '../../web/outputs/meshes/form-words'
import { MESH_FORMS } from '../../web/outputs/meshes/list'
import { PIECE } from '../../web/outputs/meshes/mesh-part'
import type { MeshFormId } from '../../web/survey/survey-jobs'
import { Writing } from '../../web/survey/writing'
import { core, randomHexahedron, randomSource, unitCube } from './core-fixtures'
import {
  checked,
  collapsedEdge,
  flat,
  invalidCorner,
  meshOf,
  mirroredCube,
  moved,
  mshText,
  notFinite,
} from './mesh-fixtures'

const folder = mkdtempSync(join(tmpdir(), 'hexlens-writers-'))
afterAll(() => rmSync(folder, { recursive: true }))

const LISTS = { minima: true, volumes: true }
const opened = (mesh: Mesh) => checked(mesh, { worst: Infinity, lists: LISTS })

const next = randomSource(22)
/** Numbers that are easily lost: of 17 digits, subnormal, huge, -0; NaN. */
const hard = [
  0.1 + 0.2,
  -1 / 3,
  5e-324,
  2 ** -1060 * 3,
  1.7976931348623157e308,
  -0,
  123456789.12345679,
  -1.2345678901234566e-7,
]
const elements = [
  ...[unitCube, invalidCorner, collapsedEdge, mirroredCube, notFinite, flat],
  moved(2, [hard[0] as number, hard[1] as number, hard[2] as number]),
  moved(5, [hard[3] as number, hard[4] as number, hard[5] as number]),
  moved(7, [hard[6] as number, hard[7] as number, 0]),
  ...Array.from({ length: 60 }, () => randomHexahedron(next, 0.3)),
]
const everything = meshOf(elements)
const indices = elements.map((_, cell) => cell)

function written(form: MeshFormId, check: MeshCheck): { content: Uint8Array; steps: number; said: readonly string[] } {
  const writing = new Writing(form, { name: 'made', check, core })
  const parts: Uint8Array[] = []
  let last = 0
  for (;;) {
    // Steps of no time at all: one piece each.
    const step = writing.run(0)
    if ('refused' in step) throw new Error(step.refused)
    expect(step.fraction).toBeGreaterThanOrEqual(last)
    last = step.fraction
    parts.push(step.bytes)
    if (step.isEnd) return { content: new Uint8Array(Buffer.concat(parts)), steps: parts.length, said: step.said }
  }
}

function readBack(content: Uint8Array, id: string): Mesh {
  const [mesh, ...others] = readMeshes(fileOfBytes(`back.${id}`, content))
  expect(others).toEqual([])
  return mesh as Mesh
}

const bits = (numbers: Float64Array | readonly number[]) => [...new BigUint64Array(Float64Array.from(numbers).buffer)]

/** A block of unit cubes with more numbers than a piece has. */
function largeMesh(): Mesh {
  const perSide = 26
  const side = perSide + 1
  const points = Float64Array.from({ length: 3 * side ** 3 }, (_, i) => {
    const point = Math.floor(i / 3)
    return Math.floor(point / side ** (i % 3)) % side
  })
  const corners = [0, 1, 1 + side, side].flatMap((corner, i, four) => [
    corner,
    ...(i === 3 ? four.map(c => c + side * side) : []),
  ])
  const cells = Uint32Array.from({ length: 8 * perSide ** 3 }, (_, i) => {
    const cell = i >> 3
    const place = [cell % perSide, Math.floor(cell / perSide) % perSide, Math.floor(cell / perSide ** 2)] as const
    return place[0] + side * (place[1] + side * place[2]) + (corners[i & 7] as number)
  })
  return { ...meshOf([]), points, cells, ids: null }
}

const large = await opened(largeMesh())

it('the page names the formats in the order of the list', () => {
  expect(Object.keys(FORM_WORDS)).toEqual(MESH_FORMS.map(({ id }) => id))
})

describe.each(MESH_FORMS.map(({ id }) => id))('.%s', id => {
  it('gives the same points and cells, bit for bit, and the same verdicts', async () => {
    const check = await opened(everything)
    const mesh = readBack(written(`mesh.${id}`, check).content, id)
    expect(bits(mesh.points)).toEqual(bits(everything.points))
    expect([...mesh.cells]).toEqual([...everything.cells])
    const again = await opened(mesh)
    expect([...again.standings]).toEqual([...check.standings])
  })

  it('is in several pieces where it is large', () => {
    const { content, steps } = written(`mesh.${id}`, large)
    expect(steps).toBeGreaterThan((large.mesh.points.length + large.mesh.cells.length) / PIECE)
    const mesh = readBack(content, id)
    for (const list of ['points', 'cells'] as const) {
      expect(mesh[list].length).toBe(large.mesh[list].length)
      expect(mesh[list].every((number, i) => number === large.mesh[list][i])).toBe(true)
    }
  })

  it('has of the invalid cells these alone, and their points', async () => {
    const cells = Uint32Array.of(0, 1, 2, 3, 4, 5, 6, 7, 4, 5, 6, 7, 0, 1, 2, 3)
    const shared: Mesh = { ...meshOf([unitCube]), cells, ids: null }
    for (const own of [everything, shared]) {
      const check = await opened(own)
      const invalid = [...check.standings.keys()].filter(cell => check.standingOf(cell) === 'invalid')
      const mesh = readBack(written(`invalid.${id}`, check).content, id)
      expect(invalid.map((_, i) => bits(verticesOf(mesh, i)))).toEqual(invalid.map(cell => bits(verticesOf(own, cell))))
      const used = new Set(invalid.flatMap(cell => [...own.cells.subarray(8 * cell, 8 * cell + 8)]))
      expect(mesh.points.length / 3).toBe(used.size)
      expect((await opened(mesh)).invalid).toBe(invalid.length)
      if (own === everything) expect([...(mesh.ids ?? [])]).toEqual(invalid.map(cell => cell + 1))
    }
  })

  it('is the same from the command line, and keeps what the mesh was read with', async () => {
    const [source, target] = [join(folder, 'source.msh'), join(folder, `out.${id.toUpperCase()}`)]
    writeFileSync(source, mshText(elements.slice(0, 6), 101))
    let said = ''
    await main(['check', source, '--annotate', target], {
      input: (async function* () {})(),
      output: { write: () => {} },
      errors: { write: text => (said += text) },
    })
    const file = fileOfBytes(source, new Uint8Array(readFileSync(source)))
    const own = written(`mesh.${id}`, await opened(readMeshes(file)[0] as Mesh))
    expect(Buffer.from(own.content).equals(readFileSync(target))).toBe(true)
    expect(said).toBe(own.said.map(sentence => `hexlens: ${sentence}\n`).join(''))
  })

  it('leaves the mesh its memory, and has a file for no cells', async () => {
    const check = await opened(meshOf([unitCube]))
    const step = new Writing(`mesh.${id}`, { name: 'a', check, core }).run(Infinity)
    if ('refused' in step) throw new Error(step.refused)
    structuredClone(step.bytes, { transfer: [step.bytes.buffer] })
    expect([check.mesh.points.length, check.mesh.cells.length]).toEqual([24, 8])
    expect(readBack(written(`invalid.${id}`, check).content, id).cells.length).toBe(0)
  })
})

const text = ({ content }: { content: Uint8Array }) => new TextDecoder('latin1').decode(content)

test('a VTU has the indices and ids of invalid cells, and no words', async () => {
  const named = await opened({ ...everything, ids: indices.map(cell => `part.${cell}`) })
  expect(text(written('invalid.vtu', named))).toContain('Name="index"')
  expect(text(written('invalid.vtu', named))).not.toContain('Name="cell_id"')
  expect(text(written('invalid.vtu', await opened(everything)))).toContain('Name="cell_id"')
})

test.each([
  [null, 'The mesh has no ids'],
  [indices.map(cell => `part.${cell}`), 'The ids are words'],
  [Float64Array.from(indices, cell => cell), 'Not all ids are whole numbers from 1 to 2147483647'],
  [Float64Array.from(indices, cell => 2 ** 31 + cell), 'Not all ids are whole numbers from 1 to 2147483647'],
  [Float64Array.from(indices, cell => 7 + (cell % 60)), 'Several cells have one id'],
])('elements are numbered from 1 where %s', async (ids, why) => {
  const check = await opened({ ...everything, ids })
  const { content, said } = written('mesh.msh', check)
  expect(said).toEqual([`${why}: elements are numbered from 1, in the file's order.`])
  expect([...(readBack(content, 'msh').ids ?? [])]).toEqual(indices.map(cell => cell + 1))
})

test('ids that do not rise are kept', async () => {
  const ids = Float64Array.from(indices, cell => 1000 - cell)
  for (const form of ['mesh.msh', 'mesh.inp'] as const) {
    const { content } = written(form, await opened({ ...everything, ids }))
    expect([...(readBack(content, form.slice(-3)).ids ?? [])]).toEqual([...ids])
  }
})

test('Abaqus has sets of the invalid and the unanswered, and says what it cannot hold', async () => {
  const check = await opened(everything)
  const { content, said } = written('mesh.inp', check)
  const { blocks } = readBack(content, 'inp')
  const cellsOf = (standing: string) => indices.filter(cell => check.standingOf(cell) === standing)
  expect(blocks.map(({ name, cells }) => [name, [...cells]])).toEqual([
    ['HEXLENS_INVALID', cellsOf('invalid')],
    ['HEXLENS_UNANSWERED', cellsOf('unanswered')],
  ])
  expect(said.map(sentence => sentence.split(' ').slice(0, 3).join(' '))).toEqual([
    'Coordinates that are',
    'Some coordinates have',
  ])
  for (const sentence of said) expect(text({ content })).toContain(`** ${sentence}\n`)
  const plain = written('mesh.inp', await opened(meshOf([unitCube])))
  expect(plain.said).toEqual([])
  expect(text(plain)).not.toContain('ELSET')
})
