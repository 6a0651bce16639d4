/** A section that its button shows and hides: one at a time, since it moves the picture down; Escape hides it. Both are hidden at first. */

let opened: ButtonSection | null = null

export class ButtonSection {
  readonly button = document.createElement('button')
  readonly root = document.createElement('section')

  constructor(id: string, name: string) {
    const { button, root } = this
    button.type = 'button'
    button.textContent = name
    button.hidden = true
    button.setAttribute('aria-controls', id)
    button.addEventListener('click', () => this.open(Boolean(root.hidden)))
    root.id = id
    root.className = id
    root.setAttribute('aria-label', name)
    for (const part of [button, root])
      part.addEventListener('keydown', ({ key }) => {
        if (key !== 'Escape' || root.hidden) return
        this.open(false)
        button.focus()
      })
    this.open(false)
  }

  open(isOpen: boolean): void {
    if (isOpen && opened !== this) {
      opened?.open(false)
      opened = this
    }
    this.root.hidden = !isOpen
    this.button.setAttribute('aria-expanded', String(isOpen))
  }
}
