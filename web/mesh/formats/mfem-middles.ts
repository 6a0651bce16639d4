/**
 * The further nodes of MFEM's hexahedra of order 2 in a continuous space: after those of the vertices come one an edge, one a face and one
 * an element. Edges and faces are numbered as elements name them first (Mesh::GetElementToEdgeTable, GetElementToFaceTable).
 */
import { areAtMiddles } from '../middles'

const EDGES = [0, 1, 1, 2, 3, 2, 0, 3, 4, 5, 5, 6, 7, 6, 4, 7, 0, 4, 1, 5, 2, 6, 3, 7] as const
const FACES = [3, 2, 1, 0, 0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7, 4, 5, 6, 7] as const

/** True for hexahedra with nodes at the middles; null if the number of nodes is another. */
export function straightHexahedra(
  cells: readonly number[],
  vertexCount: number,
  nodeCount: number,
  coordinate: (node: number, axis: number) => number,
): readonly boolean[] | null {
  const edges = numbered(cells, EDGES, 2)
  const faces = numbered(cells, FACES, 4)
  const elements = cells.length / 8
  if (vertexCount + edges.count + faces.count + elements !== nodeCount) return null
  const firstFace = vertexCount + edges.count
  const firstElement = firstFace + faces.count
  return Array.from({ length: elements }, (_, element) => {
    const others = [
      ...edges.numbers.slice(12 * element, 12 * element + 12).map(edge => vertexCount + edge),
      ...faces.numbers.slice(6 * element, 6 * element + 6).map(face => firstFace + face),
      firstElement + element,
    ]
    return areAtMiddles(coordinate, cells.slice(8 * element, 8 * element + 8), others) === true
  })
}

/** The numbers of all elements' edges or faces, each by the vertices that it has. */
function numbered(cells: readonly number[], corners: readonly number[], size: number) {
  const known = new Map<string, number>()
  const numbers: number[] = []
  for (let at = 0; at < cells.length; at += 8)
    for (let first = 0; first < corners.length; first += size) {
      const vertices = corners.slice(first, first + size).map(vertex => cells[at + vertex] as number)
      const key = vertices.sort((a, b) => a - b).join(' ')
      const number = known.get(key) ?? known.size
      known.set(key, number)
      numbers.push(number)
    }
  return { numbers, count: known.size }
}
