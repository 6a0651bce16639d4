/** Gmsh .msh in ASCII: versions 2 and 4.1, told apart by the first line of $Nodes. Element type 5 is the hexahedron. */
import type { Vec3 } from '../hexahedron'
import { type Format, Refused } from './format'
import { Mesh } from './mesh'
import { toDouble } from './numbers'
import { Scanner, toInteger } from './scanner'

const HEXAHEDRON = '5'

export const gmsh: Format = {
  name: 'Gmsh',
  read(text) {
    const nodes = /^[ \t]*\$Nodes\s*$/m.exec(text)
    const elements = /^[ \t]*\$Elements\s*$/m.exec(text)
    if (nodes === null || elements === null) return null
    const [, version, isBinary] = /^[ \t]*\$MeshFormat\s+([\d.]+)\s+(\d)/m.exec(text) ?? []
    if (isBinary === '1') throw new Refused('This Gmsh file is binary. Save it as ASCII, and it can be read.')
    if (version === '4' || version === '4.0') {
      throw new Refused('This is Gmsh’s format 4.0; the versions 2.2 and 4.1 are read here.')
    }
    const nodeLines = new Scanner(text, nodes.index + nodes[0].length)
    const elementLines = new Scanner(text, elements.index + elements[0].length)
    const header = fieldsOf(nodeLines)
    fieldsOf(elementLines)
    const mesh = new Mesh()
    if (header.length === 1) {
      readNodes2(mesh, nodeLines)
      readElements2(mesh, elementLines)
    } else {
      readNodes4(mesh, nodeLines)
      readElements4(mesh, elementLines)
    }
    return mesh.reading('of type 5, the eight-node hexahedron')
  },
}

/** Empty at the section's end. */
function fieldsOf(lines: Scanner): string[] {
  const line = lines.line()
  return line === null || line.startsWith('$') ? [] : line.split(/\s+/)
}

function pointOf(fields: readonly string[]): Vec3 {
  if (fields.length < 3) throw new Refused('The text ends in the middle of its coordinates.')
  return [toDouble(fields[0] as string), toDouble(fields[1] as string), toDouble(fields[2] as string)]
}

function readNodes2(mesh: Mesh, lines: Scanner): void {
  for (let fields = fieldsOf(lines); fields.length > 0; fields = fieldsOf(lines)) {
    mesh.nodes.set(toInteger(fields[0] as string), pointOf(fields.slice(1)))
  }
}

/** number, type, how many tags, the tags, the nodes */
function readElements2(mesh: Mesh, lines: Scanner): void {
  for (let fields = fieldsOf(lines); fields.length > 0; fields = fieldsOf(lines)) {
    if (fields[1] !== HEXAHEDRON) mesh.addOther()
    else mesh.addHexahedron(`element ${fields[0]}`, fields.slice(3 + Number(fields[2])).map(toInteger))
  }
}

/** Blocks: entity dimension, entity, parametric, how many; then all node numbers, then all points. */
function readNodes4(mesh: Mesh, lines: Scanner): void {
  for (let block = fieldsOf(lines); block.length > 0; block = fieldsOf(lines)) {
    const tags: number[] = []
    while (tags.length < Number(block[3])) {
      const fields = fieldsOf(lines)
      if (fields.length === 0) throw new Refused('The text ends in the middle of its coordinates.')
      tags.push(toInteger(fields[0] as string))
    }
    for (const tag of tags) mesh.nodes.set(tag, pointOf(fieldsOf(lines)))
  }
}

/** Blocks: entity dimension, entity, type, how many; then a number and its nodes on each line. */
function readElements4(mesh: Mesh, lines: Scanner): void {
  for (let block = fieldsOf(lines); block.length > 0; block = fieldsOf(lines)) {
    for (let left = Number(block[3]); left > 0; left--) {
      const fields = fieldsOf(lines)
      if (fields.length === 0) throw new Refused('The text ends in the middle of its cells.')
      if (block[2] !== HEXAHEDRON) mesh.addOther()
      else mesh.addHexahedron(`element ${fields[0]}`, fields.slice(1).map(toInteger))
    }
  }
}
