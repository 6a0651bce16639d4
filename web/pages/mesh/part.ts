/** The mesh that the page begins with: an elbow of a pipe, solid, in which some points are misplaced. */
import { vtkFile } from './vtk-file'

/** Cells along an edge of the square in the middle, from there to the wall, and along the pipe. */
const CORE = 8
const RING = 6
const ALONG = 20

/** Radii: of the pipe, of its axis about the bend, and half the side of the square in the middle. */
const RADIUS = 1
const BEND = 2.2
const HALF_CORE = 0.42
/** Straight pieces at both ends, each of so many cells. */
const STRAIGHT = 4

/**
 * Points that are off: which, and by how much. Three are pushed through a face of their cells. The others, in groups of two to five, were
 * drawn at random and moved on until corners, centre and Gauss points accept the one cell that they leave invalid.
 */
const MISPLACED: readonly (readonly [point: number, x: number, y: number, z: number])[] = [
  [2194, 0.1, 0.05, 0.02],
  [2990, -0.1, -0.1, 0],
  [3396, 0.12, 0, -0.1],
  [7448, 0.138, 0.028, 0.035],
  [7721, 0.088, 0.013, 0.103],
  [7743, 0.0515, -0.062, 0.08],
  [7470, 0.0935, -0.0405, -0.0075],
  [152, -0.0855, 0.0285, -0.038],
  [119, 0.093, 0.043, -0.0405],
  [7042, -0.0445, -0.015, -0.0045],
  [7074, 0.139, 0.124, -0.161],
  [6800, -0.012, 0.018, -0.0035],
  [6801, 0.004, -0.048, 0.09],
  [7073, 0.161, 0.031, -0.0375],
  [5806, 0.0255, 0.024, -0.053],
  [5533, -0.005, 0.029, 0.054],
  [5796, -0.07, -0.0185, -0.04],
  [5797, 0.0835, -0.032, 0.019],
  [5524, 0.006, 0.107, 0.041],
]

export interface Part {
  readonly points: Float64Array
  readonly cells: Uint32Array
}

/** As it should be. */
export function elbow(): Part {
  const section = sectionOf()
  const levels = ALONG + 2 * STRAIGHT + 1
  const points = new Float64Array(3 * levels * section.points.length)
  let at = 0
  for (let level = 0; level < levels; ++level)
    for (const [u, v] of section.points) {
      points.set(placeOf(level, u, v), at)
      at += 3
    }
  const cells: number[] = []
  for (let level = 0; level + 1 < levels; ++level)
    for (const quad of section.quads)
      for (const upper of [0, 1]) for (const point of quad) cells.push(point + (level + upper) * section.points.length)
  return { points, cells: Uint32Array.from(cells) }
}

export function part(): Part {
  const { points, cells } = elbow()
  for (const [point, ...by] of MISPLACED)
    for (const [axis, step] of by.entries()) points[3 * point + axis] = (points[3 * point + axis] as number) + step
  return { points, cells }
}

/** The part as a file, so that it is opened as any other. */
export function partFile(): File {
  return vtkFile('elbow.vtk', 'An elbow with misplaced points', part())
}

interface Section {
  /** In the unit disc. */
  readonly points: readonly (readonly [number, number])[]
  readonly quads: readonly (readonly [number, number, number, number])[]
}

/** A square in the middle, bulged, and rings of quadrilaterals from its rim to the circle. */
function sectionOf(): Section {
  const points: (readonly [number, number])[] = []
  const quads: (readonly [number, number, number, number])[] = []
  const core = (i: number, j: number) => i + (CORE + 1) * j
  for (let j = 0; j <= CORE; ++j)
    for (let i = 0; i <= CORE; ++i) points.push(inCore((2 * i) / CORE - 1, (2 * j) / CORE - 1))
  for (let j = 0; j < CORE; ++j)
    for (let i = 0; i < CORE; ++i) quads.push([core(i, j), core(i + 1, j), core(i + 1, j + 1), core(i, j + 1)])
  const rim = [
    ...Array.from({ length: CORE }, (_, i) => core(i, 0)),
    ...Array.from({ length: CORE }, (_, j) => core(CORE, j)),
    ...Array.from({ length: CORE }, (_, i) => core(CORE - i, CORE)),
    ...Array.from({ length: CORE }, (_, j) => core(0, CORE - j)),
  ]
  let inner = rim
  for (let ring = 1; ring <= RING; ++ring) {
    const way = ring / RING
    const outer = rim.map((point, k) => {
      const [x, y] = points[point] as readonly [number, number]
      const angle = ((k / rim.length) * 2 - 0.75) * Math.PI
      points.push([x + way * (Math.cos(angle) - x), y + way * (Math.sin(angle) - y)])
      return points.length - 1
    })
    for (const [k, point] of inner.entries()) {
      const next = (k + 1) % rim.length
      quads.push([point, outer[k] as number, outer[next] as number, inner[next] as number])
    }
    inner = outer
  }
  return { points, quads }
}

/** The square's sides are bent outwards, so that no angle at its corners is flat. */
function inCore(x: number, y: number): readonly [number, number] {
  const bulge = 0.18
  return [HALF_CORE * x * (1 + bulge * (1 - y * y)), HALF_CORE * y * (1 + bulge * (1 - x * x))]
}

/** A point of the section at a level: straight, about the bend, and straight again. */
function placeOf(level: number, u: number, v: number): readonly [number, number, number] {
  const step = (BEND * Math.PI) / 2 / ALONG
  const turned = Math.max(0, Math.min(ALONG, level - STRAIGHT)) / ALONG
  const angle = (turned * Math.PI) / 2
  const beyond = step * (level - STRAIGHT - turned * ALONG)
  const radius = BEND - RADIUS * u
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)]
  return [BEND - radius * cos + beyond * sin, RADIUS * v, radius * sin + beyond * cos]
}
