/**
 * The static grids of the six faces and of the section, which is one face more: (s, t, face) at every grid point, and the indices of the
 * faces face by face, tile by tile.
 */
import { BufferAttribute, BufferGeometry } from 'three'
import { faces } from '../../model/hexahedron'

/** The section's number among the faces. */
export const SECTION = faces.length

/** Quads along each side of a face; a bilinear patch bends so little that 32 chords are within a pixel of it. */
export const FACE_QUADS = 32
/** Tiles along each side of a face: what is sorted by depth when faces are see-through. */
export const FACE_TILES = 8

const QUADS_PER_TILE = FACE_QUADS / FACE_TILES
export const TILE_COUNT = faces.length * FACE_TILES * FACE_TILES
export const TILE_INDICES = QUADS_PER_TILE * QUADS_PER_TILE * 6
export const FACE_INDICES = FACE_TILES * FACE_TILES * TILE_INDICES

/** (s, t) in the middle of a tile of a face; tiles are numbered t first. */
export function tileMiddle(tileOfFace: number): readonly [number, number] {
  return [(Math.floor(tileOfFace / FACE_TILES) + 0.5) / FACE_TILES, ((tileOfFace % FACE_TILES) + 0.5) / FACE_TILES]
}

/** Indices in the order of faces, and of tiles in a face. */
export function tiledIndices(count: number = faces.length): Uint16Array {
  const side = FACE_QUADS + 1
  const indices: number[] = []
  for (let face = 0; face < count; face++) {
    for (let tile = 0; tile < FACE_TILES * FACE_TILES; tile++) {
      const i0 = Math.floor(tile / FACE_TILES) * QUADS_PER_TILE
      const j0 = (tile % FACE_TILES) * QUADS_PER_TILE
      for (let quad = 0; quad < QUADS_PER_TILE * QUADS_PER_TILE; quad++) {
        const i = i0 + Math.floor(quad / QUADS_PER_TILE)
        const j = j0 + (quad % QUADS_PER_TILE)
        const corner = (face * side + i) * side + j
        indices.push(corner, corner + side, corner + 1, corner + 1, corner + side, corner + side + 1)
      }
    }
  }
  return Uint16Array.from(indices)
}

export function createFacesGeometry(): BufferGeometry {
  return gridsOf(0, faces.length)
}

export function createSectionGeometry(): BufferGeometry {
  return gridsOf(SECTION, 1)
}

function gridsOf(first: number, count: number): BufferGeometry {
  const side = FACE_QUADS + 1
  const points: number[] = []
  for (let face = first; face < first + count; face++)
    for (let i = 0; i < side; i++) for (let j = 0; j < side; j++) points.push(i / FACE_QUADS, j / FACE_QUADS, face)
  const geometry = new BufferGeometry()
  geometry.setAttribute('facePoint', new BufferAttribute(Float32Array.from(points), 3))
  geometry.setIndex(new BufferAttribute(tiledIndices(count), 1))
  return geometry
}
