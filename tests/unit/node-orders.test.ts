/** Other orders of the eight points, and what trying them says. */
import { describe, expect, it } from 'vitest'
import type { Vertices } from '../../web/model/hexahedron'
import { distinctOrders, orderClass, reflections, reordered, rotations } from '../../web/model/node-order'
import { nodeOrders } from '../../web/model/node-orders'
import { presets, presetVertices } from '../../web/model/presets'
import { triedOrders } from '../../web/panels/node-order/tried-orders'
import { cases, core, entry, randomHexahedron, randomSource, unitCube } from './core-fixtures'

const AS_GIVEN = [0, 1, 2, 3, 4, 5, 6, 7]
const byId = (id: string) => {
  const found = nodeOrders.find(order => order.id === id)
  if (!found) throw new Error(`There is no order ${id}.`)
  return found
}

function isValid(vertices: Vertices): boolean {
  const result = core.isValid(vertices)
  if (!result.ok) throw new Error(result.error.message)
  return result.value
}

/** `vertices`, which are in this page's order, as a program writes them: its point permutation[i] is our vertex i. */
function writtenIn(permutation: readonly number[], vertices: Vertices): Vertices {
  return reordered(
    vertices,
    AS_GIVEN.map(v => permutation.indexOf(v)),
  )
}

describe('the symmetries of the cube', () => {
  it('are 48 different permutations, half of them rotations', () => {
    for (const list of [rotations, reflections]) {
      expect(new Set(list.map(String)).size).toBe(24)
      for (const symmetry of list) expect(symmetry.toSorted()).toEqual(AS_GIVEN)
    }
    expect(new Set([...rotations, ...reflections].map(String)).size).toBe(48)
    expect(rotations.map(String)).toContain(String(AS_GIVEN))
  })

  it('keep the verdict of every element or make a valid one negative', () => {
    const random = randomSource(48)
    for (let n = 0; n < 40; n++) {
      const vertices = randomHexahedron(random, 0.3)
      const valid = isValid(vertices)
      for (const rotation of rotations) expect(isValid(reordered(vertices, rotation))).toBe(valid)
      for (const reflection of reflections) if (valid) expect(isValid(reordered(vertices, reflection))).toBe(false)
    }
    for (const reflection of reflections) {
      const result = core.analyze(reordered(unitCube, reflection))
      expect(result).toMatchObject({ value: { boundaryMinimum: -1, boundaryMaximum: -1 } })
    }
  })
})

describe('the orders', () => {
  it('have names of their own and are permutations, none of them a rotation of the order as given', () => {
    expect(new Set(nodeOrders.map(({ id }) => id)).size).toBe(nodeOrders.length)
    expect(new Set(nodeOrders.map(({ name }) => name)).size).toBe(nodeOrders.length)
    for (const { permutation, says } of nodeOrders) {
      expect(permutation.toSorted()).toEqual(AS_GIVEN)
      expect(orderClass(permutation)).not.toBe(orderClass(AS_GIVEN))
      expect(says).toMatch(/^[A-Z].*\.$/)
    }
  })

  it('differ by more than a rotation, but for those that are inside out', () => {
    const groups = distinctOrders(nodeOrders).map(group => group.map(({ id }) => id))
    expect(groups.filter(group => group.length > 1)).toEqual([['med', 'top-first']])
    expect(groups.length).toBe(nodeOrders.length - 1)
    expect(distinctOrders(rotations.map(permutation => ({ permutation })))).toEqual([])
    expect(distinctOrders(reflections.map(permutation => ({ permutation }))).length).toBe(1)
  })

  it('are those of their programs: where each has its points in the cube', () => {
    const cube = (id: string) => writtenIn(byId(id).permutation, unitCube)
    const points = (...digits: string[]) => digits.flatMap(each => [...each].map(Number))
    expect(cube('lexicographic')).toEqual(points('000', '100', '010', '110', '001', '101', '011', '111'))
    expect(cube('lexicographic-last')).toEqual(points('000', '001', '010', '011', '100', '101', '110', '111'))
    expect(cube('med')).toEqual(points('000', '010', '110', '100', '001', '011', '111', '101'))
    expect(cube('top-first')).toEqual(points('001', '101', '111', '011', '000', '100', '110', '010'))
    expect(cube('top-backwards')).toEqual(points('000', '100', '110', '010', '001', '011', '111', '101'))
    expect(cube('bottom-backwards')).toEqual(points('000', '010', '110', '100', '001', '101', '111', '011'))
    expect(cube('top-from-1')).toEqual(points('000', '100', '110', '010', '101', '111', '011', '001'))
    expect(cube('top-first-from-1')).toEqual(points('001', '101', '111', '011', '100', '110', '010', '000'))
    expect(cube('uprights')).toEqual(points('000', '001', '100', '101', '110', '111', '010', '011'))
  })

  it('give back a good element that was written in them', () => {
    const random = randomSource(8)
    const good = [unitCube, ...Array.from({ length: 20 }, () => randomHexahedron(random, 0.1))].filter(isValid)
    expect(good.length).toBeGreaterThan(15)
    for (const { id, permutation } of nodeOrders)
      for (const vertices of good) {
        const written = writtenIn(permutation, vertices)
        expect(reordered(written, permutation)).toEqual(vertices)
        // A top turned by a quarter makes another valid element, a twisted one.
        if (isValid(written)) continue
        const { helpful } = triedOrders(core, written)
        expect(helpful.flatMap(({ orders }) => orders.map(order => order.id))).toContain(id)
      }
  })
})

describe('trying them', () => {
  it('names valid elements only, with their minima, the greatest first', () => {
    for (const vertices of [
      ...presets.map(each => presetVertices(each, () => 0.4)),
      ...cases.map(c => c.vertices.flat()),
    ]) {
      const tried = triedOrders(core, vertices)
      expect([tried.vertices, tried.count]).toEqual([vertices, distinctOrders(nodeOrders).length])
      const sizes = tried.helpful.map(({ boundaryMinimum, exponent }) => Math.log2(boundaryMinimum) + exponent)
      expect(sizes).toEqual(sizes.toSorted((a, b) => b - a))
      for (const { vertices: other, boundaryMinimum, orders } of tried.helpful) {
        expect(other).toEqual(reordered(vertices, entry(orders, 0).permutation))
        expect(core.analyze(other)).toMatchObject({ value: { valid: true, boundaryMinimum } })
      }
    }
  })

  it('helps where an element is inside out, and nowhere where its points lie in a plane', () => {
    const inverted = presetVertices(presets.find(({ id }) => id === 'inverted') ?? presets[0])
    expect(triedOrders(core, inverted).helpful[0]?.orders.map(({ id }) => id)).toEqual(['med', 'top-first'])
    expect(
      triedOrders(
        core,
        unitCube.map((x, i) => (i % 3 === 2 ? 0 : x)),
      ).helpful,
    ).toEqual([])
  })
})
