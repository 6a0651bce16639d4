/** The fix of a mesh whose nodes are all in one wrong order. */
import { describe, expect, test } from 'vitest'
import type { ClassifyCells } from '../../web/mesh/check'
import type { Mesh } from '../../web/mesh/mesh'
import { distinctOrders, orderClass, reflections } from '../../web/model/node-order'
import type { NodeOrder } from '../../web/model/node-orders'
import { nodeOrders } from '../../web/model/node-orders'
import { part } from '../../web/pages/mesh/part'
import { mended } from '../../web/survey/mend'
import { Survey } from '../../web/survey/survey'
import { wholeOrderOf } from '../../web/survey/whole-order'
import { core, randomHexahedron, randomSource, unitCube } from './core-fixtures'
import { checked, classifyCells, invalidCorner, meshOf, mirroredCube, notFinite, voxelOrder } from './mesh-fixtures'

const LISTS = { minima: true, volumes: true, acceptedBy: true }

async function surveyOf(mesh: Mesh): Promise<{ readonly survey: Survey; readonly order: NodeOrder | null }> {
  const check = await checked(mesh, { worst: Infinity, lists: LISTS })
  return {
    survey: new Survey(check, { core, meeting: null }),
    order: await wholeOrderOf(check, { classify: classifyCells, core }),
  }
}

/** The valid cells of the page's own part, as a program with another order writes them. */
const elbow = await (async (): Promise<Mesh> => {
  const mesh: Mesh = { ...meshOf([]), ...part() }
  const { valid } = (await checked(mesh)).answers
  return { ...mesh, cells: mesh.cells.filter((_, i) => valid[i >> 3] === 1) }
})()

function writtenIn({ permutation }: NodeOrder, mesh: Mesh): Mesh {
  const cells = mesh.cells.slice()
  for (let i = 0; i < cells.length; ++i) cells[(i & ~7) + (permutation[i & 7] as number)] = mesh.cells[i] as number
  return { ...mesh, cells }
}

/** In these two most of the part's cells are valid as well: a cube whose top is turned by one is. */
const isAlsoValid = ({ id }: NodeOrder) => id === 'top-from-1' || id === 'top-from-3'
const wrongOrders = distinctOrders(nodeOrders).map(([first]) => first as NodeOrder)
const isMirror = ({ permutation }: NodeOrder) => orderClass(permutation) === orderClass(reflections[0] as number[])

describe('a mesh in one wrong order', () => {
  test.each(wrongOrders.filter(order => !isMirror(order) && !isAlsoValid(order)))(
    '$id: its button makes all valid, and a note says so',
    async order => {
      const { survey, order: found } = await surveyOf(writtenIn(order, elbow))
      expect(survey.check.valid).toBeLessThan(100)
      expect(found?.id).toBe(order.id)
      const { fixes } = survey.overview('a', found)
      expect(fixes).toEqual([{ id: `order-${order.id}`, words: `Take the nodes in the order “${order.name}”` }])
      const better = await surveyOf(mended(survey.check, `order-${order.id}`))
      expect(better.survey.check.valid).toBe(elbow.cells.length / 8)
      expect(better.order).toBe(null)
      const { sentences, fixes: left } = better.survey.overview('a', better.order)
      expect(sentences.join(' ')).toContain(`have been taken here in the order “${order.name}”`)
      expect(left).toEqual([])
      expect(new Set(survey.check.mesh.cells)).toEqual(new Set(better.survey.check.mesh.cells))
    },
  )

  test('that only mirrors it has the button for mirrored cells alone', async () => {
    const { survey, order } = await surveyOf(writtenIn(wrongOrders.find(isMirror) as NodeOrder, elbow))
    expect(order).toBe(null)
    expect(survey.overview('a', order).fixes.map(({ id }) => id)).toEqual(['mirrored'])
  })

  test('nobody has stated: the open cells are answered in it, mirrored ones as well', async () => {
    for (const [element, id] of [
      [voxelOrder, 'lexicographic'],
      [mirroredCube, 'med'],
    ] as const) {
      const { survey, order } = await surveyOf({ ...meshOf([element, element]), isOrderStated: false })
      expect(survey.check.unanswered).toBe(2)
      expect(order?.id).toBe(id)
      const better = await surveyOf(mended(survey.check, `order-${id}`))
      expect(better.survey.check).toMatchObject({ valid: 2, unanswered: 0 })
    }
  })

  test('keeps a cell unanswered that is not finite', async () => {
    const { survey, order } = await surveyOf(meshOf([voxelOrder, notFinite, voxelOrder]))
    expect(order?.id).toBe('lexicographic')
    const better = await surveyOf(mended(survey.check, 'order-lexicographic'))
    expect(better.survey.check).toMatchObject({ valid: 2, unanswered: 1 })
  })
})

describe('no order is offered', () => {
  const next = randomSource(5)
  const noisy = Array.from({ length: 300 }, () => randomHexahedron(next, 0.35))
  test.each([
    ['where all are valid', [unitCube, unitCube]],
    ['where one cell is valid in none', [voxelOrder, invalidCorner, voxelOrder]],
    ['where some are in it and some are not', [voxelOrder, unitCube, voxelOrder]],
    ['where cells are bad in no particular way', noisy],
    ['where half are in it', [voxelOrder, voxelOrder, unitCube, unitCube]],
    ['where nothing is finite', [notFinite, notFinite]],
  ])('%s', async (_, elements) => {
    expect((await surveyOf(meshOf(elements))).order).toBe(null)
  })

  test.each(wrongOrders.filter(isAlsoValid))(
    'where most are valid in their own, if all are in another, too: $id',
    async order => {
      const { survey, order: found } = await surveyOf(writtenIn(order, elbow))
      expect(survey.check.invalid).toBeGreaterThan(0)
      expect(survey.check.valid).toBeGreaterThan(7000)
      expect(found).toBe(null)
    },
  )

  test('where the first cells would be valid in it, and one that is looked at last is not', async () => {
    const good = Array.from({ length: 40 }, () => voxelOrder)
    // It is valid in the page's order alone, and the least bad: it comes last.
    const survey = await surveyOf(meshOf([...good, unitCube]))
    expect(survey.order).toBe(null)
    let asked = 0
    const counting = ((points, cells, wanted) => {
      asked++
      return classifyCells(points, cells, wanted)
    }) as ClassifyCells
    await wholeOrderOf(survey.survey.check, { classify: counting, core })
    expect(asked).toBe(1)
  })
})
