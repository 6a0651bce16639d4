/** Medit .mesh in ASCII: Vertices and Hexahedra, numbered from 1, each with a reference after it. */
import { type Format, Refused } from './format'
import { Mesh } from './mesh'
import { Scanner } from './scanner'

export const medit: Format = {
  name: 'Medit',
  read(text) {
    const vertices = /^[ \t]*Vertices\s+(\d+)/m.exec(text)
    const isMedit = /^[ \t]*MeshVersionFormatted\b/m.test(text)
    if (vertices === null || !(isMedit || /^[ \t]*Hexahedra\s+\d/m.test(text))) return null
    if (/^[ \t]*Dimension\s+2\b/m.test(text))
      throw new Refused('This Medit mesh is of the plane; hexahedra have three dimensions.')
    const mesh = new Mesh()
    const bare = text.includes('#') ? text.replace(/#.*/g, '') : text
    const points = sectionOf(bare, 'Vertices')
    for (let node = 1; node <= (points?.count ?? 0); node++) {
      const { scanner } = points as Section
      mesh.nodes.set(node, [scanner.double(), scanner.double(), scanner.double()])
      scanner.word()
    }
    const cells = sectionOf(bare, 'Hexahedra')
    for (let cell = 1; cell <= (cells?.count ?? 0); cell++) {
      const { scanner } = cells as Section
      const nodes: number[] = []
      while (nodes.length < 8) nodes.push(scanner.integer())
      scanner.word()
      mesh.addHexahedron(`hexahedron ${cell}`, nodes)
    }
    return mesh.reading('under Hexahedra')
  },
}

interface Section {
  readonly count: number
  readonly scanner: Scanner
}

function sectionOf(text: string, keyword: string): Section | null {
  const header = new RegExp(String.raw`^[ \t]*${keyword}\s+(\d+)`, 'm').exec(text)
  return header && { count: Number(header[1]), scanner: new Scanner(text, header.index + header[0].length) }
}
