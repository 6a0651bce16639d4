/** The words about a mesh, from its answers alone. */
import { describe, expect, it } from 'vitest'
import { exitOf, gravestExit } from '../../web/mesh/check'
import { joined } from '../../web/mesh/join-meshes'
import { core, entry, randomHexahedron, randomSource, unitCube } from './core-fixtures'
import {
  builderOf,
  checked,
  classifyCells,
  collapsedEdge,
  flat,
  invalidCorner,
  meshOf,
  mirroredCube,
  moved,
  notFinite,
  voxelOrder,
} from './mesh-fixtures'

const strict = { allowsUnchecked: false }
const lenient = { allowsUnchecked: true }
const scaledBy = (factor: number, element: readonly number[]) => element.map(x => factor * x)

describe('the order from the worst to the best', () => {
  it('begins with volume 0 and a negative minimum, then rises, collapsed cells among the zeros, ties by index', async () => {
    const elements = [
      unitCube,
      flat,
      mirroredCube,
      collapsedEdge,
      notFinite,
      voxelOrder,
      scaledBy(2, mirroredCube),
      flat,
    ]
    const { worst } = await checked(meshOf(elements), { worst: Infinity })
    expect([...worst]).toEqual([5, 2, 6, 1, 3, 7, 0, 4])
  })

  it('is the same for a few as for all, seed 7', async () => {
    const random = randomSource(7)
    const mesh = meshOf(
      Array.from({ length: 500 }, (_, i) => randomHexahedron(random, 0.05 * (i % 9)).map(x => Math.round(8 * x) / 8)),
    )
    const { worst: all } = await checked(mesh, { worst: Infinity })
    expect([...all].sort((a, b) => a - b)).toEqual(Array.from({ length: 500 }, (_, i) => i))
    for (const most of [0, 1, 10, 64, 65, 499])
      expect((await checked(mesh, { worst: most })).worst).toEqual(all.slice(0, most))
    const key = (cell: number) => {
      const result = core.analyze(
        entry(
          Array.from({ length: 500 }, (_, i) => [...mesh.points.subarray(24 * i, 24 * i + 24)]),
          cell,
        ),
      )
      if (!result.ok) throw new Error(result.error.message)
      const { relativeMinimum, boundaryMinimum } = result.value
      return relativeMinimum ?? (boundaryMinimum < 0 ? -Infinity : 0)
    }
    const keys = [...all].map(key)
    for (let i = 1; i < keys.length; ++i) expect(entry(keys, i)).toBeGreaterThanOrEqual(entry(keys, i - 1))
  })
})

describe('counts', () => {
  it('are those of the verdicts; a cell with coincident vertices is degenerate whatever its ids', async () => {
    const check = await checked(meshOf([unitCube, collapsedEdge, invalidCorner, flat, notFinite]))
    expect(check).toMatchObject({ hexahedra: 5, valid: 1, invalid: 3, unanswered: 1, degenerate: 2, below: 0 })
    expect(exitOf(check, strict)).toBe(1)
  })

  it('coincident vertices are found as the core finds them, seed 3', async () => {
    const random = randomSource(3)
    const elements = Array.from({ length: 2000 }, (_, i) =>
      i % 2 ? unitCube.map(() => Math.floor(3 * random())) : randomHexahedron(random, 0.2),
    )
    const mesh = meshOf(elements)
    const reports = elements.map(element => core.analyze(element)).map(result => (result.ok ? result.value : null))
    const expected = Uint8Array.from(reports, report => (report && report.coincident.length > 0 ? 1 : 0))
    const { coincident } = await classifyCells(mesh.points, mesh.cells, { coincident: true })
    expect(coincident).toEqual(expected)
  })

  it('with degenerate cells skipped these count there alone and are not among the worst', async () => {
    const mesh = meshOf([unitCube, collapsedEdge, invalidCorner])
    const check = await checked(mesh, { skipsDegenerate: true, minRelative: 2 })
    expect(check).toMatchObject({ hexahedra: 3, valid: 1, invalid: 1, degenerate: 1, below: 2 })
    expect([...check.worst]).toEqual([2, 0])
    const rest = await checked(meshOf([unitCube, collapsedEdge]), { skipsDegenerate: true })
    expect(exitOf(rest, strict)).toBe(0)
  })

  it('below a bound are those of a lesser relative minimum, flat cells among the zeros', async () => {
    const mesh = meshOf([unitCube, scaledBy(1e-3, moved(6, [1, 1, 0.5])), flat, voxelOrder])
    const below = async (minRelative: number) => (await checked(mesh, { minRelative })).below
    expect([
      await below(-1),
      await below(0),
      await below(1e-9),
      await below(0.99),
      await below(1),
      await below(1.1),
    ]).toEqual([1, 1, 2, 3, 3, 4])
    expect(exitOf(await checked(meshOf([unitCube]), { minRelative: 1.5 }), lenient)).toBe(1)
  })

  it('cells of more nodes are answered by their corners, and never count as valid', async () => {
    const builder = builderOf([unitCube])
    builder.notTrilinear([0, 1, 2, 3, 4, 5, 6, 7], true)
    builder.notTrilinear([4, 5, 6, 7, 0, 1, 2, 3], false)
    const check = await checked(builder.mesh())
    expect(check).toMatchObject({ hexahedra: 1, valid: 1, notTrilinear: { count: 2, validByCorners: 1 } })
    expect(check.notes).toEqual([
      '2 cells have more than eight nodes and are not trilinear: by the eight corners 1 would be valid, and 1 has all further nodes at the middles.',
    ])
    expect([exitOf(check, strict), exitOf(check, lenient)]).toEqual([3, 0])
  })
})

