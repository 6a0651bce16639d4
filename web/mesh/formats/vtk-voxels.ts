/** Voxels of VTK's files that are no boxes along the axes: some programs write hexahedra as voxels. */

export class NotBoxes {
  #count = 0
  /** The index of the first. */
  #first = 0
  #inOtherOrder = 0

  /** A voxel's corners lie on two planes along each axis, those of vertex 0 and of vertex 7. */
  check(points: Float64Array, list: Uint32Array, start: number, tolerance: number, index: number): void {
    const isBox = (bits: readonly number[]): boolean => {
      for (let axis = 0; axis < 3; ++axis) {
        const low = points[3 * (list[start] as number) + axis] as number
        const far = bits.indexOf(7)
        const high = points[3 * (list[start + far] as number) + axis] as number
        const within = tolerance * Math.max(Math.abs(low), Math.abs(high))
        for (let v = 0; v < 8; ++v) {
          const value = points[3 * (list[start + v] as number) + axis] as number
          // A corner that is not finite makes the cell unanswered anyway.
          if (Math.abs(value - ((((bits[v] as number) >> axis) & 1) === 1 ? high : low)) > within) return false
        }
      }
      return true
    }
    if (isBox([0, 1, 2, 3, 4, 5, 6, 7])) return
    if (this.#count++ === 0) this.#first = index
    if (isBox([0, 1, 3, 2, 4, 5, 7, 6])) this.#inOtherOrder++
  }

  /** True if none of them would be a box in the order of a hexahedron. */
  get isOrderCertain(): boolean {
    return this.#inOtherOrder === 0
  }

  /** Null where all voxels are boxes. */
  note(): string | null {
    if (this.#count === 0) return null
    const which = `${this.#count} of the voxels (type 11) ${this.#count === 1 ? 'is no box' : 'are no boxes'} along the axes in the order of a voxel, first the hexahedron of index ${this.#first}`
    return this.isOrderCertain
      ? `${which}: they are answered as hexahedra with these corners.`
      : `${which}; ${this.#inOtherOrder} would be in the order of a hexahedron (type 12), so the order of their nodes is not certain.`
  }
}
