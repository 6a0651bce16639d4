/**
 * A mesh that nobody sees, opened while nothing else is to do: an engine makes fast code of what has run for a while, and the first mesh that
 * somebody opens finds it.
 */

/** Cells along each axis: enough for all that decide together. */
const SIDE = 42
const VTK_HEXAHEDRON = 12

/**
 * Parts of an edge by which points are moved: with the least a few cells in a thousand are invalid, with the greatest most are, which runs more of
 * the code. As often as an engine needs until it has made its fastest.
 */
const NOISES = [0.6, 1.4, 0.6]

/** A mesh to be opened, and whether all of its check is wanted, beyond what is shown first. */
export interface Practice {
  readonly noise: number
  readonly isWhole: boolean
}

/** The meshes of a practice. The last one alone is checked as a whole: whoever opens a mesh early does without that. */
export const PRACTICE: readonly Practice[] = NOISES.map((noise, i) => ({ noise, isWhole: i === NOISES.length - 1 }))

/** As programs write large meshes: VTU, appended, raw, with indices of 64 bits. */
export function practiceFile(noise: number): File {
  const along = SIDE + 1
  const count = SIDE ** 3
  const points = new Float64Array(3 * along ** 3)
  // A generator of Lehmer's: the same mesh each time.
  let seed = 1
  for (let i = 0; i < points.length; ++i) {
    seed = (48271 * seed) % 0x7fffffff
    const point = Math.floor(i / 3)
    const place = [point % along, Math.floor(point / along) % along, Math.floor(point / along ** 2)][i % 3] as number
    points[i] = place + noise * (seed / 0x7fffffff - 0.5)
  }
  const around = [0, 1, along + 1, along]
  const offsets = [...around, ...around.map(step => step + along ** 2)]
  const cells = new Uint32Array(16 * count)
  for (let at = 0, z = 0; z < SIDE; ++z)
    for (let y = 0; y < SIDE; ++y)
      for (let x = 0; x < SIDE; ++x)
        for (const offset of offsets) {
          cells[at] = x + along * (y + along * z) + offset
          at += 2
        }
  const ends = new Uint32Array(2 * count)
  for (let cell = 0; cell < count; ++cell) ends[2 * cell] = 8 * (cell + 1)
  const lists = [points, cells, ends, new Uint8Array(count).fill(VTK_HEXAHEDRON)]
  let offset = 0
  const [atPoints, atCells, atEnds, atTypes] = lists.map(({ byteLength }) => {
    const own = offset
    offset += 8 + byteLength
    return `format="appended" offset="${own}"/>`
  })
  const head = `<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" header_type="UInt64"><UnstructuredGrid>
<Piece NumberOfPoints="${along ** 3}" NumberOfCells="${count}"><Points><DataArray type="Float64" NumberOfComponents="3" ${atPoints}</Points>
<Cells><DataArray type="Int64" Name="connectivity" ${atCells}<DataArray type="Int64" Name="offsets" ${atEnds}
<DataArray type="UInt8" Name="types" ${atTypes}</Cells></Piece></UnstructuredGrid><AppendedData encoding="raw">_`
  const parts = lists.flatMap(list => [Uint32Array.of(list.byteLength, 0), list])
  return new File([head, ...parts, '</AppendedData></VTKFile>'], 'practice.vtu')
}
