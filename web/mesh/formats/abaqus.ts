/**
 * Abaqus and CalculiX input files: parts and their instances, nodes, elements, sets, what is included and what is generated. What moves or
 * makes nodes and is not read here is refused by its name.
 */
import type { Mesh } from '../mesh'
import { PrintedDigits } from '../precision'
import { headText } from '../snippet-text'
import type { MeshFile, MeshFormat, ReadOptions } from '../source'
import { shown } from '../text-cursor'
import { AbaqusAssembly } from './abaqus-assembly'
import type { Context, Section } from './abaqus-context'
import { copyElements, elementLineSection, elementSection, setSection } from './abaqus-elements'
import { type Keyword, keywordOf } from './abaqus-keyword'
import { nodeCopySection, nodeFillSection, nodeLineSection, nodeSection, systemSection } from './abaqus-nodes'
import type { AbaqusPart } from './abaqus-part'
import { includedLines } from './includes'
import type { Frame } from './movement'
import { collect } from './placements'
import { TextLines } from './text-lines'

const STAR = 42

/** Options that make, move or bring nodes and elements in ways that are not read. */
const REFUSED = new Set([
  ...['NMAP', 'IMPORT', 'IMPORTNODESET', 'IMPORTELSET', 'SYMMETRICMODELGENERATION', 'SUBSTRUCTUREGENERATE'],
  ...['SOLIDELEMENTGENERATION', 'TRANSFORMNODES'],
])

export const abaqus: MeshFormat = {
  name: 'Abaqus',
  recognizes(head, name) {
    const text = headText(head)
    if (/^[> \t]*\*(?:KEYWORD\b|ELEMENT_|PART_|SECTION_|CONTROL_|MAT_)/im.test(text)) return 'no'
    if (/^[> \t]*\*ELEMENT[ \t]*,/im.test(text)) return 'yes'
    const isDyna = /\.(?:k|key|dyn)$/.test(name)
    if (/^[> \t]*\*NODE[ \t]*(?:,|\r?$)/im.test(text)) return isDyna ? 'maybe' : 'yes'
    if (/^[> \t]*\*(?:HEADING|PART|INCLUDE|ASSEMBLY|NGEN)\b/im.test(text) && !isDyna)
      return name.endsWith('.inp') ? 'yes' : 'maybe'
    return name.endsWith('.inp') && /^[ \t]*\*[a-z]/im.test(text) ? 'maybe' : 'no'
  },
  read(file, options) {
    const lines = new TextLines(file, options)
    const meshes: Mesh[] = []
    for (let isFollowed = true; isFollowed; ) {
      const reader = new AbaqusReader(file, options, lines)
      meshes.push(reader.read())
      isFollowed = reader.isFollowed
    }
    return meshes
  },
}

class AbaqusReader implements Context {
  readonly #file: MeshFile
  readonly #options: ReadOptions
  readonly #assembly = new AbaqusAssembly()
  readonly precision = new PrintedDigits()
  readonly notes: string[] = []
  lines: TextLines
  keyword: Keyword = { name: '', written: '', parameters: new Map() }
  part: AbaqusPart = this.#assembly.global
  frame: Frame | null = null
  #section: Section | null = null
  #isCutOff = false
  #hasElements = false
  /** True if another file begins in the same text: a second heading behind elements. */
  isFollowed = false

  constructor(file: MeshFile, options: ReadOptions, lines: TextLines) {
    this.#file = file
    this.#options = options
    this.lines = lines
  }

  read(): Mesh {
    this.#readLines(0)
    this.#section?.end?.()
    return collect({
      format: 'Abaqus',
      fileName: this.#file.name,
      placements: this.#assembly.placements(this.notes, this.#isCutOff),
      precision: this.precision,
      notes: this.notes,
      isCutOff: this.#isCutOff,
    })
  }

