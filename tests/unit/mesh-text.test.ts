import { readdirSync, readFileSync } from 'node:fs'
import { describe, expect, test } from 'vitest'
import type { Mesh } from '../../web/mesh/mesh'
import { MeshRefusal } from '../../web/mesh/mesh'
import { readMeshes } from '../../web/mesh/read-mesh'
import { fileOfBytes } from '../../web/mesh/source'

const shared = new URL('../../../shared/', import.meta.url)
const pastes = new URL('pastes/', shared)

interface Expected {
  readonly file: string
  readonly hexahedra: number | null
  readonly exit: readonly number[]
  readonly expect: readonly (readonly [string, readonly number[]])[] | null
}

function readFile(url: URL, name: string): readonly Mesh[] {
  return readMeshes(fileOfBytes(name, readFileSync(new URL(name, url))))
}

function readText(text: string, name = 'paste.txt'): Mesh {
  const meshes = readMeshes(fileOfBytes(name, new TextEncoder().encode(text)))
  expect(meshes).toHaveLength(1)
  return meshes[0] as Mesh
}

function refusal(text: string | Uint8Array, name = 'paste.txt'): string {
  const bytes = typeof text === 'string' ? new TextEncoder().encode(text) : text
  try {
    const meshes = readMeshes(fileOfBytes(name, bytes))
    return `read as ${meshes.map(({ format, cells }) => `${format}, ${cells.length / 8}`)}`
  } catch (error) {
    if (error instanceof MeshRefusal) return error.message
    throw error
  }
}

function elements(mesh: Mesh): number[][] {
  return Array.from({ length: mesh.cells.length / 8 }, (_, i) =>
    [...mesh.cells.subarray(8 * i, 8 * i + 8)].flatMap(point => [...mesh.points.subarray(3 * point, 3 * point + 3)]),
  )
}

const expected: readonly Expected[] = JSON.parse(readFileSync(new URL('expected.json', pastes), 'utf8'))
const OTHERS = /^(?:07|09|15|17|18|19|21|22|24|29|31|32|44|49|51|63|68|72|73|75|77|79|80|82)-/
const UNSTATED = /^(?:02|13|26|43|47|53|54|56|57|59|62|65)-/

describe('texts as people post them', () => {
  test.each(expected.filter(({ file }) => !OTHERS.test(file)))('$file', ({ file, hexahedra, exit, expect: wanted }) => {
    let meshes: readonly Mesh[]
    try {
      meshes = readFile(pastes, file)
    } catch (error) {
      expect(error).toBeInstanceOf(MeshRefusal)
      expect(exit, String(error)).toContain(2)
      return
    }
    const found = meshes.flatMap(elements)
    expect(found).toHaveLength(hexahedra ?? found.length)
    for (const [i, [, coordinates]] of (wanted ?? []).entries()) {
      for (const [c, value] of coordinates.entries()) expect(found[i]?.[c]).toBeCloseTo(value, 4)
    }
    for (const mesh of meshes) expect(mesh.isOrderStated, mesh.format).toBe(!UNSTATED.test(file))
  })

  test.each(readdirSync(pastes).filter(name => name.startsWith('min-')))('%s ends quickly', name => {
    const start = performance.now()
    expect(refusal(readFileSync(new URL(name, pastes)), name)).toMatch(/\.$/)
    expect(performance.now() - start).toBeLessThan(1000)
  })
})

void readText
