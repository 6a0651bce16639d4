/**
 * Displacements of the nodes in an Exodus file: the first results at nodes whose names begin with "dis", in any case, and are equal but for an
 * x, y and z at the end: disp_x, DISPLX, displacement_x. VTK's reader looks for the same names, and moves the nodes as well.
 */
import { float32Note, largestOf } from '../precision'
import { shown } from '../shown'
import { lengthOf, type Variable, type Variables } from './netcdf-variables'

interface Component {
  readonly name: string
  readonly variable: Variable
  /** Its shape as it should be: times, in old files all results, and nodes, whose number is -1 here. */
  readonly shape: readonly number[]
  /** The number of this result among those that share the variable. */
  readonly index: number
}

export class Displacements {
  readonly #components: readonly Component[]
  readonly #step: number
  readonly #refuse: (what: string) => never
  /** The numbers of one axis. */
  #values = new Float64Array(0)
  #largest = 0

  /** Null if the file has none. */
  static of(
    variables: Variables,
    { step, count }: { readonly step: number; readonly count: number },
    refuse: (what: string) => never,
  ): Displacements | null {
    const names = (variables.variable('name_nod_var')?.strings() ?? []).map(name => name.trim())
    const found = indicesOf(names)
    if (found === null) return null
    const together = variables.variable('vals_nod_var')
    const components = found.map((index): Component => {
      const name = names[index] as string
      const own = variables.variable(`vals_nod_var${index + 1}`)
      if (own !== null) return { name, variable: own, shape: [count, -1], index: 0 }
      if (together === null) refuse(`${shown(name)} is result ${index + 1}, and there is no vals_nod_var${index + 1}.`)
      return { name, variable: together, shape: [count, names.length, -1], index }
    })
    return new Displacements(components, step, refuse)
  }

  private constructor(components: readonly Component[], step: number, refuse: (what: string) => never) {
    this.#components = components
    this.#step = step
    this.#refuse = refuse
  }

  /** Refuses results of another number of times or nodes. */
  expect(nodes: number): void {
    for (const { name, variable, shape } of this.#components) {
      const wanted = shape.map(length => (length < 0 ? nodes : length))
      if (wanted.join() !== variable.shape.join())
        this.#refuse(
          `the results ${shown(name)} have the shape ${variable.shape.join(' x ')}; ${wanted.join(' x ')} was expected.`,
        )
    }
  }

  /** Adds those of the nodes from `from` on to their coordinates, three a node. */
  add(from: number, coordinates: Float64Array): void {
    const length = coordinates.length / 3
    if (this.#values.length < length) this.#values = new Float64Array(length)
    const own = this.#values.subarray(0, length)
    for (const [axis, { variable, index }] of this.#components.entries()) {
      const perStep = lengthOf(variable) / (variable.shape[0] as number)
      const nodes = variable.shape.at(-1) as number
      variable.numbers(this.#step * perStep + index * nodes + from, own)
      for (let i = 0, at = axis; i < length; ++i, at += 3)
        coordinates[at] = (coordinates[at] as number) + (own[i] as number)
      if (variable.isFloat32) this.#largest = Math.max(this.#largest, largestOf(own))
    }
  }

  /** What was done, for people. */
  notes(): string[] {
    const names = this.#components.map(({ name }) => shown(name).slice(1, -1)).join(', ')
    const precision = float32Note(this.#largest, 'Displacements')
    return [
      `The displacements ${names} are added to the coordinates; each sum is rounded to a double.`,
      ...(precision === null ? [] : [precision]),
    ]
  }
}

/** The places of three names. */
function indicesOf(names: readonly string[]): readonly number[] | null {
  for (const [i, name] of names.entries()) {
    const last = name.slice(-1)
    if (!/^dis/i.test(name) || !/^x$/i.test(last)) continue
    const stem = name.slice(0, -1)
    const others = (last === 'x' ? ['y', 'z'] : ['Y', 'Z']).map(axis => names.indexOf(stem + axis))
    if (!others.includes(-1)) return [i, ...others]
  }
  return null
}
