/** Abaqus and CalculiX input: *NODE and *ELEMENT of the eight-node bricks. Node numbers hold within one *PART. */
import { type Format, Refused } from './format'
import { Mesh } from './mesh'
import { toDouble } from './numbers'
import { Scanner, toInteger } from './scanner'

/** Continuum, thermal, acoustic, cohesive and shell bricks: eight corners in the same order. */
const BRICK = /^(?:C3D8|[A-Z]{1,2}C3D8|COH3D8|SC8)/

/** Lines before the next keyword are nodes, bricks, other elements, or nothing of interest. */
type Section = 'nodes' | 'bricks' | 'others' | 'none'

export const abaqus: Format = {
  name: 'Abaqus',
  read(text) {
    if (!/^[ \t]*\*NODE\b(?![ \t]+\w)/im.test(text) || !/^[ \t]*\*ELEMENT\b(?![ \t]+\w)/im.test(text)) return null
    const mesh = new Mesh()
    const lines = new Scanner(text)
    let section: Section = 'none'
    let brick: string[] = []
    for (let line = lines.line(); line !== null; line = lines.line()) {
      if (line.startsWith('**')) continue
      if (line.startsWith('*')) {
        brick = []
        if (/^\*PART\b/i.test(line)) mesh.endPart()
        section = sectionOf(line)
        continue
      }
      if (section === 'nodes') readNode(mesh, line)
      else if (section === 'others') mesh.addOther()
      else if (section === 'bricks') {
        // A line may end before the eighth node; the next one goes on.
        brick.push(...fieldsOf(line))
        if (brick.length < 9) continue
        mesh.addHexahedron(`element ${brick[0]}`, brick.slice(1, 9).map(toInteger))
        brick = []
      }
    }
    return mesh.reading('a brick of eight nodes, such as C3D8')
  },
}

function sectionOf(keyword: string): Section {
  if (/^\*NODE\s*(,|$)/i.test(keyword)) {
    if (/SYSTEM\s*=\s*[CS]/i.test(keyword)) {
      throw new Refused('The nodes are in cylindrical or spherical coordinates; x, y and z are needed.')
    }
    return 'nodes'
  }
  if (!/^\*ELEMENT\s*(,|$)/i.test(keyword)) return 'none'
  const type = /TYPE\s*=\s*(\w+)/i.exec(keyword)?.[1]?.toUpperCase() ?? ''
  return BRICK.test(type) ? 'bricks' : 'others'
}

function fieldsOf(line: string): string[] {
  return line.split(',').flatMap(field => field.trim() || [])
}

/** Coordinates left out are zero. */
function readNode(mesh: Mesh, line: string): void {
  const [node = '', ...coordinates] = line.split(',').map(field => field.trim())
  const [x, y, z] = [0, 1, 2].map(axis => (coordinates[axis] ? toDouble(coordinates[axis]) : 0))
  mesh.nodes.set(toInteger(node), [x as number, y as number, z as number])
}
