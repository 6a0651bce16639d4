/**
 * OpenFOAM's polyMesh: `points`, `faces` as lists of points, and the cells on both sides of a face in `owner` and `neighbour`. A face goes around
 * anticlockwise seen from its neighbour, or from outside where it has none. Cells with the faces of a hexahedron are read as trilinear.
 */
import { RowPattern } from '../../core/reading-interface'
import { cellsOfFaces, type Faces } from '../cells-of-faces'
import { RowSearch } from '../file-rows'
import { gunzipped } from '../gzip'
import { type Mesh, MeshRefusal } from '../mesh'
import { MeshBuilder } from '../mesh-builder'
import { float32Note, largestOf } from '../precision'
import { headText } from '../snippet-text'
import { isNamed, type MeshFile, type MeshFormat, type ReadOptions } from '../source'
import { shown, TextCursor } from '../text-cursor'
import { TypedList } from '../typed-list'
import { FoamFile, withoutBrackets } from './foam-file'

const [OPEN, SEMICOLON, OPEN_BRACE] = [40, 59, 123] as const
const MESH_CLASS =
  /\bclass\s{1,20}(?:faceList|faceCompactList|labelList|polyBoundaryMesh|cellList|regIOobject|faceZoneMesh|cellZoneMesh|pointZoneMesh|ZoneMesh<\w{1,20}>)\s{0,9};/
/** Files without which there is no mesh. */
const NEEDED = ['points', 'faces', 'owner', 'neighbour']
/** Files of a mesh that say nothing of its cells. */
const BESIDE = ['boundary', 'faceZones', 'pointZones', 'cellLevel', 'pointLevel', 'level0Edge', 'surfaceIndex']
export const MESH_FILES: readonly string[] = [...NEEDED, 'cellZones', ...BESIDE]
const POINT_ROW = new RowPattern(['real', 'real', 'real', 'end'])
/** Numbers of faces that are read at once. */
const AT_ONCE = 65_536
/** Points of one face. */
const MOST_POINTS = 16_384

