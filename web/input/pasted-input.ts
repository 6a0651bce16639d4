/** Texts and files that a reader pastes, drops or opens. Text fields keep their own. */

export type PastedInput = { readonly text: string } | { readonly files: readonly File[] }

/** Null where there is nothing to read. */
function inputOf(transfer: DataTransfer | null): PastedInput | null {
  const files = Array.from(transfer?.files ?? [])
  if (files.length > 0) return { files }
  const text = transfer?.getData('text/plain') ?? ''
  return text === '' ? null : { text }
}

export interface InputListener {
  /** True if anything is taken at all. */
  isWelcome(): boolean
  take(input: PastedInput): void
}

/** Listens for what is pasted or dropped anywhere in an element; `lens` shows where a drop will be taken. */
export function listenForInput(shadow: ShadowRoot, lens: HTMLElement, { isWelcome, take }: InputListener): void {
  shadow.addEventListener('paste', event => {
    if (isWelcome()) onPaste(event as ClipboardEvent, take)
  })
  shadow.addEventListener('dragover', event => {
    const { dataTransfer } = event as DragEvent
    const isOurs = isWelcome() && takesDrop(event as DragEvent)
    lens.classList.toggle('is-drop-target', isOurs)
    if (!isOurs || !dataTransfer) return
    event.preventDefault()
    dataTransfer.dropEffect = 'copy'
  })
  const leave = () => lens.classList.remove('is-drop-target')
  shadow.addEventListener('dragleave', leave)
  shadow.addEventListener('dragend', leave)
  shadow.addEventListener('drop', event => {
    leave()
    const input = isWelcome() && takesDrop(event as DragEvent) ? inputOf((event as DragEvent).dataTransfer) : null
    if (input === null) return
    event.preventDefault()
    take(input)
  })
}

export function onPaste(event: ClipboardEvent, take: (input: PastedInput) => void): void {
  const input = event.defaultPrevented || isTextField(event.composedPath()[0]) ? null : inputOf(event.clipboardData)
  if (input === null) return
  event.preventDefault()
  take(input)
}

/** A file is never a text field's: the browser would leave the page for it. */
function takesDrop(event: DragEvent): boolean {
  const types = event.dataTransfer?.types ?? []
  return types.includes('Files') || (types.includes('text/plain') && !isTextField(event.composedPath()[0]))
}

function isTextField(target: EventTarget | undefined): boolean {
  return target instanceof HTMLElement && (target.isContentEditable || target.matches('input, textarea, select'))
}
