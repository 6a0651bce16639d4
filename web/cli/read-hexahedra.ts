/** An entry of what `analyze` and `certify` accept, a JSON list of {"name", "vertices": [[x, y, z], ... 8]}. Pure; further keys are ignored. */
import { shown } from '../mesh/text-cursor'
import { VERTEX_COUNT, type Vertices } from '../model/hexahedron'
import { Refusal } from '../model/result'
import { described } from './json-entries'

export interface NamedHexahedron {
  readonly name: string
  /** 24 numbers; a decimal beyond the doubles, such as 1e999, has been read as an infinity. */
  readonly vertices: Vertices
}

/** Throws a Refusal that says which entry and why. */
export function readHexahedron(entry: unknown, index: number): NamedHexahedron {
  const fail = (why: string): never => {
    throw new Refusal(`Entry ${index}${named(entry)}: ${why}`)
  }
  if (typeof entry !== 'object' || entry === null || Array.isArray(entry))
    return fail(`it is ${described(entry)}, not an object with "name" and "vertices".`)
  const { name, vertices } = entry as Record<string, unknown>
  if (typeof name !== 'string') return fail(`"name" is ${described(name)}, not a string.`)
  if (!Array.isArray(vertices))
    return fail(`"vertices" is ${described(vertices)}, not a list of ${VERTEX_COUNT} points.`)
  if (vertices.length !== VERTEX_COUNT)
    return fail(`it has ${counted(vertices, 'vertex', 'vertices')}, not ${VERTEX_COUNT}.`)
  for (const [v, point] of vertices.entries()) {
    if (!Array.isArray(point)) return fail(`vertex ${v} is ${described(point)}, not a list of 3 coordinates.`)
    if (point.length !== 3) return fail(`vertex ${v} has ${counted(point, 'coordinate', 'coordinates')}, not 3.`)
    const bad = point.findIndex(coordinate => typeof coordinate !== 'number')
    if (bad >= 0) return fail(`vertex ${v} ${'xyz'[bad]} is ${described(point[bad])}, not a number.`)
  }
  return { name, vertices: vertices.flat() }
}

function named(entry: unknown): string {
  const name = (entry as { name?: unknown } | null)?.name
  return typeof name === 'string' ? ` (${shown(name)})` : ''
}

function counted(list: readonly unknown[], one: string, many: string): string {
  return `${list.length} ${list.length === 1 ? one : many}`
}
