/** A quiet line beside the links to the pages: what became of the reader's work. One at a time. */
const line = document.createElement('p')
line.className = 'note'
line.role = 'status'
document.querySelector('.pages')?.append(line)

export interface NoteButton {
  readonly label: string
  press(): void
}

export function say(text: string, button: NoteButton | null = null): void {
  if (line.firstChild?.textContent === text) return
  line.replaceChildren(text)
  if (button === null) return
  const element = document.createElement('button')
  element.type = 'button'
  element.textContent = button.label
  element.addEventListener('click', () => button.press())
  line.append(' ', element)
}

/** Takes the line back, if it still says this. */
export function unsay(text: string): void {
  if (line.firstChild?.textContent === text) line.replaceChildren()
}
