/**
 * The list that was read last in this tab, as it was given: a text or files. IndexedDB holds it, since
 * it may be large; the tab knows its key. The lists of tabs that are closed go when others come.
 */
import type { PastedInput } from '../input/pasted-input'
import { InputStore } from './input-store'
import { Keeper, TAB_ALONE } from './keep'
import { say, unsay } from './note'

const MOST_MEGABYTES = 16
/** Of all tabs. */
const MOST_LISTS = 4

const store = new InputStore('hexlens', MOST_LISTS)
const key = new Keeper<number>('list', 1, value => (typeof value === 'number' ? value : null), TAB_ALONE)

/** Keeps each list that is read in the lens, and reads the one that was kept again. */
export function keepLists(lens: HTMLElementTagNameMap['hex-lens']): void {
  let list: PastedInput | null = null
  let note = ''

  async function onList(input: PastedInput | null): Promise<void> {
    if (input && list && isSame(input, list)) return // the one that was kept
    list = input
    unsay(note)
    const told = await keepList(input)
    if (list !== input) return
    note = told
    if (note !== '') say(note)
  }

  lens.addEventListener('hex-list', event => void onList((event as CustomEvent<PastedInput | null>).detail))
  void keptList().then(kept => {
    if (kept === null || list !== null) return
    list = kept
    lens.offer('text' in kept ? kept.text : kept.files, true)
  })
}

function isSame(a: PastedInput, b: PastedInput): boolean {
  if ('text' in a || 'text' in b) return 'text' in a && 'text' in b && a.text === b.text
  return a.files.length === b.files.length && a.files.every((file, i) => file === b.files[i])
}

/** Resolves to what the reader is told if it is not kept; to nothing if it is. Null is no list. */
async function keepList(input: PastedInput | null): Promise<string> {
  key.forget()
  if (input === null) return ''
  const bytes = 'text' in input ? 2 * input.text.length : input.files.reduce((sum, { size }) => sum + size, 0)
  if (bytes > MOST_MEGABYTES * 1e6)
    return `The list is gone when you leave this page: up to ${MOST_MEGABYTES} MB are kept.`
  try {
    const added = await store.add(input)
    if (key.keep(added) === 'kept') return ''
  } catch {
    // No room, or refused.
  }
  return 'The list is gone when you leave this page: this browser does not keep it.'
}

/** Null if there is none. */
async function keptList(): Promise<PastedInput | null> {
  const own = key.own()
  return own === null ? null : store.get(own)
}

export function forgetLists(): void {
  store.forget()
}