  #readLines(depth: number): void {
    const { lines } = this
    let blank = 0
    while (lines.next()) {
      if (lines.isBlank) {
        blank = lines.number
        continue
      }
      let first = 0
      while (lines.at(first) <= 32) first++
      if (lines.at(first) === STAR) {
        if (lines.at(first + 1) === STAR) continue
        this.#endSection()
        if (depth === 0 && this.#hasElements && /^\s*\*\s*HEADING\b/i.test(lines.text())) {
          lines.hold()
          this.isFollowed = true
          return
        }
        this.keyword = this.#nextKeyword()
        if (this.keyword.name === 'ELEMENT') this.#hasElements = true
        this.#section = this.#start(depth)
        const input = this.keyword.parameters.get('INPUT')
        const hasDataFile = this.keyword.name === 'NODE' || this.keyword.name === 'ELEMENT'
        if (hasDataFile && input !== undefined) this.#include(input, depth)
      } else if (lines.isElision) {
        this.#isCutOff = true
        this.part.model.forgetPlaces()
      } else if (blank > 0 && this.#section !== null && lines.isProseAfter(blank)) {
        this.#endSection()
        this.notes.push(`Line ${lines.number} is text: what follows it, up to the next keyword, is passed over.`)
      } else this.#section?.line()
    }
  }

  #endSection(): void {
    this.#section?.end?.()
    this.#section = null
  }

  /** The keyword of this line, which goes on after a comma at its end. */
  #nextKeyword(): Keyword {
    const { lines } = this
    let text = lines.text()
    while (text.endsWith(',') && text.length < 65_536 && lines.next()) {
      const more = lines.text().trim()
      if (more.startsWith('**')) continue
      if (!/^[a-z]/i.test(more)) {
        lines.hold()
        break
      }
      text += more
    }
    return keywordOf(text.trim())
  }

  /** The purpose of the lines under the keyword; null if nobody needs them. */
  #start(depth: number): Section | null {
    const { name, written, parameters } = this.keyword
    switch (name) {
      case 'NODE':
        return nodeSection(this)
      case 'SYSTEM':
        return systemSection(this)
      case 'NGEN':
        return nodeLineSection(this)
      case 'NFILL':
        return nodeFillSection(this)
      case 'NCOPY':
        return nodeCopySection(this)
      case 'ELEMENT':
        return elementSection(this)
      case 'ELGEN':
        return elementLineSection(this)
      case 'ELCOPY':
        copyElements(this)
        return null
      case 'NSET':
      case 'ELSET':
        return this.#setSection(name)
      case 'INSTANCE':
        return this.#assembly.instanceSection(this)
      case 'PART':
        this.#assembly.startPart(this)
        return null
      case 'ENDPART':
      case 'ENDINSTANCE':
      case 'ASSEMBLY':
      case 'ENDASSEMBLY':
        this.part = this.#assembly.global
        this.frame = null
        return null
      case 'INCLUDE':
        this.#include(parameters.get('INPUT') ?? '', depth)
        // A section in which the included file ends goes on.
        return this.#section
      case 'IMPERFECTION':
        this.notes.push('*IMPERFECTION moves nodes in the analysis; the nodes are read as they are written.')
        return null
    }
    if (REFUSED.has(name))
      this.lines.refuse(`${shown(written)} is not read here: write the nodes and elements themselves.`)
    return null
  }

  #setSection(kind: 'NSET' | 'ELSET'): Section | null {
    const instance = this.keyword.parameters.get('INSTANCE')
    const part = instance === undefined ? this.part : this.#assembly.ownPartOf(instance)
    return part === null ? null : setSection(this, kind, part)
  }

  #include(name: string, depth: number): void {
    const lines: TextLines = this.lines
    const { written } = this.keyword
    if (name === '') lines.refuse(`${shown(written)} names no file: INPUT=name was expected.`)
    const included = includedLines(lines, this.#options, shown(written), name, depth)
    this.#assembly.global.model.forgetPlaces()
    this.lines = included
    this.#readLines(depth + 1)
    this.lines = lines
  }
}
