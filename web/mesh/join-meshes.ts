/** The meshes of one file as one. */
import type { Mesh } from './mesh'

/** Points, cells, names and counts one after the other; the mesh itself where there is but one. */
export function joined(meshes: readonly [Mesh, ...Mesh[]]): Mesh {
  if (meshes.length === 1) return meshes[0]
  const points = concatenated(
    meshes.map(mesh => mesh.points),
    length => new Float64Array(length),
  )
  const other = new Map<string, number>()
  for (const mesh of meshes) for (const [type, count] of mesh.other) other.set(type, (other.get(type) ?? 0) + count)
  return {
    format: [...new Set(meshes.map(({ format }) => format))].join(', '),
    points,
    cells: joinedIndices(meshes, mesh => mesh.cells),
    ids: joinedIds(meshes),
    blocks: joinedBlocks(meshes),
    notTrilinear: {
      corners: joinedIndices(meshes, mesh => mesh.notTrilinear.corners),
      straight: joinedStraight(meshes),
    },
    other,
    notes: [
      `There are ${meshes.length} meshes in this file; they are taken together.`,
      ...new Set(meshes.flatMap(({ notes }) => notes)),
    ],
    isOrderStated: meshes.every(({ isOrderStated }) => isOrderStated),
    isCutOff: meshes.some(({ isCutOff }) => isCutOff),
    coordinatePlaces: null,
    ...joinedSteps(meshes),
  }
}

/** None where the meshes have other ones. */
function joinedSteps(meshes: readonly [Mesh, ...Mesh[]]): Pick<Mesh, 'steps' | 'isSteady'> {
  const [{ steps }, ...others] = meshes
  const areSame = others.every(other => other.steps.join('\n') === steps.join('\n'))
  return areSame ? { steps, isSteady: meshes.every(({ isSteady }) => isSteady === true) } : { steps: [] }
}

function concatenated<T extends Float64Array | Uint32Array>(lists: readonly T[], make: (length: number) => T): T {
  const whole = make(lists.reduce((sum, { length }) => sum + length, 0))
  let at = 0
  for (const list of lists) {
    whole.set(list as never, at)
    at += list.length
  }
  return whole
}

function joinedIndices(meshes: readonly Mesh[], listOf: (mesh: Mesh) => Uint32Array): Uint32Array {
  let before = 0
  const lists = meshes.map(mesh => {
    const own = before
    before += mesh.points.length / 3
    return own === 0 ? listOf(mesh) : listOf(mesh).map(index => index + own)
  })
  return concatenated(lists, length => new Uint32Array(length))
}

/** Null where a mesh with cells has none. */
function joinedIds(meshes: readonly Mesh[]): Mesh['ids'] {
  const withCells = meshes.filter(({ cells }) => cells.length > 0)
  if (withCells.length === 0 || withCells.some(({ ids }) => ids === null)) return null
  if (withCells.every(({ ids }) => ids instanceof Float64Array))
    return concatenated(
      withCells.map(({ ids }) => ids as Float64Array),
      length => new Float64Array(length),
    )
  return withCells.flatMap(({ ids }) => Array.from(ids as ArrayLike<number | string>, String))
}

function joinedBlocks(meshes: readonly Mesh[]): Mesh['blocks'] {
  let before = 0
  return meshes.flatMap(({ cells, blocks }) => {
    const own = before
    before += cells.length / 8
    return blocks.map(block => ({ name: block.name, cells: block.cells.map(cell => cell + own) }))
  })
}

/** Null where a mesh with such cells was not looked at. */
function joinedStraight(meshes: readonly Mesh[]): number | null {
  const counts = meshes.filter(({ notTrilinear }) => notTrilinear.corners.length > 0)
  if (counts.length === 0 || counts.some(({ notTrilinear }) => notTrilinear.straight === null)) return null
  return counts.reduce((sum, { notTrilinear }) => sum + (notTrilinear.straight ?? 0), 0)
}
