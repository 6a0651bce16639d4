/** Meshes that are made for tests, and what checks them. */
import { readFileSync } from 'node:fs'
import { loadBatchCore } from '../../web/core/batch/batch-core'
import { type CheckOptions, type ClassifyCells, checkMesh } from '../../web/mesh/check'
import type { Mesh } from '../../web/mesh/mesh'
import { MeshBuilder } from '../../web/mesh/mesh-builder'
import type { MeshCheck } from '../../web/mesh/mesh-check'
import { core, unitCube } from './core-fixtures'

const batch = await loadBatchCore(
  new WebAssembly.Module(readFileSync(new URL('../../build/hexlens-batch.wasm', import.meta.url))),
)

export const classifyCells = (async (points, cells, wanted) =>
  batch.classify({ points, cells, firstPoint: 0 }, wanted, {
    worst: wanted.worst ? { few: wanted.worst, limit: Infinity } : null,
  })) as ClassifyCells

export function checked(mesh: Mesh, options: Partial<CheckOptions> = {}): Promise<MeshCheck> {
  return checkMesh(
    mesh,
    { classify: classifyCells, core },
    { worst: 10, minRelative: null, skipsDegenerate: false, ...options },
  )
}

/** A mesh of elements that share nothing; ids count from 1. */
export function builderOf(elements: readonly (readonly number[])[], hasIds = true): MeshBuilder {
  const builder = new MeshBuilder('Made', 'made')
  for (const [i, element] of elements.entries()) {
    const first = builder.pointCount
    for (let v = 0; v < 24; v += 3)
      builder.point(element[v] as number, element[v + 1] as number, element[v + 2] as number)
    builder.hexahedron(
      [0, 1, 2, 3, 4, 5, 6, 7].map(v => first + v),
      hasIds ? i + 1 : null,
    )
  }
  return builder
}

export function meshOf(elements: readonly (readonly number[])[], hasIds = true): Mesh {
  return builderOf(elements, hasIds).mesh()
}

export function moved(vertex: number, to: readonly [number, number, number], element: readonly number[] = unitCube) {
  return element.flatMap((x, i) => (Math.floor(i / 3) === vertex ? [to[i % 3] as number] : [x]))
}

export const mirroredCube = unitCube.map((x, i) => (i % 3 === 0 ? -x : x))
/** The cube's vertices in the order of VTK_VOXEL. */
export const voxelOrder = [0, 1, 3, 2, 4, 5, 7, 6].flatMap(v => unitCube.slice(3 * v, 3 * v + 3))
/** All of it is flat. */
export const flat = unitCube.map((x, i) => (i % 3 === 2 ? 0 : x))
/** Vertex 1 lies on vertex 0. */
export const collapsedEdge = moved(1, [0, 0, 0])
export const invalidCorner = moved(6, [0.25, 0.25, 0.25])
export const notFinite = moved(6, [1, Number.NaN, 1])

/** A Gmsh file of version 2.2; element ids count up from `firstId`, physical group 7 has a name. */
export function mshText(elements: readonly (readonly number[])[], firstId = 1): string {
  const nodes = elements.flatMap((element, e) =>
    [0, 1, 2, 3, 4, 5, 6, 7].map(v => `${8 * e + v + 1} ${element.slice(3 * v, 3 * v + 3).join(' ')}`),
  )
  const cells = elements.map(
    (_, e) => `${firstId + e} 5 2 7 1 ${[1, 2, 3, 4, 5, 6, 7, 8].map(v => 8 * e + v).join(' ')}`,
  )
  return [
    '$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n3 7 "left, wall"\n$EndPhysicalNames',
    `$Nodes\n${nodes.length}\n${nodes.join('\n')}\n$EndNodes`,
    `$Elements\n${cells.length}\n${cells.join('\n')}\n$EndElements\n`,
  ].join('\n')
}
