/**
 * OpenFOAM's blockMeshDict: vertices in brackets, and blocks `hex (…)` that name them in VTK's order. Each block is one element. What the
 * dictionary computes (variables, #calc) is refused; a scale does not change what is valid, and is only noted.
 */
import { MeshBuilder } from '../mesh-builder'
import { headText, snippetText } from '../snippet-text'
import { Tokens } from '../snippets/tokens'
import type { MeshFormat } from '../source'
import { shown } from '../text-cursor'

export const blockMeshDict: MeshFormat = {
  name: 'blockMeshDict',
  recognizes: head => {
    const text = headText(head)
    if (!/\bvertices\s{0,100}\(/.test(text)) return 'no'
    return /\bobject\s{1,20}blockMeshDict\b/.test(text) || /\bhex\s{0,20}\(\s{0,20}[\d\w]/.test(text) ? 'yes' : 'no'
  },
  read(file) {
    const builder = new MeshBuilder('blockMeshDict', file.name)
    const text = snippetText(file)
    if (text === null) return builder.refuse('this blockMeshDict is binary.')
    const names = new Map<string, number>()
    const dictionary = new Dictionary(text)
    for (let word = dictionary.next(); word !== null; word = dictionary.next()) {
      if (dictionary.depth > 0) continue
      if (word === 'vertices') readVertices(dictionary, builder, names)
      else if (word === 'blocks') readBlocks(dictionary, builder, names)
      else if (word === 'convertToMeters' || word === 'scale') {
        const scale = dictionary.next() ?? ''
        if (Number(scale) !== 1)
          builder.note(`Coordinates are as they are written, without the scale of ${shown(scale)}.`)
      } else if (word === 'edges' && hasEntries(dictionary)) {
        builder.note('The dictionary has curved edges: each block is checked as the trilinear element of its corners.')
      }
    }
    return [builder.mesh()]
  },
}

/** The words, numbers and brackets of a dictionary without its comments. */
class Dictionary {
  readonly #tokens: Tokens
  readonly #text: string
  /** Open braces. */
  depth = 0

  constructor(text: string) {
    this.#text = text
    this.#tokens = new Tokens(text)
  }

  /** Null at the end. */
  next(): string | null {
    const tokens = this.#tokens
    for (let kind = tokens.next(); kind !== 'end'; kind = tokens.next()) {
      if (kind === 'line') continue
      const word = tokens.word
      if (word === '/' && this.#text[tokens.to] === '/') this.#skipTo('\n')
      else if (word === '/' && this.#text[tokens.to] === '*') this.#skipTo('*/')
      else {
        if (word === '{') this.depth++
        else if (word === '}') this.depth--
        return word
      }
    }
    return null
  }

  #skipTo(end: string): void {
    const at = this.#text.indexOf(end, this.#tokens.to + 1)
    this.#tokens.to = at < 0 ? this.#text.length : at + end.length
  }
}

function expect(dictionary: Dictionary, builder: MeshBuilder, wanted: string): void {
  const word = dictionary.next()
  if (word !== wanted)
    builder.refuse(`${word === null ? 'the text ends' : `${shown(word)} stands`} where “${wanted}” was expected.`)
}

function readVertices(dictionary: Dictionary, builder: MeshBuilder, names: Map<string, number>): void {
  expect(dictionary, builder, '(')
  for (let word = dictionary.next(); word !== ')'; word = dictionary.next()) {
    let name: string | null = null
    if (word === 'name') {
      name = dictionary.next()
      word = dictionary.next()
    }
    const isProjected = word === 'project'
    if (isProjected) word = dictionary.next()
    if (word !== '(')
      builder.refuse(`vertex ${builder.pointCount} begins with ${shown(word ?? 'the end')}, where “(” was expected.`)
    const point = [0, 1, 2].map(() => coordinate(dictionary, builder))
    expect(dictionary, builder, ')')
    if (isProjected) {
      builder.note('The dictionary projects vertices: they are where it writes them.')
      for (let inner = dictionary.next(); inner !== ')' && inner !== null; inner = dictionary.next());
    }
    const index = builder.point(...(point as [number, number, number]))
    if (name !== null) names.set(name, index)
  }
}

function coordinate(dictionary: Dictionary, builder: MeshBuilder): number {
  const word = dictionary.next() ?? ''
  const tokens = new Tokens(word)
  if (tokens.next() === 'number') return tokens.value
  return builder.refuse(
    `vertex ${builder.pointCount} has ${shown(word)} for a coordinate, and only numbers are read: let blockMesh or foamDictionary -expand compute them.`,
  )
}

function readBlocks(dictionary: Dictionary, builder: MeshBuilder, names: ReadonlyMap<string, number>): void {
  expect(dictionary, builder, '(')
  let depth = 0
  let name: string | null = null
  for (let word = dictionary.next(); depth > 0 || word !== ')'; word = dictionary.next()) {
    if (word === null) builder.refuse('the text ends among the blocks, where “)” was expected.')
    if (word === '(') depth++
    else if (word === ')') depth--
    else if (word === 'name' && depth === 0) name = dictionary.next()
    else if (word === 'hex' && depth === 0) {
      expect(dictionary, builder, '(')
      const nodes: number[] = []
      for (let node = dictionary.next(); node !== ')'; node = dictionary.next()) {
        const index = names.get(node ?? '') ?? (/^\d{1,9}$/.test(node ?? '') ? Number(node) : -1)
        if (index < 0 || index >= builder.pointCount)
          builder.refuse(
            `block ${builder.cellCount} names vertex ${shown(node ?? '')}; the vertices are 0 to ${builder.pointCount - 1}.`,
          )
        nodes.push(index)
      }
      if (nodes.length !== 8)
        builder.refuse(`block ${builder.cellCount} has ${nodes.length} vertices, where 8 were expected.`)
      builder.hexahedron(nodes, name ?? `block ${builder.cellCount}`)
      name = null
    }
  }
}

function hasEntries(dictionary: Dictionary): boolean {
  if (dictionary.next() !== '(') return false
  let entries = 0
  let depth = 1
  for (let word = dictionary.next(); word !== null; word = dictionary.next()) {
    if (word === '(') depth++
    else if (word === ')') depth--
    if (depth === 0) break
    entries++
  }
  return entries > 0
}
