/** VTK legacy files in ASCII, whole or in part: POINTS and CELLS, in the classical layout or that of version 5.1. */
import type { Vec3 } from '../hexahedron'
import { type Format, Refused } from './format'
import { Mesh } from './mesh'
import { Scanner, toInteger } from './scanner'

const HEXAHEDRON = 12

export const vtk: Format = {
  name: 'VTK',
  read(text) {
    const points = /^[ \t]*POINTS\s+(\d+)\s+\w+/im.exec(text)
    const cells = /^[ \t]*CELLS\s+(\d+)\s+\d+/im.exec(text)
    if (points === null || cells === null) return null
    if (/^[ \t]*BINARY\s*$/im.test(text.slice(0, 1000))) {
      throw new Refused('This VTK file is binary. Save it as ASCII, and it can be read.')
    }
    const mesh = new Mesh()
    readPoints(mesh, new Scanner(text, endOf(points)), Number(points[1]))
    const types = readTypes(text)
    readCells(new Scanner(text, endOf(cells)), Number(cells[1])).forEach((nodes, cell) => {
      const type = types?.[cell]
      if (nodes.length === 8 && (type === undefined || type === HEXAHEDRON)) mesh.addHexahedron(`cell ${cell}`, nodes)
      else mesh.addOther()
    })
    return mesh.reading('a cell of eight points and type 12 (VTK_HEXAHEDRON)')
  },
}

function endOf(match: RegExpExecArray): number {
  return match.index + match[0].length
}

function readPoints(mesh: Mesh, scanner: Scanner, count: number): void {
  for (let node = 0; node < count; node++) {
    mesh.nodes.set(node, [scanner.double(), scanner.double(), scanner.double()] as Vec3)
  }
}

/** Null in a snippet that leaves them out. */
function readTypes(text: string): number[] | null {
  const header = /^[ \t]*CELL_TYPES\s+(\d+)/im.exec(text)
  if (header === null) return null
  const scanner = new Scanner(text, endOf(header))
  return Array.from({ length: countOf(header[1], text) }, () => scanner.integer())
}

function readCells(scanner: Scanner, count: number): number[][] {
  const first = scanner.word()
  if (first.toUpperCase() === 'OFFSETS') return readOffsetCells(scanner, count)
  const cells: number[][] = []
  for (let size = toInteger(first); ; size = scanner.integer()) {
    const cell: number[] = []
    while (cell.length < size) cell.push(scanner.integer())
    cells.push(cell)
    if (cells.length >= count) return cells
  }
}

function readOffsetCells(scanner: Scanner, count: number): number[][] {
  scanner.word()
  const offsets: number[] = []
  while (offsets.length < count) offsets.push(scanner.integer())
  if (scanner.word().toUpperCase() !== 'CONNECTIVITY')
    throw new Refused('After OFFSETS this VTK file lacks CONNECTIVITY.')
  scanner.word()
  return offsets.slice(1).map((end, cell) => {
    const nodes: number[] = []
    for (let i = offsets[cell] as number; i < end; i++) nodes.push(scanner.integer())
    return nodes
  })
}

/** A count that the text is long enough for. */
function countOf(digits: string | undefined, text: string): number {
  const count = Number(digits)
  if (count > text.length) throw new Refused('The text ends in the middle of its cells.')
  return count
}
