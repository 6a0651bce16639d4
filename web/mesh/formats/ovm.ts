/**
 * OpenVolumeMesh in ASCII: vertices, edges, faces of halfedges, polyhedra of halffaces. Halfedge 2e goes along edge e and 2e + 1 back, and
 * so for faces; a cell's halffaces look outwards. The order of a hexahedron's points comes from its faces, the first one as bottom.
 */
import { hexahedronOfFaces } from '../hexahedron-of-faces'
import { MeshBuilder } from '../mesh-builder'
import { headText } from '../snippet-text'
import type { MeshFormat } from '../source'
import { shown, TextCursor } from '../text-cursor'

/** What a line of comment begins with. */
const HASH = 35

export const ovm: MeshFormat = {
  name: 'OVM',
  recognizes: head => (/^\s{0,100}OVM\s+(?:ASCII|BINARY)/i.test(headText(head, 200)) ? 'yes' : 'no'),
  read(file, { onProgress, throwIfCancelled }) {
    const builder = new MeshBuilder('OVM', file.name)
    const cursor = new TextCursor(file)
    cursor.word()
    if (cursor.word().toUpperCase() === 'BINARY') builder.refuse('this OVM file is binary: save it as ASCII.')
    const passComments = () => {
      for (cursor.skipBlanks(); cursor.peek() === HASH; cursor.skipBlanks()) cursor.skipLine()
    }
    const count = (name: string): number => {
      passComments()
      const word = cursor.word()
      if (word.toLowerCase() !== name.toLowerCase())
        cursor.refuse(`${shown(word)} stands where “${name}” was expected.`)
      passComments()
      const value = cursor.count(`the number of ${name}`)
      // An entry has at least one digit and a blank.
      if (2 * value > file.size) cursor.refuse(`the file is too short for ${value} ${name}.`)
      throwIfCancelled()
      onProgress(cursor.position / file.size)
      return value
    }
    const index = (most: number, what: string): number => {
      passComments()
      const value = cursor.count(`the number of ${what}`)
      if (value >= most) cursor.refuse(`${what} ${value} is not there: there are ${most}.`)
      return value
    }
    const list = (most: number, what: string): number[] => {
      passComments()
      const size = cursor.count('a count')
      if (2 * size > file.size) cursor.refuse(`the file is too short for ${size} entries.`)
      return Array.from({ length: size }, () => index(most, what))
    }
    const points = count('Vertices')
    for (let i = 0; i < points; i++) {
      passComments()
      builder.point(...builder.readPoint(cursor))
    }
    const edges = count('Edges')
    const ends = Float64Array.from({ length: 2 * edges }, () => index(points, 'vertex'))
    const faceCount = count('Faces')
    const faces = Array.from({ length: faceCount }, () =>
      list(2 * edges, 'halfedge').map(halfedge => ends[halfedge] as number),
    )
    const cells = count('Polyhedra')
    let others = 0
    for (let i = 0; i < cells; i++) {
      const halffaces = list(2 * faceCount, 'halfface')
      const around = halffaces.map(halfface => {
        const face = faces[halfface >> 1] as number[]
        return halfface % 2 === 0 ? face : [...face].reverse()
      })
      const eight = hexahedronOfFaces(around, faces[(halffaces[0] ?? 0) >> 1]?.[0])
      if (eight === null) {
        others++
        builder.otherCell('polyhedron')
      } else builder.hexahedron(eight, i)
    }
    if (others === 0 && cells === 0) builder.note('The file has no polyhedra.')
    return [builder.mesh()]
  },
}
