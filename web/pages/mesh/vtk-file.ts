/** An example as a file that Gmsh and others read. */

export function vtkFile(
  name: string,
  title: string,
  { points, cells }: { readonly points: Float64Array; readonly cells: Uint32Array },
): File {
  const lines = [
    '# vtk DataFile Version 3.0',
    title,
    'ASCII',
    'DATASET UNSTRUCTURED_GRID',
    `POINTS ${points.length / 3} double`,
    ...rows(points, 3),
    `CELLS ${cells.length / 8} ${(9 * cells.length) / 8}`,
    ...rows(cells, 8).map(row => `8 ${row}`),
    `CELL_TYPES ${cells.length / 8}`,
    ...Array.from({ length: cells.length / 8 }, () => '12'),
  ]
  return new File([`${lines.join('\n')}\n`], name)
}

function rows(numbers: Float64Array | Uint32Array, length: number): string[] {
  return Array.from({ length: numbers.length / length }, (_, i) =>
    numbers.subarray(length * i, length * (i + 1)).join(' '),
  )
}
