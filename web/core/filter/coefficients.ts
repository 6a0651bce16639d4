/**
 * Corner values and Bernstein coefficients of jacdet in doubles, docs/algorithm.md (3) to (8), for
 * the filter of a search alone: what passes it is analysed by the core, whose numbers are the ones
 * that count.
 */
import { bernsteinIndex, bernsteinStrides, edgeBernstein, faceBernstein, vertexBernstein } from '../../model/bernstein'
import { faces, type Vec3, vertexReference } from '../../model/hexahedron'

/**
 * True if a corner value of the element whose coordinates begin there is at most `most`. It stops
 * at the first one: each is the determinant of the three edge vectors at the corner.
 */
export function hasCornerAtMost(elements: Float64Array, element: number, most: number): boolean {
  for (let at = 0; at < CORNER_EDGES.length; at += 6) {
    const from = element + (CORNER_EDGES[at] as number)
    const to = element + (CORNER_EDGES[at + 1] as number)
    const from1 = element + (CORNER_EDGES[at + 2] as number)
    const to1 = element + (CORNER_EDGES[at + 3] as number)
    const from2 = element + (CORNER_EDGES[at + 4] as number)
    const to2 = element + (CORNER_EDGES[at + 5] as number)
    const ux = (elements[to] as number) - (elements[from] as number)
    const uy = (elements[to + 1] as number) - (elements[from + 1] as number)
    const uz = (elements[to + 2] as number) - (elements[from + 2] as number)
    const vx = (elements[to1] as number) - (elements[from1] as number)
    const vy = (elements[to1 + 1] as number) - (elements[from1 + 1] as number)
    const vz = (elements[to1 + 2] as number) - (elements[from1 + 2] as number)
    const wx = (elements[to2] as number) - (elements[from2] as number)
    const wy = (elements[to2 + 1] as number) - (elements[from2 + 1] as number)
    const wz = (elements[to2 + 2] as number) - (elements[from2 + 2] as number)
    if ((uy * vz - uz * vy) * wx + (uz * vx - ux * vz) * wy + (ux * vy - uy * vx) * wz <= most) return true
  }
  return false
}

/** Offsets of the ends of each corner's edges along xi, eta and zeta, six a corner. */
const CORNER_EDGES = Uint8Array.from(
  vertexReference.flatMap(corner =>
    [0, 1, 2].flatMap(axis => [0, 1].map(side => coordinatesOf(corner.with(axis, side) as unknown as Vec3))),
  ),
)

/** The index of a vertex's coordinates in an element. */
function coordinatesOf(reference: Vec3): number {
  return 3 * vertexReference.findIndex(point => point.every((x, axis) => x === reference[axis]))
}

/** Edge vectors from vertex to vertex, three numbers each: U_jk at 2j + k, V_ik at 2i + k, W_ij at 2i + j. */
const u = new Float64Array(12)
const v = new Float64Array(12)
const w = new Float64Array(12)
/** U_jk x V_ik at 4i + 2j + k. */
const normals = new Float64Array(24)

/** The index of the vertex ijk in an element, at 4i + 2j + k. */
const FIRST = [0, 1, 2, 3, 4, 5, 6, 7].map(ijk => coordinatesOf([ijk >> 2, (ijk >> 1) & 1, ijk & 1]))

/** Sets the eight corner coefficients of the element whose coordinates begin there. */
export function setCorners(bernstein: Float64Array, elements: Float64Array, element: number): void {
  for (let a = 0; a < 2; ++a)
    for (let b = 0; b < 2; ++b)
      for (let r = 0; r < 3; ++r) {
        const here = element + r
        const to = 3 * (2 * a + b) + r
        u[to] = value(elements, here, 4 + 2 * a + b) - value(elements, here, 2 * a + b)
        v[to] = value(elements, here, 4 * a + 2 + b) - value(elements, here, 4 * a + b)
        w[to] = value(elements, here, 4 * a + 2 * b + 1) - value(elements, here, 4 * a + 2 * b)
      }
  for (let i = 0; i < 2; ++i)
    for (let j = 0; j < 2; ++j)
      for (let k = 0; k < 2; ++k) {
        cross(normals, 3 * (4 * i + 2 * j + k), 3 * (2 * j + k), 3 * (2 * i + k))
        bernstein[bernsteinIndex(2 * i, 2 * j, 2 * k)] = dot(normals, 3 * (4 * i + 2 * j + k), 3 * (2 * i + j))
      }
}

