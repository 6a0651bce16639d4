/** docs/formats.md: what it says of the formats is so. */
import { describe, expect, test } from 'vitest'
import { formatNames } from '../../web/mesh/format-names'
import { MeshRefusal } from '../../web/mesh/mesh'
import { MESH_FORMS } from '../../web/outputs/meshes/list'
import { peers } from './document'
import type { Given } from './fact'
import { FACTS } from './facts'
import { contradictions, FILE_FACTS } from './file-facts'
import { answerOf, cornersOf, madeFiles } from './made-mesh'
import { PEERS } from './peers'
import { readGiven } from './read-fact'

function refusal(given: Given): string {
  try {
    return `read as ${readGiven(given, 0).format}`
  } catch (error) {
    if (error instanceof MeshRefusal) return error.message
    throw error
  }
}

test('every format has facts', () => {
  expect(FACTS.map(({ format }) => format)).toEqual([...formatNames, 'JSON', 'NumPy'])
})

test.each(FILE_FACTS)('$path: $says', fact => {
  const record = peers.made[fact.path]
  if (!record) throw new Error('The peers were not asked.')
  expect(contradictions(fact, answerOf(fact.path), record)).toEqual([])
})

test('the peers were asked for every file, and read back what is written', () => {
  expect(Object.keys(peers.made).sort()).toEqual(madeFiles.map(({ path }) => path).sort())
  expect(Object.keys(peers.written)).toEqual(MESH_FORMS.map(({ id }) => `written.${id}`))
  const records = Object.values(peers.written).flatMap(record => PEERS.map(peer => record[peer]))
  const readers = records.filter(record => record !== null && !('refused' in record))
  expect(readers.length).toBeGreaterThanOrEqual(MESH_FORMS.length)
  for (const record of readers) expect(record).toMatchObject({ areHexahedraSame: true })
})

describe.each(FACTS)('$format', ({ format, read, notRead }) => {
  test.each([...read, ...notRead])('$says', ({ given, step, gives }) => {
    for (const one of given) {
      if (gives instanceof RegExp) {
        expect(refusal(one)).toMatch(gives)
        continue
      }
      const mesh = readGiven(one, step)
      const { hexahedra, vertices, curved, other, ids, blocks, steps, note, isCutOff } = gives
      expect(mesh.format).toBe(format)
      if (hexahedra !== undefined) expect(mesh.cells.length / 8).toBe(hexahedra)
      if (vertices !== undefined) expect(cornersOf(mesh, mesh.cells)[0]).toEqual(vertices)
      if (curved !== undefined) expect(mesh.notTrilinear.corners.length / 8).toBe(curved)
      if (other !== undefined) expect(Object.fromEntries(mesh.other)).toEqual(other)
      if (ids !== undefined) expect(mesh.ids && [...mesh.ids].slice(0, ids?.length)).toEqual(ids)
      if (blocks !== undefined) expect(mesh.blocks.map(({ name }) => name)).toEqual(blocks)
      if (steps !== undefined) expect(mesh.steps).toEqual(steps)
      if (note !== undefined) expect(mesh.notes.join('\n')).toMatch(note)
      if (isCutOff !== undefined) expect(mesh.isCutOff).toBe(isCutOff)
    }
  })
})
