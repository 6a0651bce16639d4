/** A checked mesh as a list of cells, as it comes out of a worker. */
import { describe, expect, test } from 'vitest'
import { memoryOf } from '../../web/core/workers'
import { CheckedCells, columnsOf } from '../../web/mesh/checked-cells'
import { formatNames } from '../../web/mesh/format-names'
import { formats } from '../../web/mesh/formats'
import type { Mesh } from '../../web/mesh/mesh'
import { readMeshes } from '../../web/mesh/read-mesh'
import { nodeOrders } from '../../web/model/node-orders'
import { unitCube } from './core-fixtures'
import { textFile } from './mesh-expectations'
import { checked, flat, invalidCorner, meshOf, mirroredCube, mshText, notFinite, voxelOrder } from './mesh-fixtures'

/** The list with its columns sent as a worker sends them. */
async function listOf(mesh: Mesh): Promise<CheckedCells> {
  const columns = columnsOf(await checked(structuredClone(mesh), { worst: Infinity }))
  return new CheckedCells(structuredClone(columns, { transfer: memoryOf(columns) }))
}

const listed = (list: CheckedCells) => Array.from({ length: list.count }, (_, place) => list.at(place))

describe('the list', () => {
  test('has all cells, worst first, with what is said of each; those that are unanswered come last and say why', async () => {
    const list = await listOf(meshOf([unitCube, notFinite, mirroredCube, flat, invalidCorner]))
    expect(listed(list).map(({ id, standing }) => `${id} ${standing}`)).toEqual([
      '5 invalid',
      '3 invalid',
      '4 invalid',
      '1 valid',
      '2 unanswered',
    ])
    expect(list.at(2)).toMatchObject({ cell: 3, relativeMinimum: Number.NaN, why: null, block: null })
    expect(list.at(3)).toMatchObject({ cell: 0, relativeMinimum: 1, why: null })
    expect(list.at(4).why).toBe('vertex 6 y is NaN')
    expect(list.verticesOf(1)).toBe(null)
    expect(list.verticesOf(4)).toEqual(invalidCorner)
    expect(list.rankOf(0)).toBe(3)
  })

  test('finds a cell by what the file calls it, the next one if several are called so, or by its index', async () => {
    const [mesh] = readMeshes(textFile('a.msh', mshText([unitCube, flat, invalidCorner], 17))) as [Mesh]
    const numbers = await listOf(mesh)
    expect([numbers.hasIds, numbers.hasBlocks, numbers.at(0).block]).toEqual([true, true, 'left, wall'])
    expect([numbers.find('18'), numbers.find('1'), numbers.find(''), numbers.find('x')]).toEqual([1, null, null, null])
    const names = await listOf({ ...mesh, ids: ['Part-1.7', 'ä', 'Part-1.7'] })
    expect([names.find('Part-1.7'), names.find('Part-1.7', 0), names.find('Part-1.7', 2)]).toEqual([0, 2, 0])
    expect([names.find('ä'), names.find('Part-1'), names.at(names.rankOf(1)).id]).toEqual([1, null, 'ä'])
    const none = await listOf({ ...mesh, ids: null })
    expect([none.hasIds, none.find('2'), none.find('3'), none.at(none.rankOf(2)).id]).toEqual([false, 2, null, '2'])
  })

  test('shows names of the file without control and bidirectional characters, cut to a length', async () => {
    const list = await listOf({
      ...meshOf([unitCube]),
      ids: ['a\u202eb\u0007c'],
      blocks: [{ name: `\u2066${'x'.repeat(100)}`, cells: Uint32Array.of(0) }],
    })
    expect(list.at(0)).toMatchObject({ id: 'abc', block: `${'x'.repeat(60)}…` })
  })

  test('knows the order in which a cell is valid whose own is not stated', async () => {
    const list = await listOf({ ...meshOf([unitCube, voxelOrder]), isOrderStated: false })
    expect(list.openOrderOf(0)).toBe(null)
    expect(list.openOrderOf(1)).toBe(nodeOrders[0])
    expect(list.at(list.rankOf(1))).toMatchObject({
      standing: 'unanswered',
      why: 'order not stated; valid in the order “Lexicographic”',
    })
  })
})

test('the formats that are named to people are those that are read', () => {
  const inputs = ['link', 'picture', 'not read yet', 'text', 'HDF5']
  expect(formatNames).toEqual(formats.map(({ name }) => name).filter(name => !inputs.includes(name)))
})
