/** Files that name others which were not given: they wait for these. */
import { isNamed } from '../mesh/source'
import type { GivenFiles, PastedInput } from './pasted-input'

export class WaitingFiles {
  #waiting: { readonly given: GivenFiles; readonly missing: readonly string[] } | null = null

  /** The input with the files that wait for one of its own. */
  completed(input: PastedInput): PastedInput {
    if (!('files' in input) || this.#waiting === null) return input
    const { given, missing } = this.#waiting
    if (!input.files.some(file => missing.some(name => isNamed(file, name)))) return input
    const pathsOf = ({ files, paths }: GivenFiles) => files.map((file, i) => [file, paths?.[i] ?? file.name] as const)
    const others = pathsOf(given).filter(([, path]) => !pathsOf(input).some(([, own]) => own === path))
    const all = [...others, ...pathsOf(input)]
    return { files: all.map(([file]) => file), paths: all.map(([, path]) => path) }
  }

  /** `missing` are the files that were named and not given; with none, or with null, nothing waits any more. */
  refused(input: PastedInput | null, missing: readonly string[]): void {
    this.#waiting = input && 'files' in input && missing.length > 0 ? { given: input, missing } : null
  }
}
