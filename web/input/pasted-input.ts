/** Texts and files that a reader pastes, drops or opens. Text fields keep their own. */

export type PastedInput = { readonly text: string } | GivenFiles

export interface GivenFiles {
  readonly files: readonly File[]
  /** Of files out of folders: the path of each from there, its name included. */
  readonly paths?: readonly string[]
}

/** What it is called on the page. */
export function inputName(input: PastedInput): string {
  if ('text' in input) return 'the text'
  const [first] = input.files
  return input.files.length === 1 && first ? first.name : `${input.files.length} files`
}

/** Null where there is nothing to read. */
function inputOf(transfer: DataTransfer | null): PastedInput | null {
  const files = Array.from(transfer?.files ?? [])
  if (files.length > 0) return { files }
  const text = transfer?.getData('text/plain') ?? ''
  return text === '' ? null : { text }
}

/** The input that a paste brings, whose browser then has nothing more to do with it. */
export function pastedIn(event: ClipboardEvent): PastedInput | null {
  const input = event.defaultPrevented || isTextField(event.composedPath()[0]) ? null : inputOf(event.clipboardData)
  if (input !== null) event.preventDefault()
  return input
}

/** The same of a drop. */
export function droppedIn(event: DragEvent): PastedInput | null {
  const input = takesDrop(event) ? inputOf(event.dataTransfer) : null
  if (input !== null) event.preventDefault()
  return input
}

/** A file is never a text field's: the browser would leave the page for it. */
export function takesDrop(event: DragEvent): boolean {
  const types = event.dataTransfer?.types ?? []
  return types.includes('Files') || (types.includes('text/plain') && !isTextField(event.composedPath()[0]))
}

function isTextField(target: EventTarget | undefined): boolean {
  return target instanceof HTMLElement && (target.isContentEditable || target.matches('input, textarea, select'))
}
