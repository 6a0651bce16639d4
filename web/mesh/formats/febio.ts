/**
 * FEBio (.feb), versions 2 to 4: <node id="1">x,y,z</node> in <Nodes>, <elem id="1">1,2,...</elem> in <Elements type="hex8">. Corners come first, in
 * VTK's order. Tags and commas are read as blanks where lines are alike.
 */
import type { OtherCell } from '../mesh-builder'
import { headText } from '../snippet-text'
import type { MeshFile, MeshFormat, ReadOptions } from '../source'
import { numberOf, shown, significantDigits } from '../text-cursor'
import { XmlScanner, type XmlTag } from '../xml-scanner'
import { blanked, RowText } from './row-text'

const LF = 10
const AT_ONCE = 1024 * 1024
/** Bytes between the tags of one node or element. */
const LONGEST_CONTENT = 8192
const OTHER: readonly (readonly [RegExp, OtherCell])[] = [
  [/^TET/, 'tetrahedron'],
  [/^PENTA/, 'wedge'],
  [/^PYRA/, 'pyramid'],
  [/^(?:QUAD|Q\d)/, 'quadrilateral'],
  [/^TRI/, 'triangle'],
  [/^(?:LINE|TRUSS|BEAM)/, 'line'],
]

export const febio: MeshFormat = {
  name: 'FEBio',
  recognizes: head => (/<febio_spec\b/i.test(headText(head)) ? 'yes' : 'no'),
  read(file, options) {
    return [new FebioReader(file, options).read()]
  },
}

class FebioReader {
  readonly #file: MeshFile
  readonly #scanner: XmlScanner
  readonly #text: RowText
  /** A place in the file and its line. */
  #known = { position: 0, line: 1 }
  #hasRoot = false

  constructor(file: MeshFile, options: ReadOptions) {
    this.#file = file
    this.#scanner = new XmlScanner(file)
    this.#text = new RowText('FEBio', blanked(file, '<>"\',/'), options)
  }

  read() {
    const text = this.#text
    for (let tag = this.#scanner.next(); tag !== null; tag = this.#scanner.next()) {
      if (tag.kind === 'close') continue
      if (tag.name === 'febio_spec') this.#root(tag)
      else if (/^(?:Nodes|Elements|Mesh|Geometry|Include)$/.test(tag.name)) this.#section(tag)
    }
    if (!this.#hasRoot) text.builder.refuse('this is no FEBio file: there is no <febio_spec> in it.')
    if (text.builder.pointCount === 0) text.builder.refuse('it has no <Nodes>.')
    text.readLater()
    return text.builder.mesh()
  }

  #root({ attributes }: XmlTag): void {
    this.#hasRoot = true
    const version = attributes.get('version') ?? ''
    if (!/^[234]/.test(version))
      this.#text.builder.refuse(`the version is ${shown(version)}; versions 2 to 4 are read.`)
  }

