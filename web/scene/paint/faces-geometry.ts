/**
 * The static grids of the six faces and of the section, which is one face more: (s, t, face) at every grid point, and the indices of the
 * faces face by face, tile by tile.
 */
import { BufferAttribute, BufferGeometry } from 'three'
import { faces } from '../../model/hexahedron'

/** The section's number among the faces. */
export const SECTION = faces.length

/** Quads along each side of a face, at the finest. */
export const FACE_QUADS = 32
/** Tiles along each side of a face, which are sorted by depth when faces are see-through. */
export const FACE_TILES = 8

const SIDE = FACE_QUADS + 1
const TILES_PER_FACE = FACE_TILES * FACE_TILES
export const TILE_COUNT = faces.length * TILES_PER_FACE
/** Every tile, face by face. */
const ALL_TILES = Uint16Array.from({ length: TILE_COUNT }, (_, tile) => tile)

/** (s, t) in the middle of a tile of a face; tiles are numbered t first. */
export function tileMiddle(tile: number): readonly [number, number] {
  const ofFace = tile % TILES_PER_FACE
  return [(Math.floor(ofFace / FACE_TILES) + 0.5) / FACE_TILES, ((ofFace % FACE_TILES) + 0.5) / FACE_TILES]
}

export function faceOfTile(tile: number): number {
  return Math.floor(tile / TILES_PER_FACE)
}

export function tilesOfFaces(order: readonly number[]): Uint16Array {
  const tiles = new Uint16Array(order.length * TILES_PER_FACE)
  order.forEach((face, i) => {
    tiles.set(ALL_TILES.subarray(face * TILES_PER_FACE, (face + 1) * TILES_PER_FACE), i * TILES_PER_FACE)
  })
  return tiles
}

/**
 * The division of a bilinear patch whose triangles are within OFF pixels of it: in a quad of n x n the middle lies
 * |twist| / (4 n^2) off the diagonal. `twist` is p(0,0) - p(1,0) - p(0,1) + p(1,1), in pixels. Much less than a pixel: near an edge
 * on which jacdet is almost zero two faces almost touch, and triangles would come through each other in black and white teeth.
 */
const OFF = 1 / 8

export function quadsPerTileFor(twist: number): number {
  for (let quads = 1; quads < FACE_QUADS / FACE_TILES; quads *= 2)
    if (twist <= 4 * OFF * (quads * FACE_TILES) ** 2) return quads
  return FACE_QUADS / FACE_TILES
}

/** Writes the tiles' indices, in order, to the front of `indices` and returns their number. Each tile has 1, 2 or 4 quads along its side. */
export function writeIndices(indices: Uint16Array, tiles: Uint16Array, quadsPerTile: number): number {
  const quad = FACE_QUADS / FACE_TILES / quadsPerTile
  let count = 0
  for (const tile of tiles) {
    const ofFace = tile % TILES_PER_FACE
    const corner = faceOfTile(tile) * SIDE * SIDE
    const i0 = Math.floor(ofFace / FACE_TILES) * quad * quadsPerTile
    const j0 = (ofFace % FACE_TILES) * quad * quadsPerTile
    for (let i = 0; i < quadsPerTile; i++) {
      for (let j = 0; j < quadsPerTile; j++) {
        const a = corner + (i0 + i * quad) * SIDE + j0 + j * quad
        const [b, c, d] = [a + quad * SIDE, a + quad, a + quad * SIDE + quad]
        indices[count++] = a
        indices[count++] = b
        indices[count++] = c
        indices[count++] = c
        indices[count++] = b
        indices[count++] = d
      }
    }
  }
  return count
}

export function createFacesGeometry(): BufferGeometry {
  return gridsOf(0, faces.length)
}

export function createSectionGeometry(): BufferGeometry {
  return gridsOf(SECTION, 1)
}

function gridsOf(first: number, count: number): BufferGeometry {
  const points: number[] = []
  for (let face = first; face < first + count; face++)
    for (let i = 0; i < SIDE; i++) for (let j = 0; j < SIDE; j++) points.push(i / FACE_QUADS, j / FACE_QUADS, face)
  const indices = new Uint16Array(count * FACE_QUADS * FACE_QUADS * 6)
  writeIndices(indices, ALL_TILES.subarray(0, count * TILES_PER_FACE), FACE_QUADS / FACE_TILES)
  const geometry = new BufferGeometry()
  geometry.setAttribute('facePoint', new BufferAttribute(Float32Array.from(points), 3))
  geometry.setIndex(new BufferAttribute(indices, 1))
  return geometry
}
