/**
 * Topology of the trilinear hexahedron in VTK_HEXAHEDRON order: which vertices make an edge or a face, and where they
 * lie in the reference cube [0,1]^3. Data only; every table here has its twin in wasm/src/topology.h and a test compares them.
 */

export type Vec3 = readonly [number, number, number]

/** xi, eta, zeta, or x, y, z. */
export type Axis = 0 | 1 | 2

/** Eight vertices x, y, z in VTK_HEXAHEDRON order, flat: `vertices[3 * v + axis]`. Always 24 finite doubles once accepted. */
export type Vertices = readonly number[]

export const VERTEX_COUNT = 8
export const COORDINATE_COUNT = 24

/** Reference coordinates (xi, eta, zeta) of vertices 0 to 7. */
export const vertexReference: readonly Vec3[] = [
  [0, 0, 0],
  [1, 0, 0],
  [1, 1, 0],
  [0, 1, 0],
  [0, 0, 1],
  [1, 0, 1],
  [1, 1, 1],
  [0, 1, 1],
]

/** End vertices of edges 0 to 11 (VTK order: bottom loop, top loop, uprights). */
export const edgeVertices: readonly (readonly [number, number])[] = [
  [0, 1],
  [1, 2],
  [3, 2],
  [0, 3],
  [4, 5],
  [5, 6],
  [7, 6],
  [4, 7],
  [0, 4],
  [1, 5],
  [3, 7],
  [2, 6],
]

/** Along which reference axis an edge runs. */
export const edgeAxes: readonly number[] = edgeVertices.map(([from, to]) =>
  [0, 1, 2].findIndex(axis => vertexReference[from]?.[axis] !== vertexReference[to]?.[axis]),
)

/** The four edges along xi, eta and zeta. */
export const edgesAlong: readonly (readonly number[])[] = [0, 1, 2].map(axis =>
  edgeAxes.flatMap((along, edge) => (along === axis ? [edge] : [])),
)

/**
 * Faces 0 to 5: -xi, +xi, -eta, +eta, -zeta, +zeta. `axis` is the reference coordinate that is fixed, `side` its value;
 * `s` and `t` are the other two axes in the order xi, eta, zeta; `vertices` are those at (s, t) = 00, 10, 01, 11.
 */
export interface FaceTopology {
  readonly axis: 0 | 1 | 2
  readonly side: 0 | 1
  readonly s: 0 | 1 | 2
  readonly t: 0 | 1 | 2
  readonly vertices: readonly [number, number, number, number]
  readonly name: string
}

export const faces: readonly FaceTopology[] = [
  { axis: 0, side: 0, s: 1, t: 2, vertices: [0, 3, 4, 7], name: '−ξ' },
  { axis: 0, side: 1, s: 1, t: 2, vertices: [1, 2, 5, 6], name: '+ξ' },
  { axis: 1, side: 0, s: 0, t: 2, vertices: [0, 1, 4, 5], name: '−η' },
  { axis: 1, side: 1, s: 0, t: 2, vertices: [3, 2, 7, 6], name: '+η' },
  { axis: 2, side: 0, s: 0, t: 1, vertices: [0, 1, 3, 2], name: '−ζ' },
  { axis: 2, side: 1, s: 0, t: 1, vertices: [4, 5, 7, 6], name: '+ζ' },
]

/** "4–7": an edge by its vertices, the lower one first. */
export function edgeName(edge: number): string {
  return edgeVertices[edge]?.toSorted((a, b) => a - b).join('–') ?? ''
}

/** The vertex's three coordinates. */
export function vertexOf(vertices: Vertices, vertex: number): Vec3 {
  return [vertices[3 * vertex] as number, vertices[3 * vertex + 1] as number, vertices[3 * vertex + 2] as number]
}

export function sameBits(a: Vertices, b: Vertices): boolean {
  return a.length === b.length && a.every((value, i) => Object.is(value, b[i]))
}

/** A copy with one vertex moved. */
export function withVertex(vertices: Vertices, vertex: number, to: Vec3): Vertices {
  const moved = vertices.slice()
  moved.splice(3 * vertex, 3, ...to)
  return moved
}
