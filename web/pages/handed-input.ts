/** An input that goes from one page to another in its tab. It is the browser's only until the other page has it. */
import type { PastedInput } from '../input/pasted-input'
import { InputStore } from './input-store'
import { Keeper, TAB_ALONE } from './keep'

/** Of tabs that hand over at the same time. */
const MOST = 2

const store = new InputStore('hexlens-handed', MOST)
const key = new Keeper<number>('handed', 1, value => (typeof value === 'number' ? value : null), TAB_ALONE)

/** Resolves to whether the next page can take it. */
export async function handOver(input: PastedInput): Promise<boolean> {
  try {
    return key.keep(await store.add(input)) === 'kept'
  } catch {
    return false
  }
}

/** Null if nothing was handed over; `lost` is a sentence. */
export async function takeHanded(): Promise<{ readonly input: PastedInput } | { readonly lost: string } | null> {
  const own = key.own()
  if (own === null) return null
  key.forget()
  const input = await store.get(own)
  if (input === null) return { lost: 'What the page Lens handed over is gone: drop it here again.' }
  // What was taken from there can be read to its end.
  await store.remove(own).catch(() => {})
  return { input }
}

export function forgetHanded(): void {
  store.forget()
}
