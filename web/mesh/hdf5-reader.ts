/** The reader of HDF5 files as others see it. It is large, and loaded when such a file comes: reading begins without it, and again with it. */
import { Refusal } from '../model/result'
import { MeshRefusal } from './mesh'
import type { Hdf5Reader, MeshFile, ReadOptions } from './source'

/** The reader that a file needs was not given. */
export class Hdf5Needed extends Refusal {
  constructor(file: MeshFile) {
    super(`${file.name}: this is an HDF5 file, and the reader of these was not loaded.`)
  }
}

/** The reader of the options. Throws Hdf5Needed. */
export function hdf5For(file: MeshFile, { hdf5 }: ReadOptions): Hdf5Reader {
  if (hdf5?.isWhole) return hdf5
  throw new Hdf5Needed(file)
}

/** What the reader answers. Throws a MeshRefusal for a sentence. */
export function answered<T extends object>(answer: T | string): T {
  if (typeof answer === 'string') throw new MeshRefusal(answer)
  return answer
}

/** In words, while it is loaded, with the bytes that travel. */
export const LOADING = 'Loading the HDF5 reader, 1 MB'

export class Hdf5Loading {
  readonly #load: () => Promise<Hdf5Reader>
  #reader: Hdf5Reader | null = null

  constructor(load: () => Promise<Hdf5Reader>) {
    this.#load = load
  }

  /** Does the work, a second time with the reader if it needs that; `onLoad` is called before it is loaded. */
  async reading<T>(work: (reader: Hdf5Reader | null) => T | Promise<T>, onLoad: () => void): Promise<T> {
    try {
      return await work(this.#reader?.isWhole ? this.#reader : null)
    } catch (error) {
      if (!(error instanceof Hdf5Needed)) throw error
    }
    onLoad()
    this.#reader = await this.#load().catch(reason => {
      throw new MeshRefusal(
        `The reader of HDF5 files was not loaded (${reason instanceof Error ? reason.message : reason}).`,
      )
    })
    return work(this.#reader)
  }
}