describe('the exit status', () => {
  it('is 3 where not all could be answered, and 0 if that is allowed', async () => {
    const cutOff = builderOf([unitCube])
    cutOff.isCutOff = true
    const unordered = builderOf([voxelOrder])
    unordered.isOrderStated = false
    const empty = builderOf([])
    empty.otherCell('tetrahedron', 3)
    for (const mesh of [cutOff.mesh(), unordered.mesh(), empty.mesh(), meshOf([unitCube, notFinite])]) {
      const check = await checked(mesh)
      expect([exitOf(check, strict), exitOf(check, lenient)]).toEqual([3, 0])
    }
    const other = builderOf([unitCube])
    other.otherCell('wedge')
    expect(exitOf(await checked(other.mesh()), strict)).toBe(0)
    expect(exitOf(await checked(meshOf([invalidCorner, notFinite])), lenient)).toBe(1)
  })

  it('of several files is 2 before 1 before 3 before 0', () => {
    expect([
      gravestExit([0, 3, 1, 2]),
      gravestExit([0, 3, 1]),
      gravestExit([3, 0]),
      gravestExit([0, 0]),
      gravestExit([]),
    ]).toEqual([2, 1, 3, 0, 0])
  })
})

describe('sentences', () => {
  it('say how many are mirrored, and why', async () => {
    const cause =
      'are mirrored, jacdet < 0 everywhere in them, because their nodes are numbered the other way round or an axis is reversed; with nodes 0 to 3 and 4 to 7 exchanged they are valid.'
    expect((await checked(meshOf([mirroredCube, mirroredCube]))).notes).toEqual([`All 2 hexahedra ${cause}`])
    expect((await checked(meshOf([mirroredCube, unitCube, mirroredCube]))).notes).toEqual([`2 of 3 hexahedra ${cause}`])
    expect((await checked(meshOf([unitCube, mirroredCube]))).notes[0]).toMatch(
      /^1 of 2 hexahedra is mirrored, .* it is valid\.$/,
    )
    expect((await checked(meshOf([voxelOrder]))).notes).toEqual([])
  })

  it('say which cell is unanswered, and why', async () => {
    const check = await checked(meshOf([unitCube, notFinite]))
    expect(check.notes).toEqual(['The hexahedron 2 is unanswered: vertex 6 y is not a finite number.'])
    expect(check.answerTo(1)).toEqual({ why: 'Vertex 6 y is not a finite number.' })
    expect((await checked(meshOf([notFinite, notFinite], false))).notes).toEqual([
      '2 hexahedra are unanswered, first with index 0: vertex 6 y is not a finite number.',
    ])
  })

  it('say in which other order bare points are valid, if they are not in that of the text: then the verdict is open', async () => {
    const said = async (...elements: (readonly number[])[]) => {
      const builder = builderOf(elements)
      builder.isOrderStated = false
      return checked(builder.mesh())
    }
    const lexicographic = 'in the order “Lexicographic” (deal.II, DOLFINx, VTK_VOXEL)'
    const open = await said(voxelOrder)
    expect(open).toMatchObject({ valid: 0, invalid: 0, unanswered: 1 })
    expect(open.notes).toEqual([
      `It is not stated in which order the nodes are, so the verdict is open: in the order of the text the hexahedron is not valid, ${lexicographic} it is.`,
    ])
    expect(open.answerTo(0)).toEqual({
      why: 'The order of its nodes is not stated; in the order “Lexicographic” it is valid.',
    })
    expect(await said(unitCube)).toMatchObject({ valid: 1, unanswered: 0, notes: [] })
    expect(await said(flat)).toMatchObject({ invalid: 1, unanswered: 0, notes: [] })
    const several = await said(unitCube, voxelOrder, flat, notFinite)
    expect(several).toMatchObject({ valid: 1, invalid: 1, unanswered: 2 })
    expect([...several.worst]).toEqual([2, 0, 1, 3])
    expect(several.notes).toEqual([
      `It is not stated in which order the nodes are: 1 hexahedron is not valid in the order of the text, but in another, first 2 ${lexicographic}.`,
      'The hexahedron 4 is unanswered: vertex 6 y is not a finite number.',
    ])
  })
})

describe('names', () => {
  it('are those of the file: ids, and the first block', async () => {
    const builder = builderOf([unitCube, invalidCorner, mirroredCube])
    builder.inBlock('b', 1)
    builder.inBlock('a', 1)
    builder.inBlock('a', 2)
    const check = await checked(builder.mesh())
    expect([0, 1, 2].map(check.idOf)).toEqual(['1', '2', '3'])
    expect([0, 1, 2].map(check.blockOf)).toEqual([null, 'b', 'a'])
    expect((await checked(meshOf([unitCube], false))).idOf(0)).toBeNull()
  })

  it('of several meshes in one file stand one after the other', async () => {
    const first = builderOf([unitCube])
    first.inBlock('a', 0)
    first.otherCell('wedge', 2)
    const second = builderOf([invalidCorner, unitCube])
    second.inBlock('b', 1)
    second.otherCell('wedge')
    second.notTrilinear([0, 1, 2, 3, 4, 5, 6, 7], true)
    const check = await checked(joined([first.mesh(), second.mesh()]))
    expect(check).toMatchObject({ hexahedra: 3, valid: 2, invalid: 1, notTrilinear: { count: 1, validByCorners: 0 } })
    expect(check.mesh.other).toEqual(new Map([['wedge', 3]]))
    expect([0, 1, 2].map(check.idOf)).toEqual(['1', '1', '2'])
    expect([0, 1, 2].map(check.blockOf)).toEqual(['a', null, 'b'])
    expect([...check.worst]).toEqual([1, 0, 2])
    expect(check.notes[0]).toBe('There are 2 meshes in this file; they are taken together.')
  })
})