export const openFoam: MeshFormat = {
  name: 'OpenFOAM',
  recognizes: head => {
    const text = headText(head, 16_384)
    return /\bFoamFile\s{0,20}\{/.test(text) && (MESH_CLASS.test(text) || isLargePoints(text)) ? 'yes' : 'no'
  },
  read(file, options) {
    return [new PolyMesh(file, options).read()]
  },
}

/** The points of a mesh, of which there are more than of one element. */
function isLargePoints(head: string): boolean {
  if (!/\bclass\s{1,20}vectorField\s{0,9};/.test(head) || !/\bobject\s{1,20}points\s{0,9};/.test(head)) return false
  return /\}\s{0,100}(?:\/\/[^\n]{0,200}\s{0,100})?(\d{1,12})\s{0,20}\(/.exec(head)?.[1] !== '8'
}

class PolyMesh {
  readonly #given: MeshFile
  readonly #options: ReadOptions
  readonly #builder: MeshBuilder
  #location: { readonly folder: string; readonly name: string } | null = null

  constructor(file: MeshFile, options: ReadOptions) {
    this.#given = file
    this.#options = options
    this.#builder = new MeshBuilder('OpenFOAM', file.name)
  }

  read(): Mesh {
    // All files are asked for before one is read: what is not there is missing at once.
    const files = new Map(NEEDED.map(name => [name, this.#found(name)]))
    const zones = this.#found('cellZones')
    for (const name of BESIDE) this.#found(name)
    const missing = [...files].filter(([, file]) => file === null).map(([name]) => `“${name}”`)
    if (missing.length > 0) {
      const [last, ...others] = missing.reverse()
      const named = others.length > 0 ? `${others.reverse().join(', ')} and ${last}` : last
      throw new MeshRefusal(
        `${this.#given.name}: this is a file of an OpenFOAM mesh; it needs ${named} of the same folder beside it: give all files of polyMesh together.`,
      )
    }
    const [points, faces, owner, neighbour] = [...files.values()].map(file => this.#opened(file as MeshFile)) as [
      FoamFile,
      FoamFile,
      FoamFile,
      FoamFile,
    ]
    this.#points(points)
    const list = this.#faces(faces)
    const cells = this.#cells(list, owner, neighbour)
    if (zones !== null) this.#zones(this.#opened(zones), cells)
    return this.#builder.mesh()
  }

  #found(name: string): MeshFile | null {
    if (isNamed(this.#given, name)) return this.#given
    const packed = isNamed(this.#given, `${name}.gz`) ? null : this.#options.find(name)
    return packed ?? this.#options.find(`${name}.gz`)
  }

  #opened(file: MeshFile): FoamFile {
    const foam = new FoamFile(/\.gz$/i.test(file.name) ? gunzipped(file) : file, this.#options)
    const { location } = foam
    this.#location ??= location === '' ? null : { folder: location, name: file.name }
    if (this.#location !== null && location !== '' && location !== this.#location.folder)
      throw new MeshRefusal(
        `${file.name}: it is of ${shown(location)}, and ${this.#location.name} of ${shown(this.#location.folder)}: they are files of two meshes.`,
      )
    return foam
  }

  #points(foam: FoamFile): void {
    const builder = this.#builder
    builder.areCoordinatesElsewhere = foam.file !== this.#given
    const count = foam.count('points', 3 * foam.bytesOf('scalar'))
    foam.expect(OPEN, 'a bracket before the points')
    builder.reserve(count, 0)
    if (foam.isBinary) {
      const values = foam.scalars(3 * count, 'coordinates')
      for (let i = 0; i < values.length; i += 3)
        builder.point(values[i] as number, values[i + 1] as number, values[i + 2] as number)
      const note = foam.isFloat32 ? float32Note(largestOf(values)) : null
      if (note !== null) builder.note(note)
    } else this.#textPoints(foam, count)
    foam.end(count, 'points')
  }

  #textPoints(foam: FoamFile, count: number): void {
    const builder = this.#builder
    const { position, line } = foam.cursor
    const cursor = new TextCursor(withoutBrackets(foam.file), position, line)
    const search = new RowSearch(this.#options.core)
    while (builder.pointCount < count) {
      const left = count - builder.pointCount
      cursor.skipBlanks()
      const rows = left < 4 ? null : cursor.rows(search, POINT_ROW)
      if (rows === null) {
        builder.point(...builder.readPoint(cursor))
        continue
      }
      if (rows.count > left) foam.refuse(`there are more points than the ${count} that were declared.`, cursor.position)
      builder.pointRows(rows)
      foam.progress(cursor.position)
    }
    foam.cursor.goTo({ position: cursor.position })
  }

  #faces(foam: FoamFile): Faces {
    if (foam.isBinary && foam.className === 'faceCompactList') return this.#compactFaces(foam)
    const count = foam.count('faces', foam.isBinary ? 4 + 3 * foam.bytesOf('label') : 6)
    foam.expect(OPEN, 'a bracket before the faces')
    const faces = foam.isBinary ? binaryFaces(foam, count) : this.#textFaces(foam, count)
    foam.end(count, 'faces')
    return faces
  }

  /** Where the faces begin, with the end of the last, and the points of all. */
  #compactFaces(foam: FoamFile): Faces {
    const starts = foam.labels('places of faces')
    const points = foam.labels('points of faces')
    for (let i = 1; i < starts.length; ++i)
      if ((starts[i] as number) < (starts[i - 1] as number)) foam.refuse(`face ${i - 1} ends before it begins.`)
    if (starts.length === 0 || starts[0] !== 0 || starts.at(-1) !== points.length)
      foam.refuse(`the faces have ${points.length} points, and end at ${starts.at(-1) ?? 0}.`)
    return { points, ends: starts.subarray(1) }
  }

  /** Each face is its number of points, then these. */
  #textFaces(foam: FoamFile, count: number): Faces {
    const run = foam.run()
    const points = new TypedList(Uint32Array)
    points.reserve(4 * count)
    const ends = new Uint32Array(count)
    const some = new Uint32Array(AT_ONCE)
    let [held, face] = [0, 0]
    while (face < count) {
      // No number behind the last face: a face has four at least.
      const filled = run.indices(some, held, Math.min(AT_ONCE, Math.max(held + 1, 4 * (count - face))))
      let at = 0
      for (; at < filled && face < count; ++face) {
        const size = some[at] as number
        if (size > MOST_POINTS) foam.refuse(`face ${face} has ${size} points, more than faces have.`, run.position)
        if (at + size >= filled) break
        points.reserve(points.length + size)
        for (let i = 0; i < size; ++i) points.values[points.length++] = some[++at] as number
        ends[face] = points.length
        at++
      }
      if (filled === held && at === 0) {
        const word = run.nextWord()
        foam.refuse(
          `${face} of ${count} faces are there; ${word === '' ? 'the file ends there' : `then ${shown(word)}`}.`,
          run.position,
        )
      }
      some.copyWithin(0, at, filled)
      held = filled - at
    }
    if (held > 0) foam.refuse(`there are more faces than the ${count} that were declared.`, run.position)
    foam.cursor.goTo({ position: run.position })
    return { points: points.whole(), ends }
  }

  /** Returns the place of each of OpenFOAM's cells among the hexahedra, one more than it, or 0. */
  #cells({ points, ends }: Faces, ownerFile: FoamFile, neighbourFile: FoamFile): Uint32Array {
    const builder = this.#builder
    const faceCount = ends.length
    const owner = ownerFile.labels('owners')
    const neighbour = neighbourFile.labels('neighbours')
    if (owner.length !== faceCount) ownerFile.refuse(`it has ${owner.length} owners; the mesh has ${faceCount} faces.`)
    if (neighbour.length > faceCount)
      neighbourFile.refuse(`it has ${neighbour.length} neighbours; the mesh has ${faceCount} faces.`)
    for (let i = 0; i < points.length; ++i)
      if ((points[i] as number) >= builder.pointCount)
        builder.refuse(`a face names point ${points[i]}; the points are 0 to ${builder.pointCount - 1}.`)
    const places = cellsOfFaces(builder, { points, ends }, owner, neighbour, 0)
    if (builder.cellCount > 0)
      builder.note(
        'Cells of OpenFOAM are polyhedra; those with the faces of a hexahedron are checked as trilinear ones.',
      )
    return places
  }

  /** Names with dictionaries, in which `cellLabels` is a list. */
  #zones(foam: FoamFile, places: Uint32Array): void {
    const builder = this.#builder
    if (foam.next() === -1) return
    const count = foam.count('zones', 2)
    foam.expect(OPEN, 'a bracket before the zones')
    for (let zone = 0; zone < count; ++zone) {
      const name = foam.word().replaceAll('"', '')
      foam.expect(OPEN_BRACE, `a brace behind the name of zone ${shown(name)}`)
      for (let word = foam.word(); word !== '}'; word = foam.word()) {
        if (word === '') foam.refuse(`the file ends in zone ${shown(name)}.`)
        if (word !== 'cellLabels') {
          for (let value = word; value !== ';'; value = foam.word())
            if (value === '') foam.refuse(`the file ends in zone ${shown(name)}.`)
          continue
        }
        // A list may have its type in front.
        if (!/^\d$/.test(String.fromCharCode(foam.next()))) foam.word()
        for (const cell of foam.labels('cells of a zone').sort()) {
          const place = places[cell]
          if (place === undefined)
            foam.refuse(`zone ${shown(name)} has cell ${cell}; the cells are 0 to ${places.length - 1}.`)
          if (place > 0) builder.inBlock(name, place - 1)
        }
        if (foam.next() === SEMICOLON) foam.word()
      }
    }
  }
}

/** Faces as older versions write them: each a list of its own. */
function binaryFaces(foam: FoamFile, count: number): Faces {
  const points = new TypedList(Uint32Array)
  const ends = new Uint32Array(count)
  for (let face = 0; face < count; ++face) {
    for (const point of foam.labels('points of a face')) points.push(point)
    ends[face] = points.length
  }
  return { points: points.whole(), ends }
}
