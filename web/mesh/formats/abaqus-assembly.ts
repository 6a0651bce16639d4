/** Abaqus: parts, the instances of them that an assembly has, and where each is put. */
import { shown } from '../text-cursor'
import type { Context, Section } from './abaqus-context'
import { moveLine, moveOf } from './abaqus-moves'
import { AbaqusPart } from './abaqus-part'
import { rigidMove } from './movement'
import type { Placement } from './placements'
import type { TextLines } from './text-lines'

interface Instance {
  readonly name: string
  readonly partName: string
  /** Definitions in the instance itself. */
  readonly own: AbaqusPart
  readonly moveLines: number[][]
  readonly line: number
  readonly lines: TextLines
}

export class AbaqusAssembly {
  /** Nodes and elements in no part. */
  readonly global = new AbaqusPart()
  /** Parts by their names in capitals, as the instances. */
  readonly #parts = new Map<string, { name: string; part: AbaqusPart }>()
  readonly #instances = new Map<string, Instance>()

  /** *PART */
  startPart(context: Context): void {
    const name = context.keyword.parameters.get('NAME') ?? ''
    const key = name.toUpperCase()
    if (this.#parts.has(key)) context.lines.refuse(`part ${shown(name)} is defined twice.`)
    context.part = new AbaqusPart()
    context.frame = null
    this.#parts.set(key, { name, part: context.part })
  }

  /** *INSTANCE */
  instanceSection(context: Context): Section {
    const { parameters } = context.keyword
    const lines: TextLines = context.lines
    const [name, partName] = [parameters.get('NAME') ?? '', parameters.get('PART') ?? '']
    if (parameters.has('LIBRARY') || parameters.has('INSTANCE'))
      lines.refuse('*INSTANCE from the library of another analysis is not read here.')
    if (this.#instances.has(name.toUpperCase())) lines.refuse(`instance ${shown(name)} is defined twice.`)
    const moveLines: number[][] = []
    const own = new AbaqusPart()
    this.#instances.set(name.toUpperCase(), { name, partName, own, moveLines, line: lines.number, lines })
    context.part = own
    context.frame = null
    return { line: () => moveLines.push(moveLine(context.lines)) }
  }

  /** The part in which an instance has its own sets; null if there is no such instance. */
  ownPartOf(instance: string): AbaqusPart | null {
    return this.#instances.get(instance.toUpperCase())?.own ?? null
  }

  placements(notes: string[], isCutOff: boolean): Placement[] {
    const placements: Placement[] = []
    const instances = [...this.#instances.values()]
    if (!this.global.model.isEmpty || this.#parts.size === 0) placements.push(placed(this.global, null))
    for (const instance of instances) placements.push(...this.#instancePlacements(instance, notes, isCutOff))
    const used = new Set(instances.map(({ partName }) => partName.toUpperCase()))
    for (const [key, { name, part }] of this.#parts) {
      if (used.has(key)) continue
      if (instances.length === 0) {
        placements.push(placed(part, name))
        notes.push('The text has parts and no assembly: each part is read once, where it was drawn.')
      } else if (part.model.cellCount > 0)
        notes.push(
          `Part ${shown(name)} has no instance: its ${part.model.cellCount} hexahedra are not in the assembly.`,
        )
    }
    return placements
  }

  #instancePlacements(instance: Instance, notes: string[], isCutOff: boolean): Placement[] {
    const { name, partName, own, moveLines, line, lines } = instance
    const part = this.#parts.get(partName.toUpperCase())?.part
    if (part === undefined && own.model.isEmpty)
      lines.refuse(`instance ${shown(name)} is of part ${shown(partName)}, which is not defined.`, line)
    const { translation, rotation } = moveOf(moveLines, lines, line)
    const isMoved = translation.some(value => value !== 0) || rotation !== null
    const move = isMoved ? rigidMove(translation, rotation) : null
    if (isMoved && move === null)
      lines.refuse(`instance ${shown(name)}: the two points of its axis are the same.`, line)
    if (isMoved) notes.push('Instances are moved as the assembly says; their coordinates are rounded to doubles.')
    const placements: Placement[] = []
    const hasPart = part !== undefined && !part.model.isEmpty
    if (hasPart && (own.model.cellCount > 0 || own.model.others.size > 0) && own.model.nodeCount > 0)
      lines.refuse(
        `instance ${shown(name)} has elements of its own besides those of its part: this is not read here.`,
        line,
      )
    if (hasPart && part) {
      part.finishSets()
      placements.push({ model: part.model, name, move, blocks: isCutOff ? new Map() : own.cellsOfSets(part) })
    }
    if (!own.model.isEmpty) {
      own.finishSets()
      placements.push({ model: own.model, name, move })
    }
    return placements
  }
}

function placed(part: AbaqusPart, name: string | null): Placement {
  part.finishSets()
  return { model: part.model, name, move: null }
}