/** Sets the other nineteen, of the element that setCorners was called for just before. */
export function setOthers(b: Float64Array): void {
  for (let m = 0; m < 2; ++m)
    for (let k = 0; k < 2; ++k) {
      b[bernsteinIndex(1, 2 * m, 2 * k)] = 0.5 * (mixed(0, m, k, 1, m) + mixed(1, m, k, 0, m))
      b[bernsteinIndex(2 * m, 1, 2 * k)] = 0.5 * (mixed(m, 0, k, m, 1) + mixed(m, 1, k, m, 0))
    }
  for (let i = 0; i < 2; ++i)
    for (let j = 0; j < 2; ++j) {
      cross(sum, 0, 3 * (2 * j), 3 * (2 * i + 1))
      cross(sum, 3, 3 * (2 * j + 1), 3 * (2 * i))
      b[bernsteinIndex(2 * i, 2 * j, 1)] = 0.5 * (dot(sum, 0, 3 * (2 * i + j)) + dot(sum, 3, 3 * (2 * i + j)))
    }
  let [middles, corners] = [0, 0]
  for (const { middle } of EDGES) middles += b[middle] as number
  for (const corner of vertexBernstein) corners += b[corner] as number
  for (const { centre, s, t } of FACES) {
    const sides = (b[centre - s] as number) + (b[centre + s] as number) + (b[centre - t] as number)
    const ends = (b[centre - s - t] as number) + (b[centre + s + t] as number) + (b[centre - s + t] as number)
    b[centre] = 0.5 * (sides + (b[centre + t] as number)) - 0.25 * (ends + (b[centre + s - t] as number))
  }
  b[CENTRE] = 0.25 * (middles - corners)
}

export const CENTRE = bernsteinIndex(1, 1, 1)
/** The middle of each edge, and the stride to its ends. */
export const EDGES = edgeBernstein.map(([lower, middle]) => ({ middle, stride: middle - lower }))
const FACES = faces.map(({ s, t }, face) => ({
  centre: faceBernstein[face]?.[4] as number,
  s: bernsteinStrides[s],
  t: bernsteinStrides[t],
}))

/** Coefficients on each axis once the element is cut into eight; neighbours share some. */
export const FINE = 5

/**
 * Sets the 125 coefficients of the element's eight halves by halving on each axis in turn, `fine[25 * i + 5 * j + k]`. Those with even
 * indices are values of jacdet.
 */
export function setFine(fine: Float64Array, bernstein: Float64Array): void {
  for (let i = 0; i < 3; ++i)
    for (let j = 0; j < 3; ++j) halve(bernstein, bernsteinIndex(i, j, 0), 1, alongZeta, 15 * i + 5 * j, 1)
  for (let i = 0; i < 3; ++i) for (let k = 0; k < FINE; ++k) halve(alongZeta, 15 * i + k, 5, alongEta, 25 * i + k, 5)
  for (let jk = 0; jk < FINE * FINE; ++jk) halve(alongEta, jk, 25, fine, jk, 25)
}

const alongZeta = new Float64Array(3 * 3 * FINE)
const alongEta = new Float64Array(3 * FINE * FINE)

/** Three coefficients of a quadratic into the five of its halves. */
function halve(from: Float64Array, at: number, step: number, to: Float64Array, first: number, stride: number): void {
  const a = from[at] as number
  const b = from[at + step] as number
  const c = from[at + 2 * step] as number
  const left = (a + b) / 2
  const right = (b + c) / 2
  to[first] = a
  to[first + stride] = left
  to[first + 2 * stride] = (left + right) / 2
  to[first + 3 * stride] = right
  to[first + 4 * stride] = c
}

const sum = new Float64Array(6)

function value(elements: Float64Array, here: number, vertex: number): number {
  return elements[here + (FIRST[vertex] as number)] as number
}

/** (U_jk x V_ik) . W_lm */
function mixed(i: number, j: number, k: number, l: number, m: number): number {
  return dot(normals, 3 * (4 * i + 2 * j + k), 3 * (2 * l + m))
}

function cross(out: Float64Array, to: number, ofU: number, ofV: number): void {
  const ux = u[ofU] as number
  const uy = u[ofU + 1] as number
  const uz = u[ofU + 2] as number
  const vx = v[ofV] as number
  const vy = v[ofV + 1] as number
  const vz = v[ofV + 2] as number
  out[to] = uy * vz - uz * vy
  out[to + 1] = uz * vx - ux * vz
  out[to + 2] = ux * vy - uy * vx
}

function dot(list: Float64Array, from: number, ofW: number): number {
  return (
    (list[from] as number) * (w[ofW] as number) +
    (list[from + 1] as number) * (w[ofW + 1] as number) +
    (list[from + 2] as number) * (w[ofW + 2] as number)
  )
}
