/**
 * The cube unfolded: its side faces in a row, seen from outside with zeta upwards, the top and the
 * bottom above and below −η. Places are in cells from the net's upper left, x to the right and y
 * down.
 */
import { edgeVertices, type FaceTopology, faces, type Vec3, vertexReference } from '../../model/hexahedron'
import type { MapCell } from '../../scene/paint/face-raster'

export const NET_COLUMNS = 4
export const NET_ROWS = 3

export interface Place {
  readonly x: number
  readonly y: number
}

/** The cells of faces 0 to 5. */
export const netCells: readonly MapCell[] = [
  { column: 0, row: 1, sToLeft: true, tDown: false },
  { column: 2, row: 1, sToLeft: false, tDown: false },
  { column: 1, row: 1, sToLeft: false, tDown: false },
  { column: 3, row: 1, sToLeft: true, tDown: false },
  { column: 1, row: 2, sToLeft: false, tDown: true },
  { column: 1, row: 0, sToLeft: false, tDown: false },
]

/** A place in the face's own cell, from its upper left, as a point of [0,1]^3. */
export function pointInCell(face: number, x: number, y: number): Vec3 {
  const { sToLeft, tDown } = netCells[face] as MapCell
  return facePoint(face, sToLeft ? 1 - x : x, tDown ? y : 1 - y)
}

export function facePoint(face: number, s: number, t: number): Vec3 {
  const topology = faces[face] as FaceTopology
  const point: [number, number, number] = [0, 0, 0]
  point[topology.axis] = topology.side
  point[topology.s] = s
  point[topology.t] = t
  return point
}

export function isOnFace(face: number, point: Vec3): boolean {
  const { axis, side } = faces[face] as FaceTopology
  return point[axis] === side
}

/** The place of a face's point in the net. */
export function placeOnFace(face: number, point: Vec3): Place {
  const { s, t } = faces[face] as FaceTopology
  const { column, row, sToLeft, tDown } = netCells[face] as MapCell
  return { x: column + (sToLeft ? 1 - point[s] : point[s]), y: row + (tDown ? point[t] : 1 - point[t]) }
}

/** All places of a point: one inside a face, up to three on an edge or vertex, none in the cube. */
export function placesOf(point: Vec3): Place[] {
  const places = faces.flatMap((_, face) => (isOnFace(face, point) ? [placeOnFace(face, point)] : []))
  const isFirst = (place: Place, i: number) => places.findIndex(({ x, y }) => x === place.x && y === place.y) === i
  return places.filter(isFirst)
}

export interface NetCorner extends Place {
  readonly vertex: number
  /** Towards the empty cell in which its number stands: −1 or 1 in x and in y. */
  readonly towards: Place
}

/** The corners of the net with their vertices; every one has an empty cell beside it. */
export const netCorners: readonly NetCorner[] = vertexReference.flatMap((point, vertex) =>
  placesOf(point).map(place => ({ ...place, vertex, towards: emptySide(place) })),
)

function emptySide({ x, y }: Place): Place {
  const isTaken = (column: number, row: number) => netCells.some(cell => cell.column === column && cell.row === row)
  const sides = [-1, 1].flatMap(dx => [-1, 1].map(dy => ({ x: dx, y: dy })))
  const empty = sides.find(side => {
    const [column, row] = [x + Math.min(side.x, 0), y + Math.min(side.y, 0)]
    return column >= 0 && column < NET_COLUMNS && row >= 0 && row < NET_ROWS && !isTaken(column, row)
  })
  return empty ?? { x: 0, y: 0 }
}

/** Both ends of an edge, wherever it is in the net. */
export function edgePlaces(edge: number): (readonly [Place, Place])[] {
  const [from, to] = (edgeVertices[edge] ?? []).map(vertex => vertexReference[vertex] as Vec3)
  if (!from || !to) return []
  return faces.flatMap((_, face) =>
    isOnFace(face, from) && isOnFace(face, to) ? [[placeOnFace(face, from), placeOnFace(face, to)] as const] : [],
  )
}
