/** Points of VTK's legacy files that are implied by numbers along the axes: dimensions, and coordinates or even steps. */
import { MOST_IMPLIED_CELLS } from '../mesh'
import type { LegacyStream } from './vtk-legacy-stream'
import type { NumberType } from './vtk-numbers'

type Triple = [number, number, number]

export class LegacyLattice {
  readonly #stream: LegacyStream
  #sizes: Triple | null = null
  #origin: Triple = [0, 0, 0]
  #spacing: Triple | null = null
  readonly #axes: [Float64Array | null, Float64Array | null, Float64Array | null] = [null, null, null]

  constructor(stream: LegacyStream) {
    this.#stream = stream
  }

  get hasSteps(): boolean {
    return this.#sizes !== null && this.#spacing !== null
  }

  get hasAxes(): boolean {
    return this.#axes.every(axis => axis !== null)
  }

  readSizes(): void {
    this.#sizes = [this.#stream.count(), this.#stream.count(), this.#stream.count()]
  }

  readOrigin(): void {
    this.#origin = this.#stream.triple()
  }

  readSpacing(): void {
    this.#spacing = this.#stream.triple()
  }

  /** Returns the type of the coordinates. */
  readAxis(axis: number): NumberType {
    const count = this.#stream.count()
    const type = this.#stream.type()
    const list = this.#stream.list(count, type, Float64Array, `${'xyz'[axis]} coordinate`)
    if (list.length < count) this.#stream.refuse('a grid whose coordinates are left out has no cells.')
    this.#axes[axis] = list
    return type
  }

  /** The numbers of points along the axes; refuses more than are read. */
  sizes(): Triple {
    const sizes = this.#sizes
    if (sizes === null) return this.#stream.refuse('the grid has no DIMENSIONS.')
    if (sizes.includes(0))
      this.#stream.refuse(`the dimensions are ${sizes.join(' ')}, where counts from 1 on were expected.`)
    const cells = sizes.reduce((product, size) => product * Math.max(1, size - 1), 1)
    const points = sizes.reduce((product, size) => product * size, 1)
    if (cells > MOST_IMPLIED_CELLS || points > 2 * MOST_IMPLIED_CELLS)
      this.#stream.refuse(
        `the dimensions ${sizes.join(' ')} imply ${cells} cells and ${points} points; at most ${MOST_IMPLIED_CELLS} cells and twice as many points are read.`,
      )
    return sizes
  }

  /** The points at all combinations of coordinates, which are given or follow each other in even steps. */
  points(sizes: Readonly<Triple>, areSteps: boolean): Float64Array {
    const [x, y, z] = (areSteps ? this.#evenAxes(sizes) : this.#axes).map((axis, i) => {
      const name = 'XYZ'[i]
      if (axis === null) return this.#stream.refuse(`the grid has no ${name}_COORDINATES.`)
      if (axis.length !== sizes[i])
        this.#stream.refuse(`${name}_COORDINATES has ${axis.length}, the dimension is ${sizes[i]}.`)
      return axis
    }) as [Float64Array, Float64Array, Float64Array]
    const points = new Float64Array(3 * sizes[0] * sizes[1] * sizes[2])
    let at = 0
    for (const zk of z)
      for (const yj of y)
        for (const xi of x) {
          points[at] = xi
          points[at + 1] = yj
          points[at + 2] = zk
          at += 3
        }
    return points
  }

  #evenAxes(sizes: Readonly<Triple>): Float64Array[] {
    return sizes.map((size, axis) => {
      const [origin, step] = [this.#origin[axis] as number, this.#spacing?.[axis] ?? 1]
      return Float64Array.from({ length: size }, (_, i) => origin + i * step)
    })
  }
}
