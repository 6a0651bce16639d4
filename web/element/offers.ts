/** What a reader pastes or drops on the element: text, or one file. Text fields keep theirs. */
import type { Offer } from '../views/view'

/** Null where there is nothing to read. */
export function offerOf(transfer: DataTransfer | null): Offer | null {
  const file = transfer?.files[0]
  if (file) return { content: file }
  const text = transfer?.getData('text/plain') ?? ''
  return text === '' ? null : { content: text }
}

export interface Taker {
  /** Whether anything is taken at all. */
  isWelcome(): boolean
  take(offer: Offer): void
}

export function listenForOffers(shadow: ShadowRoot, lens: HTMLElement, { isWelcome, take }: Taker): void {
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
    const offer = isWelcome() && takesDrop(event as DragEvent) ? offerOf((event as DragEvent).dataTransfer) : null
    if (offer === null) return
    event.preventDefault()
    take(offer)
  })
}

export function onPaste(event: ClipboardEvent, take: (offer: Offer) => void): void {
  const offer = event.defaultPrevented || isTextField(event.composedPath()[0]) ? null : offerOf(event.clipboardData)
  if (offer === null) return
  event.preventDefault()
  take(offer)
}

/** A file is never a text field's: the browser would leave the page for it. */
function takesDrop(event: DragEvent): boolean {
  const types = event.dataTransfer?.types ?? []
  return types.includes('Files') || (types.includes('text/plain') && !isTextField(event.composedPath()[0]))
}

function isTextField(target: EventTarget | undefined): boolean {
  return target instanceof HTMLElement && (target.isContentEditable || target.matches('input, textarea, select'))
}
