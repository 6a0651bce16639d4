/** The mesh of Gmsh's files: nodes by id, elements by type, groups and entities by name. */

import type { FileRows } from '../file-rows'
import type { PointBlock, Refusing } from '../mesh'
import { MeshBuilder } from '../mesh-builder'
import type { RowCursor } from '../text-cursor'
import type { GmshType } from './gmsh-types'

export class GmshMesh {
  readonly builder: MeshBuilder
  /** False where binary coordinates do not lie in blocks. */
  hasPlaces = true
  /** True if the text leaves something out: elements may then name nodes that are not there. */
  mayLackNodes = false
  lackingNodes = 0
  /** Names by "dimension tag", or by "tag" if the file gives no dimension. */
  readonly #names = new Map<string, string>()
  /** Physical groups of entities, by "dimension tag". */
  readonly #groups = new Map<string, readonly number[]>()
  readonly #blocks = new Map<string, readonly string[]>()
  readonly #nodeBlocks: PointBlock[] = []
  #lastGroup = Number.NaN
  #lastVolume = Number.NaN
  #lastBlocks: readonly string[] = []
  readonly #indices: number[] = []

  constructor(fileName: string) {
    this.builder = new MeshBuilder('Gmsh', fileName)
  }

  node(cursor: Refusing, id: number, x: number, y: number, z: number): void {
    if (!this.builder.newPointWithId(id, x, y, z)) cursor.refuse(`node ${id} is defined twice.`)
  }

  /** The next nodes are in the file from byte `from` on, `stride` bytes each. */
  block({ isLittleEndian }: { readonly isLittleEndian: boolean }, count: number, from: number, stride: number): void {
    this.#nodeBlocks.push({ count, from: [from, from + 8, from + 16], stride })
    if (!this.hasPlaces) return
    this.builder.coordinatePlaces = { kind: 'blocks', blocks: this.#nodeBlocks, type: 'float64', isLittleEndian }
  }

  /** Nodes of rows that end with three coordinates, whose ids stand first or are given. */
  nodeRows(cursor: RowCursor, rows: FileRows, ids: ArrayLike<number> | null = null, from = 0): void {
    const { pattern, count, numbers } = rows
    let largest = 0
    this.builder.expectRows(rows, 'nodes')
    for (let row = 0; row < count; ++row) {
      const at = pattern.numberCount * (row + 1) - 3
      const id = (ids === null ? numbers[pattern.numberCount * row] : ids[from + row]) as number
      const [x, y, z] = [numbers[at] as number, numbers[at + 1] as number, numbers[at + 2] as number]
      cursor.row = row
      this.node(cursor, id, x, y, z)
      largest = Math.max(largest, Math.abs(x), Math.abs(y), Math.abs(z))
      this.builder.coordinateTokens(rows, row)
    }
    this.builder.digits.seeRounded(rows.mostRounded, largest)
  }

  nameGroup(dimension: number | null, tag: number, name: string): void {
    this.#names.set(dimension === null ? `${tag}` : `${dimension} ${tag}`, name)
  }

  /** The groups that an entity is in; a negative tag turns the entity round, and names the same group. */
  groupsOfEntity(dimension: number, tag: number, groups: readonly number[]): void {
    this.#groups.set(`${dimension} ${tag}`, groups.map(Math.abs))
  }

  /** The names of a volume's blocks: its groups' names, else the volume's. */
  blocksOfVolume(tag: number): readonly string[] {
    return this.#blocksOf(tag, this.#groups.get(`3 ${tag}`) ?? [])
  }

  /** The names of the blocks of an element that names its group itself; 0 stands for none. */
  blocksOfElement(group: number, volume: number): readonly string[] {
    if (group !== this.#lastGroup || volume !== this.#lastVolume) {
      this.#lastGroup = group
      this.#lastVolume = volume
      this.#lastBlocks = this.#blocksOf(volume, group === 0 ? [] : [Math.abs(group)])
    }
    return this.#lastBlocks
  }

  #blocksOf(volume: number, groups: readonly number[]): readonly string[] {
    const key = groups.length > 0 ? groups.join(' ') : `volume ${volume}`
    let blocks = this.#blocks.get(key)
    if (!blocks) {
      const nameOf = (tag: number) => this.#names.get(`3 ${tag}`) ?? this.#names.get(`${tag}`) ?? `physical ${tag}`
      blocks = groups.length > 0 ? groups.map(nameOf) : volume > 0 ? [key] : []
      this.#blocks.set(key, blocks)
    }
    return blocks
  }

  /** Hexahedra one after the other, each with its id and those of its nodes. */
  hexahedra(cursor: Refusing, type: GmshType, numbers: ArrayLike<number>, blocks: readonly string[]): void {
    const first = this.builder.cellCount
    for (let at = 0; at < numbers.length; at += 9)
      if (this.builder.hexahedronByIds(numbers, at + 1, numbers[at] as number) < 0)
        this.element(cursor, type, numbers[at] as number, numbers, at + 1, [])
    for (const block of blocks) this.builder.restInBlock(block, first)
  }

  /** An element by the ids of its nodes, which are `nodes[from]` and following. */
  element(
    cursor: Refusing,
    { kind, nodes: count }: GmshType,
    id: number,
    nodes: ArrayLike<number>,
    from: number,
    blocks: readonly string[],
  ): void {
    if (kind === 'hexahedron') {
      const cell = this.builder.hexahedronByIds(nodes, from, id)
      if (cell >= 0) {
        for (const block of blocks) this.builder.inBlock(block, cell)
        return
      }
    }
    const indices = this.#indices
    indices.length = count
    for (let i = 0; i < count; ++i) {
      const index = this.builder.findId(nodes[from + i] as number)
      if (index < 0) {
        if (!this.mayLackNodes) cursor.refuse(`element ${id} names node ${nodes[from + i]}, which is not defined.`)
        this.lackingNodes++
        return
      }
      indices[i] = index
    }
    if (kind === 'curved') {
      this.builder.quadraticCell(indices.slice(0, 8), indices.slice(8))
    } else if (kind !== 'hexahedron') this.builder.otherCell(kind)
  }
}
