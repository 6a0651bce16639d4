/** The reader of HDF5 files beside the script of the worker. */
import { scriptAddress } from '../core/script-address'
import type { Hdf5Reader } from '../mesh/source'
import { startedHdf5 } from './hdf5-place'

/** Workers alone have it, and the types of a page do not. */
declare function importScripts(address: string): void

const NAME = 'hexlens.hdf5.js'

/** A copy of the worker has no address of its own; the page tells it that of the script. */
const here = (globalThis as { readonly hexlensScript?: string }).hexlensScript ?? location.href

export async function hdf5InWorker(): Promise<Hdf5Reader> {
  try {
    importScripts(scriptAddress(new URL(NAME, here)))
  } catch {
    throw new Error(
      `${NAME} is not beside the worker’s script, or the page may not load it, as one from file:// may not`,
    )
  }
  return startedHdf5()
}