  #section(tag: XmlTag): void {
    const elsewhere = tag.attributes.get('from')
    if (elsewhere !== undefined)
      this.#scanner.refuse(tag.from, `its mesh is in ${shown(elsewhere)}, which is to be given in its place.`)
    if (tag.isEmpty) return
    if (tag.name === 'Nodes') {
      this.#lines(
        tag,
        'node',
        (id, content) => this.#node(id, content),
        around => this.#text.nodeRows(around),
      )
    } else if (tag.name === 'Elements') this.#elements(tag)
  }

  #elements(tag: XmlTag): void {
    const type = (tag.attributes.get('type') ?? '').toUpperCase()
    const { builder } = this.#text
    if (!type.startsWith('HEX')) {
      const cell = OTHER.find(([pattern]) => pattern.test(type))?.[1] ?? 'other'
      this.#lines(
        tag,
        'elem',
        () => builder.otherCell(cell),
        () => false,
      )
      return
    }
    const name =
      tag.attributes.get('name') ?? tag.attributes.get('elset') ?? `material ${tag.attributes.get('mat') ?? '?'}`
    const put = (cell: number) => builder.inBlock(name, cell)
    const one = (id: number, content: Content) => {
      const nodes = this.#nodesOf(id, content)
      if (nodes.length !== Number(type.slice(3)))
        this.#text.refuse(`element ${id} of type ${shown(type.toLowerCase())} has ${nodes.length} nodes.`)
      this.#text.hexahedron(id, nodes, put)
    }
    // Nodes may come later.
    const { position } = this.#scanner
    const line = this.#lineAt(position)
    this.#text.cursor.goTo({ position, line })
    this.#text.later(() => {
      this.#scanner.position = position
      this.#known = { position, line }
      this.#lines(tag, 'elem', one, around =>
        type === 'HEX8' ? this.#text.hexahedronRows(this.#text.rows('wwwwwwwww', around), 0, 1, put) : false,
      )
    })
    this.#passTo(tag.name)
  }

  /** Passes what is inside of a section, which is read later, straight to its end. */
  #passTo(name: string): void {
    const end = new TextEncoder().encode(`</${name}`)
    const mark = end[2] as number
    for (let from = this.#scanner.position; from < this.#file.size; from += AT_ONCE) {
      const start = Math.max(0, from - 2)
      const bytes = this.#file.read(start, Math.min(this.#file.size, from + AT_ONCE + end.length))
      for (let at = bytes.indexOf(mark, 2); at >= 0; at = bytes.indexOf(mark, at + 1)) {
        if (!end.every((byte, i) => bytes[at - 2 + i] === byte)) continue
        this.#scanner.position = start + at - 2
        this.#scanner.next()
        return
      }
    }
    this.#text.builder.refuse(`<${name}> ends nowhere: the file is cut off.`)
  }

  /** The line of a place that is behind the last one, or not far before it. */
  #lineAt(position: number): number {
    if (position < this.#known.position) this.#known = { position: 0, line: 1 }
    let { position: from, line } = this.#known
    for (; from < position; from += AT_ONCE) {
      const bytes = this.#file.read(from, Math.min(position, from + AT_ONCE))
      for (let at = bytes.indexOf(LF); at >= 0; at = bytes.indexOf(LF, at + 1)) line++
    }
    this.#known = { position, line }
    return line
  }

  /** What is in a section: many lines at once where they are alike, or one tag after another. */
  #lines(section: XmlTag, name: string, one: (id: number, content: Content) => void, many: Many): void {
    const scanner: XmlScanner = this.#scanner
    for (;;) {
      this.#many(name, many)
      const tag = scanner.next()
      if (tag === null) this.#text.builder.refuse(`<${section.name}> ends nowhere: the file is cut off.`)
      if (tag.kind === 'close' && tag.name === section.name) return
      if (tag.kind === 'close' || tag.name !== name) continue
      const id = Number(tag.attributes.get('id'))
      if (!Number.isSafeInteger(id) || id < 0) scanner.refuse(tag.from, `<${name}> has no id that is a number.`)
      const end = tag.isEmpty ? null : scanner.next()
      if (end === null || end.kind !== 'close' || end.name !== name)
        scanner.refuse(tag.from, `</${name}> was expected behind <${name} id="${id}">.`)
      one(id, this.#content(tag.to, end.from))
    }
  }

  /** Takes lines that are alike, if the next one begins here. */
  #many(name: string, many: Many): void {
    const { cursor } = this.#text
    const { position } = this.#scanner
    cursor.goTo({ position, line: this.#lineAt(position) })
    if (cursor.hasMoreOnLine()) return
    cursor.skipLine()
    const line = this.#text.line() ?? ''
    const [, before, , behind] =
      new RegExp(String.raw`^(\s*${name}\s+id\s*=)([-+.\w\s]*?)(\s+${name}\s*)$`).exec(line) ?? []
    if (before === undefined || behind === undefined || !many({ before, behind: behind.trimEnd() })) return
    this.#scanner.position = cursor.position
    this.#known = { position: cursor.position, line: cursor.line }
  }

  #content(from: number, to: number): Content {
    if (to - from > LONGEST_CONTENT) this.#scanner.refuse(from, 'a tag has more in it than nodes and elements have.')
    const text = String.fromCharCode(...this.#file.read(from, to))
    return Array.from(text.matchAll(/[^\s,]+/g), match => ({ word: match[0], from: from + match.index }))
  }

  #node(id: number, content: Content): void {
    const { builder } = this.#text
    const at = content[0]?.from ?? this.#scanner.position
    if (content.length !== 3) this.#scanner.refuse(at, `node ${id} has ${content.length} coordinates, not 3.`)
    const [x = 0, y = 0, z = 0] = content.map(({ word, from }) => {
      const value = numberOf(word) ?? this.#scanner.refuse(from, `${shown(word)} is not a coordinate.`)
      builder.coordinateToken(from, word.length)
      builder.digits.see(value, significantDigits(word))
      return value
    })
    builder.pointWithId(id, x, y, z)
  }

  #nodesOf(id: number, content: Content): number[] {
    return content.map(({ word, from }) =>
      /^\d{1,15}$/.test(word)
        ? Number(word)
        : this.#scanner.refuse(from, `${shown(word)} in element ${id} is not the number of a node.`),
    )
  }
}

/** Words with their places in the file. */
type Content = readonly { readonly word: string; readonly from: number }[]
type Many = (around: { before: string; behind: string }) => boolean
