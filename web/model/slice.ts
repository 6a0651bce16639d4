/** A panel's own part of the state, by the panel's name. It outlives the page, and is no part of the history. */
import type { Readers } from './document-readers'
import type { Action, State } from './state'

export interface Slice<T extends object> {
  /** The panel's. */
  readonly name: string
  /** In a new element. */
  readonly first: T
  /** Its keys in the state's document, beside those of the element and of other panels. */
  readonly readers: Readers<T>
  /** Throws RangeError for what no caller may send. */
  readonly check?: (value: T) => void
}

// biome-ignore lint/suspicious/noExplicitAny: a list holds slices of all types, and each is used with its own values alone.
export type AnySlice = Slice<any>

export function sliceOf<T extends object>({ name, first }: Slice<T>, { slices }: Pick<State, 'slices'>): T {
  return (slices[name] as T | undefined) ?? first
}

export function sliceChange<T extends object>(slice: Slice<T>, change: Partial<T>): Action {
  return { type: 'change-slice', slice, change }
}
