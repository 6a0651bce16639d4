/**
 * Wavefront OBJ: a surface. Six quadrilaterals that close around eight points are a hexahedron, whose order comes from its faces; any other
 * surface has no hexahedra and is refused by name.
 */
import { hexahedronOfFaces } from '../hexahedron-of-faces'
import { MeshBuilder } from '../mesh-builder'
import { headText } from '../snippet-text'
import { type MeshFormat, progressOf } from '../source'
import { numberOf, shown, significantDigits, TextCursor } from '../text-cursor'

export const obj: MeshFormat = {
  name: 'OBJ',
  recognizes(head, name) {
    const text = headText(head)
    if (!/^v[ \t]+[-+.\d]+[ \t]+[-+.\d]/m.test(text)) return 'no'
    return /^f[ \t]+-?\d/m.test(text) || name.endsWith('.obj') ? 'yes' : 'no'
  },
  read(file, options) {
    const builder = new MeshBuilder('OBJ', file.name)
    const cursor = new TextCursor(file)
    const onLine = progressOf(file, options)
    const faces: number[][] = []
    const names: string[] = []
    let name = ''
    let others = 0
    for (let line = cursor.nextLine(); line !== null; line = cursor.nextLine()) {
      onLine(cursor.position)
      const [keyword, ...words] = line.trim().split(/\s+/)
      if (keyword === 'o' || keyword === 'g') name = words.join(' ')
      else if (keyword === 'v') {
        const [x, y, z] = words
          .slice(0, 3)
          .map(word => numberOf(word) ?? cursor.refuse(`${shown(word)} is not a coordinate.`))
        if (x === undefined || y === undefined || z === undefined)
          return cursor.refuse('a point has three coordinates.')
        for (const [axis, value] of [x, y, z].entries())
          builder.digits.see(value, significantDigits(words[axis] as string))
        builder.point(x, y, z)
      } else if (keyword === 'f') {
        const face = words.map(word => {
          const index = Number(word.split('/')[0])
          const point = index < 0 ? builder.pointCount + index : index - 1
          if (!Number.isInteger(index) || point < 0) cursor.refuse(`${shown(word)} is not the number of a point.`)
          return point
        })
        if (face.length === 4) {
          faces.push(face)
          names.push(name)
        } else others++
      }
    }
    let read = 0
    if (others === 0 && faces.length % 6 === 0) {
      for (let first = 0; first < faces.length; first += 6) {
        const eight = hexahedronOfFaces(faces.slice(first, first + 6))
        if (eight === null) break
        builder.hexahedron(eight, names[first] || read)
        read++
      }
    }
    if (read === 0 || 6 * read < faces.length) {
      builder.refuse(
        `this is a surface in OBJ (${builder.pointCount} points, ${faces.length + others} faces), which has no hexahedra: Gmsh or Cubit mesh its inside.`,
      )
    }
    builder.note('OBJ has faces, not cells: each six that close around eight points are read as a hexahedron.')
    return [builder.mesh()]
  },
}
